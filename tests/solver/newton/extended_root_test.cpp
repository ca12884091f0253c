// The bound on a root in extended precision: it holds where the input's last digit moves the root
// by a good part of its distance to another, as near a cusp of events.
#include "solver/newton/extended_root.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stationary {
namespace {

/// (y - 1)^2 = s: two roots, 1 - sqrt(s) and 1 + sqrt(s). The input is s. Beside it z = 1.
struct TwoRoots {
  static constexpr int dimension = 2;
  double s;

  std::size_t inputs() const { return 1; }
  bool has_decimals() const { return false; }
  ExtendedVector<2> values(const ExtendedVector<2>& y, InputChange change) const {
    const DoubleDouble off = y[0] - 1.0;
    // Of the sum s + 1, as of a body whose numbers are of order one.
    return {off * off - (change(s + 1.0, 0) - 1.0), y[1] - 1.0};
  }
  std::array<Conditioned, 2> conditioned(const std::array<Conditioned, 2>& y, bool) const {
    const Conditioned off = y[0] - Conditioned(1.0);
    return {off * off - Conditioned(s), y[1] - Conditioned(1.0)};
  }
};

TEST(ExtendedRoot, TheBoundHoldsNearADoubleRoot) {
  int told = 0;
  for (int k = 4; k < 52; ++k) {
    const double s = std::ldexp(1.0, -k);
    const double root = std::sqrt(s);
    const auto found = extended_root(TwoRoots{s}, {DoubleDouble(1.0 + root), 1.0});
    if (!found) continue;
    ++told;
    EXPECT_NEAR(double(found->y[0] - 1.0), root, 1e-14 * root);
    for (const double unit : {-0x1p-53, 0x1p-53}) {
      const double by = unit * (1.0 + s);
      const double moved = by / (std::sqrt(s + by) + root);
      EXPECT_GE(found->error[0], std::abs(moved) / (1.0 + root)) << "s = 2^-" << k;
    }
    // No more than about twice what it is to the first order, and a little.
    EXPECT_LE(found->error[0], 2.5 * 0x1p-53 * (1.0 + s) / (2.0 * root) + 1e-15);
  }
  EXPECT_GE(told, 40);
  EXPECT_FALSE(extended_root(TwoRoots{0x1p-53}, {DoubleDouble(1.0 + 0x1p-26), 1.0}));
}

}  // namespace
}  // namespace stationary
