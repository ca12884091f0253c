// Axes: what runs off does not press the rest flat, one stiff mode does not hide the others; what they
// are called.
#include "solver/program/diagram/axis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/program/diagram/axis_name.hpp"
#include "solver/program/diagram/ticks.hpp"

namespace stationary {
namespace {

constexpr int rows = 200;
constexpr double many = 100.0;  ///< ticks

template <class Function>
WeightedCurve curve(const Function& value) {
  WeightedCurve out;
  for (int k = 0; k < rows; ++k) out.push_back({value(static_cast<double>(k) / rows), 1.0 / rows});
  return out;
}

/// How much of the axis a curve spans, as far as it is in the picture.
double span(const Axis& axis, const WeightedCurve& curve) {
  double low = 1.0;
  double high = 0.0;
  for (const WeightedValue& v : curve) {
    const double place = std::clamp(axis.place(v.value), 0.0, 1.0);
    low = std::min(low, place);
    high = std::max(high, place);
  }
  return high - low;
}

TEST(Axis, ShowsAllOfWhatStaysTogether) {
  const auto rising = curve([](double x) { return 1.0 + x; });
  const Axis axis = fitted_axis({rising});
  EXPECT_FALSE(axis.logarithmic);
  EXPECT_LT(axis.range.low, 1.0);
  EXPECT_GT(axis.range.high, rising.back().value);
  EXPECT_GT(span(axis, rising), 0.9);
}

TEST(Axis, WhatRunsOffIsCut) {
  // An escape over next to no range.
  auto escaping = curve([](double x) { return 1.0 + x; });
  escaping.push_back({1e3, 1e-4});
  escaping.push_back({1e6, 1e-6});
  const auto level = curve([](double x) { return 1.0 - 0.2 * x; });
  const Axis axis = fitted_axis({escaping, level});
  EXPECT_FALSE(axis.logarithmic);
  EXPECT_LT(axis.range.high, 3.0);
  EXPECT_GT(axis.place(2.0) - axis.place(0.8), 0.4);
}

TEST(Axis, LogarithmicWhereTheCurvesThemselvesSpanMuch) {
  const auto wide = curve([](double x) { return std::pow(100.0, x); });
  const Axis axis = fitted_axis({wide});
  EXPECT_TRUE(axis.logarithmic);
  EXPECT_GT(span(axis, wide), 0.9);
  EXPECT_NEAR(axis.value(axis.place(7.0)), 7.0, 1e-12);
  EXPECT_TRUE(std::isnan(axis.place(-1.0)));
}

TEST(Axis, OneValueHasAnIntervalAboutIt) {
  const Axis axis = fitted_axis({curve([](double) { return 2.0; })});
  EXPECT_LT(axis.range.low, 2.0);
  EXPECT_GT(axis.range.high, 2.0);
}

TEST(Axis, AStiffModeDoesNotHideTheOthers) {
  std::vector<WeightedCurve> modes{curve([](double) { return 5e4; })};
  for (int k = 1; k <= 4; ++k)
    modes.push_back(curve([k](double x) { return k * (1.0 + 0.3 * x); }));
  const Axis axis = fitted_rate_axis(modes);
  EXPECT_TRUE(axis.logarithmic);
  for (const WeightedCurve& mode : modes) {
    EXPECT_GT(axis.place(mode.front().value), 0.02);
    EXPECT_LE(axis.place(mode.front().value), 1.0);
  }
}

TEST(Axis, AModeThatOutgrowsTheOthersIsCutAboveThem) {
  std::vector<WeightedCurve> modes{curve([](double x) { return 4.0 / (1.001 - x); })};
  for (int k = 1; k <= 4; ++k) modes.push_back(curve([k](double x) { return k + 0.1 * x; }));
  const Axis axis = fitted_rate_axis(modes);
  EXPECT_FALSE(axis.logarithmic);
  EXPECT_EQ(axis.range.low, 0.0);
  EXPECT_GT(axis.place(4.0), 0.4);
}

TEST(Axis, TicksOfALogarithmicOneAreAllNamed) {
  EXPECT_EQ(logarithmic_ticks({0.05, 30.0}, many), "'0.1' 0.1, '1' 1, '10' 10");
  EXPECT_EQ(logarithmic_ticks({0.3, 3.0}, many),
            "'0.3' 0.3, '0.5' 0.5, '0.7' 0.7, '1' 1, '2' 2, '3' 3");
  EXPECT_EQ(logarithmic_ticks({1.0, 100.0}, many, true),
            "'1' 0, '2' 0.301029995664, '5' 0.698970004336, '10' 1, "
            "'20' 1.30102999566, '50' 1.69897000434, '100' 2");
}

TEST(Axis, IsFiniteNearTheEndsOfTheDoubles) {
  for (const double size : {5e-324, 1e-320, 1e-307, 1e200, 1e300, 1.7e308}) {
    const auto wide = curve([&](double x) { return x > 0.5 ? size : 1.0 + x; });
    const auto signs = curve([&](double x) { return x > 0.5 ? size : -size; });
    const auto level = curve([&](double) { return size; });
    for (const auto& each : {wide, signs, level}) {
      for (const Axis& axis : {fitted_axis({each}), fitted_rate_axis({each}), whole_axis({each})}) {
        EXPECT_LT(axis.range.low, axis.range.high) << size;
        EXPECT_TRUE(std::isfinite(axis.range.high - axis.range.low)) << size;
        EXPECT_EQ(axis.place(axis.range.low), 0.0) << size;
        EXPECT_EQ(axis.place(axis.range.high), 1.0) << size;
        if (axis.logarithmic) {
          EXPECT_NE(logarithmic_ticks(axis.range, many), "") << size;
        }
      }
    }
  }
  EXPECT_FALSE(asked_axis({1e-320, 1.0}, true).logarithmic);
}

TEST(Axis, NoTicksWhereThereIsNoLogarithm) {
  for (const AxisRange& range : {AxisRange{0.0, 1.0}, AxisRange{-1.0, 1.0}, AxisRange{1.0, 1.0},
                                 AxisRange{std::nan(""), 1.0}})
    EXPECT_EQ(logarithmic_ticks(range, many), "");
  EXPECT_EQ(logarithmic_ticks({1e300, INFINITY}, many),
            "'1e+300' 1e+300, '1e+302' 1e+302, "
            "'1e+304' 1e+304, '1e+306' 1e+306");
}

TEST(Axis, HasAsManyTicksAsThereIsRoomFor) {
  EXPECT_EQ(linear_ticks({0.0, 1.0}, 400.0, AxisWay::upright), "autofreq");
  EXPECT_EQ(linear_ticks({0.8, 1.55}, 90.0, AxisWay::upright), "0.2");
  EXPECT_EQ(linear_ticks({0.0, 1.0}, 150.0, AxisWay::level), "autofreq");
  EXPECT_EQ(linear_ticks({0.0, 1.0}, 100.0, AxisWay::level), "0.5");
  EXPECT_EQ(linear_ticks({10000.0, 18000.0}, 150.0, AxisWay::level), "5000");
  EXPECT_EQ(linear_ticks({-4e307, 4e307}, 20.0, AxisWay::upright), "5e+307");
  EXPECT_EQ(logarithmic_ticks({0.3, 3.0}, 4.0), "'0.5' 0.5, '1' 1, '2' 2");
  EXPECT_EQ(logarithmic_ticks({1e-6, 1e6}, 3.0), "'0.0001' 0.0001, '1' 1, '10000' 10000");
}

TEST(AxisName, IsThePapersNotTheKey) {
  EXPECT_EQ(axis_name("body.J.1"), "J₂");
  EXPECT_EQ(axis_name("body.J.1/body.J.0"), "J₂/J₁");
  EXPECT_EQ(axis_name("potential.fibre.degrees"), "fibre angle/°");
  EXPECT_EQ(axis_name("potential.plane.c"), "c of the plane");
  EXPECT_EQ(axis_name("potential.coupled.lambda"), "λ of V");
  EXPECT_EQ(axis_name("motion.nu"), "ν");
  EXPECT_EQ(axis_name("rho"), "ϱ");
  EXPECT_EQ(axis_name("something else"), "something else");
}

}  // namespace
}  // namespace stationary
