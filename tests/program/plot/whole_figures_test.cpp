// Whole figures by the program: of tables at the ends of the double range.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/program/needs_gnuplot.hpp"
#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class WholeFigure : public ::testing::Test {
 protected:
  Outcome plot(const std::string& text, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"plot", directory_.file("x.csv", text), "-o",
                                       directory_ / "x.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }

  TemporaryDirectory directory_;
};

TEST_F(WholeFigure, OfValuesAtTheEndsOfTheDoubles) {
  NEEDS_GNUPLOT();
  for (const std::string value : {"1e300", "1.7e308", "-1.7e308", "1e-320", "5e-324", "0"}) {
    const Outcome outcome = plot(
        "branch,nu1,lambda,mu,rho,class,growth,im1\ni,0.1,1,1,1,stable,0,1\n"
        "i,0.2,2,1,1.7e308,stable,0," +
        value + "\ni,0.3," + value + ",1,1,unstable," + value + ",0\n");
    EXPECT_EQ(outcome.code, 0) << value << outcome.err;
    const Outcome map = plot("xi,status,nu,body.J.0\n" + value + ",solved,0," + "4e307\n" +
                             "1.7e308,solved,0.5,4e307\n1,solved,0,1\n1,solved,0.5,1\n");
    EXPECT_EQ(map.code, 0) << value << map.err;
  }
}

}  // namespace
}  // namespace stationary::testing
