// What a curve of events is followed by: the event's equations, the second parameter held, and what
// of the event's nature the curve's special points depend on.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "solver/event_curve/event_curve.hpp"
#include "solver/event_curve/event_sides.hpp"
#include "solver/proof/event_system.hpp"

namespace stationary {

template <int M>
struct EventCurveSystem {
  std::unique_ptr<HeldEventEquations<M>> equations;
  ExtendedVector<M> start;  ///< the event, nearly
  Branch branch;
  /// Under which the potential is defined (Family::conditions), and their values at y, p2.
  std::function<std::vector<ConditionValue>(const ReducedVector<M>& y, double second)> conditions;
  bool turns = false;     ///< the family in p1 turns there
  bool spectral = false;  ///< Lambda is among the unknowns
  /// The function that vanishes all along the curve; nothing: not known.
  std::optional<std::size_t> own_function{};
  /// Of a circle that breaks: what changes its sign where the ellipses' side does; else empty.
  std::function<double(const EventPlace& at, double second)> pitchfork{};
};

/// What may vanish at an event of a spin about a material axis, the likeliest first.
std::vector<EventCurveSystem<5>> spin_event_systems(const EventCurveSetting& setting,
                                                    const Member& event, double second,
                                                    Circle circle);

/// Of an event of any other family with N unknowns; nothing where it has no equations for it.
template <int N>
std::optional<EventCurveSystem<event_dimension<N>>> family_event_system(
    const EventCurveSetting& setting, const Member& event, double second, Circle circle);

/// As of TestValues.
std::optional<std::size_t> test_function(const EventFunction& function);

}  // namespace stationary
