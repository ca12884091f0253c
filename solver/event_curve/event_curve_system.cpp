#include "solver/event_curve/event_curve_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <variant>

#include "lib/number/elementary.hpp"
#include "solver/event_curve/oriented_event_equations.hpp"
#include "solver/event_curve/pitchfork.hpp"
#include "solver/family/coefficient_slope.hpp"
#include "solver/family/oriented_events.hpp"
#include "solver/proof/extended_event.hpp"

namespace stationary {
namespace {

bool is_coefficient(const FamilyParameter& parameter) {
  using Kind = FamilyParameter::Kind;
  return parameter.kind == Kind::plane || parameter.kind == Kind::thickness ||
         parameter.kind == Kind::shared;
}

/// Of the potential with both numbers at their values.
std::vector<ConditionValue> conditions_of(const Potential& potential,
                                          const FamilyParameter& first_parameter,
                                          const FamilyParameter& second_parameter,
                                          const ReducedVector<5>& y, double second) {
  const double first = y[ExtendedEventEquations<5>::parameter];
  if (!potential.is_isotropic()) {
    AnisotropicPotential V = potential.anisotropic();
    if (const int k = coefficient_place(V, first_parameter); k >= 0)
      V = V.with_coefficient(k, first);
    if (const int k = coefficient_place(V, second_parameter); k >= 0)
      V = V.with_coefficient(k, second);
    return V.conditions_at({0.0, y[0], y[1], y[2]});
  }
  return potential.visit_parts([&](auto model) {
    if (is_coefficient(first_parameter)) model = at_coefficient(model, first_parameter, first);
    if (is_coefficient(second_parameter)) model = at_coefficient(model, second_parameter, second);
    return model_conditions(model, {0.0, y[0], y[1], y[2]});
  });
}

/// The equations that the family in p1 at the held p2 has for one event of it.
template <int N>
class EquationsOfFamilies final : public HeldEventEquations<event_dimension<N>> {
 public:
  static constexpr int M = event_dimension<N>;
  using typename ExtendedEventEquations<M>::Errors;

  EquationsOfFamilies(const EventCurveSetting& setting, const Member& event, double second,
                      Circle circle)
      : setting_(setting), event_(event), circle_(circle) {
    hold(second);
  }

  /// Those at a few values are kept: slopes in p2 are differences.
  void hold(double second) override {
    const auto kept = std::ranges::find(kept_, second, &AtValue::second);
    if (kept != kept_.end()) {
      here_ = &*kept;
      return;
    }
    here_ = &kept_[next_];
    next_ = (next_ + 1) % kept_.size();
    here_->second = second;
    here_->equations = nullptr;
    here_->family = nullptr;
    try {
      auto family = setting_.family(event_.parameter, second, false);
      if (auto* own = std::get_if<std::unique_ptr<Family<N>>>(&family)) {
        here_->family = std::move(*own);
        here_->equations = here_->family->event_equations(setting_.type, circle_, event_);
      }
    } catch (const std::invalid_argument&) {
      // A value that a step of the curve tries out.
    }
  }
  const Family<N>* family() const { return here_->family.get(); }
  bool known() const { return here_->equations != nullptr; }

  ExtendedVector<M> values(const ExtendedVector<M>& y) const override {
    if (known()) return here_->equations->values(y);
    ExtendedVector<M> out;
    out.fill(DoubleDouble(std::numeric_limits<double>::quiet_NaN()));
    return out;
  }
  std::optional<ExtendedRoot<M>> root(const ExtendedVector<M>& y) const override {
    if (!known()) return std::nullopt;
    return here_->equations->root(y);
  }
  Errors conditions(const ExtendedVector<M>& y) const override {
    return known() ? here_->equations->conditions(y) : Errors{};
  }
  double stretch_error(const Errors& error) const override {
    return here_->equations->stretch_error(error);
  }

 private:
  struct AtValue {
    double second = std::numeric_limits<double>::quiet_NaN();
    std::unique_ptr<Family<N>> family;
    std::unique_ptr<ExtendedEventEquations<M>> equations;
  };

