// continue --from: going on from any row of any table, on its own family or on one that begins
// there; and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <nlohmann/json.hpp>
#include <utility>

#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string cases = STATIONARY_CASES;

class FromRow : public ::testing::Test {
 protected:
  /// A table of a shipped case under this name.
  std::string table(const std::string& command, const std::string& file, const std::string& name,
                    const std::vector<std::string>& more = {}) {
    const std::string path = directory_ / name;
    std::vector<std::string> arguments{command, cases + "/" + file, "-o", path, "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return path;
  }
  static Outcome from(const std::string& file, const std::string& row,
                      const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"continue", cases + "/" + file, "--from", row};
    if (more.empty() || more.front() != "summary") arguments.insert(arguments.end(), {"-o", "-"});
    for (const std::string& each : more)
      if (each != "summary") arguments.push_back(each);
    return run_program(arguments);
  }
  /// The parameter's values at the events of a table.
  static std::vector<double> events(const std::string& csv, const std::string& event,
                                    const std::string& column) {
    std::vector<double> out;
    for (const Row& row : rows_of(csv))
      if (row.at("event") == event) out.push_back(number(row.at(column)));
    return out;
  }
  TemporaryDirectory directory_;
};

TEST_F(FromRow, AnyRowLeadsToTheSameSheet) {
  const std::string path = table("continue", "fold.toml", "fold.csv");
  const auto expected = events(text_of(path), "fold-nu", "nu1");
  ASSERT_EQ(expected.size(), 1U);
  const std::size_t rows = rows_of(text_of(path)).size();
  for (const std::string& row :
       {std::string("1"), std::to_string(rows / 2), std::to_string(rows), std::string("fold-nu"),
        std::string("tilt:1"), std::string("limit")}) {
    const Outcome outcome = from("fold.toml", path + ":" + row);
    ASSERT_EQ(outcome.code, 0) << row << ": " << outcome.err;
    const auto found = events(outcome.out, "fold-nu", "nu1");
    ASSERT_EQ(found.size(), 1U) << row;
    EXPECT_NEAR(found[0], expected[0], 1e-14) << row;
  }
  EXPECT_THAT(from("fold.toml", path + ":2", {"summary"}).out, HasSubstr("fold.csv:2"));
}

/// Circles and ellipses of one branch, families in and out of a plane: S at the event is of both.
TEST_F(FromRow, WhereTwoSheetsMeetItGoesOnAlongTheRowsOwn) {
  const std::vector<std::pair<std::string, std::string>> cases_and_events{
      {"jacobi", "ellipse"}, {"two_polar", "ellipse"}, {"no_plane", "shear"}};
  for (const auto& [name, event] : cases_and_events) {
    const std::string file = name + ".toml";
    const std::string path = table("continue", file, name + ".csv");
    const std::vector<Row> own = rows_of(text_of(path));
    const Outcome outcome = from(file, path + ":" + event);
    ASSERT_EQ(outcome.code, 0) << name << ": " << outcome.err;
    const std::vector<Row> found = rows_of(outcome.out);
    const auto count = [](const std::vector<Row>& rows, const auto& is_one) {
      return std::ranges::count_if(rows, is_one);
    };
    const auto is_event = [](const Row& row) { return !row.at("event").empty(); };
    // The meeting next to alpha = 0 is located from some rows, and from others only known to be between two.
    const double open = name == "no_plane" ? 1.0 : 0.0;
    EXPECT_NEAR(double(count(found, is_event)), double(count(own, is_event)), open) << name;
    const auto is_round = [](const Row& row) { return row.at("xi") == row.at("zeta"); };
    EXPECT_EQ(count(found, is_round), count(own, is_round)) << name;
    EXPECT_NEAR(double(found.size()), double(own.size()), 0.02 * double(own.size()) + 2.0) << name;
  }
}

/// The end of a curve of events is at the rectangle's side, but for rounding.
TEST_F(FromRow, AnEndOfACurveIsInTheRange) {
  const std::vector<std::string> sides{
      "--set", "curve.event=tilt",     "--set", "curve.parameters=[\"nu\",\"body.J.2\"]",
      "--set", "curve.from=[0.1,0.3]", "--set", "curve.to=[1.5,2.0]"};
  const std::string path = table("curve", "fold.toml", "curve.csv", sides);
  const std::size_t rows = rows_of(text_of(path)).size();
  for (const std::size_t row : {std::size_t{1}, rows}) {
    const Outcome outcome =
        from("fold.toml", path + ":" + std::to_string(row),
             {"--set", "continuation.from=0.1", "--set", "continuation.to=1.5"});
    EXPECT_EQ(outcome.code, 0) << row << ": " << outcome.err;
  }
}

