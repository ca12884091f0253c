// Motions of anisotropic bodies: laws over random ones, error bounds against the same balance
// solved in extended precision, what is refused.
#include "solver/solve/anisotropic_equilibrium.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "lib/balance/balance_in_momenta.hpp"
#include "solver/motion/oriented_system.hpp"
#include "solver/search/anisotropic_search.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"

namespace stationary {
namespace {

using namespace testing;

constexpr std::optional<Branch> families[] = {std::nullopt, Branch::i, Branch::ii};

/// Of (iii) and, where V is not even, the two oblique families from rest.
template <class F>
void over_motions(std::uint64_t seed, int count, const F& f) {
  support::Random random(seed);
  for (int k = 0; k < count; ++k) {
    const OrientedBody at = random_oriented_body(random, k);
    for (const auto& near : families) {
      if (near && at.V.even_in_alpha()) continue;
      const Equilibrium found = solved_motion(at, near);
      ASSERT_EQ(found.status, SolveStatus::solved) << at.text << "\n" << found.message;
      f(at, near, found);
    }
  }
}

TEST(AnisotropicEquilibrium, SatisfiesBothFormsOfTheBalanceAndCompatibility) {
  over_motions(401, 32, [](const OrientedBody& at, const auto&, const Equilibrium& found) {
    const auto V = at.V.model();
    EXPECT_LE(found.residual, 1e-15) << at.text;
    const Vector7<double> momenta = steady_momenta(at.body, found.q, found.nu);
    const double scale = potential_derivatives<2>(V, found.q).hessian.cwiseAbs().maxCoeff();
    EXPECT_LE(momentum_balance_residual(at.body, V, found.q, momenta).norm(), 1e-14 * scale)
        << at.text;
    const Vector3<double> pi = locked_inertia(at.body, found.q) * found.nu;
    EXPECT_LE(pi.cross(found.nu).norm(), 1e-14 * pi.norm() * found.nu.norm()) << at.text;
    EXPECT_NEAR(found.nu.norm(), at.nu, 1e-15) << at.text;
    EXPECT_EQ(found.connection, Connection::rest);
  });
}

/// The same balance, solved by Newton with its residual and its unknowns in extended precision.
template <class Layout>
std::array<DoubleDouble, 5> exact_coordinates(const OrientedBody& at, const Equilibrium& found) {
  constexpr int N = Layout::dimension;
  const OrientedModels models(at.V);
  const OrientedSystem<Layout> system{&models, at.body, Branch::iii, at.nu};
  ReducedVector<N> start;
  start.template head<4>() << found.q.xi, found.q.zeta, found.q.rho, shear_coordinate(found.q);
  if constexpr (Layout::axis) start[4] = axis_coordinate(std::atan2(found.nu[1], found.nu[0]));
  std::array<DoubleDouble, static_cast<std::size_t>(N)> x;
  for (int i = 0; i < N; ++i) x[static_cast<std::size_t>(i)] = start[i];
  const Inertia3<DoubleDouble> J{at.body.J1, at.body.J2, at.body.J3};
  const auto linearized = system.linearize(start);
  for (int step = 0; step < 4; ++step) {
    const auto b = balance_at<Layout, 1>(J, models.extended, Branch::iii, two_product(at.nu, at.nu),
                                         all_coordinates<Layout>(x, DoubleDouble(1.0)));
    ReducedVector<N> g;
    for (int i = 0; i < N; ++i) g[i] = double(b.g[system.place(i)]) * linearized.scale[i];
    const ReducedVector<N> delta = linearized.jacobian.inverse() * g;
    for (int i = 0; i < N; ++i) {
      auto& each = x[static_cast<std::size_t>(i)];
      each = renormalized(each * (1.0 - DoubleDouble(delta[i])));
    }
  }
  return all_coordinates<Layout>(x, DoubleDouble(1.0));
}

TEST(AnisotropicEquilibrium, ErrorBoundsHoldAndAreFewUnits) {
  over_motions(402, 32, [](const OrientedBody& at, const auto& near, const Equilibrium& found) {
    const auto y = near ? exact_coordinates<ObliqueLayout>(at, found)
                        : exact_coordinates<ShearedLayout>(at, found);
    const auto q = oriented_stretch(y[0], y[1], y[2], y[3]).q;
    const auto off = [&](double x, const DoubleDouble& exact, const DoubleDouble& scale) {
      return std::abs(double((DoubleDouble(x) - exact) / scale));
    };
    double error = std::max({off(found.q.xi, q.xi, q.xi), off(found.q.zeta, q.zeta, q.zeta),
                             off(found.q.rho, q.rho, q.rho),
                             off(found.q.alpha, q.alpha, sqrt(q.xi * q.zeta))});
    if (near) {
      const auto axis = axis_angle(y[4]);
      const DoubleDouble sine = axis.cosine * found.nu[1] - axis.sine * found.nu[0];
      error = std::max(error, std::abs(double(sine)) / at.nu);
    }
    EXPECT_LE(error, found.error_bound) << at.text;
    EXPECT_LE(error, 2.3e-16) << at.text;
    EXPECT_LE(found.error_bound, 1e-13) << at.text;
  });
}

TEST(AnisotropicEquilibrium, ScalesAndKnowsNoSenseOfTheSpin) {
  over_motions(403, 16, [](const OrientedBody& at, const auto& near, const Equilibrium& found) {
    // J -> 4 J and nu -> nu/2 leave the balance as it is.
    OrientedBody other = at;
    other.body = Body(4.0 * at.body.J1, 4.0 * at.body.J2, 4.0 * at.body.J3);
    other.nu = 0.5 * at.nu;
    const Equilibrium scaled = solved_motion(other, near);
    ASSERT_EQ(scaled.status, SolveStatus::solved) << at.text;
    EXPECT_LE(stretch_difference(scaled.q, found.q), 4e-15) << at.text;
    if (near) return;
    const Equilibrium back = solve(at.problem(Branch::iii), -at.nu);
    EXPECT_LE(stretch_difference(back.q, found.q), 1e-16) << at.text;
    EXPECT_EQ(back.nu[2], -at.nu);
  });
}

/// Axes 1 and 2 exchanged: fibres at 90 degrees less their angle, alpha as it is. Axis 1 turned
/// about: fibres at minus their angle, alpha and nu1 of the other sign.
TEST(AnisotropicEquilibrium, SymmetriesOfTheMaterialFrame) {
  support::Random random(404);
  for (int k = 0; k < 8; ++k) {
    const double degrees = random.uniform(5.0, 85.0);
    const double stiffness = random.log_uniform(0.1, 1.0);
    const Body body = random.body(2.0);
    const double nu = random.uniform(0.1, 0.3);
    const BiotLog<> plane{1.0, 0.8};
    for (const auto& near : families) {
      const auto motion = [&](const Body& J, double angle, std::optional<Branch> about) {
        const Potential V = fibred(plane, stiffness, angle);
        return solved_motion({J, V.anisotropic(), nu, ""}, about);
      };
      const Equilibrium at = motion(body, degrees, near);
      ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
      const auto other = near ? std::optional(*near == Branch::i ? Branch::ii : Branch::i) : near;
      const Equilibrium exchanged = motion(Body(body.J2, body.J1, body.J3), 90.0 - degrees, other);
      EXPECT_LE(stretch_difference(
                    {exchanged.q.alpha, exchanged.q.zeta, exchanged.q.xi, exchanged.q.rho}, at.q),
                4e-15);
      const Equilibrium turned = motion(body, -degrees, near);
      EXPECT_LE(
          stretch_difference({-turned.q.alpha, turned.q.xi, turned.q.zeta, turned.q.rho}, at.q),
          4e-15);
      if (!near) continue;
      EXPECT_NEAR(std::abs(exchanged.nu[1]), std::abs(at.nu[0]), 1e-14);
      EXPECT_NEAR(turned.nu[0] * turned.nu[1], -at.nu[0] * at.nu[1], 1e-14);
    }
  }
}

/// To first order in k, from both sides of which: the isotropic solution.
TEST(AnisotropicEquilibrium, SoftFibresLeaveTheIsotropicMotion) {
  const Body body(1.0, 1.7, 0.6);
  const Potential isotropic(PlanarPotential(NeoHookean<>{1.0, 2.0}),
                            ThicknessPotential(ReciprocalQuadratic<>{1.0, 3.0}));
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    const Equilibrium without = solve(Problem(body, isotropic, branch), 0.4);
    double before = 0.0;
    for (const double k : {1e-4, 1e-6, 1e-8}) {
      const Potential V = fibred(NeoHookean<>{1.0, 2.0}, k, 30.0);
      const Equilibrium with = branch == Branch::iii
                                   ? solve(Problem(body, V, branch), 0.4)
                                   : solve_oblique(body, V, {0.4, branch}, without_search());
      ASSERT_EQ(with.status, SolveStatus::solved) << with.message;
      const double apart = stretch_difference(with.q, without.q);
      EXPECT_LE(apart, 10.0 * k);
      if (before > 0.0) {
        EXPECT_NEAR(before / apart, 100.0, 1.0);
      }
      before = apart;
    }
  }
}

TEST(AnisotropicEquilibrium, AnIsotropicPotentialInOrthotropicClothes) {
  support::Random random(405);
  for (int k = 0; k < 6; ++k) {
    const double mu = random.log_uniform(0.5, 2.0);
    const double lambda = random.uniform(0.0, 2.0);
    const ThicknessPotential thickness = ReciprocalQuadratic<>{1.0, 3.0};
    const double stiff = lambda + 2.0 * mu;
    const Potential oriented(AnisotropicPotential(
        OrthotropicSaintVenantKirchhoff<>{stiff, stiff, lambda, mu}, thickness, {}));
    const Potential isotropic(PlanarPotential(SaintVenantKirchhoff<>{mu, lambda}), thickness);
    const Body body = random.body(2.0);
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      const Equilibrium a = solve(Problem(body, oriented, branch), 0.3);
      const Equilibrium b = solve(Problem(body, isotropic, branch), 0.3);
      ASSERT_EQ(a.status, SolveStatus::solved) << a.message;
      EXPECT_LE(stretch_difference(a.q, b.q), 1e-15);
      EXPECT_EQ(a.q.alpha, 0.0);
    }
  }
}

