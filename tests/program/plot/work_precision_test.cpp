// The shipped measurements are whole: every method on every problem, finite numbers, and nothing
// more accurate than double can be. What time they took is nobody's to test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

const std::string stem = STATIONARY_RESULTS "/work_precision";

std::vector<Row> measurements() { return rows_of(text_of(stem + ".csv")); }

TEST(WorkPrecision, HasItsColumns) {
  EXPECT_EQ(header_of(text_of(stem + ".csv")),
            "what,method,model,branch,tolerance,seconds,seconds_min,seconds_max,error_worst,"
            "error_median,count,failed");
}

TEST(WorkPrecision, HasEveryMethodOnEveryCase) {
  std::map<std::string, std::set<std::string>> methods;
  std::set<std::array<std::string, 2>> cases;
  std::set<std::array<std::string, 4>> measured;
  for (const Row& row : measurements()) {
    methods[row.at("what")].insert(row.at("method"));
    cases.insert({row.at("model"), row.at("branch")});
    measured.insert({row.at("what"), row.at("method"), row.at("model"), row.at("branch")});
  }
  EXPECT_EQ(cases.size(), 6U);
  std::size_t expected = 0;
  for (const auto& [what, of_it] : methods) expected += of_it.size() * cases.size();
  EXPECT_EQ(measured.size(), expected);
  using ::testing::IsSupersetOf;
  const std::vector<std::string> common{"reduced-newton", "reduced-corrected",   "newton-4x4",
                                        "tiny-solver",    "tiny-solver-default", "ceres",
                                        "minpack-hybrj"};
  for (const char* what : {"warm", "warm-coarse", "cold"})
    EXPECT_THAT(methods[what], IsSupersetOf(common)) << what;
  for (const char* what : {"warm", "warm-coarse"})
    EXPECT_THAT(methods[what], IsSupersetOf({"sweep", "sweep-bounded", "sweep-certified"}));
  EXPECT_THAT(methods["cold"], IsSupersetOf({"solve", "solve-certified", "solve-nlopt"}));
  EXPECT_THAT(methods["spectrum"], IsSupersetOf({"blocks", "general", "eigen-qr-11x11"}));
  EXPECT_THAT(methods["curve"], IsSupersetOf({"follow", "follow-spectra"}));
}

TEST(WorkPrecision, HasFiniteNumbersInOrder) {
  for (const Row& row : measurements()) {
    SCOPED_TRACE(row.at("what") + " " + row.at("method") + " " + row.at("model"));
    const double seconds = number(row.at("seconds"));
    EXPECT_GT(number(row.at("seconds_min")), 0.0);
    EXPECT_LE(number(row.at("seconds_min")), seconds);
    EXPECT_LE(seconds, number(row.at("seconds_max")));
    EXPECT_TRUE(std::isfinite(number(row.at("seconds_max"))));
    EXPECT_TRUE(std::isfinite(number(row.at("error_worst"))));
    EXPECT_LE(number(row.at("error_median")), number(row.at("error_worst")));
    EXPECT_GT(number(row.at("count")), 0.0);
    EXPECT_EQ(row.at("failed"), "0");
  }
}

/// Half a unit in the last place, which is 2^-53 relative at most.
TEST(WorkPrecision, TheCorrectedSolvesAreRoundedCorrectly) {
  for (const Row& row : measurements()) {
    const std::string& method = row.at("method");
    if (!method.starts_with("sweep") && !method.starts_with("solve")) continue;
    EXPECT_LE(number(row.at("error_worst")), 0x1p-53) << method << " " << row.at("model");
  }
}

TEST(WorkPrecision, SaysWhereItWasMeasured) {
  const auto metadata = nlohmann::json::parse(text_of(stem + ".meta.json"));
  for (const char* key : {"date", "processor", "compiler", "flags", "libraries", "repeats"})
    EXPECT_TRUE(metadata.contains(key)) << key;
  EXPECT_GE(metadata.at("repeats").get<int>(), 7);
  EXPECT_EQ(metadata.at("rows").get<std::size_t>(), measurements().size());
  for (const char* extension : {".svg", ".png"})
    EXPECT_GT(std::filesystem::file_size(stem + extension), 10000U) << extension;
}

}  // namespace
}  // namespace stationary::testing