/// The case of the metadata starts where the table did.
TEST_F(FromRow, MetadataHaveTheStart) {
  const std::string path = table("continue", "fold.toml", "fold.csv");
  const Row row = rows_of(text_of(path)).at(6);
  ASSERT_EQ(from("fold.toml", path + ":7", {"summary", "--quiet", "-o", directory_ / "x.csv"}).code,
            0);
  const auto told = nlohmann::json::parse(text_of(directory_ / "x.meta.json"));
  const auto& start = told["case"]["solve"]["start"];
  ASSERT_EQ(start.size(), 4U);
  EXPECT_EQ(start[1], number(row.at("xi")));
  EXPECT_EQ(start[2], number(row.at("zeta")));
  EXPECT_EQ(told["case"]["motion"]["nu"], number(row.at("nu1")));
  EXPECT_EQ(told["overrides"]["motion.nu"], "--from " + path + ":7");
}

TEST_F(FromRow, HdfFiveToo) {
  NEEDS_HDF5();
  const std::string csv = table("continue", "fold.toml", "fold.csv");
  const std::string hdf = table("continue", "fold.toml", "fold.h5");
  EXPECT_EQ(from("fold.toml", hdf + ":7").out, from("fold.toml", csv + ":7").out);
}

TEST_F(FromRow, ATiltLeadsToTheTiltedFamilyAndBack) {
  const std::vector<std::string> range{"--set", "continuation.to=1.2"};
  const std::string straight = table("continue", "disc.toml", "disc.csv", range);
  const Outcome tilted = from("disc.toml", straight + ":tilt",
                              {"--set", "motion.branch=tilted", "--set", "continuation.to=1.2"});
  ASSERT_EQ(tilted.code, 0) << tilted.err;
  const auto rows = rows_of(tilted.out);
  EXPECT_EQ(rows.front().at("branch"), "tilted");
  EXPECT_EQ(rows.front().at("event"), "tilt");
  EXPECT_EQ(rows.back().at("event"), "tilt");
  // In the plane that the tilt is in, and in no other.
  const Outcome elsewhere = from("disc.toml", straight + ":tilt",
                                 {"--set", "motion.branch=tilted", "--set", "motion.plane=\"23\"",
                                  "--set", "continuation.to=1.2"});
  EXPECT_EQ(elsewhere.code, 2);
  EXPECT_THAT(elsewhere.err, HasSubstr("an event where that family begins"));
  // Its ends lie on branches (i) and (iii).
  const std::string back = directory_ / "tilted.csv";
  ASSERT_EQ(run_program({"continue", cases + "/tilted.toml", "-o", back, "-q"}).code, 0);
  for (const auto& [branch, which, nu] :
       {std::tuple{"i", ":tilt:1", "nu1"}, std::tuple{"iii", ":tilt:2", "nu3"}}) {
    const Outcome again =
        from("disc.toml", back + which,
             {"--set", std::string("motion.branch=") + branch, "--set", "continuation.to=1.2"});
    ASSERT_EQ(again.code, 0) << branch << ": " << again.err;
    const auto at = events(again.out, "tilt", nu);
    ASSERT_GE(at.size(), 1U) << branch;
    const auto expected = events(text_of(back), "tilt", nu);
    EXPECT_NEAR(at[0], std::max(expected[0], expected[1]), 1e-12) << branch;
  }
}

