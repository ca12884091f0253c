// What is said of errors and of what is proven, held against closed forms and other computations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// a = b as doubles and not as numbers: one that is within half a unit of a makes another balance, which has
/// motions where none are if they are equal.
TEST(StatedErrors, NumbersThatReadAlikeNeedNotBeEqual) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("case.toml", R"([body]
J = [1.0, 1.0, 1.0]
[potential]
coupled = { expression = "a*log(d) + b*log(rho) + k/2*(d*rho - 2)^2", a = 1.1, b = 1.1, k = 3.0 }
[motion]
branch = "iii"
nu = 2e-7
[solve]
all = true
)");
  const Outcome outcome = run_program({"solve", file});
  EXPECT_THAT(outcome.err + outcome.out, Not(HasSubstr("proven that there is none")));
  EXPECT_NE(outcome.code, 3);
}

/// Rates that are far larger than their difference: it is known to fewer digits.
TEST(StatedErrors, ALineOfEllipsesAtLargeRates) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("case.toml", R"([body]
J = [1.0, 1.0, 0.6]
[potential]
plane = { model = "biot", mu = 0.005, lambda = 10.0 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }
[motion]
branch = "two-polar"
omega = 0.2
theta_dot = 0.1
)");
  for (const auto& [omega, theta_dot] : {std::pair{"0.2", "0.1"}, std::pair{"1.1", "1.0"},
                                         std::pair{"2.1", "2.0"}, std::pair{"10.1", "10.0"}}) {
    const Outcome outcome =
        run_program({"solve", file, "--set", std::string("motion.omega=") + omega, "--set",
                     std::string("motion.theta_dot=") + theta_dot});
    EXPECT_EQ(outcome.code, 3) << omega;
    EXPECT_THAT(outcome.err, HasSubstr("form a continuum")) << omega;
  }
}

/// A thick body, whose inertias all but share what its thickness makes: the lanes of a map have the digits of
/// `solve`.
TEST(StatedErrors, RatesOfAThickBodyInAMap) {
  const TemporaryDirectory directory;
  const std::string file = directory.file("rod.toml", R"([body]
J = [3.0, 1e-5, 0.06]
[potential]
plane = { model = "hencky", mu = 3e-4, lambda = 0.02 }
thickness = { model = "harmonic", k = 40.0, rest = 50000.0 }
[motion]
branch = "i"
nu = 1.35
[map]
x = { parameter = "nu", from = 0.4, to = 2.4, count = 41 }
)");
  const auto cells = rows_of(run_program({"map", file, "-o", "-"}).out);
  ASSERT_EQ(cells.size(), 41U);
  int compared = 0;
  for (const Row& cell : cells) {
    if (cell.at("status") != "solved") continue;
    const Row alone = only_row(
        run_program({"solve", file, "-o", "-", "--set", "motion.nu=" + cell.at("nu")}).out);
    for (const char* column : {"growth", "re1", "im1", "re5", "im5"}) {
      const double expected = number(alone, column);
      EXPECT_NEAR(number(cell, column), expected, 2e-13 * std::abs(expected))
          << column << " at " << cell.at("nu");
    }
    ++compared;
  }
  EXPECT_GE(compared, 20);
}

}  // namespace
}  // namespace stationary::testing
