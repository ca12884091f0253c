// Frequencies as curves: a mode keeps its Krein signature, not its place in the row.
#include "solver/program/diagram/rate_tracks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace stationary {
namespace {

struct RowModes {
  std::vector<double> frequency;
  std::vector<int> krein;
  double growth = 0.0;
};

Diagram diagram_of_modes(const std::vector<RowModes>& rows) {
  Diagram out;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    DiagramPoint point{};
    point.parameter = point.abscissa = static_cast<double>(k);
    point.frequency.fill(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t m = 0; m < rows[k].frequency.size(); ++m) {
      point.frequency[m] = rows[k].frequency[m];
      point.krein[m] = static_cast<std::int8_t>(rows[k].krein[m]);
    }
    point.growth = rows[k].growth;
    out.points.push_back(point);
  }
  return out;
}

std::vector<RateTrack> tracks(const std::vector<RowModes>& rows) {
  std::vector<std::size_t> all(rows.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return rate_tracks(diagram_of_modes(rows), all);
}

std::vector<double> rates(const RateTrack& track) {
  std::vector<double> out;
  for (const RatePoint& each : track.points) out.push_back(each.rate);
  return out;
}

TEST(RateTracks, OppositeSignaturesCross) {
  const auto found = tracks({{{1.0, 2.0}, {1, -1}}, {{1.4, 1.6}, {1, -1}}, {{1.2, 1.8}, {-1, 1}}});
  ASSERT_EQ(found.size(), 2U);
  for (const RateTrack& track : found) {
    const bool positive = track.kind == RateKind::positive;
    EXPECT_EQ(rates(track), positive ? (std::vector<double>{1.0, 1.4, 1.8})
                                     : (std::vector<double>{2.0, 1.6, 1.2}));
  }
}

/// The table has them in ascending order.
std::vector<RowModes> two_modes(double (*one)(double), double (*two)(double)) {
  std::vector<RowModes> out;
  for (const double x : {-3.5, -2.5, -1.5, -0.5, 0.5, 1.5, 2.5, 3.5})
    out.push_back({{std::min(one(x), two(x)), std::max(one(x), two(x))}, {1, 1}});
  return out;
}

TEST(RateTracks, OneSignatureCrossesWhereItGoesStraightOn) {
  const auto found =
      tracks(two_modes([](double x) { return 10.0 + x; }, [](double x) { return 10.0 - 0.1 * x; }));
  ASSERT_EQ(found.size(), 2U);
  for (const RateTrack& track : found) {
    ASSERT_EQ(track.points.size(), 8U);
    const double first = track.points.front().rate;
    EXPECT_NEAR(track.points.back().rate, first < 7.0 ? 13.5 : 9.65, 1e-12);
  }
}

TEST(RateTracks, OneSignatureTurnsAwayWhereItBends) {
  const auto found = tracks(two_modes([](double x) { return 10.0 + std::sqrt(1.0 + x * x); },
                                      [](double x) { return 10.0 - std::sqrt(1.0 + x * x); }));
  ASSERT_EQ(found.size(), 2U);
  for (const RateTrack& track : found)
    EXPECT_NEAR(track.points.back().rate, track.points.front().rate, 1e-12);
}

TEST(RateTracks, AfterACollisionTheQuadrupleGoesOn) {
  const auto found = tracks(
      {{{1.0, 2.0, 5.0}, {1, -1, 1}}, {{1.5, 1.5, 5.0}, {0, 0, 1}}, {{1.5, 1.5, 5.0}, {0, 0, 1}}});
  int undetermined = 0;
  for (const RateTrack& track : found) {
    if (track.kind == RateKind::undetermined) {
      ++undetermined;
      EXPECT_EQ(rates(track), (std::vector<double>{1.5, 1.5}));
    } else if (track.points.size() == 3) {
      EXPECT_EQ(rates(track), (std::vector<double>{5.0, 5.0, 5.0}));
    } else {
      EXPECT_EQ(rates(track).back(), 1.5);
    }
  }
  EXPECT_EQ(undetermined, 2);
  EXPECT_EQ(found.size(), 5U);
}

TEST(RateTracks, ComeDownToZeroButDoNotRunAlongIt) {
  const auto found = tracks({{{0.5, 2.0}, {1, 1}, 0.0},
                             {{0.0, 2.0}, {0, 1}, 0.0},
                             {{0.0, 2.0}, {0, 1}, 0.3},
                             {{0.0, 2.0}, {0, 1}, 0.4}});
  ASSERT_EQ(found.size(), 3U);
  for (const RateTrack& track : found) {
    if (track.kind == RateKind::growth) {
      EXPECT_EQ(rates(track), (std::vector<double>{0.0, 0.3, 0.4}));
    } else if (track.points.size() == 2) {
      EXPECT_EQ(rates(track), (std::vector<double>{0.5, 0.0}));
    } else {
      EXPECT_EQ(rates(track).size(), 4U);
    }
  }
}

TEST(RateTracks, WhereAModeIsMissingTheOthersKeepTheirCurves) {
  // At nu = 0 the lowest mode, the spin's own, is not there.
  const auto found = tracks({{{1.0, 2.0, 3.0}, {1, 1, 1}}, {{0.1, 1.1, 2.1, 3.1}, {1, 1, 1, 1}}});
  ASSERT_EQ(found.size(), 3U);
  for (const RateTrack& track : found)
    EXPECT_NEAR(track.points[1].rate - track.points[0].rate, 0.1, 1e-12);
}

}  // namespace
}  // namespace stationary
