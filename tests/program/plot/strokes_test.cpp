// Curves on the page: cut at the panel's edges, with an exit for each, and dashes that never make up
// a solid line.
#include "solver/program/plot/strokes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <random>

#include "solver/program/plot/plot_style.hpp"

namespace stationary {
namespace {

constexpr PanelSize panel{600.0, 300.0};

std::vector<PagePoint> wave(double from, double to, int points) {
  std::vector<PagePoint> out;
  for (int k = 0; k <= points; ++k) {
    const double x = from + (to - from) * k / points;
    out.push_back({x, 150.0 + 40.0 * std::sin(x / 60.0)});
  }
  return out;
}

/// Whether a level curve is drawn at x.
bool covers(const DrawnCurve& curve, double x) {
  for (const Stroke& stroke : curve.strokes)
    for (std::size_t k = 1; k < stroke.size(); ++k)
      if (std::min(stroke[k - 1].x, stroke[k].x) <= x &&
          x <= std::max(stroke[k - 1].x, stroke[k].x))
        return true;
  return false;
}

TEST(Strokes, ASolidLineInsideIsItself) {
  const auto path = wave(10.0, 590.0, 50);
  const DrawnCurve curve = drawn(path, panel, {});
  ASSERT_EQ(curve.strokes.size(), 1U);
  EXPECT_EQ(curve.strokes.front().size(), path.size());
  EXPECT_TRUE(curve.exits.empty());
}

TEST(Strokes, WhatLeavesIsCutAtTheEdgeAndToldOf) {
  const std::vector<PagePoint> path{{100.0, 100.0}, {200.0, 500.0}, {300.0, 100.0}, {400.0, -1e9}};
  const DrawnCurve curve = drawn(path, panel, {});
  ASSERT_EQ(curve.strokes.size(), 2U);
  EXPECT_EQ(curve.strokes[0].back().y, 300.0);
  EXPECT_EQ(curve.strokes[1].front().y, 300.0);
  ASSERT_EQ(curve.exits.size(), 3U);
  EXPECT_EQ(curve.exits[0].side, PanelSide::top);
  EXPECT_NEAR(curve.exits[0].place, 150.0, 1e-9);
  EXPECT_EQ(curve.exits[1].side, PanelSide::top);
  EXPECT_NEAR(curve.exits[1].place, 250.0, 1e-9);
  EXPECT_EQ(curve.exits[2].side, PanelSide::bottom);
  for (const Stroke& stroke : curve.strokes)
    for (const PagePoint& p : stroke) {
      EXPECT_GE(p.y, -1e-9);
      EXPECT_LE(p.y, 300.0 + 1e-9);
    }
}

TEST(Strokes, BrokenWhereSomethingIsMissing) {
  const double none = std::nan("");
  const std::vector<PagePoint> path{{0, 1}, {10, 1}, {20, none}, {30, 1}, {40, 1}};
  EXPECT_EQ(drawn(path, panel, {}).strokes.size(), 2U);
}

TEST(Strokes, DashedCurvesOnOneAnotherLeaveTheSameGaps) {
  // Wherever they begin, in whichever direction, however finely they are computed, of any class.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> begin(0.0, 200.0);
  std::vector<DrawnCurve> curves;
  for (int k = 0; k < 30; ++k) {
    std::vector<PagePoint> path = wave(begin(random), 600.0 - begin(random), 100 + 40 * k);
    if (k % 2 == 1) std::ranges::reverse(path);
    const ClassStyle& look = class_styles[2 + static_cast<std::size_t>(k) % 3];
    ASSERT_FALSE(look.dashes.empty());
    curves.push_back(drawn(path, panel, look.dashes));
  }
  int gaps = 0;
  for (double x = 205.0; x < 395.0; x += 0.5) {
    bool any = false;
    for (const DrawnCurve& curve : curves) any |= covers(curve, x);
    if (!any) ++gaps;
  }
  // A third of every period.
  EXPECT_GT(gaps, 0.3 * 380);
  EXPECT_LT(gaps, 0.4 * 380);
}

/// gnuplot rounds places to half a pixel: the end of a line lies across its last segment.
TEST(Strokes, NoEndLiesAcrossAShortSegment) {
  for (const auto dashes : {std::span<const Dash>(), std::span<const Dash>(unstable_dashes)}) {
    std::vector<PagePoint> path{{10.0, 150.0}};
    for (int k = 0; k < 500; ++k) path.push_back({10.7 + k, 150.01 + 0.01 * (k % 2)});
    path.push_back({509.9, 150.0});
    const DrawnCurve curve = drawn(path, panel, dashes);
    ASSERT_FALSE(curve.strokes.empty());
    EXPECT_EQ(curve.strokes.front().front().x, 10.0);
    for (const Stroke& stroke : curve.strokes) {
      const double whole = std::abs(stroke.back().x - stroke.front().x);
      EXPECT_GT(whole, 0.9);
      EXPECT_GE(std::abs(stroke[1].x - stroke[0].x), std::min(whole, 4.0));
      EXPECT_GE(std::abs(stroke.end()[-1].x - stroke.end()[-2].x), std::min(whole, 4.0));
      for (std::size_t k = 1; k < stroke.size(); ++k)
        EXPECT_GE(std::abs(stroke[k].x - stroke[k - 1].x), std::min(whole, 2.0));
    }
  }
}

/// A line that turned back within a stroke would have a mitre beyond the fold.
TEST(Strokes, EndWhereThePathTurnsBack) {
  std::vector<PagePoint> path;
  for (int k = -100; k <= 100; ++k) path.push_back({300.0 - 1.5 * std::abs(k), 100.0 + 0.2 * k});
  const DrawnCurve curve = drawn(path, panel, {});
  ASSERT_EQ(curve.strokes.size(), 2U);
  EXPECT_EQ(curve.strokes[0].back().x, 300.0);
  EXPECT_EQ(curve.strokes[1].front().x, 300.0);
}

TEST(Strokes, SteepOnesAreDashedToo) {
  const std::vector<PagePoint> path{{100.0, 0.0}, {101.0, 300.0}};
  const DrawnCurve curve = drawn(path, panel, unstable_dashes);
  EXPECT_EQ(curve.strokes.size(), 15U);
  double length = 0.0;
  for (const Stroke& stroke : curve.strokes)
    length += std::hypot(stroke.back().x - stroke.front().x, stroke.back().y - stroke.front().y);
  EXPECT_NEAR(length, 300.0 * dash_gap_begins / dash_period, 1.0);
}

TEST(Strokes, NoPatternFillsTheCommonGap) {
  for (const ClassStyle& look : class_styles)
    for (const Dash& dash : look.dashes) {
      EXPECT_LT(dash.from, dash.to);
      EXPECT_LE(dash.to, dash_gap_begins);
    }
  EXPECT_LE(dash_gap_begins, 0.7 * dash_period);
}

}  // namespace
}  // namespace stationary
