// `atlas --complete` from outside: what is proven for every nu of the range.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/program/json_schema.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

nlohmann::json completeness_of(const std::string& case_file,
                               const std::vector<std::string>& more = {}) {
  const TemporaryDirectory directory;
  std::vector<std::string> command{
      "atlas",         case_file, "-o",    directory / "x.csv",    "--complete",
      "--checkpoints", "1",       "--set", "output.spectrum=false"};
  command.insert(command.end(), more.begin(), more.end());
  const Outcome outcome = run_program(command);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return nlohmann::json::parse(text_of(directory / "x.meta.json"))["completeness"];
}

/// A branch, and of tilted motions their plane.
std::string kind_of(const nlohmann::json& part) {
  return part["branch"].get<std::string>() +
         (part.contains("plane") ? part["plane"].get<std::string>() : "");
}

/// The parts of the range that are not proven, of a kind; each begins where the last ends.
double undecided_length(const nlohmann::json& completeness, const std::string& kind) {
  double length = 0.0;
  std::optional<double> end;
  int found = 0;
  for (const auto& each : completeness) {
    if (kind_of(each) != kind) continue;
    ++found;
    if (end) {
      EXPECT_EQ(each["from"].get<double>(), *end);
    }
    end = each["to"].get<double>();
    EXPECT_EQ(each.at("sheets").is_number_integer(), each["status"] == "proven");
    EXPECT_EQ(each["reason"] == "", each["status"] == "proven");
    EXPECT_EQ(each["beyond"] == "sheet-leaves-box", each["status"] == "beyond");
    if (each["status"] != "proven") length += *end - each["from"].get<double>();
  }
  EXPECT_GT(found, 0);
  return length;
}

TEST(CompleteAtlas, IsCompleteButForAMillionthOfTheRange) {
  for (const char* each :
       {"neo_hookean", "fold", "apart", "near_degenerate", "circle", "disc", "coupled"}) {
    const auto completeness = completeness_of(shipped(std::string(each) + ".toml"));
    for (const char* kind : {"i", "ii", "iii", "tilted13", "tilted23"}) {
      const bool mirrored = std::string(kind) == "ii" || std::string(kind) == "tilted23";
      if (std::string(each) == "circle" && mirrored) continue;  // as (i), and in the other plane
      // Where both of two tilted sheets leave the box, a search between them is undecided.
      const bool leave = std::string(each) == "coupled" && std::string(kind).starts_with("tilted");
      EXPECT_LT(undecided_length(completeness, kind), leave ? 1e-4 : 1e-6) << each << ' ' << kind;
    }
  }
}

