// A leaf and what it is reduced to, by code for any processor and by that for fused multiply-adds:
// the same bits.
#include "lib/leaf/reductions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

using support::Random;

DoubleDouble with_tail(Random& random, double x) {
  return {x, x * random.uniform(-0x1p-54, 0x1p-54)};
}

/// Symmetric, with zeros.
template <std::size_t n>
Square<DoubleDouble, n> random_form(Random& random) {
  Square<DoubleDouble, n> out;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j)
      out[i][j] = out[j][i] = with_tail(
          random, random.integer(0, 2) == 0 ? 0.0 : random.sign() * random.log_uniform(1e-3, 1e3));
  return out;
}

template <std::size_t n>
Scales<n> random_scales(Random& random) {
  Scales<n> out;
  for (double& each : out) each = std::ldexp(1.0, random.integer(-3, 3));
  return out;
}

void expect_bits(const DoubleDouble& a, const DoubleDouble& b) {
  EXPECT_EQ(a.hi, b.hi);
  EXPECT_EQ(a.lo, b.lo);
}

template <std::size_t n, class T>
void expect_polynomial_bits(const ReducedLeaf<n, T>& a, const ReducedLeaf<n, T>& b) {
  EXPECT_EQ(a.unit, b.unit);
  EXPECT_EQ(a.h, b.h);
  EXPECT_EQ(a.h_size, b.h_size);
  EXPECT_EQ(a.magnitude, b.magnitude);
  for (std::size_t k = 0; k <= n; ++k) expect_bits(a.c[k], b.c[k]);
}

template <std::size_t n>
void expect_reduction_bits(Random& random) {
  const auto& portable = portable_leaf_reductions().pairs<n>();
  const auto& fused = fused_leaf_reductions()->pairs<n>();
  {
    const auto A = random_form<n>(random);
    const auto B = random_form<n>(random);
    const auto scale = random_scales<n>(random);
    ReducedProduct<n> out[2];
    portable.product(A, B, scale, out[0]);
    fused.product(A, B, scale, out[1]);
    expect_polynomial_bits(out[0], out[1]);
    // To the same vectors.
    std::array<double, n> x[2];
    for (std::size_t k = 0; k < 2; ++k) {
      x[k].fill(0.75);
      out[k].similarity.carry_right(x[k]);
      out[k].similarity.carry_left(x[k]);
    }
    EXPECT_EQ(x[0], x[1]);
  }
  const auto E = random_form<2 * n>(random);
  const auto scale = random_scales<2 * n>(random);
  ReducedSquare<n> out[2];
  Square<double, 2 * n> H[2];
  portable.square(E, scale, H[0], out[0]);
  fused.square(E, scale, H[1], out[1]);
  expect_polynomial_bits(out[0], out[1]);
  EXPECT_EQ(H[0], H[1]);
  std::array<double, n> x;
  x.fill(0.75);
  EXPECT_EQ(out[0].similarity.carry(x), out[1].similarity.carry(x));
}

/// Of any motion: with alpha and nu of any zeros, at rest too, of a held volume and of none.
void expect_variation_bits(Random& random) {
  const Body body(random.log_uniform(0.1, 10.0), random.log_uniform(0.1, 10.0),
                  random.log_uniform(0.1, 10.0));
  const auto or_none = [&](double size) {
    return random.integer(0, 2) == 0 ? DoubleDouble(0.0) : with_tail(random, random.sign() * size);
  };
  const auto stretch = [&] { return with_tail(random, random.log_uniform(0.4, 2.5)); };
  const DoubleDouble alpha = or_none(random.uniform(0.0, 0.3));
  const BasicStretch<DoubleDouble> q{alpha, stretch(), stretch(), stretch()};
  Vector3<DoubleDouble> nu;
  for (int k = 0; k < 3; ++k) nu[k] = or_none(random.log_uniform(1e-3, 10.0));
  const auto V = random_form<4>(random);
  Matrix4<DoubleDouble> V_qq;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) V_qq(Eigen::Index(i), Eigen::Index(j)) = V[i][j];
  const bool turns = nu[0].hi != 0.0 || nu[1].hi != 0.0 || nu[2].hi != 0.0;
  const LeafShape shape{turns, random.integer(0, 1) == 0};
  LeafForm<DoubleDouble> out[2];
  const std::size_t portable =
      portable_leaf_reductions().second_variation(body, q, nu, shape, V_qq, out[0]);
  const std::size_t fused =
      fused_leaf_reductions()->second_variation(body, q, nu, shape, V_qq, out[1]);
  EXPECT_EQ(portable, fused);
  for (std::size_t i = 0; i < 2 * shape.pairs(); ++i)
    for (std::size_t j = 0; j < 2 * shape.pairs(); ++j) expect_bits(out[0][i][j], out[1][i][j]);
}

TEST(LeafReductions, AreTheSameBits) {
  if (fused_leaf_reductions() == nullptr) GTEST_SKIP() << "no code for fused multiply-adds here";
  Random random(2027);
  for (int k = 0; k < 2000; ++k) {
    expect_reduction_bits<2>(random);
    expect_reduction_bits<3>(random);
    expect_reduction_bits<4>(random);
    expect_reduction_bits<5>(random);
    expect_variation_bits(random);
  }
}

}  // namespace
}  // namespace stationary
