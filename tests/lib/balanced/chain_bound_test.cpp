// The bound of a chain's eigenvalues holds at every corner of what its entries may be.
#include "lib/balanced/chain_bound.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <limits>

#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

using Entries = std::array<double, 5>;  // a, b, c, d^2, e^2

/// Of -chain, ascending.
Eigen::Vector3d eigenvalues(const Entries& x) {
  Eigen::Matrix3d chain;
  const double d = std::sqrt(x[3]);
  const double e = std::sqrt(x[4]);
  chain << x[0], d, 0.0, d, x[1], e, 0.0, e, x[2];
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(-chain, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

/// How far each eigenvalue comes over all corners.
Eigen::Vector3d largest_change(const Entries& x, const Entries& error) {
  const Eigen::Vector3d here = eigenvalues(x);
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
  for (unsigned corner = 0; corner < 32; ++corner) {
    Entries there = x;
    for (std::size_t k = 0; k < 5; ++k) there[k] += corner >> k & 1 ? error[k] : -error[k];
    for (std::size_t k = 3; k < 5; ++k) there[k] = std::max(there[k], 0.0);  // a square
    out = out.cwiseMax((eigenvalues(there) - here).cwiseAbs());
  }
  return out;
}

ChainBound bound_of(const Entries& x, const Entries& error, double u) {
  const auto input = [&](std::size_t k) {
    return Conditioned(x[k], error[k] / u - std::abs(x[k]));
  };
  return ChainBound({input(0), input(1), input(2), input(3), input(4)}, u);
}

TEST(ChainBound, HoldsWhereRootsAreApart) {
  support::Random random(17);
  const auto size = [&](double least, double most) {
    return std::pow(10.0, random.uniform(least, most));
  };
  int resolved = 0;
  int of_small_couplings = 0;
  for (int n = 0; n < 20'000; ++n) {
    const double gap = size(-3.0, 0.0);
    const Entries x{1.0, 1.0 + gap * random.uniform(-2.0, 2.0),
                    1.0 + gap * random.uniform(-2.0, 2.0), gap * gap * size(-8.0, 0.0),
                    gap * gap * size(-8.0, 0.0)};
    Entries error;
    for (std::size_t k = 0; k < 3; ++k) error[k] = gap * size(-3.0, -1.0);
    for (std::size_t k = 3; k < 5; ++k) error[k] = gap * gap * size(-6.0, 0.5);
    const ChainBound bound = bound_of(x, error, 0x1p-20);
    const Eigen::Vector3d roots = eigenvalues(x);
    const Eigen::Vector3d change = largest_change(x, error);
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(change[k], bound.largest() * (1.0 + 1e-12));
      double slope = 1.0;
      double nearest = std::numeric_limits<double>::infinity();
      for (int other = 0; other < 3; ++other) {
        if (other == k) continue;
        slope *= roots[k] - roots[other];
        nearest = std::min(nearest, std::abs(roots[k] - roots[other]));
      }
      if (!bound.resolves(nearest)) continue;
      ++resolved;
      of_small_couplings += error[3] > x[3];
      EXPECT_LE(change[k], bound(roots[k], slope, nearest) + 1e-14) << n << " " << k;
    }
  }
  EXPECT_GT(resolved, 5'000);
  EXPECT_GT(of_small_couplings, 300);
}

/// Of a diagonal alone its own error, and what is of second order.
TEST(ChainBound, IsNoWiderThanItNeeds) {
  const double u = 0x1p-40;
  const ChainBound bound = bound_of({1.0, 2.0, 4.0, 0.0, 0.0}, {u, u, u, 0.0, 0.0}, u);
  EXPECT_TRUE(bound.resolves(1.0));
  EXPECT_FALSE(bound.resolves(16.0 * u));
  EXPECT_NEAR(bound(-1.0, 3.0, 1.0), u, 1e-3 * u);
  EXPECT_NEAR(bound.largest(), u, 1e-3 * u);
}

/// A coupling that may be zero, or many times what it is, is told from no gap of its size.
TEST(ChainBound, OfAnUncertainCouplingResolvesNothingBesideIt) {
  const double u = 0x1p-40;
  const ChainBound bound = bound_of({1.0, 1.001, 4.0, 1e-9, 0.0}, {0.0, 0.0, 0.0, 1e-6, 0.0}, u);
  EXPECT_FALSE(bound.resolves(0.001));
  EXPECT_GE(bound.largest(), std::sqrt(1e-6));
}

}  // namespace
}  // namespace stationary
