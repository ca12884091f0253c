// Reasons why nothing exists: given exactly on the right side of each inequality, and never where a
// search finds a solution.
#include "solver/solve/nonexistence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/newton/newton.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary {
namespace {

using namespace testing;
using ::testing::HasSubstr;

constexpr double stiff = 1e6;  // a thickness that never gives out

std::optional<std::string> reason(std::string_view model, std::array<double, 2> c, Branch branch,
                                  double nu, const Body& body = plate, double b = stiff) {
  return nonexistence_reason(
      Problem(body, make_potential(model, c, "reciprocal-quadratic", {1.0, b}), branch), nu);
}

/// J nu^2 < limit in exact arithmetic.
bool below(double J, double nu, double limit) {
  return Number50(J) * Number50(nu) * Number50(nu) < Number50(limit);
}

/// Speeds on both sides of sqrt(limit/J), down to neighbouring doubles.
std::vector<double> around(double limit, double J) {
  const double end = std::sqrt(limit / J);
  std::vector<double> out{end, std::nextafter(end, 0.0), std::nextafter(end, 10.0 * end)};
  for (int k = 1; k <= 15; ++k) {
    out.push_back(end * (1.0 - std::pow(10.0, -k)));
    out.push_back(end * (1.0 + std::pow(10.0, -k)));
  }
  return out;
}

TEST(Existence, ReciprocalDeterminantEndsWhereItsStiffnessIsSpent) {
  const struct {
    Branch branch;
    Body body;
    double J;
    const char* says;
  } cases[] = {{Branch::i, plate, 1.7, "J2 nu^2"},
               {Branch::ii, plate, 1.0, "J1 nu^2"},
               {Branch::iii, plate, 1.7, "J2 nu^2"},
               {Branch::iii, {1.7, 1.0, 0.6}, 1.7, "J1 nu^2"}};
  for (const auto& c : cases) {
    for (const double nu : around(2.0, c.J)) {
      const auto why = reason("reciprocal-determinant", {1.0, 2.0}, c.branch, nu, c.body);
      EXPECT_EQ(!why.has_value(), below(c.J, nu, 2.0)) << name(c.branch) << " " << nu;
      if (why) {
        EXPECT_THAT(*why, HasSubstr(c.says));
      }
      const auto other = reason("reciprocal-determinant", {1.0, 2.0}, c.branch, -nu, c.body);
      EXPECT_EQ(other, why);
    }
  }
}

TEST(Existence, ThicknessEndsWhereItsStiffnessIsSpent) {
  for (const char* thickness : {"reciprocal-quadratic", "harmonic"}) {
    // Coefficients so that the stiffness is 0.5.
    const std::array<double, 2> axial =
        thickness == std::string_view("harmonic") ? std::array{0.5, 1.3} : std::array{1.3, 0.5};
    const Potential potential = make_potential("biot-log", {1.0, 0.6}, thickness, axial);
    for (const double nu : around(0.5, plate.J3)) {
      for (const Branch branch : {Branch::i, Branch::ii}) {
        const auto why = nonexistence_reason(Problem(plate, potential, branch), nu);
        EXPECT_EQ(!why.has_value(), below(plate.J3, nu, 0.5)) << thickness << " " << nu;
        if (why) {
          EXPECT_THAT(*why, HasSubstr("V_rho'(rho) = J3 nu^2 rho"));
        }
      }
      EXPECT_EQ(nonexistence_reason(Problem(plate, potential, Branch::iii), nu), std::nullopt);
    }
  }
}

TEST(Existence, NeoHookeanNeedsBothRatesOnOneSideOfMu) {
  for (const double limit_J : {1.0, 1.7}) {
    for (const double nu : around(1.1, limit_J)) {
      const bool xi = below(1.0, nu, 1.1);
      const bool zeta = below(1.7, nu, 1.1);
      const auto has = [&](Branch b) {
        return reason("neo-hookean", {1.1, 0.4}, b, nu).has_value();
      };
      EXPECT_EQ(has(Branch::i), !zeta) << nu;
      EXPECT_EQ(has(Branch::ii), !xi) << nu;
      EXPECT_EQ(has(Branch::iii), xi != zeta) << nu;
    }
  }
  // A round plate never has the two on different sides.
  for (const double nu : around(1.1, 1.0))
    EXPECT_EQ(reason("neo-hookean", {1.1, 0.4}, Branch::iii, nu, Body(1.0, 1.0, 0.6)),
              std::nullopt);
}

TEST(Existence, NeoHookean3dNeedsAllRatesOnOneSideOfMu) {
  for (const double limit_J : {1.0, 1.7, 0.6}) {
    for (const double nu : around(1.1, limit_J)) {
      const bool J1 = below(1.0, nu, 1.1);
      const bool J2 = below(1.7, nu, 1.1);
      const bool J3 = below(0.6, nu, 1.1);
      const auto has = [&](Branch b) {
        return reason("neo-hookean-3d", {1.1, 0.4}, b, nu).has_value();
      };
      EXPECT_EQ(has(Branch::i), !(J2 && J3)) << nu;
      EXPECT_EQ(has(Branch::ii), !(J1 && J3)) << nu;
      EXPECT_EQ(has(Branch::iii), !(J1 && J2)) << nu;
    }
  }
}

TEST(Existence, HenckyEndsAtItsFold) {
  const std::array<double, 2> c{1.1, 0.8};
  for (const Branch branch : {Branch::i, Branch::ii}) {
    const double J = branch == Branch::i ? plate.J2 : plate.J1;
    const double end = std::sqrt(support::HenckyFold<double>(J, c[0], c[1]).nu_squared);
    for (int k = 1; k <= 13; ++k) {
      const double gap = std::pow(10.0, -k);
      EXPECT_EQ(reason("hencky", c, branch, end * (1.0 - gap)), std::nullopt) << gap;
      const auto why = reason("hencky", c, branch, end * (1.0 + gap));
      ASSERT_TRUE(why.has_value()) << gap;
      EXPECT_THAT(*why, HasSubstr("fold"));
    }
  }
  for (const double nu : {0.1, 1.0, 10.0})
    EXPECT_EQ(reason("hencky", c, Branch::iii, nu), std::nullopt);
}

/// biot's balance is linear: its one solution by Cramer's rule in 50 digits.
TEST(Existence, BiotHasAReasonExactlyWhereItsSolutionIsNotPositive) {
  support::Random random(91);
  int none = 0;
  int exists = 0;
  const auto expect_right = [&](const Body& body, double mu, double lambda, Branch branch,
                                double nu) {
    const Problem problem(
        body, make_potential("biot", {mu, lambda}, "reciprocal-quadratic", {1.0, 1e12}), branch);
    const auto c = problem.rates(Number50(nu) * Number50(nu));
    // (2 mu + lambda - c_xi) xi + lambda zeta = 2 (mu + lambda), and likewise.
    const Number50 a = Number50(2.0 * mu) + lambda - c.xi;
    const Number50 b = Number50(2.0 * mu) + lambda - c.zeta;
    const Number50 det = a * b - Number50(lambda) * lambda;
    const Number50 force = 2 * (Number50(mu) + lambda);
    const Number50 xi = force * (b - lambda) / det;
    const Number50 zeta = force * (a - lambda) / det;
    const bool positive = xi > 0 && zeta > 0;
    ++(positive ? exists : none);
    EXPECT_EQ(nonexistence_reason(problem, nu).has_value(), !positive)
        << mu << " " << lambda << " " << name(branch) << " " << nu << " xi " << xi << " zeta "
        << zeta;
  };
  for (int k = 0; k < 3000; ++k) {
    const double mu = random.log_uniform(0.1, 10.0);
    const double lambda = random.uniform(-0.9, 3.0) * mu;
    const Body body = random.body();
    const auto branch = static_cast<Branch>(random.integer(0, 2));
    const double nu = std::sqrt(mu) * random.log_uniform(0.03, 10.0);
    expect_right(body, mu, lambda, branch, nu);
    // At the ends: 2 mu = c_i, and det = 0 on the lower root, from both sides.
    const double J = random.integer(0, 1) == 0 ? body.J1 : body.J2;
    for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12})
      for (const double side : {-1.0, 1.0})
        expect_right(body, mu, lambda, branch, std::sqrt(2.0 * mu / J) * (1.0 + side * gap));
  }
  EXPECT_GT(none, 1000);
  EXPECT_GT(exists, 1000);
}