  const EventCurveSetting& setting_;
  Member event_;
  Circle circle_;
  std::array<AtValue, 4> kept_;
  std::size_t next_ = 0;
  AtValue* here_ = nullptr;
};

/// The conditions of a family's potential at an event's unknowns and the second number.
template <int N>
auto conditions_by(EquationsOfFamilies<N>& equations) {
  using Unknowns = ReducedVector<event_dimension<N>>;
  constexpr int first = ExtendedEventEquations<event_dimension<N>>::parameter;
  return [&equations](const Unknowns& y, double second) {
    equations.hold(second);
    return equations.family() == nullptr
               ? std::vector<ConditionValue>{}
               : equations.family()->conditions(EventPlace::of<N>(y), y[first]);
  };
}

}  // namespace

EventCurveSetting spin_setting(std::function<SpinningProblem(double first, double second)> spin,
                               const FamilyParameter& first, const FamilyParameter& second,
                               EventType type) {
  EventCurveSetting out;
  out.family = [spin, first](double p1, double p2, bool spectrum) {
    const SpinningProblem at = spin(p1, p2);
    return axis_family(at.problem, {.nu = at.nu, .parameter = first, .spectrum = spectrum}, false);
  };
  out.first = first;
  out.second = second;
  out.type = type;
  out.spin = std::move(spin);
  return out;
}

std::vector<EventCurveSystem<5>> spin_event_systems(const EventCurveSetting& setting,
                                                    const Member& event, double second,
                                                    Circle circle) {
  const SpinningProblem at = setting.spin(event.parameter, second);
  const Potential& potential = at.problem.potential();
  const EventSetting equations{at.problem.body(),   potential,
                               at.problem.branch(), at.nu,
                               setting.first,       circle,
                               Inputs::doubles,     EventSetting::Held{setting.second, second}};
  std::vector<EventCurveSystem<5>> out;
  for (const SoughtEvent& what : sought_events(setting.type, at.problem.branch(), event)) {
    EventCurveSystem<5> system{
        potential.is_isotropic() ? extended_event_equations(equations, what.function)
                                 : oriented_event_equations(equations, what.function),
        event_unknowns(event, what), at.problem.branch(),
        [potential, first = setting.first, second_parameter = setting.second](
            const ReducedVector<5>& y, double p2) {
          return conditions_of(potential, first, second_parameter, y, p2);
        }};
    system.turns = what.function.kind == EventFunction::Kind::fold;
    system.spectral = what.function.spectral();
    system.own_function = test_function(what.function);
    if (what.function.kind == EventFunction::Kind::ellipse) {
      system.pitchfork = [&setting, circle](const EventPlace& place, double p2) {
        const SpinningProblem there = setting.spin(place.first, p2);
        return pitchfork_coefficient(there.problem, there.nu, place.straight(), circle);
      };
    }
    out.push_back(std::move(system));
  }
  return out;
}

template <int N>
std::optional<EventCurveSystem<event_dimension<N>>> family_event_system(
    const EventCurveSetting& setting, const Member& event, double second, Circle circle) {
  constexpr int M = event_dimension<N>;
  auto equations = std::make_unique<EquationsOfFamilies<N>>(setting, event, second, circle);
  if (!equations->known()) return std::nullopt;
  const AnyFamily family = setting.family(event.parameter, second, true);
  const auto& own = *std::get<std::unique_ptr<Family<N>>>(family);
  // With what of y the event does without.
  const ReducedVector<N> x = own.coordinates_of(event);
  const auto start = equations->root(event_unknowns(event, x));
  if (!start) return std::nullopt;
  constexpr double near = 1e-3;
  for (int k = 0; k < N; ++k) {
    const double there = double(start->y[event_place(static_cast<std::size_t>(k))]);
    if (!(std::abs(log(there / x[k])) < near)) return std::nullopt;  // another event
  }
  EventCurveSystem<M> out{nullptr, start->y, own.branch(), conditions_by(*equations)};
  const EventPlace place = place_of(family, event, circle);
  const EventFunctions at = functions_at(family, place, member_at(family, place));
  out.own_function = nearest_function(setting.type, at.context, at.values);
  out.turns = out.own_function && at.values.value[*out.own_function] == at.turning;
  out.equations = std::move(equations);
  return out;
}

template std::optional<EventCurveSystem<5>> family_event_system<2>(const EventCurveSetting&,
                                                                   const Member&, double, Circle);
template std::optional<EventCurveSystem<5>> family_event_system<3>(const EventCurveSetting&,
                                                                   const Member&, double, Circle);
template std::optional<EventCurveSystem<5>> family_event_system<4>(const EventCurveSetting&,
                                                                   const Member&, double, Circle);
template std::optional<EventCurveSystem<6>> family_event_system<5>(const EventCurveSetting&,
                                                                   const Member&, double, Circle);

std::optional<std::size_t> test_function(const EventFunction& function) {
  using Kind = EventFunction::Kind;
  switch (function.kind) {
    case Kind::fold:
      return TestValues::fold;
    case Kind::momentum:
      return TestValues::momentum;
    case Kind::inertia:
      return function.a + function.b == 1   ? TestValues::inertia_12
             : function.a + function.b == 2 ? TestValues::inertia_13
                                            : TestValues::inertia_23;
    case Kind::ellipse:
      return TestValues::ellipse;
    case Kind::turn:
      return TestValues::turn;
    case Kind::collision:
      return TestValues::collision;
    case Kind::crossing:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace stationary