/// With its nu the same way round, as the search has it too.
TEST(AnisotropicEquilibrium, FromAStartTheSameMotion) {
  over_motions(406, 8, [](const OrientedBody& at, const auto& near, const Equilibrium& found) {
    Stretch start = found.q;
    start.xi *= 1.02;
    start.alpha += 0.01;
    const SolveOptions options = without_search(start);
    const Equilibrium again = near ? solve_oblique(at.body, at.potential(), {at.nu, near}, options)
                                   : solve(at.problem(Branch::iii), at.nu, options);
    ASSERT_EQ(again.status, SolveStatus::solved) << at.text << again.message;
    EXPECT_EQ(again.connection, Connection::given_start);
    // At slow spin the start says little of the axis: then the other one's family is near too.
    if (!near || std::abs(again.nu.normalized().dot(found.nu.normalized())) > 0.7) {
      EXPECT_LE(stretch_difference(again.q, found.q), 1e-15) << at.text;
      EXPECT_LE((again.nu - found.nu).norm(), 1e-14 * at.nu) << at.text;
    }
    if (!near) return;
    EXPECT_GE(again.nu[0] + again.nu[1], 0.0) << at.text;
    const SearchResult all = search_oblique(at.body, at.potential(), {at.nu, near}, {});
    EXPECT_EQ(std::ranges::count_if(all.solutions,
                                    [&](const Equilibrium& each) {
                                      return stretch_difference(each.q, found.q) < 1e-14 &&
                                             (each.nu - found.nu).norm() < 1e-13 * at.nu;
                                    }),
              1)
        << at.text;
  });
}