/// From a row that is an event its sheet has all of its events, that one too, where they are.
TEST_F(FromRow, TheEventOfTheRowIsKept) {
  struct Found {
    std::string event;
    double parameter;
    auto operator<=>(const Found&) const = default;
  };
  const auto is_proper = [](const Row& row) {
    const std::string& event = row.at("event");
    return !event.empty() && event != "limit" && event != "escape" && event != "collapse";
  };
  const auto events_of = [&](const std::string& csv, const std::string& column) {
    std::vector<Found> out;
    for (const Row& row : rows_of(csv)) {
      if (!is_proper(row)) continue;
      const double nu =
          std::hypot(number(row.at("nu1")), number(row.at("nu2")), number(row.at("nu3")));
      out.push_back({row.at("event"), column.empty() ? nu : number(row.at(column))});
    }
    std::ranges::sort(out);
    return out;
  };
  int compared = 0;
  for (const auto& [file, column] : {std::pair{"fold.toml", ""},
                                     {"circle.toml", ""},
                                     {"neo_hookean.toml", ""},
                                     {"tilted.toml", ""},
                                     {"inertia.toml", "body.J.1"},
                                     {"broken_pitchfork.toml", ""}}) {
    const std::string path = table("continue", file, "own.csv");
    const std::vector<Found> expected = events_of(text_of(path), column);
    ASSERT_FALSE(expected.empty()) << file;
    std::size_t number_of_row = 0;
    for (const Row& row : rows_of(text_of(path))) {
      ++number_of_row;
      if (!is_proper(row)) continue;
      const std::string& event = row.at("event");
      const Outcome outcome = from(file, path + ":" + std::to_string(number_of_row));
      ASSERT_EQ(outcome.code, 0) << file << ' ' << event << ": " << outcome.err;
      const std::vector<Found> found = events_of(outcome.out, column);
      ASSERT_EQ(found.size(), expected.size()) << file << ' ' << event << ' ' << number_of_row;
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_EQ(found[k].event, expected[k].event) << file << ' ' << event;
        EXPECT_NEAR(found[k].parameter, expected[k].parameter, 1e-11) << file << ' ' << event;
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 20);
}

TEST_F(FromRow, ATrailingParameterOverridesTheCase) {
  const std::string path =
      table("continue", "second_axis.toml", "J.csv",
            {"--set", "continuation={parameter=\"body.J.1\",from=1.2,to=1.9}"});
  const auto rows = rows_of(text_of(path));
  const Row& row = rows[rows.size() / 2];
  const Outcome outcome =
      from("second_axis.toml", path + ":" + std::to_string(rows.size() / 2 + 1),
           {"--set", "continuation={from=0.0,to=0.9}", "--set", "output.columns=[]"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  // At the row's nu the sheet has the row's S, which the case's own J does not give.
  bool met = false;
  const auto found = rows_of(outcome.out);
  for (std::size_t k = 1; k < found.size(); ++k) {
    const double nu = number(row.at("nu2"));
    if ((number(found[k - 1].at("nu2")) <= nu) == (number(found[k].at("nu2")) <= nu)) continue;
    met = true;
    const double low = std::min(number(found[k - 1].at("xi")), number(found[k].at("xi")));
    const double high = std::max(number(found[k - 1].at("xi")), number(found[k].at("xi")));
    EXPECT_GE(number(row.at("xi")), low - 1e-12);
    EXPECT_LE(number(row.at("xi")), high + 1e-12);
  }
  EXPECT_TRUE(met);
}

TEST_F(FromRow, TheCaseMayNameTheRow) {
  const std::string path = table("continue", "fold.toml", "fold.csv");
  std::string text = text_of(cases + "/fold.toml");
  text.insert(text.find("[continuation]") + 14, "\nstart_row = \"fold.csv:9\"");
  const std::string own = directory_.file("own.toml", text);
  const Outcome outcome = run_program({"continue", own, "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, from("fold.toml", path + ":9").out);
}

TEST_F(FromRow, AnEmptyNameIsNoRow) {
  for (const char* const command : {"continue", "curve"}) {
    const Outcome outcome = run_program({command, cases + "/fold.toml", "--from", ""});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("found an empty name; expected a row of a table"));
  }
  const Outcome own =
      run_program({"continue", cases + "/fold.toml", "--set", "continuation.start_row=\"\""});
  EXPECT_EQ(own.code, 2);
  EXPECT_THAT(own.err, HasSubstr("continuation.start_row: found"));
}

TEST_F(FromRow, AWrongRowOfTheCaseIsToldInTheCase) {
  std::string text = text_of(cases + "/fold.toml");
  text.insert(text.find("[continuation]") + 14, "\nstart_row = \"fold.csv:tlt\"");
  const std::string own = directory_.file("own.toml", text);
  for (const char* const command : {"continue", "check"}) {
    const Outcome outcome = run_program({command, own});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("own.toml:"));
    EXPECT_THAT(outcome.err, HasSubstr("continuation.start_row: found \"tlt\""));
    EXPECT_THAT(outcome.err, HasSubstr("did you mean \"tilt\"?"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("--from")));
  }
}

TEST_F(FromRow, DoesNotReplaceItsTable) {
  const std::string path = table("continue", "fold.toml", "fold.csv");
  const std::string before = text_of(path);
  const Outcome outcome =
      run_program({"continue", cases + "/fold.toml", "--from", path + ":3", "-o", path});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is the table of the row to start from"));
  EXPECT_EQ(text_of(path), before);
}

TEST_F(FromRow, DoesNotReplaceTheTableOfTheCasesOwnRow) {
  const std::string path = table("continue", "fold.toml", "fold.csv");
  const std::string before = text_of(path);
  for (const char* const name : {"fold.csv", "fold.h5"}) {
    const Outcome outcome =
        run_program({"continue", cases + "/fold.toml", "--set",
                     "continuation.start_row=\"" + path + ":3\"", "-o", directory_ / name});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("the table of the row to start from"));
  }
  EXPECT_EQ(text_of(path), before);
}

TEST_F(FromRow, DoesNotReplaceTheMetadataOfItsTable) {
  const std::string path = table("continue", "fold.toml", "fold.csv");
  const std::string before = text_of(directory_ / "fold.meta.json");
  for (const char* const name : {"fold", "fold.h5"}) {
    const Outcome outcome = run_program(
        {"continue", cases + "/fold.toml", "--from", path + ":3", "-o", directory_ / name});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("fold.csv, the table of the row to start from"));
  }
  EXPECT_EQ(text_of(directory_ / "fold.meta.json"), before);
}

TEST_F(FromRow, WhatLeadsNowhereIsRefused) {
  const std::string path = table("continue", "fold.toml", "fold.csv");
  const auto refused = [&](const std::string& row, const std::vector<std::string>& more,
                           const std::string& why) {
    const Outcome outcome = from("fold.toml", row, more);
    EXPECT_EQ(outcome.code, 2) << row;
    EXPECT_THAT(outcome.err, HasSubstr(why)) << row;
  };
  refused(path, {}, "TABLE:N, TABLE:EVENT or TABLE:EVENT:K");
  refused(path + ":0", {}, "rows from 1 on");
  refused(path + ":1000000", {}, "expected a row 1000000");
  refused(path + ":fold-nu:7", {}, "found 1 row of fold-nu");
  refused(path + ":fold-un", {}, "did you mean \"fold-nu\"?");
  refused(directory_ / "none.csv:1", {}, "cannot read it");
  refused(path + ":3", {"--set", "motion.branch=tilted"}, "an event where that family begins");
  refused(path + ":fold-nu", {"--set", "motion.branch=tilted"},
          "an event where that family begins");
  refused(path + ":limit", {"--set", "continuation.from=0.3"}, "a row in the range followed");
  const std::string narrow = table("continue", "fold.toml", "narrow.csv",
                                   {"--set", "output.columns=[\"branch\",\"nu1\",\"lambda\"]"});
  refused(narrow + ":2", {}, "found no xi in the row");
}

/// A row of the table that a case is followed from lies on what comes of it.
TEST_F(FromRow, NumbersOfGravityAndCoordinatesOfAFluidAreTheRows) {
  const auto holds = [](const Outcome& found, const Row& row) {
    return std::ranges::any_of(rows_of(found.out), [&](const Row& each) {
      return std::abs(number(each.at("xi")) / number(row.at("xi")) - 1.0) < 1e-12 &&
             std::abs(number(each.at("zeta")) / number(row.at("zeta")) - 1.0) < 1e-12;
    });
  };
  const std::string path =
      table("continue", "elastic_sphere.toml", "g.csv",
            {"--set", "motion.nu=0.2", "--set", "continuation.parameter=gravity.g", "--set",
             "continuation.from=0.5", "--set", "continuation.to=2"});
  const Row row = rows_of(text_of(path)).at(2);
  ASSERT_NE(row.at("gravity.g"), "2");
  for (const char* const gravity : {"gravity={g=4.0}", "gravity={pi_G_rho=1.0}"}) {
    const Outcome found =
        from("elastic_sphere.toml", path + ":3", {"--set", gravity, "--set", "output.columns=[]"});
    ASSERT_EQ(found.code, 0) << found.err;
    EXPECT_TRUE(holds(found, row)) << gravity;
  }
  const std::string bodies = directory_.file("bodies.csv", "body.J.1\n1.0\n1.3\n2.0\n");
  const std::string fluids = directory_ / "fluids.csv";
  ASSERT_EQ(run_program({"study", cases + "/maclaurin.toml", "--over", bodies, "--do", "solve",
                         "-o", fluids, "-q"})
                .code,
            0);
  const Outcome found = from("maclaurin.toml", fluids + ":2", {"--set", "output.columns=[]"});
  ASSERT_EQ(found.code, 0) << found.err;
  EXPECT_TRUE(holds(found, rows_of(text_of(fluids)).at(1)));
}

/// Of a study's rows J, models and formulas are the row's too.
TEST_F(FromRow, ARowOfAStudyHasItsOwnBody) {
  const std::string bodies =
      directory_.file("bodies.csv",
                      "body.J,potential.plane.model,potential.plane.mu,potential.plane.lambda\n"
                      "\"[1.0, 1.9, 0.6]\",,,\n,hencky,1.1,0.8\n");
  const std::string study = directory_ / "study.csv";
  const Outcome studied = run_program(
      {"study", cases + "/disc.toml", "--over", bodies, "--do", "solve", "-o", study, "-q"});
  ASSERT_EQ(studied.code, 0) << studied.err;
  const std::vector<std::vector<std::string>> own = {
      {"body.J=[1.0, 1.9, 0.6]"}, {"potential.plane={model=\"hencky\",mu=1.1,lambda=0.8}"}};
  for (std::size_t k = 0; k < own.size(); ++k) {
    std::vector<std::string> command{"continue", cases + "/disc.toml", "-o", "-"};
    for (const std::string& each : own[k]) command.insert(command.end(), {"--set", each});
    const Outcome expected = run_program(command);
    ASSERT_EQ(expected.code, 0) << expected.err;
    const Outcome found = from("disc.toml", study + ":" + std::to_string(k + 1));
    ASSERT_EQ(found.code, 0) << found.err;
    std::size_t compared = 0;
    for (const char* const event : {"tilt", "fold-nu", "oblique"}) {
      const auto here = events(found.out, event, "nu1");
      const auto there = events(expected.out, event, "nu1");
      ASSERT_EQ(here.size(), there.size()) << event << " " << k;
      for (std::size_t e = 0; e < here.size(); ++e) EXPECT_NEAR(here[e], there[e], 1e-10) << event;
      compared += here.size();
    }
    EXPECT_GT(compared, 0U) << k;
  }
}

/// Where a sheet escapes a double of the parameter does not tell its rows from one another.
TEST_F(FromRow, AnEscapeLeadsToTheWholeOfItsSheet) {
  const std::string path = table("continue", "mooney_rivlin.toml", "m.csv");
  const auto whole = events(text_of(path), "fold-nu", "nu1");
  const Outcome found = from("mooney_rivlin.toml", path + ":escape");
  ASSERT_EQ(found.code, 0) << found.err;
  const auto again = events(found.out, "fold-nu", "nu1");
  ASSERT_EQ(again.size(), whole.size());
  for (std::size_t k = 0; k < whole.size(); ++k) EXPECT_NEAR(again[k], whole[k], 1e-11);
}

TEST_F(FromRow, ARowInAnotherPlaneIsRefused) {
  const std::string path = table("continue", "tilted.toml", "t.csv");
  const Row row = rows_of(text_of(path)).at(3);
  const bool first = number(row.at("nu2")) == 0.0;
  for (const bool same : {false, true}) {
    const Outcome outcome =
        from("tilted.toml", path + ":4",
             {"--set", std::string("motion.plane=\"") + (same == first ? "13" : "23") + "\""});
    EXPECT_EQ(outcome.code, same ? 0 : 2) << outcome.err;
    if (!same) {
      EXPECT_THAT(outcome.err, HasSubstr("lies in another plane"));
    }
  }
}

/// Not a number by its beginning, nor 0 where there is none.
TEST_F(FromRow, WhatIsMissingOrNoNumberIsRefused) {
  struct Changed {
    const char* file;
    std::vector<std::string> left_out;
    const char* comma;  ///< a column with decimal commas
    const char* message;
  };
  for (const Changed& each :
       {Changed{"double_well.toml", {}, "nu3", "in the column nu3"},
        Changed{"double_well.toml", {}, "xi", "in the column xi"},
        Changed{"double_well.toml", {"nu3"}, nullptr, "found no nu3 in the row"},
        Changed{"oblique.toml", {"nu2"}, nullptr, "found no nu2 in the row"},
        Changed{"oblique.toml", {"alpha"}, nullptr, "found no alpha in the row"}}) {
    SCOPED_TRACE(each.message);
    const auto rows = rows_of(text_of(table("continue", each.file, "whole.csv")));
    ASSERT_GT(rows.size(), 7U);
    std::string header;
    std::string cells;
    for (const auto& [column, cell] : rows[7]) {
      if (std::ranges::find(each.left_out, column) != each.left_out.end()) continue;
      std::string written = cell;
      if (each.comma != nullptr && column == each.comma)
        written = "\"" + written.replace(written.find('.'), 1, ",") + "\"";
      header += (header.empty() ? "" : ",") + column;
      cells += (cells.empty() ? "" : ",") + written;
    }
    const std::string path = directory_.file("changed.csv", header + "\n" + cells + "\n");
    const Outcome outcome = from(each.file, path + ":1");
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(each.message));
  }
}

}  // namespace
}  // namespace stationary::testing
