// The metadata beside the shipped results: of their tables, without what depends on a run, and enough
// to draw each figure again as it is.
#include <gtest/gtest.h>

#include <algorithm>
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
