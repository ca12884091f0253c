// Materials from the literature, each written as four or more formulas that are one function: the
// same proven solutions, classes and sheets from every spelling, nothing undecided, nothing
// assumed.
#include "tests/support/bodies/published_materials.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using support::published_materials;
using support::PublishedMaterial;
using ::testing::HasSubstr;
using ::testing::Not;

std::string case_of(const PublishedMaterial& material, const std::string& spelling,
                    const std::string& branch, const std::string& more) {
  std::string out =
      "[body]\nJ = [1.0, 1.7, 0.6]\n[potential]\ncoupled = { expression = \"" + spelling + "\"";
  for (std::size_t k = 0; k < material.parameters.size(); ++k) {
    char value[40];
    std::snprintf(value, sizeof value, "%.17g", material.values[k]);
    out += ", " + material.parameters[k] + " = " + value;
  }
  return out + " }\n[motion]\nbranch = \"" + branch + "\"\nnu = 0.3\n" + more;
}

class PublishedMaterialTest : public ::testing::TestWithParam<std::size_t> {
 protected:
  const PublishedMaterial& material() const { return published_materials()[GetParam()]; }
};

INSTANTIATE_TEST_SUITE_P(Twelve, PublishedMaterialTest,
                         ::testing::Range(std::size_t{0}, std::size_t{12}), [](const auto& test) {
                           std::string name;
                           for (const char c : published_materials()[test.param].name)
                             if (std::isalnum(static_cast<unsigned char>(c))) name += c;
                           return name;
                         });

TEST_P(PublishedMaterialTest, EverySpellingHasTheSameProvenSolutionsAndClasses) {
  ASSERT_EQ(published_materials().size(), 12U);
  ASSERT_GE(material().spellings.size(), 4U);
  const TemporaryDirectory directory;
  for (const std::string branch : {"i", "ii", "iii"}) {
    std::vector<std::vector<std::string>> first;
    for (const std::string& spelling : material().spellings) {
      const std::string path = directory.file(
          "material.toml", case_of(material(), spelling, branch,
                                   "[solve]\nall = true\n[output]\ncertificate = true\n"));
      const Outcome all = run_program({"solve", path, "-o", "-"});
      EXPECT_THAT(all.err, Not(HasSubstr("undecided"))) << spelling;
      if (first.empty() && all.code == 3) {
        // None at all is an answer too; the same of every spelling.
        EXPECT_THAT(all.err, HasSubstr("none")) << spelling;
        continue;
      }
      ASSERT_EQ(all.code, 0) << spelling << "\n" << all.err;
      std::vector<std::vector<std::string>> rows;
      for (const Row& row : rows_of(all.out)) {
        EXPECT_EQ(row.at("certified"), "yes") << spelling;
        EXPECT_TRUE(std::isfinite(number(row.at("energy")))) << spelling;
        std::vector<std::string> values;
        for (const char* column : {"xi", "zeta", "rho", "class", "negative"})
          values.push_back(row.at(column));
        rows.push_back(values);
      }
      if (first.empty()) first = rows;
      EXPECT_EQ(rows, first) << branch << ": " << spelling;
    }
  }
}

TEST_P(PublishedMaterialTest, EverySpellingHasTheSameSheets) {
  const TemporaryDirectory directory;
  std::string first;
  // The last spelling is the least like the first.
  const auto& spellings = material().spellings;
  for (const std::string& spelling : {spellings.front(), spellings.back()}) {
    const std::string path = directory.file(
        "material.toml", case_of(material(), spelling, "i",
                                 "[continuation]\nparameter = \"nu\"\nfrom = 0.0\nto = 0.8\n"));
    const Outcome atlas =
        run_program({"atlas", path, "--checkpoints", "8", "-o", directory / "atlas.csv"});
    ASSERT_EQ(atlas.code, 0) << spelling << "\n" << atlas.err;
    const auto metadata = nlohmann::json::parse(text_of(directory / "atlas.meta.json"));
    for (const auto& at : metadata.at("checkpoints"))
      EXPECT_TRUE(at.at("complete")) << spelling << at;
    std::string sheets;
    for (const auto& sheet : metadata.at("sheets")) sheets += sheet.at("branch").dump() + " ";
    if (first.empty()) first = sheets;
    EXPECT_EQ(sheets, first) << spelling;
  }
}

}  // namespace
}  // namespace stationary::testing
