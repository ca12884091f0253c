// Curves of events of anisotropic bodies and of tilted, oblique and two-polar motions: against events
// located at single values of the second parameter.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "solver/event_curve/event_curve.hpp"
#include "solver/kind/kind.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"

namespace stationary::testing {
namespace {

using Kind = FamilyParameter::Kind;

double relative_distance(double a, double b) { return std::abs(a - b) / std::abs(b); }

/// Of an anisotropic body: where its axis leaves its own, its ellipse turns away, inertias are equal
/// and frequencies meet, in nu and another number, against the family followed anew.
TEST(EventCurve, OfAnisotropicBodiesAgreesWithEventsAtSingleValues) {
  struct Numbered {
    AnisotropicPotential::Plane plane;
    Branch branch;
    std::array<double, 3> J;
    Fibre fibre;
    FamilyParameter second;
    double from;  ///< of it
    double to;
    double low;  ///< of nu
    double high;
    std::optional<double> volume{};
  };
  const FamilyParameter stiffness{Kind::fibre, 0};
  const FamilyParameter J2{Kind::inertia, 1};
  const std::array<double, 3> disc{1.0, 1.7, 0.6};
  const std::array<double, 3> plate{1.0, 1.2, 0.6};
  const Numbered all[] = {
      {NeoHookean<>{1.0, 2.0}, Branch::i, disc, {0.4, 0.0}, stiffness, 0.3, 0.5, 0.5, 0.8},
      {NeoHookean<>{1.0, 2.0}, Branch::i, disc, {0.4, 0.0}, J2, 1.6, 1.8, 0.5, 0.8},
      {Hencky<>{1.0, 0.6}, Branch::iii, plate, {0.05, 90.0}, J2, 1.18, 1.22, 0.5, 0.75},
      {Hencky<>{1.0, 0.6}, Branch::iii, plate, {0.05, 90.0}, stiffness, 0.045, 0.055, 0.5, 0.75},
      {Hencky<>{1.0, 0.6}, Branch::i, disc, {0.5, 0.0}, stiffness, 0.4, 0.6, 0.2, 0.9},
      {Hencky<>{1.0, 0.6}, Branch::ii, {1.7, 1.0, 0.6}, {0.5, 90.0}, J2, 0.95, 1.05, 0.2, 0.9},
      {Hencky<>{1.0, 0.6}, Branch::i, disc, {0.5, 0.0}, J2, 1.6, 1.8, 0.2, 0.9, 1.0},
      {Biot<>{1.0, 2.0}, Branch::iii, disc, {0.5, 90.0}, stiffness, 0.45, 0.55, 0.1, 1.8}};
  std::map<EventType, int> compared;
  int held_volume = 0;
  for (const Numbered& each : all) {
    const bool of_fibre = each.second.kind == Kind::fibre;
    const auto at = [&](double nu, double second) {
      const double k = of_fibre ? second : each.fibre.k;
      AnisotropicPotential V(each.plane, ReciprocalQuadratic<>{1.0, 3.0},
                             {{k, each.fibre.degrees}});
      if (each.volume) {
        BodyTerms<double> held;
        held.volume = each.volume;
        V = V.with_body(held);
      }
      return SpinningProblem{
          {Body(each.J[0], of_fibre ? each.J[1] : second, each.J[2]), Potential(V), each.branch},
          nu};
    };
    const double own = of_fibre ? each.fibre.k : each.J[1];
    const FollowOptions family = range(each.low, each.high, 1e-6);
    const Followed sheet = followed(at(each.low, own).problem, each.low, family);
    for (const FollowedRow& row : sheet.events()) {
      const EventCurve curve = follow_event_curve(spin_setting(at, {}, each.second, row.event),
                                                  row.member, own, Circle::none,
                                                  {.first_from = each.low,
                                                   .first_to = each.high,
                                                   .second_from = each.from,
                                                   .second_to = each.to,
                                                   .tolerance = 1e-6});
      ASSERT_EQ(curve.failure, "") << name(row.event);
      for (const EventCurvePoint& point : curve.points) {
        const double p = point.member.parameter;
        const Problem there = at(p, point.second).problem;
        SolveOptions beside;
        beside.start = point.member.q;
        beside.search = false;
        const double near = p * (1.0 - 1e-4);
        const Followed again =
            followed(there, near, range(p * (1.0 - 1e-3), p * (1.0 + 1e-3)), true, beside);
        double nearest = 1.0;
        for (const FollowedRow& found : again.events({row.event}))
          nearest = std::min(nearest, relative_distance(found.member.parameter, p));
        EXPECT_LE(nearest, 1e-12) << name(row.event) << " at " << point.second << ", " << p;
        ++compared[row.event];
        held_volume += each.volume.has_value();
      }
    }
  }
  EXPECT_GE(compared[EventType::oblique], 6);
  EXPECT_GE(compared[EventType::shear], 6);
  EXPECT_GE(compared[EventType::hamiltonian_hopf], 6);
  EXPECT_GE(compared[EventType::real_collision], 6);
  EXPECT_GE(compared[EventType::krein_pass], 3);
  EXPECT_GE(held_volume, 6);
}

/// Motions of one kind in two numbers, of which the second is J_(k + 1), and where they are followed
/// in the first.
struct OtherMotions {
  std::string text;
  std::function<std::unique_ptr<stationary::Kind>(double J)> at;
  FamilyParameter first;
  int k;
  double own;   ///< J_(k + 1)
  double from;  ///< of the first
  double p;
  double to;
};

/// The event of the family of that J, followed anew from its solution, that is nearest to the
/// curve's point, relative; nothing where there is no solution.
std::optional<double> nearest_of_family(const OtherMotions& motions, const EventCurvePoint& point,
                                        EventType type) {
  const auto kind = motions.at(point.second);
  const Equilibrium start = kind->solve({});
  if (start.status != SolveStatus::solved) return std::nullopt;
  const Followed again = followed(kind->family(motions.first, {}, start.q), start.q, motions.p,
                                  range(motions.from, motions.to, 1e-6));
  double nearest = 1.0;
  for (const FollowedRow& row : again.events({type}))
    nearest = std::min(nearest, relative_distance(row.member.parameter, point.member.parameter));
  return nearest;
}

void compare_other_motions(const OtherMotions& motions, std::map<EventType, int>& compared,
                           std::map<EventType, int>& curves) {
  SCOPED_TRACE(motions.text);
  const auto kind = motions.at(motions.own);
  const Equilibrium start = kind->solve({});
  if (start.status != SolveStatus::solved) return;
  const AnyFamily family = kind->family(motions.first, {}, start.q);
  const Followed sheet =
      followed(family, start.q, motions.p, range(motions.from, motions.to, 1e-6));
  for (const FollowedRow& row : sheet.events()) {
    if (!has_event_curve(row.event, false, kind->potential().is_isotropic()) ||
        curves[row.event] >= 12 || std::abs(row.member.parameter) < 1e-2 * std::abs(motions.p))
      continue;
    EventCurveSetting setting;
    setting.family = [&](double, double J, bool spectrum) {
      return motions.at(J)->family(motions.first, {.spectrum = spectrum}, row.member.q);
    };
    setting.first = motions.first;
    setting.second = {Kind::inertia, motions.k};
    setting.type = row.event;
    const double p = row.member.parameter;
    const double reach = 0.5 * std::abs(p);
    const Circle kept = std::visit([](const auto& own) { return own->circle(); }, family);
    const Circle circle = is_on(kept, row.member.q) ? kept : Circle::none;
    const EventCurve curve = follow_event_curve(setting, row.member, motions.own, circle,
                                                {.first_from = std::max(motions.from, p - reach),
                                                 .first_to = std::min(motions.to, p + reach),
                                                 .second_from = 0.97 * motions.own,
                                                 .second_to = 1.03 * motions.own,
                                                 .tolerance = 1e-6});
    ASSERT_EQ(curve.failure, "") << name(row.event) << " at " << row.member.parameter;
    ++curves[row.event];
    ASSERT_GE(curve.points.size(), 2U);
    // What vanishes all along is no other event.
    for (const EventCurvePoint& each : curve.points)
      EXPECT_FALSE(each.special == SpecialPoint::double_event && each.other == row.event)
          << name(row.event) << " at " << each.second;
    for (const EventCurvePoint* point :
         {&curve.points.front(), &curve.points[curve.points.size() / 2], &curve.points.back()}) {
      // Where two events nearly meet, or |nu| is nearly none, which of the two it is hangs on rounding.
      if (point->member.error_bound > 1e-11) continue;
      // Ellipses end at the circle; beyond are their mirror images, and the same event of these.
      const Stretch& q = point->member.q;
      if (kept != Circle::none && circle == Circle::none && std::abs(q.xi - q.zeta) < 0.02 * q.xi)
        continue;
      const auto nearest = nearest_of_family(motions, *point, row.event);
      if (!nearest) continue;
      EXPECT_LE(*nearest, 1e-11) << name(row.event) << " at " << point->member.parameter << ", "
                                 << point->second;
      ++compared[row.event];
    }
  }
}

double& inertia_of(std::array<double, 3>& J, int k) { return J[static_cast<std::size_t>(k)]; }

TEST(EventCurve, OfTiltedMotions) {
  support::Random random(77);
  std::map<EventType, int> compared;
  std::map<EventType, int> curves;
  for (int i = 0; i < 250; ++i) {
    const Posed posed = random_problem(random, 1.0);
    const Body body = posed.problem.body();
    if (body.symmetric()) continue;
    const auto plane = random.integer(0, 1) == 0 ? TiltPlane::one_three : TiltPlane::two_three;
    const double nu = std::abs(posed.nu);
    const int k = i % 3;
    std::array<double, 3> J{body.J1, body.J2, body.J3};
    const double own = inertia_of(J, k);
    const auto at = [=, potential = posed.problem.potential()](double value) mutable {
      inertia_of(J, k) = value;
      return kind_of(Body(J[0], J[1], J[2]), potential, TiltedMotion{plane, nu});
    };
    compare_other_motions({posed.text, at, {}, k, own, 0.0, nu, 4.0 * nu}, compared, curves);
  }
  EXPECT_GE(compared[EventType::tilt], 20);
  EXPECT_GE(compared[EventType::fold_nu] + compared[EventType::fold_momentum], 6);
}

/// Of bodies with a fibre askew: the sheared motions of (iii), and those about an oblique axis.
TEST(EventCurve, OfBodiesWithAFibreAskew) {
  support::Random random(78);
  std::map<EventType, int> compared;
  std::map<EventType, int> curves;
  for (int i = 0; i < 60; ++i) {
    const std::array<double, 3> J{1.0, random.log_uniform(1.2, 2.0), random.log_uniform(0.4, 0.9)};
    const double lambda = random.log_uniform(1.0, 3.0);
    const AnisotropicPotential::Plane plane =
        i % 4 < 2 ? AnisotropicPotential::Plane(NeoHookean<>{1.0, lambda})
                  : AnisotropicPotential::Plane(Hencky<>{1.0, lambda});
    const Potential V(
        AnisotropicPotential(plane, ReciprocalQuadratic<>{1.0, 3.0},
                             {{random.log_uniform(0.1, 0.8), random.uniform(10.0, 80.0)}}));
    const int k = i % 3;
    const bool oblique = i % 2 == 0;
    const auto at = [=](double value) mutable {
      std::array<double, 3> varied = J;
      inertia_of(varied, k) = value;
      const Motion motion = oblique ? Motion(ObliqueRotation{.nu = 0.5, .near = Branch::i})
                                    : Motion(AxisRotation{Branch::iii, 0.5});
      return kind_of(Body(varied[0], varied[1], varied[2]), V, motion);
    };
    compare_other_motions(
        {std::to_string(i), at, {}, k, J[static_cast<std::size_t>(k)], 0.1, 0.5, 1.5}, compared,
        curves);
  }
  EXPECT_GE(compared[EventType::tilt], 20);
  EXPECT_GE(compared[EventType::fold_nu] + compared[EventType::fold_momentum], 6);
}

TEST(EventCurve, OfTwoPolarMotions) {
  support::Random random(79);
  std::map<EventType, int> compared;
  std::map<EventType, int> curves;
  for (int i = 0; i < 60; ++i) {
    const Potential V = testing::make_potential(
        "saint-venant-kirchhoff",
        std::array{random.log_uniform(0.5, 1.5), random.log_uniform(1.0, 3.0)},
        "reciprocal-quadratic", std::array{1.1, 1.5});
    const double J1 = random.log_uniform(0.7, 1.4);
    const double own = random.log_uniform(0.5, 2.5);
    const TwoPolarMotion motion =
        i % 2 == 0 ? TwoPolarMotion(TwoPolarRates<double>{1.2, random.uniform(-0.6, -0.1)})
                   : TwoPolarMotion(TwoPolarMomenta<double>{random.uniform(1.5, 3.0),
                                                            random.uniform(-1.5, -0.3)});
    const auto at = [=](double J3) { return kind_of(Body(J1, J1, J3), V, Motion(motion)); };
    const int varied = i % 2 == 0 ? 1 : 0;  // theta', s3
    const double p = std::visit(
        [&](const auto& numbers) {
          const auto& [first, second] = numbers;
          return varied == 0 ? first : second;
        },
        motion);
    compare_other_motions({std::to_string(i),
                           at,
                           {Kind::nu, varied},
                           2,
                           own,
                           i % 2 == 0 ? -0.9 : 0.5,
                           p,
                           i % 2 == 0 ? -0.02 : 6.0},
                          compared, curves);
  }
  EXPECT_GE(compared[EventType::ellipse], 6);
  EXPECT_GE(compared[EventType::tilt], 12);
}

/// What is no event of the family, or has no equations there, is said.
TEST(EventCurve, OfOtherMotionsWithoutEquations) {
  EXPECT_FALSE(has_event_curve(EventType::hamiltonian_hopf, false, true));
  EXPECT_FALSE(has_event_curve(EventType::oblique, false, false));
  EXPECT_FALSE(has_event_curve(EventType::zero_momentum, true, true));
  const Potential V = testing::make_potential("reciprocal-determinant", std::array{1.0, 2.0},
                                              "reciprocal-quadratic", std::array{1.0, 3.0});
  const auto at = [&](double J2) {
    return kind_of(Body(1.0, J2, 0.6), V, TiltedMotion{TiltPlane::one_three, 1.07});
  };
  const Equilibrium start = at(1.7)->solve({});
  ASSERT_EQ(start.status, SolveStatus::solved);
  const Followed sheet = followed(at(1.7)->family({}, {}, start.q), start.q, 1.07, range(1.0, 1.1));
  EventCurveSetting setting;
  setting.family = [&](double, double J2, bool spectrum) {
    return at(J2)->family({}, {.spectrum = spectrum}, start.q);
  };
  setting.second = {Kind::inertia, 1};
  setting.type = EventType::oblique;
  const EventCurve curve = follow_event_curve(setting, sheet.rows[1].member, 1.7, Circle::none, {});
  EXPECT_EQ(curve.failure, "the family has no equations for it");
  EXPECT_TRUE(curve.points.empty());
}

}  // namespace
}  // namespace stationary::testing