/// In units so small that products vanish nothing is proven.
TEST(Existence, AnUnderflowIsNoReason) {
  for (const double unit : {1e-165, 1e-150}) {
    const Problem problem(Body(unit, 1.7 * unit, 0.6 * unit),
                          make_potential("biot", {unit, 2.0 * unit}), Branch::i);
    EXPECT_FALSE(nonexistence_reason(problem, 0.0)) << unit;
    EXPECT_FALSE(nonexistence_reason(problem, 0.3)) << unit;
  }
}

TEST(Existence, NoReasonIsKnownForTheOthers) {
  for (const char* model : {"saint-venant-kirchhoff", "biot-log"})
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii})
      for (const double nu : {0.0, 0.1, 1.0, 10.0, 100.0})
        EXPECT_EQ(reason(model, {1.0, 0.6}, branch, nu, plate, 1e9), std::nullopt);
}

TEST(Existence, RestAlwaysExists) {
  support::Random random(92);
  for (int k = 0; k < 500; ++k) {
    const Posed posed = random_problem(random, 6.0);
    EXPECT_EQ(nonexistence_reason(posed.problem, 0.0), std::nullopt) << posed.text;
  }
}

/// Solutions of a system that Newton finds from a grid of starts.
template <class System>
int found_by_multistart(const System& system) {
  constexpr int N = System::dimension;
  int found = 0;
  const double grid[] = {0.01, 0.1, 0.5, 0.9, 1.2, 2.0, 10.0, 100.0};
  const auto from = [&](ReducedVector<N> x) {
    if (!newton(system, x).converged || !refine(system, x).converged) return;
    const Linearized<N> at = system.linearize(x);
    const bool within = x.minCoeff() > 1e-6 && x.maxCoeff() < 1e6;
    if (within && at.g.cwiseAbs().maxCoeff() <= 1e-12 * at.magnitude) ++found;
  };
  for (const double a : grid) {
    if constexpr (N == 1) {
      from(ReducedVector<1>(a));
    } else {
      for (const double b : grid) {
        if constexpr (N == 2) {
          from({a, b});
        } else {
          for (const double c : {0.1, 1.0, 10.0}) from({a, b, c});
        }
      }
    }
  }
  return found;
}

