// The metadata beside the shipped results: of their tables, without what depends on a run, and enough
// to draw each figure again as it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/program/json_schema.hpp"
#include "tests/program/needs_gnuplot.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Stems of the tables that the program wrote; the others were measured.
std::vector<std::string> tables() {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(STATIONARY_RESULTS)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() == ".csv" && stem != "work_precision" && stem != "completeness" &&
        stem != "event_curves" && stem != "riemann" && !stem.starts_with("stress"))
      out.push_back(stem);
  }
  std::ranges::sort(out);
  return out;
}

std::string result(const std::string& name) { return STATIONARY_RESULTS "/" + name; }

class ShippedTable : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedTable, HasItsMetadataWithoutTheRun) {
  const Json metadata = Json::parse(text_of(result(GetParam() + ".meta.json")));
  EXPECT_EQ(schema_fault(metadata, Json::parse(text_of(STATIONARY_SCHEMA))), "");
  EXPECT_FALSE(metadata.contains("run"));
  EXPECT_EQ(metadata["rows"], rows_of(text_of(result(GetParam() + ".csv"))).size());
  EXPECT_TRUE(
      fs::exists(fs::path(STATIONARY_CASES) / ".." / metadata["case_file"].get<std::string>()));
}

/// Where a sheet ends on another, both tell the event, each with what it knows of the place.
TEST(ShippedAtlas, BracketsOfOneEventOnTwoSheetsOverlap) {
  int seen = 0;
  for (const std::string& stem : tables()) {
    const Json metadata = Json::parse(text_of(result(stem + ".meta.json")));
    for (const Json& one : metadata["events"]) {
      for (const Json& other : metadata["events"]) {
        const double p = one["parameter"];
        if (other["event"] != one["event"] || other["sheet"] <= one["sheet"]) continue;
        if (!(std::abs(other["parameter"].get<double>() - p) <= 1e-9 * std::abs(p))) continue;
        EXPECT_LE(one["bracket"][0], other["bracket"][1]) << stem << one << other;
        EXPECT_LE(other["bracket"][0], one["bracket"][1]) << stem << one << other;
        ++seen;
      }
    }
  }
  EXPECT_GE(seen, 10);
}

/// The end of an oblique sheet under gravity has no equations of its own: what the inputs' rounding may do to it is
/// more than to the event of the axis, which has, and holds that.
TEST(ShippedAtlas, AnEndWithoutEquationsHasTheWiderBracket) {
  const Json metadata = Json::parse(text_of(result("heavy_plate_atlas.meta.json")));
  const auto width = [](const Json& event) {
    return event["bracket"][1].get<double>() - event["bracket"][0].get<double>();
  };
  int seen = 0;
  for (const Json& one : metadata["events"]) {
    for (const Json& other : metadata["events"]) {
      if (one["event"] != "oblique" || other["event"] != "oblique") continue;
      if (one["sheet"] > 2 || other["sheet"] != 6 || one["parameter"] != other["parameter"])
        continue;
      EXPECT_LT(other["bracket"][0], one["bracket"][0]);
      EXPECT_GT(other["bracket"][1], one["bracket"][1]);
      EXPECT_GT(width(other), 8.0 * width(one));
      ++seen;
    }
  }
  EXPECT_EQ(seen, 2);
}

TEST_P(ShippedTable, IsDrawnAgainAsItIs) {
  NEEDS_GNUPLOT();
  // A map's picture is of a table that is too large to ship.
  const std::string text = text_of(result(GetParam() + ".meta.json"));
  const std::string picture = result(GetParam() + ".svg");
  if (!fs::exists(picture) || Json::parse(text)["case"].contains("map")) return;
  const TemporaryDirectory directory;
  const std::string drawn = directory / "drawn.svg";
  const Outcome plotted = run_program({"plot", result(GetParam() + ".csv"), "-o", drawn, "-q"});
  ASSERT_EQ(plotted.code, 0) << plotted.err;
  EXPECT_TRUE(text_of(drawn) == text_of(picture))
      << "`cmake --build ... --target results` makes it";
}

INSTANTIATE_TEST_SUITE_P(All, ShippedTable, ::testing::ValuesIn(tables()),
                         [](const auto& param) { return param.param; });

}  // namespace
}  // namespace stationary::testing
