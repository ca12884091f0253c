// Every shipped case is accepted by check and ends as its comment says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "solver/program/case/case_file.hpp"
#include "solver/program/table/table.hpp"
#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

std::vector<std::string> shipped_cases() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(STATIONARY_CASES))
    if (entry.path().extension() == ".toml") out.push_back(entry.path().stem().string());
  std::ranges::sort(out);
  return out;
}

std::string path_of(const std::string& stem) {
  return std::string(STATIONARY_CASES "/") + stem + ".toml";
}

class ShippedCase : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedCase, IsAcceptedAndEndsAsItSays) {
  const Outcome checked = run_program({"check", path_of(GetParam())});
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_THAT(checked.out, ::testing::HasSubstr("modes from"));
  const Outcome solved = run_program({"solve", path_of(GetParam())});
  EXPECT_EQ(solved.code, GetParam() == "too_fast" ? 3 : 0) << solved.err;
}

TEST_P(ShippedCase, OpensWithWhatItShowsAndWhereItsNumbersComeFrom) {
  const std::string text = text_of(path_of(GetParam()));
  EXPECT_TRUE(text.starts_with("# "));
  EXPECT_THAT(text, ::testing::HasSubstr("# Shows: "));
  EXPECT_THAT(text, ::testing::HasSubstr("# Numbers: "));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedCase, ::testing::ValuesIn(shipped_cases()),
                         [](const auto& param) { return param.param; });

TEST(ShippedCases, CoverEveryBranchAndEveryModel) {
  std::set<std::string, std::less<>> seen;
  for (const std::string& stem : shipped_cases()) {
    const Case input = read_case(path_of(stem));
    seen.emplace(input.branch_name());
    for (const ModelChoice& model : input.models) seen.insert(model.description.name);
  }
  for (const std::string_view branch : {"i", "ii", "iii", "tilted", "oblique", "two-polar"})
    EXPECT_TRUE(seen.contains(branch));
  for (const ModelDescription& model : model_descriptions())
    EXPECT_TRUE(seen.contains(model.name)) << model.name;
}

}  // namespace
}  // namespace stationary::testing