/// physics: balance at alpha = 0 without V_alpha = 0 is no motion.
TEST(AnisotropicEquilibrium, NoneAboutAMaterialAxisThatIsNoneOfSymmetry) {
  const Body body(1.0, 1.7, 0.6);
  const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 30.0);
  for (const Branch branch : {Branch::i, Branch::ii}) {
    const Equilibrium at = solve(Problem(body, V, branch), 0.3);
    EXPECT_EQ(at.status, SolveStatus::none_exists);
    EXPECT_NE(at.message.find("no stationary ellipse about this axis"), std::string::npos);
    EXPECT_NE(at.message.find("e-03 of the largest term"), std::string::npos) << at.message;
    EXPECT_TRUE(std::isnan(at.q.xi));
    // At rest no axis is asked for.
    EXPECT_EQ(solve(Problem(body, V, branch), 0.0).status, SolveStatus::solved);
  }
}

TEST(AnisotropicEquilibrium, RestStatesOfStiffFibresThatDoNotFitTheirBody) {
  const Body body(1.0, 1.7, 0.6);
  for (const double k : {0.1, 10.0, 1e4}) {
    // At rest without fibres xi = zeta = 2^(1/4).
    const Potential V = fibred(ReciprocalDeterminant<>{2.0, 1.0}, k, 25.0);
    const Equilibrium rest = solve(Problem(body, V, Branch::iii), 0.0);
    ASSERT_EQ(rest.status, SolveStatus::solved) << rest.message;
    EXPECT_LE(rest.residual, 1e-15);
    EXPECT_NE(rest.q.alpha, 0.0);
  }
}

TEST(AnisotropicEquilibrium, RefusesWhatItCannotServe) {
  const Body body(1.0, 1.7, 0.6);
  const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 30.0);
  const Potential isotropic(PlanarPotential(NeoHookean<>{1.0, 2.0}),
                            ThicknessPotential(ReciprocalQuadratic<>{1.0, 3.0}));
  EXPECT_THROW(solve_oblique(body, isotropic, {0.3}), std::invalid_argument);
  EXPECT_THROW(solve_oblique(body, V, {0.0}), std::invalid_argument);
  EXPECT_THROW(solve_oblique(body, V, {-0.1}), std::invalid_argument);
  SolveOptions by_ceres;
  by_ceres.method = Method::ceres;
  EXPECT_THROW(solve(Problem(body, V, Branch::iii), 0.1, by_ceres), std::invalid_argument);
  EXPECT_THROW(anisotropic_family(body, V.anisotropic(), Branch::i, false, {}),
               std::invalid_argument);
}

}  // namespace
}  // namespace stationary