/// A proven stability diagram: at most a millionth of the range is left, there are as many motions of
/// all classes as are proven to be, and at the sheets' rows they are those of the table.
TEST(CompleteAtlas, ProvesTheClassesOfEveryMotion) {
  int compared = 0;
  int whole_diagrams = 0;  // of tilted motions
  for (const char* each :
       {"neo_hookean", "fold", "apart", "near_degenerate", "circle", "disc", "coupled"}) {
    const TemporaryDirectory directory;
    const Outcome outcome = run_program({"atlas", shipped(std::string(each) + ".toml"), "-o",
                                         directory / "x.csv", "--complete", "--checkpoints", "1"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("classes       branch (i): proven for nu in ["));
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    std::map<std::string, double> open;
    std::map<std::string, double> range;
    for (const auto& part : metadata["classes"]) {
      const std::string branch = kind_of(part);
      const double from = part["from"];
      const double to = part["to"];
      range[branch] = to;
      if (part["status"] != "proven") {
        open[branch] += to - from;
        EXPECT_TRUE(part.contains("reason") && part.contains("events"));
        continue;
      }
      int of_all_classes = 0;
      for (const auto& [word, number] : part["sheets"].items()) of_all_classes += number.get<int>();
      const double middle = 0.5 * (from + to);
      for (const auto& whole : metadata["completeness"]) {
        if (kind_of(whole) == branch && whole["from"].get<double>() < middle &&
            middle < whole["to"].get<double>()) {
          EXPECT_EQ(whole["sheets"], of_all_classes) << each << ' ' << branch << ' ' << middle;
        }
      }
    }
    for (const auto& [branch, length] : open) {
      // Of tilted motions that are not all of one sign in both halves less is told.
      const bool tilted = branch.starts_with("tilted");
      EXPECT_LT(length, (tilted ? 0.3 : 1e-6) * range[branch]) << each << ' ' << branch;
      whole_diagrams += tilted && length < 1e-6 * range[branch];
    }
    // A row's class is one of those proven at its nu; beyond the box, rows are of no proof.
    for (const Row& row : rows_of(text_of(directory / "x.csv"))) {
      const std::string branch = row.at("branch");
      const std::string column = branch == "i" ? "nu1" : branch == "ii" ? "nu2" : "nu3";
      if (!range.contains(branch) || !row.at("event").empty()) continue;
      const auto inside = [&](const char* stretch) {
        return number(row.at(stretch)) > 1e-3 && number(row.at(stretch)) < 1e3;
      };
      if (!inside("xi") || !inside("zeta") || !inside("rho")) continue;
      const double nu = number(row.at(column));
      for (const auto& part : metadata["classes"]) {
        if (part["branch"] != branch || part["status"] != "proven") continue;
        if (!(part["from"].get<double>() < nu && nu < part["to"].get<double>())) continue;
        if (row.at("class") == "marginal") continue;
        EXPECT_TRUE(part["sheets"].contains(row.at("class")))
            << each << " (" << branch << ") at nu = " << nu << ": " << row.at("class");
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 2000);
  EXPECT_GE(whole_diagrams, 4);
}

/// The rest state is a motion of the sheet, and what a class says of it is said of another leaf.
TEST(CompleteAtlas, AClassIsOfNuAboveZero) {
  const Outcome outcome = run_program({"atlas", shipped("fibre.toml"), "--complete",
                                       "--checkpoints", "1", "--set", "continuation.to=0.3"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("  1 sheet for nu in [0, 0.3]"));
  EXPECT_THAT(outcome.out, HasSubstr("  1 stable for nu in (0, 0.3]"));
}

TEST(CompleteAtlas, ProvesThatEllipsesPartFromCircles) {
  int parts = 0;
  for (const auto& each : completeness_of(shipped("circle.toml"))) {
    if (each["status"] == "proven") continue;
    if (each["reason"].get<std::string>().starts_with("ellipses part from circles")) {
      EXPECT_EQ(each["branch"], "iii");
      EXPECT_THAT(each["reason"].get<std::string>(), HasSubstr("one event, proven"));
      ++parts;
    }
  }
  EXPECT_EQ(parts, 2);
}

/// What is told of the outside of the box: of every interval one word, "excluded" only where no row of any
/// sheet is outside at its nu, and a sheet that leaves the box changes the number by one.
TEST(CompleteAtlas, SaysWhatIsKnownBeyondTheBox) {
  std::map<std::string, int> words;
  for (const char* each : {"neo_hookean", "apart", "near_degenerate", "circle", "fold"}) {
    const TemporaryDirectory directory;
    const Outcome outcome =
        run_program({"atlas", shipped(std::string(each) + ".toml"), "-o", directory / "x.csv",
                     "--complete", "--checkpoints", "1", "--set", "output.spectrum=false"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(" of the range of these branches is proven"));
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    EXPECT_EQ(schema_fault(metadata, nlohmann::json::parse(text_of(STATIONARY_SCHEMA))), "");
    EXPECT_GT(metadata["complete_fraction"].get<double>(), 1.0 - 1e-9);
    EXPECT_LE(metadata["complete_fraction"].get<double>(), 1.0);
    const std::vector<Row> rows = rows_of(text_of(directory / "x.csv"));
    const auto& all = metadata["completeness"];
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::string beyond = all[k]["beyond"];
      ++words[beyond];
      if (beyond == "sheet-leaves-box") {
        EXPECT_EQ(all[k]["status"], "beyond");
        EXPECT_THAT(all[k]["reason"].get<std::string>(), HasSubstr("a sheet leaves the box"));
        ASSERT_TRUE(k > 0 && k + 1 < all.size());
        const int change = all[k + 1]["sheets"].get<int>() - all[k - 1]["sheets"].get<int>();
        EXPECT_EQ(std::abs(change), 1) << each << ' ' << k;
      }
      if (beyond != "excluded") continue;
      for (const Row& row : rows) {
        if (row.at("branch") != all[k]["branch"]) continue;
        const double nu =
            std::hypot(number(row.at("nu1")), number(row.at("nu2")), number(row.at("nu3")));
        if (!(all[k]["from"].get<double>() < nu && nu < all[k]["to"].get<double>())) continue;
        for (const char* stretch : {"xi", "zeta", "rho"}) {
          EXPECT_GT(number(row.at(stretch)), 1e-3) << each << " at nu = " << nu;
          EXPECT_LT(number(row.at(stretch)), 1e3) << each << " at nu = " << nu;
        }
      }
    }
  }
  EXPECT_GE(words["excluded"], 40);
  EXPECT_GE(words["sheet-leaves-box"], 10);
  EXPECT_GE(words["sheet-listed"], 3);
}

/// Of a branch, where sheets leave the box.
std::vector<nlohmann::json> leaving(const nlohmann::json& completeness, const std::string& branch) {
  std::vector<nlohmann::json> out;
  for (const auto& each : completeness)
    if (each["branch"] == branch && each["beyond"] == "sheet-leaves-box") out.push_back(each);
  return out;
}

/// A sheet that leaves the box is outside it at least until it leaves a wider one too: of no nu between
/// is it said that there is nothing.
TEST(CompleteAtlas, ExcludesNoSheetThatHasLeftTheBox) {
  int outside = 0;
  for (const char* each : {"neo_hookean", "apart", "near_degenerate"}) {
    const auto all = completeness_of(shipped(std::string(each) + ".toml"));
    const auto wide =
        completeness_of(shipped(std::string(each) + ".toml"), {"--set", "solve.box=[1e-5, 1e5]"});
    for (const char* branch : {"i", "ii", "iii"}) {
      const auto leaves = leaving(all, branch);
      const auto leaves_wide = leaving(wide, branch);
      ASSERT_EQ(leaves.size(), leaves_wide.size()) << each << ' ' << branch;
      for (std::size_t k = 0; k < leaves.size(); ++k) {
        // As it grows nu goes up or down, or by less than it is told to.
        const double low =
            std::min(leaves[k]["to"].get<double>(), leaves_wide[k]["to"].get<double>());
        const double high =
            std::max(leaves[k]["from"].get<double>(), leaves_wide[k]["from"].get<double>());
        if (!(low < high)) continue;
        ++outside;
        for (const auto& part : all) {
          if (part["branch"] != branch || part["beyond"] != "excluded") continue;
          EXPECT_FALSE(part["from"].get<double>() < high && low < part["to"].get<double>())
              << each << " (" << branch << ") in [" << low << ", " << high << "]";
        }
      }
    }
  }
  EXPECT_GE(outside, 10);
}

/// Of a coupled body no row alone says that nothing is outside, as all three have ln det S in common; their
/// differences do, but for the nu at which a stretch escapes or its pull equals its stiffness.
TEST(CompleteAtlas, ExcludesMotionsOutsideOfACoupledBody) {
  std::map<std::string, double> open;
  std::map<std::string, double> excluded;
  for (const auto& each : completeness_of(shipped("coupled.toml"))) {
    (each["beyond"] == "excluded" ? excluded : open)[each["branch"]] +=
        each["to"].get<double>() - each["from"].get<double>();
  }
  ASSERT_EQ(excluded.size(), 3U);
  for (const auto& [branch, length] : excluded) {
    EXPECT_NEAR(length + open[branch], 2.0, 1e-12) << branch;
    EXPECT_GT(open[branch], 0.0) << branch;
    EXPECT_LT(open[branch], 1e-6) << branch;
  }
}

/// Beside an escape nothing is left open but a small end of the interval, and the summary has that in one piece.
TEST(CompleteAtlas, ExcludesMotionsOutsideSoonAfterAnEscape) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_program({"atlas", shipped("neo_hookean.toml"), "-o", directory / "x.csv", "--complete",
                   "--checkpoints", "1", "--set", "output.spectrum=false"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("  0 sheets for nu in [0.766964988846, 1.1]"));
  EXPECT_THAT(outcome.out, HasSubstr("  0 sheets for nu in [0.766964988847, 1]"));
  std::map<std::string, double> open;
  std::map<std::string, int> pieces;
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  for (const auto& each : metadata["completeness"]) {
    if (each["status"] != "proven" || each["sheets"] != 0 || each["branch"] == "tilted") continue;
    ++pieces[each["branch"]];
    if (each["beyond"] != "excluded")
      open[each["branch"]] += each["to"].get<double>() - each["from"].get<double>();
  }
  // Of (iii) cut at both ends, between its two families, and whole above the fold.
  EXPECT_EQ(pieces, (std::map<std::string, int>{{"i", 2}, {"ii", 2}, {"iii", 4}}));
  for (const auto& [branch, length] : open) {
    EXPECT_GT(length, 0.0) << branch;
    EXPECT_LT(length, 1e-9) << branch;
  }
  EXPECT_EQ(open.size(), 3U);
}

/// So far out that along the sheet nu has come to its limit to all digits, and may as well turn: a number
/// that changes by an odd one is no fold.
TEST(CompleteAtlas, TellsASheetThatLeavesFromAFold) {
  int left = 0;
  for (const char* each : {"neo_hookean", "near_degenerate"}) {
    const TemporaryDirectory directory;
    const Outcome outcome = run_program(
        {"atlas", shipped(std::string(each) + ".toml"), "-o", directory / "x.csv", "--complete",
         "--checkpoints", "1", "--set", "output.spectrum=false", "--set", "solve.box=[1e-6, 1e6]"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    const auto& all = metadata["completeness"];
    for (std::size_t k = 1; k + 1 < all.size(); ++k) {
      if (all[k]["status"] == "proven" || all[k]["branch"] == "tilted") continue;
      const int change = all[k + 1]["sheets"].get<int>() - all[k - 1]["sheets"].get<int>();
      EXPECT_EQ(all[k]["status"], change % 2 == 0 ? "undecided" : "beyond") << each << ' ' << k;
      left += all[k]["status"] == "beyond";
    }
  }
  EXPECT_EQ(left, 10);
}

/// The key is the option, and either's checkpoints are.
TEST(CompleteAtlas, IsAskedForByTheCaseToo) {
  const TemporaryDirectory directory;
  const auto metadata = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"atlas", shipped("disc.toml"),   "-o", directory / "x.csv", "-q",
                                 "--set", "output.spectrum=false"};
    all.insert(all.end(), more.begin(), more.end());
    const Outcome outcome = run_program(all);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return nlohmann::json::parse(text_of(directory / "x.meta.json"));
  };
  const auto by_option = metadata({"--complete", "--checkpoints", "3"});
  const auto by_key = metadata({"--set", "atlas.complete=true", "--set", "atlas.checkpoints=3"});
  EXPECT_FALSE(by_key["completeness"].empty());
  EXPECT_EQ(by_key["completeness"], by_option["completeness"]);
  EXPECT_EQ(by_key["checkpoints"], by_option["checkpoints"]);
  EXPECT_EQ(by_key["case"]["atlas"]["complete"], true);
  EXPECT_EQ(by_key["case"]["atlas"]["checkpoints"], 3);
  const auto neither = metadata({"--set", "atlas.checkpoints=7", "--checkpoints", "2"});
  EXPECT_FALSE(neither.contains("completeness"));
  EXPECT_EQ(neither["checkpoints"].size(), 10U);  // three branches, two planes
}

/// Sheets are sought and counted in the case's box.
TEST(CompleteAtlas, IsOfTheCasesBox) {
  const TemporaryDirectory directory;
  const auto sheets = [&](const std::string& box) {
    const Outcome outcome =
        run_program({"atlas", shipped("disc.toml"), "-o", directory / "x.csv", "-q", "--complete",
                     "--checkpoints", "1", "--set", "output.spectrum=false", "--set",
                     "continuation.to=0.1", "--set", "solve.box=" + box});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    int out = 0;
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    for (const auto& each : metadata["completeness"])
      if (each["status"] == "proven") out += each["sheets"].get<int>();
    return out;
  };
  EXPECT_EQ(sheets("[0.1, 10]"), 3);
  EXPECT_EQ(sheets("[2, 10]"), 0);
}

}  // namespace
}  // namespace stationary::testing
