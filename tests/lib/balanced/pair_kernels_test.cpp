// The kernels for processors with fused multiply-adds give the bits of the portable ones.
#include "lib/balanced/pair_kernels.hpp"

#include <gtest/gtest.h>

#include <bit>

#include "lib/number/fused.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/double_double_operands.hpp"

namespace stationary {
namespace {

void expect_same(const DoubleDouble& x, const DoubleDouble& y) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(x.hi), std::bit_cast<std::uint64_t>(y.hi));
  EXPECT_EQ(std::bit_cast<std::uint64_t>(x.lo), std::bit_cast<std::uint64_t>(y.lo));
}
void expect_same(double x, double y) { expect_same(DoubleDouble(x), DoubleDouble(y)); }

template <int D>
void expect_same(const Polynomial<DoubleDouble, D>& p, const Polynomial<DoubleDouble, D>& q) {
  for (std::size_t k = 0; k <= D; ++k) expect_same(p.c[k], q.c[k]);
}
void expect_same(const SeparatedRoots& p, const SeparatedRoots& q) {
  ASSERT_EQ(p.found, q.found);
  for (std::size_t k = 0; p.found && k < 3; ++k) {
    expect_same(p.root[k], q.root[k]);
    expect_same(p.slope[k], q.slope[k]);
    expect_same(p.gap[k], q.gap[k]);
  }
}
void expect_same(const LeadingState& p, const LeadingState& q) {
  for (const auto member :
       {&LeadingState::m1, &LeadingState::m2, &LeadingState::m3, &LeadingState::uu,
        &LeadingState::uv, &LeadingState::vv, &LeadingState::ww, &LeadingState::omega2,
        &LeadingState::zeta2, &LeadingState::sum})
    expect_same(p.*member, q.*member);
  ASSERT_EQ(p.apart, q.apart);
  p.apart ? expect_same(p.E, q.E) : expect_same(p.V_aa, q.V_aa);
}

void expect_same(const PairCurvatures& p, const PairCurvatures& q) {
  expect_same(p.plane.uu, q.plane.uu);
  expect_same(p.plane.uv, q.plane.uv);
  expect_same(p.plane.vv, q.plane.vv);
  expect_same(p.w_l, q.w_l);
  expect_same(p.ww, q.ww);
}

void expect_same(const InPlaneBlocks& p, const InPlaneBlocks& q) {
  expect_same(p.state, q.state);
  expect_same(p.chain, q.chain);
  expect_same(p.chain_roots, q.chain_roots);
  for (const auto member : {&OddQuadratic<DoubleDouble>::b, &OddQuadratic<DoubleDouble>::c,
                            &OddQuadratic<DoubleDouble>::det_P, &OddQuadratic<DoubleDouble>::det_Q,
                            &OddQuadratic<DoubleDouble>::Q_22})
    expect_same(p.odd.*member, q.odd.*member);
  for (const auto member : {&RootPair<DoubleDouble>::mean, &RootPair<DoubleDouble>::separation,
                            &RootPair<DoubleDouble>::large, &RootPair<DoubleDouble>::small})
    expect_same(p.odd_roots.*member, q.odd_roots.*member);
}

void expect_same(const NormalBlocks& p, const NormalBlocks& q) {
  expect_same(p.state, q.state);
  for (const auto member :
       {&NormalBlocks::I3_I1, &NormalBlocks::I3_I2, &NormalBlocks::odd, &NormalBlocks::rho})
    expect_same(p.*member, q.*member);
  for (const auto member : {&NormalBlock<DoubleDouble>::k, &NormalBlock<DoubleDouble>::trace,
                            &NormalBlock<DoubleDouble>::det, &NormalBlock<DoubleDouble>::det0,
                            &NormalBlock<DoubleDouble>::gain})
    expect_same(p.even.*member, q.even.*member);
  expect_same(p.cubic, q.cubic);
  expect_same(p.cubic_roots, q.cubic_roots);
}