int found_by_multistart(const Posed& posed, bool thickness) {
  const auto rates = posed.problem.rates(two_product(posed.nu, posed.nu));
  return posed.problem.potential().visit_parts([&](const auto& model) {
    if constexpr (requires { model.plane; }) {
      using Axial = std::decay_t<decltype(model.thickness)>;
      using Plane = std::decay_t<decltype(model.plane)>;
      return thickness ? found_by_multistart(ThicknessSystem<Axial>{model.thickness, rates.rho})
                       : found_by_multistart(PlanarSystem<Plane>{model.plane, rates});
    } else {
      return found_by_multistart(CoupledSystem<std::decay_t<decltype(model)>>{model, rates});
    }
  });
}

TEST(Existence, WhereAReasonIsGivenASearchFindsNothing) {
  support::Random random(93);
  int reasons = 0;
  int searched_well = 0;
  for (int k = 0; k < 2000; ++k) {
    const Posed posed = random_problem(random, 2.0);
    const auto why = nonexistence_reason(posed.problem, posed.nu);
    if (why) {
      ++reasons;
      const bool thickness = why->starts_with("V_rho'");
      EXPECT_EQ(found_by_multistart(posed, thickness), 0) << posed.text << "\n" << *why;
      const Equilibrium answer = solve(posed.problem, posed.nu);
      EXPECT_EQ(answer.status, SolveStatus::none_exists);
      EXPECT_EQ(answer.message, *why);
    } else if (k % 20 == 0 && solve(posed.problem, posed.nu).status == SolveStatus::solved) {
      // The search itself can find: otherwise the above would mean nothing.
      searched_well += found_by_multistart(posed, false) > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(reasons, 200);
  EXPECT_GT(searched_well, 50);
}

}  // namespace
}  // namespace stationary
