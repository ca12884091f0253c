// Curves of events in two parameters: against closed forms, against events located at single values
// of the second parameter, and their special points.
#include "solver/event_curve/event_curve.hpp"

#include <gtest/gtest.h>

#include <map>

#include "solver/event_curve/pitchfork.hpp"
#include "solver/kind/kind.hpp"
#include "solver/search/search.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"

namespace stationary::testing {
namespace {

using Kind = FamilyParameter::Kind;

/// A problem by its numbers, two of which vary.
struct Numbers {
  std::string_view model;
  Branch branch;
  std::array<double, 3> J{1.0, 1.7, 0.6};
  std::array<double, 2> plane{1.0, 2.0};
  double nu = 0.4;
  std::array<double, 2> axial{1.0, 3.0};

  SpinningProblem problem() const {
    return {{Body(J[0], J[1], J[2]),
             testing::make_potential(model, plane, "reciprocal-quadratic", axial), branch},
            nu};
  }
  double& at(const FamilyParameter& p) {
    const auto k = static_cast<std::size_t>(p.index);
    return p.kind == Kind::nu ? nu : p.kind == Kind::inertia ? J[k] : plane[k];
  }
  Numbers with(const FamilyParameter& p, double value) const {
    Numbers out = *this;
    out.at(p) = value;
    return out;
  }
};

EventCurveSetting setting(const Numbers& numbers, EventType type, const FamilyParameter& first,
                          const FamilyParameter& second) {
  return spin_setting(
      [=](double p, double r) { return numbers.with(first, p).with(second, r).problem(); }, first,
      second, type);
}

Member start(const Numbers& numbers, const Stretch& q, double first) {
  Member out;
  out.body = numbers.problem().problem.body();
  out.q = q;
  out.nu = numbers.nu;
  out.parameter = first;
  return out;
}

double relative(double a, double b) { return std::abs(a - b) / std::abs(b); }

/// hencky (i): zeta = sqrt e, nu^2 J2 = 2 mu (mu + lambda)/[(2 mu + lambda) e].
TEST(EventCurve, FoldOfHencky) {
  Numbers numbers{.model = "hencky", .branch = Branch::i, .plane = {1.25, 0.5}};
  const double product = 2.0 * 1.25 * 1.75 / (3.0 * std::exp(1.0));
  numbers.nu = std::sqrt(product / numbers.J[1]);
  const Equilibrium near = solve(numbers.with({}, (1.0 - 1e-9) * numbers.nu).problem().problem,
                                 (1.0 - 1e-9) * numbers.nu);
  ASSERT_EQ(near.status, SolveStatus::solved);
  const EventCurveOptions options{
      .first_from = 0.1, .first_to = 2.0, .second_from = 0.3, .second_to = 4.0, .tolerance = 1e-6};
  const EventCurve curve =
      follow_event_curve(setting(numbers, EventType::fold_nu, {}, {Kind::inertia, 1}),
                         start(numbers, near.q, numbers.nu), numbers.J[1], Circle::none, options);
  ASSERT_EQ(curve.failure, "");
  EXPECT_EQ(curve.first.event, EventType::limit);
  EXPECT_EQ(curve.last.event, EventType::limit);
  ASSERT_GE(curve.points.size(), 10U);
  EXPECT_EQ(curve.points.front().second, 0.3);
  EXPECT_EQ(curve.points.back().second, 4.0);
  for (const EventCurvePoint& point : curve.points) {
    const double nu = point.member.parameter;
    EXPECT_LE(relative(nu * nu * point.second, product), 1e-14) << point.second;
    EXPECT_LE(relative(point.member.q.zeta, std::exp(0.5)), point.member.error_bound);
    EXPECT_LE(point.member.error_bound, 1e-13);
    if (point.special != SpecialPoint::none) {  // other events pass by
      EXPECT_EQ(point.special, SpecialPoint::double_event);
      continue;
    }
    ASSERT_TRUE(point.before && point.after) << point.second;
    EXPECT_NE(*point.before, StabilityClass::marginal);
  }
}

/// reciprocal-determinant (i) tilts where J1 xi^2 = J3 rho^2: c = xi^4 A1^(3/2) A2^(-1/2).
TEST(EventCurve, TiltOfReciprocalDeterminant) {
  const Numbers numbers{.model = "reciprocal-determinant",
                        .branch = Branch::i,
                        .J = {1.0, 1.5, 0.5},
                        .plane = {1.0, 2.0},
                        .nu = 0.5};
  const auto place = [&](double nu) {
    const double A2 = 2.0 - 1.5 * nu * nu;
    const double rho = std::cbrt(1.0 / (3.0 - 0.5 * nu * nu));
    const double xi = std::sqrt(0.5) * rho;
    return std::pair{std::pow(xi, 4) * std::pow(2.0, 1.5) / std::sqrt(A2),
                     Stretch{0.0, xi, xi * std::sqrt(2.0 / A2), rho}};
  };
  const auto [c, q] = place(0.5);
  const EventCurveOptions options{
      .first_from = 0.1, .first_to = 1.0, .second_from = 0.05, .second_to = 0.5, .tolerance = 1e-6};
  Numbers own = numbers;
  own.plane[0] = c;
  const EventCurve curve = follow_event_curve(setting(own, EventType::tilt, {}, {Kind::plane, 0}),
                                              start(own, q, 0.5), c, Circle::none, options);
  ASSERT_EQ(curve.failure, "");
  ASSERT_GE(curve.points.size(), 10U) << curve.first.reason << "; " << curve.last.reason;
  double least = 1.0;
  double most = 0.0;
  for (const EventCurvePoint& point : curve.points) {
    const double nu = point.member.parameter;
    EXPECT_LE(relative(place(nu).first, point.second), 1e-13) << nu;
    EXPECT_LE(relative(place(nu).second.zeta, point.member.q.zeta), 1e-13) << nu;
    least = std::min(least, nu);
    most = std::max(most, nu);
    if (point.special != SpecialPoint::none) continue;
    ASSERT_TRUE(point.before && point.after) << nu;
    EXPECT_NE(*point.before, *point.after) << nu;
  }
  EXPECT_NEAR(least, 0.1, 1e-12);
  EXPECT_NEAR(most, 1.0, 1e-12);
}

/// On the circle of hencky, u = ln xi: J nu^2 e^(2u) = mu, 2 (mu + lambda) u = mu.
TEST(EventCurve, EllipseOfHencky) {
  const Numbers numbers{.model = "hencky",
                        .branch = Branch::iii,
                        .J = {1.0, 1.0, 0.5},
                        .plane = {1.0, 3.0},
                        .nu = std::exp(-0.125)};
  const double xi = std::exp(0.125);
  const EventCurveOptions options{
      .first_from = 0.1, .first_to = 2.0, .second_from = 0.5, .second_to = 6.0, .tolerance = 1e-6};
  const EventCurve curve =
      follow_event_curve(setting(numbers, EventType::ellipse, {}, {Kind::plane, 1}),
                         start(numbers, {0.0, xi, xi, std::cbrt(1.0 / 3.0)}, numbers.nu), 3.0,
                         Circle::xi_zeta, options);
  ASSERT_EQ(curve.failure, "");
  ASSERT_GE(curve.points.size(), 5U);
  for (const EventCurvePoint& point : curve.points) {
    const double u = 0.5 / (1.0 + point.second);
    EXPECT_EQ(point.member.q.xi, point.member.q.zeta);
    EXPECT_LE(relative(point.member.q.xi, std::exp(u)), 1e-14);
    EXPECT_LE(relative(point.member.parameter, std::exp(-u)), 1e-14);
    // Beyond it E'' is indefinite on the leaf; E with the material momentum is not.
    EXPECT_EQ(point.before, StabilityClass::stable);
    EXPECT_EQ(point.after, StabilityClass::stable);
    EXPECT_EQ(point.special, SpecialPoint::none);
  }
}

/// hencky: F_vvvv = -16 mu, F_vv. K^-1 F_vv. = 16 mu^2/lambda at the event, det K of lambda's sign.
TEST(EventCurve, PitchforkOfHencky) {
  for (const double lambda : {3.0, 0.7, -0.5}) {
    const double u = 0.5 / (1.0 + lambda);
    const Problem problem(Body(1.0, 1.0, 0.5), make_potential("hencky", {1.0, lambda}),
                          Branch::iii);
    const double expected = (-16.0 * lambda - 48.0) / (16.0 * std::abs(lambda) + 48.0);
    const double xi = std::exp(u);
    EXPECT_NEAR(pitchfork_coefficient(problem, std::exp(-u), {0.0, xi, xi, std::cbrt(1.0 / 3.0)}),
                expected, 1e-12)
        << lambda;
  }
}

/// Where lambda passes 0 the circle turns, and the ellipses do not change sides.
TEST(EventCurve, ACircleThatTurnsIsNoDegeneratePitchfork) {
  const double u = 0.5 / 1.7;
  const Numbers numbers{.model = "hencky",
                        .branch = Branch::iii,
                        .J = {1.0, 1.0, 0.5},
                        .plane = {1.0, 0.7},
                        .nu = std::exp(-u)};
  const double xi = std::exp(u);
  const EventCurve curve = follow_event_curve(
      setting(numbers, EventType::ellipse, {}, {Kind::plane, 1}),
      start(numbers, {0.0, xi, xi, std::cbrt(1.0 / 3.0)}, numbers.nu), 0.7, Circle::xi_zeta,
      {.first_from = 0.1,
       .first_to = 2.0,
       .second_from = -0.5,
       .second_to = 2.0,
       .tolerance = 1e-6});
  ASSERT_EQ(curve.failure, "");
  int meetings = 0;
  for (const EventCurvePoint& point : curve.points) {
    EXPECT_NE(point.special, SpecialPoint::degenerate_pitchfork) << point.second;
    if (point.special != SpecialPoint::double_event) continue;
    ++meetings;
    EXPECT_EQ(point.other, EventType::fold_nu);
    EXPECT_NEAR(point.second, 0.0, 1e-10);
  }
  EXPECT_EQ(meetings, 1);
}

/// Of an isotropic body an axis leaves its own in the plane, and an ellipse turns away from its axes,
/// where J1 = J2, whatever nu; the stretches are the motion's there.
TEST(EventCurve, OfAxesThatTurnWhereTwoInertiasAreEqual) {
  struct Turning {
    EventType type;
    Numbers numbers;
    double from;  ///< of nu
    double to;
  };
  const std::array<double, 3> J{1.0, 1.05, 0.6};
  const Turning all[] = {
      {EventType::oblique, {"hencky", Branch::i, J, {1.1, 0.8}, 0.4}, 0.1, 0.7},
      {EventType::oblique, {"neo-hookean", Branch::ii, J, {1.0, 2.0}, 0.5}, 0.2, 0.8},
      {EventType::shear, {"biot-log", Branch::iii, J, {1.0, 4.0}, 1.2}, 1.15, 1.3}};
  for (const Turning& each : all) {
    const FamilyParameter J2{Kind::inertia, 1};
    const Numbers& numbers = each.numbers;
    // An ellipse that is far from a circle, or the only motion there is.
    const SearchResult found = search(numbers.problem().problem, numbers.nu);
    const auto shape = [](const Equilibrium& at) {
      return std::abs(std::log(at.q.xi / at.q.zeta));
    };
    const auto start = std::ranges::max_element(found.solutions, {}, shape);
    ASSERT_NE(start, found.solutions.end());
    const Followed sheet =
        followed(axis_family(numbers.problem().problem, {.nu = numbers.nu, .parameter = J2}),
                 start->q, numbers.J[1], range(0.9, 1.1));
    const auto events = sheet.events({each.type});
    ASSERT_EQ(events.size(), 1U) << sheet.text();
    const EventCurve curve = follow_event_curve(
        setting(numbers, each.type, J2, {}), events[0].member, numbers.nu, Circle::none,
        {.first_from = 0.5, .first_to = 1.5, .second_from = each.from, .second_to = each.to});
    ASSERT_EQ(curve.failure, "");
    ASSERT_GE(curve.points.size(), 3U);
    EXPECT_EQ(curve.points.front().second, each.from);
    EXPECT_EQ(curve.points.back().second, each.to);
    for (const EventCurvePoint& point : curve.points) {
      EXPECT_NEAR(point.member.parameter, 1.0, 1e-14);
      const Numbers there = numbers.with(J2, 1.0);
      const Equilibrium own =
          solve(there.problem().problem, point.second, {.start = point.member.q, .search = false});
      ASSERT_EQ(own.status, SolveStatus::solved) << name(each.type) << " " << point.second;
      if (each.type == EventType::oblique) {
        EXPECT_LE(relative(point.member.q.xi, own.q.xi), 1e-12);
        EXPECT_LE(relative(point.member.q.zeta, own.q.zeta), 1e-12);
      }
      EXPECT_LE(relative(point.member.q.rho, own.q.rho), 1e-12);
    }
  }
}

/// Follows the curve of each event of a family and, at some of its points, the family anew: the
/// event has to be there.
void compare_events(const Numbers& numbers, double nu, const SolveOptions& start_at,
                    const FamilyParameter& second, double from, double to,
                    std::map<EventType, int>& compared) {
  const FollowOptions family = range(0.0, 2.5, 1e-6);
  const double own_value = Numbers(numbers).at(second);
  const Followed own = followed(numbers.problem().problem, nu, family, true, start_at);
  for (const FollowedRow& row : own.events()) {
    if (!has_event_curve(row.event, true, true) || compared[row.event] >= 20) continue;
    const EventCurveOptions options{.first_from = 0.01,
                                    .first_to = 2.5,
                                    .second_from = from,
                                    .second_to = to,
                                    .tolerance = 1e-6,
                                    .spectrum = false};
    const EventCurve curve = follow_event_curve(setting(numbers, row.event, {}, second), row.member,
                                                own_value, Circle::none, options);
    ASSERT_EQ(curve.failure, "") << numbers.model << " " << name(row.event);
    for (std::size_t k = 0; k < curve.points.size();
         k += std::max<std::size_t>(1, curve.points.size() / 4)) {
      const EventCurvePoint& point = curve.points[k];
      const Problem there = numbers.with(second, point.second).problem().problem;
      // From the event's own stretches: the family may have other sheets.
      SolveOptions beside = start_at;
      beside.start = point.member.q;
      beside.search = false;
      const double p = point.member.parameter;
      Followed again;
      for (const double near : {p * (1.0 - 1e-4), p * (1.0 + 1e-4)}) {
        if (solve(there, near, beside).status != SolveStatus::solved) continue;
        again = followed(there, near, family, true, beside);
        break;
      }
      double nearest = 1.0;
      for (const FollowedRow& each : again.events({row.event}))
        nearest = std::min(nearest, relative(each.member.parameter, p));
      EXPECT_LE(nearest, 1e-12) << numbers.model << " (" << name(numbers.branch) << ") "
                                << name(row.event) << " at " << point.second << ", " << p;
      ++compared[row.event];
    }
  }
}

/// The events of the family in p1 at values of p2 that the curves' points have.
TEST(EventCurve, AgreesWithEventsAtSingleValues) {
  std::map<EventType, int> compared;
  for (const std::string_view model : {"neo-hookean", "neo-hookean-3d", "hencky", "biot-log"})
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii})
      compare_events({.model = model, .branch = branch}, 0.0, {}, {Kind::inertia, 1}, 1.5, 1.9,
                     compared);
  // Frequencies that meet and pass.
  const Numbers broken{.model = "neo-hookean",
                       .branch = Branch::iii,
                       .J = {1.046, 0.972, 0.234},
                       .plane = {0.0525, 2.3792},
                       .axial = {0.591, 1.917}};
  compare_events(broken, 0.35, {.start = Stretch{0.0, 0.9949, 1.0604, 0.6755}}, {Kind::inertia, 2},
                 0.22, 0.25, compared);
  int all = 0;
  std::string types;
  for (const auto& [type, count] : compared) {
    all += count;
    types += std::string(name(type)) + " " + std::to_string(count) + "; ";
  }
  EXPECT_GE(all, 80) << types;
  EXPECT_GE(compared.size(), 6U) << types;
}

}  // namespace
}  // namespace stationary::testing
