#include "solver/program/text/nearest_name.hpp"

#include <gtest/gtest.h>

namespace stationary {
namespace {

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndExchanges) {
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("branch", "branch"), 0);
  EXPECT_EQ(edit_distance("brunch", "branch"), 1);
  EXPECT_EQ(edit_distance("brnach", "branch"), 1);
  EXPECT_EQ(edit_distance("Branch", "branch"), 0);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(NearestName, FindsTheMeantOneAndNoFarOne) {
  constexpr std::string_view names[] = {"neo-hookean", "hencky", "biot", "biot-log", "nu"};
  EXPECT_EQ(nearest_name("neo-hokean", names), "neo-hookean");
  EXPECT_EQ(nearest_name("biotlog", names), "biot-log");
  EXPECT_EQ(nearest_name("mu", names), "nu");
  constexpr std::string_view options[] = {"--set", "--output", "--quiet"};
  EXPECT_EQ(nearest_name("--out", options), "--output");
  EXPECT_EQ(nearest_name("--se", options), "--set");
  EXPECT_FALSE(nearest_name("steel", names));
  EXPECT_FALSE(nearest_name("", names));
  EXPECT_FALSE(nearest_name("x", names));
  EXPECT_FALSE(nearest_name(std::string(100000, 'n'), names));
}

}  // namespace
}  // namespace stationary
