// Two imaginary pairs of opposite Krein signature that the error bounds do not tell apart: nothing
// is claimed of them, in any path.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/stability/general_spectrum.hpp"
#include "lib/stability/mode_collector.hpp"

namespace stationary {
namespace {

/// H = (p1^2 + p2^2)/2 + w (q1 p2 - q2 p1) + e (q1^2 + q2^2)/2: s = i (w +- sqrt e), of opposite
/// signatures for 0 < e < w^2, a quadruple for e < 0. e is known to the uncertainty of the inputs.
Leaf two_frequencies(double w, double e) {
  Leaf out{};
  out.pairs = 2;
  const auto set = [&](std::size_t i, std::size_t j, double value, double magnitude) {
    out.second_variation[i][j] = out.second_variation[j][i] = value;
    out.magnitude[i][j] = out.magnitude[j][i] = magnitude;
  };
  set(0, 0, e, 1.0);
  set(1, 1, e, 1.0);
  set(2, 2, 1.0, 1.0);
  set(3, 3, 1.0, 1.0);
  set(0, 3, w, w);
  set(1, 2, -w, w);
  return out;
}

bool overlap(const Mode& a, const Mode& b) {
  return std::hypot(a.lambda_re - b.lambda_re, a.lambda_im - b.lambda_im) <=
         a.lambda_error + b.lambda_error;
}

TEST(Collision, NothingIsClaimedOfWhatCannotBeToldApart) {
  int claimed = 0;
  int marginal = 0;
  for (const double uncertainty : {1e-16, 1e-12, 1e-8}) {
    for (double e = 1e-20; e < 0.5; e *= 3.0) {
      for (const int side : {1, -1}) {
        const Spectrum spectrum =
            general_spectrum({MaterialSymmetry::none, uncertainty}, two_frequencies(1.3, side * e));
        SCOPED_TRACE(::testing::Message() << "e " << side * e << ", uncertainty " << uncertainty);
        ASSERT_EQ(spectrum.modes, 2);
        const Mode& first = spectrum.mode[0];
        const Mode& second = spectrum.mode[1];
        if (spectrum.verdict == StabilityClass::marginal) {
          ++marginal;
          EXPECT_LE(e, 1e4 * uncertainty) << "it can be decided here";
          for (const Mode* mode : {&first, &second}) {
            EXPECT_EQ(mode->krein, 0);
            EXPECT_EQ(mode->krein_open, mode->re == 0.0);
          }
          continue;
        }
        ++claimed;
        EXPECT_GT(e, uncertainty);
        EXPECT_EQ(spectrum.verdict,
                  side > 0 ? StabilityClass::elliptic : StabilityClass::oscillatory);
        if (side < 0) continue;
        EXPECT_FALSE(overlap(first, second));
        EXPECT_EQ(first.krein * second.krein, -1);
        EXPECT_FALSE(first.krein_open || second.krein_open);
      }
    }
  }
  EXPECT_GE(claimed, 100);
  EXPECT_GE(marginal, 50);
}

Spectrum collected(double first, int krein, double second, int other, double error,
                   Axis axis = Axis::may_leave) {
  ModeCollector out;
  out.add_real(first, error, krein, axis);
  out.add_real(second, error, other, axis);
  return out.finish();
}

TEST(Collision, IsAskedWhereModesAreCollected) {
  constexpr double error = 4.8e-6;
  EXPECT_EQ(collected(-0.66285672, -1, -0.66285767, 1, error).verdict, StabilityClass::marginal);
  EXPECT_EQ(collected(-0.66285672, -1, -0.66295767, 1, error).verdict, StabilityClass::elliptic);
  // Of one signature they do not leave the axis; in a symmetric problem none do.
  EXPECT_EQ(collected(-0.66285672, 1, -0.66285767, 1, error).verdict, StabilityClass::stable);
  EXPECT_EQ(collected(-0.66285672, -1, -0.66285767, 1, error, Axis::stays).verdict,
            StabilityClass::elliptic);
  // Real pairs that may be a quadruple.
  EXPECT_EQ(collected(0.66285672, 0, 0.66285767, 0, error).verdict, StabilityClass::marginal);
  EXPECT_EQ(collected(0.66285672, 0, 0.66295767, 0, error).verdict, StabilityClass::unstable);
  // A signature that is not known leaves open whether the motion is stable or elliptic.
  const Spectrum open = collected(-1.0, 1, -2.0, 0, error);
  EXPECT_EQ(open.verdict, StabilityClass::marginal);
  EXPECT_TRUE(open.mode[1].krein_open);
  EXPECT_FALSE(open.mode[0].krein_open);
}

TEST(Collision, ModesOfTwoBlocksPass) {
  ModeCollector out;
  out.begin(Block::even);
  out.add_real(-0.5, 1e-3, 1, Axis::may_leave);
  out.begin(Block::odd);
  out.add_real(-0.5, 1e-3, -1, Axis::may_leave);
  const Spectrum spectrum = out.finish();
  EXPECT_EQ(spectrum.verdict, StabilityClass::elliptic);
  EXPECT_TRUE(spectrum.away_from_zero());
}

TEST(Collision, ZeroIsNoFrequency) {
  const Spectrum spectrum = collected(-1e-9, 1, -2.0, 1, 1e-8);
  EXPECT_EQ(spectrum.verdict, StabilityClass::marginal);
  EXPECT_FALSE(spectrum.away_from_zero());
  EXPECT_TRUE(spectrum.mode[0].krein_open);
  EXPECT_EQ(spectrum.mode[1].krein, 1);
}

}  // namespace
}  // namespace stationary
