// Forces of self-gravity at alpha = 0 in the logarithms of the stretches: the sphere, Maclaurin's
// spheroids, Jacobi's bifurcation, and that slopes are slopes.
#include "lib/gravity/self_energy.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace stationary {
namespace {

/// Of J = (1, 1, 1), g = 4 (pi G rho = 1 at unit volume), in the stretches.
template <int order = 2>
GravityBalance<double> at(double xi, double zeta, double rho) {
  return gravity_balance<order>(4.0, xi * xi, zeta * zeta, rho * rho);
}

TEST(SelfEnergy, SphereIsPulledEquallyOnAllAxes) {
  for (const double a : {0.01, 1.0, 30.0}) {
    const auto b = at(a, a, a);
    for (const double pull : b.pull) EXPECT_NEAR(pull * a, 4.0 / 3.0, 4e-15);
    EXPECT_NEAR(b.slope[1] / b.slope[2], 1.0, 1e-13);
    EXPECT_NEAR(b.slope[0] / b.slope[5], 1.0, 1e-13);
  }
}

TEST(SelfEnergy, PullsAddUpToTheEnergyAndAreSymmetric) {
  const auto b = at(1.3, 0.8, 0.6);
  const double F =
      ellipsoid_integral<0>(1.3 * 1.3 + 0.8 * 0.8, 1.3 * 1.3 * 0.8 * 0.8, 0.36).value();
  EXPECT_NEAR(b.pull[0] + b.pull[1] + b.pull[2], 4.0 * F, 1e-14);
  // Axes exchanged, the third with the others too.
  const auto turned = at(0.6, 1.3, 0.8);
  EXPECT_NEAR(turned.pull[0], b.pull[2], 1e-14);
  EXPECT_NEAR(turned.pull[1], b.pull[0], 1e-14);
  EXPECT_NEAR(turned.slope[1], b.slope[2], 1e-14);
  EXPECT_NEAR(turned.slope[4], b.slope[1], 1e-14);
  EXPECT_NEAR(turned.slope[5], b.slope[3], 1e-14);
}

TEST(SelfEnergy, SlopesAreSlopes) {
  constexpr double h = 1e-5;
  const std::array<std::array<std::size_t, 3>, 3> place{{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
  for (const auto& x : {std::array{1.3, 0.8, 0.6}, std::array{1.0, 1.0, 0.2},
                        std::array{0.4, 0.4, 3.0}, std::array{1e3, 0.5, 1e-2}}) {
    const auto b = at(x[0], x[1], x[2]);
    for (std::size_t j = 0; j < 3; ++j) {
      auto ahead = x;
      auto behind = x;
      ahead[j] *= std::exp(h);
      behind[j] *= std::exp(-h);
      const auto up = at<1>(ahead[0], ahead[1], ahead[2]);
      const auto down = at<1>(behind[0], behind[1], behind[2]);
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR((up.pull[i] - down.pull[i]) / (2.0 * h), b.slope[place[i][j]],
                    1e-9 * b.pull[0] + 1e-9 * b.pull[2]);
    }
  }
}

/// Omega^2/(pi G rho) of Maclaurin's spheroids.
double maclaurin(double e) {
  return 2.0 * std::sqrt(1.0 - e * e) / (e * e * e) * (3.0 - 2.0 * e * e) * std::asin(e) -
         6.0 * (1.0 - e * e) / (e * e);
}

TEST(SelfEnergy, BalancesMaclaurinsSpheroids) {
  for (const double e : {0.1, 0.5, 0.8, 0.8126700106117429, 0.95, 0.999}) {
    const double a = std::pow(1.0 - e * e, -1.0 / 6.0);
    const double c = a * std::sqrt(1.0 - e * e);
    const auto b = at(a, a, c);
    EXPECT_NEAR((b.pull[0] - b.pull[2]) / (a * a), maclaurin(e), 2e-13 / (e * e));
  }
}

TEST(SelfEnergy, TurnsOverAtJacobisBifurcation) {
  // The stiffness along (1, -1) at fixed volume, with the centrifugal pull, changes its sign.
  const auto across = [](double e) {
    const double a = std::pow(1.0 - e * e, -1.0 / 6.0);
    const auto b = at(a, a, a * std::sqrt(1.0 - e * e));
    const double pull = b.pull[0] - b.pull[2];
    return 2.0 * (b.slope[0] - b.slope[1]) - 4.0 * pull;
  };
  const double e = 0.8126700106117429;
  EXPECT_GT(across(e - 1e-6), 0.0);
  EXPECT_LT(across(e + 1e-6), 0.0);
  EXPECT_NEAR(across(e), 0.0, 1e-14);
}

}  // namespace
}  // namespace stationary
