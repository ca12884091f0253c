// What the benchmark reads of AUTO-07p's file fort.7.
#include "tests/bench/work_precision/auto_output.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace stationary::testing {
namespace {

using bench::auto_points;
using ::testing::ElementsAre;

const std::string auto_header =
    "   0  -1.0000E+00  3.0000E+00 -9.9000E+01  1.3816E+01\n"
    "   0   NMX=*****   NPR=    0   MXBF=   0   IID =   0   IADS=   1\n"
    "   0   NPAR=  36   THL = {}    THU = {}\n"
    "   0\n"
    "   0    PT  TY  LAB    PAR(1)               U(2)               U(1)               U(2)        "
    "  "
    "\n";
const std::string start =
    "   1     1   9    1  0.0000000000E+000  0.0000000000E+000  0.0000000000E+000  "
    "0.0000000000E+000\n";
const std::string fold =
    "   1  3212   2    2  7.6696498885E-001  9.2142000001E+000 -8.7142000001E+000  "
    "9.2142000001E+000\n";
const std::string point =
    "   1  9999   0    0  7.6696498885E-001  1.3797662928E+001 -1.3297662928E+001  "
    "1.3797662928E+001\n";

TEST(AutoOutput, HasThePointsWithTheirElevenDigits) {
  const auto points = auto_points(auto_header + start + fold + point);
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[0].type, 9);
  EXPECT_EQ(points[0].parameter, 0.0);
  EXPECT_EQ(points[1].type, 2);
  EXPECT_EQ(points[2].type, 0);
  EXPECT_EQ(points[2].parameter, 7.6696498885e-1);
  EXPECT_THAT(points[2].unknowns, ElementsAre(-13.297662928, 13.797662928));
}

TEST(AutoOutput, IsThatOfTheLastRun) {
  const auto points = auto_points(auto_header + start + point + auto_header + start + fold);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[1].type, 2);
  EXPECT_TRUE(auto_points("").empty());
  EXPECT_TRUE(auto_points(auto_header + start + auto_header).empty());
}

TEST(AutoOutput, NothingElseIsTakenForAPoint) {
  for (const char* line : {
           "Segmentation fault\n",
           "   1     2   0\n",
           "   1     2   0    0  1.0E+000  2.0E+000\n",
           "   1     2   0    0  1.0E+000  2.0E+000  *****************\n",
           "   1     2   0    0  1.0E+000  2.0E+000                NaN\n",
           "   1     2   0    0                NaN  2.0E+000  1.0E+000\n",
       })
    EXPECT_THROW(auto_points(auto_header + start + line), std::runtime_error) << line;
}

}  // namespace
}  // namespace stationary::testing
