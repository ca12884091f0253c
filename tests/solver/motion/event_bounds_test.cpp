// What rows claim of themselves where the balance alone is near singular: events of stiff bodies,
// rows beside an asymptote, brackets; and events and ends where a family meets another.
#include <gtest/gtest.h>

#include <numbers>

#include "solver/family/anisotropic_family.hpp"
#include "solver/family/two_polar_family.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "solver/solve/two_polar_equilibrium.hpp"
#include "tests/support/followed.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::testing {
namespace {

using Real50 = Number50;

/// Relative to the exact value.
double error_of(double x, const Real50& exact) {
  return std::abs(((Real50(x) - exact) / exact).convert_to<double>());
}

const EventRecord* record_of(const Followed& sheet, EventType type) {
  const auto at = std::ranges::find(sheet.report.events, type, &EventRecord::type);
  return at == sheet.report.events.end() ? nullptr : &*at;
}

void expect_holds(const EventRecord& record, const Real50& exact) {
  EXPECT_EQ(record.status, EventStatus::located);
  EXPECT_LE(Real50(record.before), exact);
  EXPECT_LE(exact, Real50(record.after));
}

/// (i), hencky: zeta = sqrt(e), nu^2 = 2 mu (mu + lambda)/((2 mu + lambda) e J2), however stiff.
TEST(EventBounds, HoldAtTheFoldsOfStiffBodies) {
  for (const double lambda : {1.0, 1e2, 1e4, 1e7, 1e10}) {
    const Problem problem(Body(1.0, 1.0, 1.0),
                          Potential(PlanarPotential(Hencky<>{1.0, lambda}),
                                    ThicknessPotential(Harmonic<>{100.0, 1.0})),
                          Branch::i);
    const Followed sheet = followed(problem, 0.1, range(0.0, 3.0));
    const auto folds = sheet.events({EventType::fold_nu});
    ASSERT_EQ(folds.size(), 1U) << lambda << ": " << sheet.text();
    const Real50 e = exp(Real50(1));
    const double error = error_of(folds[0].member.q.zeta, sqrt(e));
    EXPECT_LE(error, folds[0].member.error_bound) << lambda;
    EXPECT_LE(folds[0].member.error_bound, 1e-14 * std::max(1.0, 1e-6 * lambda)) << lambda;
    const Real50 stiff(lambda);
    expect_holds(*record_of(sheet, EventType::fold_nu), sqrt(2 * (1 + stiff) / ((2 + stiff) * e)));
  }
}

/// A tilt close to collapse: the two inertias are equal as far as the bound says.
TEST(EventBounds, HoldAtATiltNearCollapse) {
  const Body body(8.095, 4.791, 0.0010712);
  const Problem problem(body,
                        Potential(PlanarPotential(SaintVenantKirchhoff<>{0.021762, 4.7164}),
                                  ThicknessPotential(ReciprocalQuadratic<>{0.10089, 48.509})),
                        Branch::ii);
  const Followed sheet = followed(problem, 0.042128, range(0.0, 0.226384));
  const auto tilts = sheet.events({EventType::tilt});
  ASSERT_EQ(tilts.size(), 1U) << sheet.text();
  const Member& at = tilts[0].member;
  EXPECT_LE(at.error_bound, 1e-14);
  const Vector3<double> m = second_moments(body, at.q);
  const double apart = std::min(std::abs(m[1] / m[2] - 1.0), std::abs(m[0] / m[2] - 1.0));
  EXPECT_LE(apart, 4.0 * at.error_bound + 8.0 * 0x1p-52);
}

/// (iii), neo-hookean-3d, on the circle: rho gives xi and nu in closed form,
///   xi^2 = exp((mu - mu rho^2)/lambda)/rho,  J nu^2 = mu - mu rho^2/xi^2.
TEST(EventBounds, RowsHoldNearEscape) {
  const Real50 mu("0.019223");
  const Real50 lambda("12.011");
  const Real50 J("245.05");
  const Problem problem(Body(245.05, 245.05, 1.5486),
                        Potential(CoupledPotential(NeoHookean3d<>{0.019223, 12.011})), Branch::iii);
  const Followed sheet = followed(problem, 0.004, range(0.0, 0.15, 1e-4));
  const auto xi2 = [&](const Real50& rho) -> Real50 {
    return exp((mu - mu * rho * rho) / lambda) / rho;
  };
  double least = 1.0;
  int rows = 0;
  for (const FollowedRow& row : sheet.rows) {
    const Member& at = row.member;
    if (at.parameter == 0.0 || at.q.xi != at.q.zeta) continue;
    const Real50 square = Real50(at.parameter) * at.parameter * J;
    const auto f = [&](const Real50& rho) -> Real50 {
      return mu - mu * rho * rho / xi2(rho) - square;
    };
    Real50 rho(at.q.rho);
    for (int k = 0; k < 60; ++k) {
      const Real50 h = rho * Real50("1e-20");
      rho -= f(rho) * 2 * h / (f(rho + h) - f(rho - h));
    }
    if (row.event == EventType::none || is_end(row.event)) {
      const double error = std::max(error_of(at.q.xi, sqrt(xi2(rho))), error_of(at.q.rho, rho));
      EXPECT_LE(error, at.error_bound) << at.parameter << ", rho " << at.q.rho;
      least = std::min(least, at.q.rho);
      ++rows;
    }
  }
  EXPECT_GE(rows, 10);
  EXPECT_LE(least, 0.02);
  EXPECT_EQ(sheet.report.forward.event, EventType::escape) << sheet.report.forward.reason;
}

/// (ii), reciprocal-determinant: I1 = I2 at nu^2 = k (1 - J1/J2)/J1, for the decimals given; J2 -
/// J1 is some units in the last place.
TEST(EventBounds, TheBracketHoldsWhatTheDecimalsMean) {
  const Problem problem(Body(2.0515, 2.051500000000002, 1.0853),
                        Potential(PlanarPotential(ReciprocalDeterminant<>{0.58953, 1.0067}),
                                  ThicknessPotential(ReciprocalQuadratic<>{0.57979, 0.37102})),
                        Branch::ii);
  const Followed sheet = followed(problem, 0.0, range(0.0, 0.1));
  const auto* record = record_of(sheet, EventType::inertia_exchange);
  ASSERT_NE(record, nullptr) << sheet.text();
  const Real50 J1("2.0515");
  const Real50 J2("2.051500000000002");
  expect_holds(*record, sqrt(Real50("1.0067") * (1 - J1 / J2) / J1));
}

/// A family that starts where its parameter passes J1 = J2 starts at that event.
TEST(EventBounds, AStartAtEqualInertiasIsOblique) {
  const Problem problem(Body(1.3805, 1.3805, 1.2313),
                        Potential(PlanarPotential(SaintVenantKirchhoff<>{0.93787, 0.71617}),
                                  ThicknessPotential(ReciprocalQuadratic<>{2.822, 0.51625})),
                        Branch::ii);
  const Equilibrium at = solve(problem, 0.58907);
  ASSERT_EQ(at.status, SolveStatus::solved);
  AxisFamilyOptions how;
  how.nu = 0.58907;
  how.parameter = {FamilyParameter::Kind::inertia, 0};
  const Followed sheet = followed(axis_family(problem, how), at.q, 1.3805, range(1.1424, 5.4996));
  const auto found = sheet.events({EventType::oblique, EventType::unexplained});
  ASSERT_EQ(found.size(), 1U) << sheet.text();
  EXPECT_EQ(found[0].event, EventType::oblique);
  EXPECT_EQ(found[0].member.parameter, 1.3805);
}

/// The circle is one motion of (iii) for all rates of one sum: where its ellipse branches off, at
/// omega + theta' = sqrt(2 mu/J) for biot, is an event at any rates.
TEST(EventBounds, TheTwoPolarCircleHasTheEventsOfItsOwnSpin) {
  const Body body(0.32205, 0.32205, 0.52404);
  const Potential potential(PlanarPotential(Biot<>{0.48276, 0.57797}),
                            ThicknessPotential(ReciprocalQuadratic<>{0.81579, 1.4281}));
  const TwoPolarMotion motion = TwoPolarRates<double>{0.55058, 0.87327};
  SolveOptions round;
  const Equilibrium circle = solve(Problem(body, potential, Branch::iii), 0.55058 + 0.87327, round);
  ASSERT_EQ(circle.status, SolveStatus::solved) << circle.message;
  ASSERT_EQ(circle.q.xi, circle.q.zeta);
  const Followed sheet =
      followed(two_polar_family(body, potential, {motion, {FamilyParameter::Kind::nu, 0}}),
               circle.q, 0.55058, range(-0.31, 1.33, 1e-6));
  const Real50 sum = sqrt(2 * Real50("0.48276") / Real50("0.32205"));
  bool found = false;
  for (const EventRecord& record : sheet.report.events) {
    if (record.type != EventType::ellipse) continue;
    const Real50 omega = sum - Real50("0.87327");
    found = found || (Real50(record.before) <= omega && omega <= Real50(record.after));
  }
  EXPECT_TRUE(found) << sheet.text();
}

/// At given momenta the ellipses come to the circle where these are equal.
TEST(EventBounds, EllipsesOfGivenMomentaEndAtTheCircle) {
  const Body body(1.3995, 1.3995, 1.0077);
  const Potential potential(PlanarPotential(Hencky<>{0.73499, 0.79982}),
                            ThicknessPotential(Harmonic<>{0.91293, 1.523}));
  const TwoPolarMotion motion = TwoPolarMomenta<double>{0.79801, 1.87};
  const Equilibrium at = solve_two_polar(body, potential, motion);
  ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
  const Followed sheet =
      followed(two_polar_family(body, potential, {motion, {FamilyParameter::Kind::nu, 0}}), at.q,
               0.79801, range(0.0082, 1.942, 1e-6));
  const SheetEnd& end = sheet.report.forward;
  EXPECT_EQ(end.event, EventType::ellipse) << end.reason;
  const Member& last = sheet.rows.back().member;
  EXPECT_EQ(last.parameter, 1.87);
  EXPECT_EQ(last.q.xi, last.q.zeta);
}

/// J1 = J2: at rest no axis of the plane is preferred, and a family still ends there.
TEST(EventBounds, AnObliqueFamilyOfEqualInertiasReachesRest) {
  const Body body(0.49097, 0.49097, 0.42202);
  const AnisotropicPotential V(NeoHookean<>{0.79064, 0.68731},
                               ThicknessPotential(ReciprocalQuadratic<>{2.1725, 0.8046}),
                               {{0.17617, -23.673}});
  const Equilibrium at = solve_oblique(body, Potential(V), {0.3, Branch::i});
  ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
  const AnyFamily family = oblique_family(body, V, {.nu = 0.0, .parameter = {}, .spectrum = true});
  const Followed sheet = followed(family, at.q, 0.3, range(0.0, 0.35, 1e-7));
  EXPECT_EQ(sheet.report.backward.event, EventType::limit) << sheet.report.backward.reason;
  const Member& rest = sheet.rows.front().member;
  EXPECT_EQ(rest.parameter, 0.0);
  EXPECT_EQ(rest.angular_velocity.norm(), 0.0);
  EXPECT_LE(rest.residual, 1e-14);
}

}  // namespace
}  // namespace stationary::testing
