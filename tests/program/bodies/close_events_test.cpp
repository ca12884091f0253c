// Events close to one another, to the end of their sheet or to the range's, and what is none beside
// a crossing of rounding.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/program/continued.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

class CloseEvents : public ::testing::Test {
 protected:
  std::vector<Row> followed(const std::string& text, const std::vector<std::string>& more = {}) {
    const Outcome outcome = continued(directory_.file("case.toml", text), more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return rows_of(outcome.out);
  }
  /// Where events of a type lie.
  static std::vector<double> places(const std::vector<Row>& rows, const std::string& event,
                                    const std::string& column) {
    std::vector<double> out;
    for (const Row& row : rows)
      if (row.at("event") == event) out.push_back(number(row, column));
    return out;
  }

  TemporaryDirectory directory_;
};

/// Two frequencies of opposite signatures pass 3e-5 beyond where the circle breaks, at which one of them is 0.
TEST_F(CloseEvents, APassBesideTheEndOfACircle) {
  const std::string text = R"([body]
J = [1.03, 1.03, 2.014]
[potential]
plane = { model = "hencky", mu = 0.449, lambda = 0.615 }
thickness = { model = "harmonic", k = 1.894, rest = 0.883 }
[motion]
branch = "iii"
nu = 0.146
[continuation]
from = 0.0
to = 1.522
)";
  for (const char* tolerance : {"1e-6", "1e-8", "1e-10"}) {
    const auto passes = places(followed(text, {std::string("continuation.tolerance=") + tolerance}),
                               "krein-pass", "nu3");
    ASSERT_EQ(passes.size(), 1U) << tolerance;
    EXPECT_NEAR(passes[0], 0.5346788, 1e-7) << tolerance;
  }
}

/// What is definite on a circle changes where no frequencies meet, in one step with a collision or not.
TEST_F(CloseEvents, AChangeOfDefinitenessBesideACollision) {
  const std::string text = R"([body]
J = [0.327, 0.327, 0.907]
[potential]
plane = { model = "hencky", mu = 0.451, lambda = 0.97 }
thickness = { model = "harmonic", k = 4.406, rest = 1.557 }
[motion]
branch = "iii"
nu = 0.0
[continuation]
from = -1.6
to = 1.6
)";
  for (const char* tolerance : {"1e-5", "1e-6", "1e-8", "1e-10"}) {
    SCOPED_TRACE(tolerance);
    const auto rows = followed(text, {std::string("continuation.tolerance=") + tolerance});
    const auto changes = places(rows, "unexplained", "nu3");
    ASSERT_EQ(changes.size(), 2U);
    EXPECT_NEAR(changes[0], -1.205381736, 1e-8);
    EXPECT_NEAR(changes[1], 1.205381736, 1e-8);
    // Up to the collision itself.
    const auto ended =
        followed(text, {std::string("continuation.tolerance=") + tolerance, "continuation.from=0",
                        "continuation.to=1.2091831503937809"});
    const auto change = places(ended, "unexplained", "nu3");
    ASSERT_EQ(change.size(), 1U);
    EXPECT_NEAR(change[0], 1.205381736, 1e-8);
  }
}

/// A tilt in the last tenth of the way to the circle where the ellipses end.
TEST_F(CloseEvents, ATiltJustBeforeASheetEnds) {
  const std::string text = R"([body]
J = [1.0, 1.0, 2.781982817860235]
[potential]
plane = { model = "biot-log", mu = 1.0, lambda = 4.0 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[motion]
branch = "iii"
nu = 1.25
[solve]
start = [0.0, 4.3087599845785105, 0.2626685868500611, 0.6933612743506347]
[continuation]
from = 0.0
to = 3.0
)";
  for (const char* tolerance : {"1e-6", "1e-8", "1e-10"}) {
    SCOPED_TRACE(tolerance);
    const auto rows = followed(text, {std::string("continuation.tolerance=") + tolerance});
    ASSERT_EQ(places(rows, "ellipse", "nu3").size(), 1U);
    EXPECT_NEAR(places(rows, "ellipse", "nu3")[0], 1.0651183125, 1e-9);
    const auto tilts = places(rows, "tilt", "nu3");
    ASSERT_EQ(tilts.size(), 1U);
    EXPECT_NEAR(tilts[0], 1.0651184670, 1e-9);
  }
}

