// Two-polar motions: the table of independently computed rows at given rates and at given momenta,
// theta' -> 0 as branch (iii), duality, lines of solutions, the circle.
#include "solver/solve/two_polar_equilibrium.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "solver/search/two_polar_search.hpp"
#include "solver/solve/stability.hpp"
#include "tests/support/reference_table.hpp"

namespace stationary {
namespace {

using support::nearest;
using support::Real50;
using support::reference_table;
using support::ReferenceRow;

Potential potential(const char* model, double p1, double p2, double a = 1.0, double b = 3.0) {
  const double plane[] = {p1, p2};
  const double thickness[] = {a, b};
  return {Potential::planar(model, plane), Potential::thickness("reciprocal-quadratic", thickness)};
}

void expect_row(const ReferenceRow& row, const Body& body, const Potential& V,
                const Equilibrium& found) {
  ASSERT_EQ(found.status, SolveStatus::solved) << row.where() << ": " << found.message;
  EXPECT_FALSE(found.circle);
  const char* names[] = {"lambda", "mu", "rho"};
  for (int k = 0; k < 3; ++k) {
    const auto exact = row.number<Real50>(names[k]);
    const double error = nearest(Real50(abs(Real50(diagonal(found.q)[k]) - exact) / exact));
    EXPECT_LE(error, 4e-15) << row.where() << " " << names[k];
    EXPECT_LE(error, found.error_bound) << row.where() << " " << names[k];
  }
  const Spectrum spectrum = two_polar_stability(body, V, found);
  ASSERT_EQ(spectrum.modes, 4) << row.where();
  double size = 0.0;
  for (int k = 0; k < 4; ++k)
    size = std::max(size, std::abs(spectrum.mode[static_cast<std::size_t>(k)].lambda_re));
  int real_pairs = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto re = row.number<Real50>("re" + std::to_string(k + 1));
    const auto im = row.number<Real50>("im" + std::to_string(k + 1));
    real_pairs += re > 0;
    const Mode& m = spectrum.mode[k];
    const double error = nearest(Real50(abs(Real50(m.lambda_re) - (re * re - im * im))));
    EXPECT_LE(error, 1e-13 * size) << row.where() << " mode " << k + 1;
    EXPECT_LE(error, 1e-11 * std::abs(m.lambda_re)) << row.where() << " mode " << k + 1;
    EXPECT_LE(error, m.lambda_error) << row.where() << " mode " << k + 1;
  }
  EXPECT_EQ(spectrum.verdict == StabilityClass::unstable, real_pairs > 0) << row.where();
}

TEST(TwoPolarTable, EveryRowByRatesAndByMomenta) {
  const auto rows = reference_table("two_polar.csv");
  ASSERT_EQ(rows.size(), 4U);
  for (const ReferenceRow& row : rows) {
    const auto value = [&](const char* column) { return row.number<double>(column); };
    const Body body(value("J"), value("J"), value("J3"));
    const Potential V =
        potential(row.text("model").c_str(), value("v1"), value("v2"), value("a"), value("b"));
    const Equilibrium by_rates =
        solve_two_polar(body, V, TwoPolarRates<double>{value("omega"), value("theta_dot")});
    expect_row(row, body, V, by_rates);
    const Equilibrium by_momenta = solve_two_polar(body, V, by_rates.two_polar->momenta);
    expect_row(row, body, V, by_momenta);
    EXPECT_NEAR(by_momenta.two_polar->rates.omega, value("omega"), 1e-14);
    EXPECT_NEAR(by_momenta.two_polar->rates.theta_dot, value("theta_dot"), 1e-14);
  }
}

TEST(TwoPolar, WithoutThetaDotIsBranchThree) {
  // An ellipse of (iii) at J1 = J2: its planar modes and wobble are those of the two-polar motion
  // at theta' = 0, whose leaf has no zero pair.
  const Body body(1.0, 1.0, 1.5);
  const Potential V = potential("biot-log", 1.0, 4.0, 0.8, 1.3);
  const double omega = 1.2;
  const Equilibrium at = solve_two_polar(body, V, TwoPolarRates<double>{omega, 0.0});
  ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
  ASSERT_FALSE(at.circle) << at.message;
  SolveOptions near;
  near.start = at.q;
  const Problem three(body, V, Branch::iii);
  const Equilibrium same = solve(three, omega, near);
  ASSERT_EQ(same.status, SolveStatus::solved) << same.message;
  EXPECT_NEAR(same.q.xi, at.q.xi, 4e-15 * at.q.xi);
  EXPECT_NEAR(same.q.zeta, at.q.zeta, 4e-15 * at.q.zeta);
  const Spectrum two_polar = two_polar_stability(body, V, at);
  const Spectrum ellipse = stability(three, same);
  ASSERT_EQ(two_polar.modes, 4);
  ASSERT_EQ(ellipse.modes, 5);
  EXPECT_TRUE(ellipse.mode[0].forced_zero);
  for (std::size_t k = 0; k < 4; ++k) {
    const Mode& a = two_polar.mode[k];
    const Mode& b = ellipse.mode[k + 1];
    EXPECT_NEAR(a.lambda_re, b.lambda_re, a.lambda_error + b.lambda_error) << k;
    EXPECT_EQ(a.krein, b.krein) << k;
  }
  EXPECT_EQ(two_polar.verdict, ellipse.verdict);
}

TEST(TwoPolar, ExchangingTheRatesKeepsTheStretches) {
  const Body body(0.8, 0.8, 2.3);
  const Potential V = potential("saint-venant-kirchhoff", 0.9, 2.1, 1.1, 1.5);
  const auto one = solve_two_polar(body, V, TwoPolarRates<double>{1.2, -0.35});
  const auto other = solve_two_polar(body, V, TwoPolarRates<double>{-0.35, 1.2});
  ASSERT_EQ(one.status, SolveStatus::solved);
  ASSERT_EQ(other.status, SolveStatus::solved);
  EXPECT_EQ(diagonal(one.q), diagonal(other.q));
  EXPECT_EQ(one.two_polar->momenta.s3, other.two_polar->momenta.p_theta);
}

/// At nu = omega + theta' = 1 branch (iii) has a line of ellipses, the circle among them, where J nu^2 = mu; of these
/// rates there are none, and the circle is alone: x - 1/x + 4 ln x/x = x.
TEST(TwoPolar, ACircleIsFoundWhereTheSpinHasALineOfEllipses) {
  const Body body(1.0, 1.0, 0.6);
  const auto found =
      solve_two_polar(body, potential("neo-hookean", 1.0, 2.0), TwoPolarRates<double>{0.5, 0.5});
  ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
  EXPECT_TRUE(found.circle);
  EXPECT_NEAR(found.q.xi, std::exp(0.25), 1e-15);
  EXPECT_EQ(found.q.xi, found.q.zeta);
}

/// From a start on it, a little off, without a search.
TEST(TwoPolar, AStartOnACircleLeadsToIt) {
  const Body body(1.0, 1.0, 0.6);
  const Potential V = potential("neo-hookean", 1.0, 2.0);
  const TwoPolarRates<double> rates{0.5, 0.5};
  const auto found = solve_two_polar(body, V, rates);
  SolveOptions near{.method = Method::newton, .start = found.q};
  near.start->xi *= 1.0 + 1e-4;
  near.start->zeta = near.start->xi;
  const auto again = solve_two_polar(body, V, rates, near);
  ASSERT_EQ(again.status, SolveStatus::solved) << again.message;
  EXPECT_TRUE(again.circle);
  EXPECT_EQ(again.q.xi, found.q.xi);
  EXPECT_EQ(again.q.rho, found.q.rho);
  EXPECT_EQ(again.counts.walk_steps, 0);
}

TEST(TwoPolar, LinesOfSolutionsAreSaidNotSampled) {
  const Body body(1.0, 1.0, 0.6);
  // J (omega^2 + theta'^2) = 0.36 + 0.64 = 1 and J (omega - theta')^2 = 4 exactly.
  const TwoPolarRates<double> unit{1.0, 0.0};
  const TwoPolarRates<double> slip{1.5, -0.5};
  for (const auto& [V, rates] : {std::pair{potential("reciprocal-determinant", 1.0, 1.0), unit},
                                 std::pair{potential("neo-hookean", 1.0, 2.0), unit},
                                 std::pair{potential("biot", 2.0, 1.0), slip}}) {
    const auto found = solve_two_polar(body, V, rates);
    EXPECT_EQ(found.status, SolveStatus::not_isolated) << found.message;
    EXPECT_NE(found.message.find("prescribe s3 and p_theta"), std::string::npos);
    EXPECT_TRUE(std::isnan(found.q.xi));
    // Off the line there is the circle only, and it is named.
    const auto circle =
        solve_two_polar(body, V, TwoPolarRates<double>{0.3 * rates.omega, 0.3 * rates.theta_dot});
    ASSERT_EQ(circle.status, SolveStatus::solved) << circle.message;
    EXPECT_TRUE(circle.circle);
    EXPECT_EQ(circle.q.xi, circle.q.zeta);
    EXPECT_NE(circle.message.find("circle"), std::string::npos);
    EXPECT_EQ(two_polar_stability(body, V, circle).modes, 5);
  }
}

TEST(TwoPolar, AnEllipseOfALineIsFoundByItsMomenta) {
  // The line of reciprocal-determinant: J (omega^2 + theta'^2) = k.
  const Body body(1.0, 1.0, 0.6);
  const Potential V = potential("reciprocal-determinant", 1.0, 1.0);
  const auto found = solve_two_polar(body, V, TwoPolarMomenta<double>{2.0, -1.5});
  ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
  EXPECT_GT(found.q.xi, found.q.zeta);
  EXPECT_NEAR(found.two_polar->rates.omega * found.two_polar->rates.omega +
                  found.two_polar->rates.theta_dot * found.two_polar->rates.theta_dot,
              1.0, 1e-14);
}

TEST(TwoPolar, WithoutSpinMomentumThereIsNoWobble) {
  const Body body(1.0, 1.0, 0.6);
  const Potential V = potential("reciprocal-determinant", 1.0, 1.0);
  const auto found = solve_two_polar(body, V, TwoPolarMomenta<double>{0.0, 2.0});
  ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
  EXPECT_EQ(two_polar_stability(body, V, found).modes, 3);
}

/// At these rates the balance is nearly singular, at these momenta it is not. True: 60 digits.
TEST(TwoPolar, ModesOfPrescribedMomentaAreWithinTheirBounds) {
  const Body body(1.0, 1.0, 0.6);
  BodyModel<> model;
  model.elastic.coupled = NeoHookean3d<>{1.0, 2.0};
  model.gravitates = true;
  model.g = 1e-4;
  model.J = {body.J1, body.J2, body.J3};
  const Potential V(model);
  const Equilibrium at = solve_two_polar(body, V, TwoPolarMomenta<double>{1.7, 0.4});
  ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
  const Spectrum found = two_polar_stability(body, V, at);
  ASSERT_EQ(found.modes, 4);
  EXPECT_NEAR(found.growth, 0.54454133029117537, 1e-13);
  const double im[] = {1.7072026866042355, 2.549015578027123, 3.6440091092484964};
  for (std::size_t k = 0; k < 3; ++k) {
    const Mode& mode = found.mode[k + 1];
    EXPECT_NEAR(mode.lambda_re, -im[k] * im[k], mode.lambda_error + 1e-14);
    EXPECT_LE(mode.lambda_error, 6e-13);
  }
}

/// Rates that all but cancel: half a unit of each counts once.
TEST(TwoPolar, BoundsOfModesAreNoWiderThanTheInputsAre) {
  const Body body(1.9658510969683916, 1.9658510969683916, 0.6);
  const Potential V = potential("neo-hookean", 1.0897329732036185, 2.221256505311472, 1.1, 1.5);
  const Equilibrium circle =
      solve_two_polar(body, V, TwoPolarRates<double>{0.5048329639385584, -0.5048329639384562});
  ASSERT_EQ(circle.status, SolveStatus::solved) << circle.message;
  ASSERT_TRUE(circle.circle);
  EXPECT_EQ(two_polar_stability(body, V, circle).verdict, StabilityClass::stable);
}

TEST(TwoPolar, MisuseThrows) {
  const Potential V = potential("biot", 1.0, 1.0);
  EXPECT_THROW(solve_two_polar(Body(1.0, 1.1, 1.0), V, TwoPolarRates<double>{1.0, 0.0}),
               std::invalid_argument);
  EXPECT_THROW(solve_two_polar(Body(1.0, 1.0, 1.0), V, TwoPolarRates<double>{1.0, std::nan("")}),
               std::invalid_argument);
  EXPECT_THROW(two_polar_stability(Body(1.0, 1.0, 1.0), V, Equilibrium{}), std::invalid_argument);
}

double from_unit(const Equilibrium& at) { return diagonal(at.q).array().log().abs().maxCoeff(); }

/// Of several ellipses at the same rates the answer is the one nearest to the unit stretches; the
/// other method comes to one of them.
TEST(TwoPolar, TheAnswerIsTheNearestEllipseOfAll) {
  const Body body(1.25, 1.25, 0.6);
  struct Given {
    const char* model;
    double lambda;
    TwoPolarRates<double> rates;
  };
  const Given given[] = {{"hencky", 3.0, {0.6, -0.05}}, {"hencky", 3.0, {0.6, 0.0}},
                         {"hencky", 3.0, {0.65, 0.02}}, {"biot-log", 0.6, {1.2, 0.0}},
                         {"biot-log", 1.0, {1.2, 0.0}}, {"biot-log", 3.0, {1.2, 0.1}},
                         {"biot-log", 3.0, {1.2, 0.3}}};
  int several = 0;
  int not_the_first = 0;
  int by_seeds = 0;
  for (const auto& [model, lambda, rates] : given) {
    const Potential V = potential(model, 1.0, lambda);
    std::vector<double> ellipses;  // how far from the unit stretches
    for (const Equilibrium& each : search_two_polar(body, V, rates, {}).solutions)
      if (!each.circle) ellipses.push_back(from_unit(each));
    ASSERT_FALSE(ellipses.empty());
    const double nearest_one = *std::ranges::min_element(ellipses);
    const Equilibrium found = solve_two_polar(body, V, rates);
    ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
    ASSERT_FALSE(found.circle);
    EXPECT_EQ(found.message.rfind("exhaustive search", 0), 0U) << found.message;
    EXPECT_NEAR(from_unit(found), nearest_one, 1e-12);
    several += ellipses.size() > 1 ? 1 : 0;
    not_the_first += ellipses.front() > nearest_one + 1e-6 ? 1 : 0;

    SolveOptions how;
    how.method = Method::nlopt;
    const Equilibrium seeded = solve_two_polar(body, V, rates, how);
    if (seeded.status != SolveStatus::solved || seeded.circle) continue;
    EXPECT_EQ(seeded.message, "global search, then Newton");
    const bool known = std::ranges::any_of(
        ellipses, [&](double each) { return std::abs(each - from_unit(seeded)) < 1e-12; });
    EXPECT_TRUE(known);
    ++by_seeds;
  }
  EXPECT_GT(several, 2);
  EXPECT_GT(not_the_first, 0);
  EXPECT_GT(by_seeds, 2);
}

/// Momenta that are nearly equal hold a body near the circle, whose rates move far by the rounding of lambda - mu: the
/// modes are those of the momenta, and their bounds know it. True values by an independent computation in 60 digits.
TEST(TwoPolarStability, OfNearlyEqualMomenta) {
  struct Known {
    double J3;
    double lambda;  ///< s^2 of the slowest mode
    StabilityClass verdict;
  };
  const Potential V{NeoHookean<>{0.35, 0.2219}, Harmonic<>{2.0, 1.0}};
  const TwoPolarMomenta<double> momenta{4.4989564750550635, 4.498956491942817};
  for (const Known& known :
       {Known{1054.2203107151793, -2.7837e-11 * 2.7837e-11, StabilityClass::stable},
        Known{1054.2207831677028, 2.7831e-11 * 2.7831e-11, StabilityClass::unstable}}) {
    const Body body(0.5141, 0.5141, known.J3);
    const Equilibrium found = solve_two_polar(body, V, momenta);
    ASSERT_EQ(found.status, SolveStatus::solved);
    ASSERT_FALSE(found.circle);
    const Spectrum spectrum = two_polar_stability(body, V, found);
    EXPECT_TRUE(spectrum.verdict == known.verdict || spectrum.verdict == StabilityClass::marginal)
        << name(spectrum.verdict);
    const Mode& slowest = spectrum.mode[0];
    EXPECT_LE(std::abs(slowest.lambda_re - known.lambda),
              slowest.lambda_error + 1e-3 * std::abs(known.lambda));
  }
  const Body body(0.2382, 0.2382, 20.42);
  const Potential hencky{Hencky<>{0.2909, 1.618}, ReciprocalQuadratic<>{0.5923, 0.3524}};
  const Equilibrium found = solve_two_polar(
      body, hencky, TwoPolarMomenta<double>{0.045407050532038945, 0.045406994352246446});
  ASSERT_EQ(found.status, SolveStatus::solved);
  const Spectrum spectrum = two_polar_stability(body, hencky, found);
  int compared = 0;
  for (const double im : {0.82557059597824541, 3.1181126890725320})
    for (int k = 0; k < spectrum.modes; ++k) {
      const Mode& mode = spectrum.mode[static_cast<std::size_t>(k)];
      if (std::abs(mode.im - im) > 1e-6) continue;
      ++compared;
      EXPECT_LE(std::abs(mode.lambda_re + im * im), mode.lambda_error + 1e-15 * im * im) << im;
      EXPECT_LE(mode.lambda_error, 1e-9);
    }
  EXPECT_EQ(compared, 2);
}

}  // namespace
}  // namespace stationary
