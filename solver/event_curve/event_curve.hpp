// The curve of an event in two numbers p1, p2 of the problem:
//
//   F(xi, zeta, rho, p1[, Lambda]; p2) = 0
//
// F the balance with what vanishes at the event (event_system.hpp), square at one p2 and regular
// where the event is a simple one. It is a family in p2 like any other and is followed as such,
// around its turns too. Special points on it:
//
//   cusp                  p1 and p2 turn together, on the curve of a fold
//   turn                  p2 turns, on the curve of two Lambdas that meet: two such events of the
//                         family in p1 meet and vanish
//   double                another event of the family in p1 lies at the same point
//   degenerate-pitchfork  ellipses begin on the other side of the circle (pitchfork.hpp)
//
// Of every kind whose family knows its events' equations (Family::event_equations); where Lambdas
// meet, of spins about a material axis with alpha = 0 alone.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/motion/event.hpp"
#include "solver/motion/family_parameter.hpp"
#include "solver/motion/problem.hpp"

namespace stationary {

enum class SpecialPoint : std::uint8_t { none, cusp, degenerate_pitchfork, double_event, turn };
constexpr std::string_view special_point_names[] = {"", "cusp", "degenerate-pitchfork", "double",
                                                    "turn"};
constexpr std::string_view name(SpecialPoint s) {
  return special_point_names[static_cast<std::size_t>(s)];
}

/// The problem at values of both parameters, with the spin.
struct SpinningProblem {
  Problem problem;
  double nu;
};

struct EventCurveSetting {
  /// The family in p1 at this p2; a p1 of it where its other numbers are valid. Throws
  /// std::invalid_argument where there is none.
  std::function<AnyFamily(double first, double second, bool spectrum)> family;
  FamilyParameter first;
  FamilyParameter second;
  EventType type;
  /// Of a spin about a material axis, whose events have equations of their own; else empty.
  std::function<SpinningProblem(double first, double second)> spin{};
};

/// Of spins about a material axis, alpha = 0.
EventCurveSetting spin_setting(std::function<SpinningProblem(double first, double second)> spin,
                               const FamilyParameter& first, const FamilyParameter& second,
                               EventType type);

struct EventCurvePoint {
  Member member;        ///< of the family in p1, with its spectrum
  double second = 0.0;  ///< p2; p1 is member.parameter
  SpecialPoint special = SpecialPoint::none;
  /// `double`: the other event.
  EventType other = EventType::none;
  /// The family's class on both sides: for p1 below and above the event; at a fold on the two
  /// sheets that meet, that with the smaller locked inertia about the axis first.
  std::optional<StabilityClass> before;
  std::optional<StabilityClass> after;
};

struct EventCurveOptions {
  double first_from = 0.0;  ///< range of p1
  double first_to = 1.0;
  double second_from = 0.0;  ///< of p2
  double second_to = 1.0;
  double tolerance = 1e-10;  ///< of the curve between its points, in ln S and p over the ranges
  bool spectrum = true;      ///< of its points, and the classes beside them
  long max_points = 1'000'000;
  const std::atomic<bool>* stop = nullptr;
};

struct EventCurveEnd {
  EventType event = EventType::none;  ///< none: interrupted, or max_points
  std::string reason;
};

struct EventCurve {
  std::string failure;  ///< why the event starts no curve; empty if it does
  std::vector<EventCurvePoint> points;
  EventCurveEnd first;  ///< of points.front()
  EventCurveEnd last;
  /// p1 where it passes the p2 of its start.
  std::vector<Member> crossings;
  bool interrupted = false;
};

/// Whether events of this type have such curves. spin: of a spin about a material axis, alpha = 0;
/// of another family the types of which it may have equations.
bool has_event_curve(EventType type, bool spin, bool isotropic);

/// From a located event of the family in p1 at this p2, in both directions. circle: that the
/// family keeps.
EventCurve follow_event_curve(const EventCurveSetting& setting, const Member& event, double second,
                              Circle circle, const EventCurveOptions& options);

}  // namespace stationary