/// Where two momenta come to be equal the rates are 0/0: no event is seen in them.
TEST_F(CloseEvents, NoneInRatesThatAreRounding) {
  const auto rows = followed(R"([body]
J = [0.812, 0.812, 2.784]
volume = 0.8
[potential]
plane = { model = "saint-venant-kirchhoff", mu = 1.527, lambda = 0.818 }
thickness = { model = "harmonic", k = 4.831, rest = 1.314 }
[motion]
branch = "two-polar"
s3 = -0.217
p_theta = 0.581
[continuation]
parameter = "motion.s3"
from = -2.0
to = 3.0
)");
  EXPECT_EQ(names_of_events(rows), "limit zero-momentum ellipse");
}

/// The momentum that is followed turns 2e-4 beyond the range: there the table ends.
TEST_F(CloseEvents, AMomentumThatTurnsBeyondItsRange) {
  const std::string text = R"([body]
J = [2.288, 2.288, 1.004]
[potential]
plane = { model = "saint-venant-kirchhoff", mu = 1.538, lambda = 1.091 }
thickness = { model = "reciprocal-quadratic", a = 0.312, b = 2.679 }
[motion]
branch = "two-polar"
s3 = -0.649
p_theta = 0.234
[continuation]
parameter = "motion.s3"
from = -1.169
to = 3.522
)";
  for (const char* tolerance : {"1e-6", "1e-8", "1e-10"}) {
    SCOPED_TRACE(tolerance);
    const auto rows = followed(text, {std::string("continuation.tolerance=") + tolerance});
    ASSERT_GT(rows.size(), 20U);
    for (const Row& row : rows) EXPECT_GE(number(row, "motion.s3"), -1.169);
    EXPECT_EQ(rows.front().at("event"), "limit");
    EXPECT_EQ(rows.front().at("motion.s3"), "-1.169");
  }
}

/// Heavy and J1 != J2: the ellipse passes xi = zeta, where the condition of `shear` is 0/0 and its sign
/// rounding, and nothing happens.
TEST_F(CloseEvents, NoneWhereAHeavyEllipseIsRound) {
  const std::string text = R"([body]
J = [1.0, 1.7, 0.6]
volume = 1.0
[gravity]
g = 2.0
[potential]
plane = { model = "biot", mu = 1.0, lambda = 1.0 }
thickness = { model = "harmonic", k = 1.0, rest = 1.0 }
[motion]
branch = "iii"
nu = 0.4
[continuation]
from = 0.0
to = 1.0
)";
  EXPECT_EQ(names_of_events(followed(text)), "limit limit");
  for (const char* round : {"0.4451051528384723", "0.44510515283847223", "0.4451051528384722"}) {
    SCOPED_TRACE(round);
    const std::string at = round;
    EXPECT_EQ(names_of_events(followed(text, {"continuation.to=" + at})), "limit limit");
    EXPECT_EQ(names_of_events(followed(text, {"continuation.from=" + at, "motion.nu=" + at})),
              "limit limit");
  }
  for (const char* stiffness : {"1e14", "1e15"}) {
    SCOPED_TRACE(stiffness);
    const std::string of = stiffness;
    EXPECT_EQ(
        names_of_events(followed(text, {"potential.plane.mu=" + of, "potential.plane.lambda=" + of,
                                        "potential.thickness.k=" + of})),
        "limit limit");
  }
}

}  // namespace
}  // namespace stationary::testing