/// Stretches of any size, some next to a circle, with tails.
PairSpin random_spin(support::Random& random, bool normal) {
  const auto number = [&](double x) {
    return DoubleDouble(x, x * random.uniform(-0x1p-54, 0x1p-54));
  };
  const double xi = random.log_uniform(0.05, 20.0);
  const double zeta = random.integer(0, 2) == 0 ? xi * (1.0 + random.sign() * 1e-5)
                                                : random.log_uniform(0.05, 20.0);
  return {.J1 = random.log_uniform(0.01, 100.0),
          .J2 = random.log_uniform(0.01, 100.0),
          .J3 = random.log_uniform(0.01, 100.0),
          .xi = number(xi),
          .zeta = number(zeta),
          .rho = number(random.log_uniform(0.05, 20.0)),
          .omega = random.sign() * random.log_uniform(0.01, 10.0),
          .normal = normal,
          .least_apart = 0x1p-10};
}

TEST(PairKernels, AreTheSameBits) {
  const PairKernels* fused = fused_pair_kernels();
  if (fused == nullptr) GTEST_SKIP() << "no kernel for fused multiply-adds here";
  const PairKernels& portable = portable_pair_kernels();
  support::Random random(2026);
  int apart = 0;
  int separated = 0;
  for (int k = 0; k < 20'000; ++k) {
    const PairSpin spin = random_spin(random, k % 2 == 0);
    const std::array<double, 2> c{random.log_uniform(0.1, 10.0), random.log_uniform(0.1, 10.0)};
    const std::size_t plane = static_cast<std::size_t>(k / 2) % portable.plane.size();
    const std::size_t thickness = static_cast<std::size_t>(k / 3) % portable.thickness.size();
    PairCurvatures of[2];
    portable.plane[plane](c, spin, of[0]);
    fused->plane[plane](c, spin, of[1]);
    portable.thickness[thickness](c, spin, of[0]);
    fused->thickness[thickness](c, spin, of[1]);
    expect_same(of[0], of[1]);
    const SpinUnits units(spin.J1, spin.omega);
    if (spin.normal) {
      NormalBlocks blocks[2];
      portable.normal_blocks(spin, of[0], units, k % 14 == 0, blocks[0]);
      fused->normal_blocks(spin, of[0], units, k % 14 == 0, blocks[1]);
      expect_same(blocks[0], blocks[1]);
      apart += blocks[0].state.apart;
      separated += blocks[0].cubic_roots.found;
    } else {
      InPlaneBlocks blocks[2];
      portable.in_plane_blocks(spin, of[0], units, k % 14 == 1, blocks[0]);
      fused->in_plane_blocks(spin, of[0], units, k % 14 == 1, blocks[1]);
      expect_same(blocks[0], blocks[1]);
      apart += blocks[0].state.apart;
      separated += blocks[0].chain_roots.found;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(apart, 5000);
  EXPECT_LT(apart, 15'000);
  EXPECT_GT(separated, 5000);
}

/// The arithmetic by itself, where the compiler calls the C library's fma if it must.
TEST(FusedPair, RoundsAsPairsOfDoubles) {
  const auto own = [](const DoubleDouble& x) { return pair_of<FusedPair>(x); };
  support::Operands operands(7);
  for (int k = 0; k < 20'000; ++k) {
    const auto [x, y] = operands.pair();
    expect_same(doubles_of(own(x) + own(y)), x + y);
    expect_same(doubles_of(own(x) - own(y)), x - y);
    expect_same(doubles_of(own(x) * own(y)), x * y);
    expect_same(doubles_of(own(x) * y.hi), x * y.hi);
    expect_same(doubles_of(own(x) / own(y)), x / y);
    expect_same(doubles_of(renormalized(own(x))), renormalized(x));
    EXPECT_EQ(leading(own(x)), leading(x));
    const DoubleDouble size = x.hi < 0.0 ? -x : x;
    expect_same(doubles_of(sqrt(own(size))), sqrt(size));
    expect_same(doubles_of(log(own(size))), log(size));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace stationary
