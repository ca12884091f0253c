// What the templates ask of a number type, for each type the library is used with.
#include "lib/number/number.hpp"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <cmath>

#include "lib/material/potential.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace support;

TEST(Number, LeadingIsTheNearestDouble) {
  EXPECT_EQ(leading(1.5), 1.5);
  EXPECT_EQ(leading(DoubleDouble(1.5, 1e-17)), 1.5);
  EXPECT_EQ(leading(Real50("0.1")), 0.1);
  EXPECT_EQ(leading(Decimal50("0.1")), 0.1);
  EXPECT_EQ(leading(ceres::Jet<double, 2>(2.5, 0)), 2.5);
  EXPECT_EQ(leading(ceres::Jet<DoubleDouble, 2>(DoubleDouble(2.5), 0)), 2.5);
}

TEST(Number, SignificandBitsAreBits) {
  EXPECT_EQ(significand_bits<double>(), 53);
  EXPECT_EQ(significand_bits<DoubleDouble>(), 104);
  EXPECT_EQ((significand_bits<ceres::Jet<double, 4>>()), 53);
  EXPECT_GE(significand_bits<Real50>(), 166);
  // A decimal type counts digits; 50 of them are 166 bits.
  EXPECT_GE(significand_bits<Decimal50>(), 166);
}

TEST(Number, PoisonIsNaN) {
  EXPECT_TRUE(std::isnan(poison<double>()));
  EXPECT_TRUE(std::isnan(poison<DoubleDouble>().hi));
  const Real50 wide = poison<Real50>();
  EXPECT_FALSE(wide == wide);
  EXPECT_TRUE(std::isnan(poison<ceres::Jet<double, 2>>().a));
}

TEST(Number, ACoefficientMayCarryTheDerivative) {
  // dW/d(mu) at a fixed state: the coefficient is the dual number, the state a double.
  using Jet = ceres::Jet<double, 1>;
  const BiotLog<Jet> model{Jet(1.0, 0), Jet(0.6)};
  const auto v = model.evaluate<2>(planar_invariants(1.3, 0.8));
  const auto unit = BiotLog<>{1.0, 0.0}.evaluate<2>(planar_invariants(1.3, 0.8));
  EXPECT_NEAR(v.w.v[0], unit.w, 1e-15);
  EXPECT_NEAR(v.w_t.v[0], unit.w_t, 1e-15);
  EXPECT_NEAR(v.w_l.v[0], unit.w_l, 1e-15);
  EXPECT_NEAR(v.w_ll.v[0], unit.w_ll, 1e-15);
}

}  // namespace
}  // namespace stationary
