// What an atlas says beside its sheets: on which side of an event motions begin, against where its own
// sheets go, and which motion has the least energy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "solver/program/table/column_file.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

struct Sided {
  std::string event;
  double nu;
  std::string side;
};

/// Where the shipped atlases' sheets go from the event is where `side` says.
TEST(AtlasSides, AgreeWithWhereTheSheetsGo) {
  std::map<std::string, int> compared;
  for (const char* name : {"neo_hookean", "fold", "apart", "near_degenerate", "circle", "disc",
                           "tilted", "double_well", "two_wells", "fibre"}) {
    const Outcome outcome = run_program({"atlas", shipped(std::string(name) + ".toml"), "-o", "-",
                                         "--checkpoints", "32", "--set", "output.spectrum=false"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto sheets = sheets_of(rows_of(outcome.out));
    // Of sheets about axes, what they say of the sheets that leave them.
    std::vector<Sided> told;
    for (const auto& sheet : sheets)
      for (const Row& row : sheet)
        if (!row.at("side").empty())
          told.push_back({row.at("event"), length(row, "nu"), row.at("side")});
    const auto expect = [&](const Row& event, const Row& beside, const std::string& side) {
      const char* const grows = event.at("event") == "fold-momentum" ? "pi" : "nu";
      const double step = length(beside, grows) - length(event, grows);
      EXPECT_EQ(side, step > 0.0 ? "after" : "before")
          << name << ", sheet " << event.at("sheet") << ", point " << event.at("point");
      ++compared[event.at("event")];
    };
    for (const auto& sheet : sheets) {
      for (std::size_t k = 0; k < sheet.size(); ++k) {
        const Row& row = sheet[k];
        EXPECT_EQ(row.at("side").empty(), row.at("criticality").empty());
        if (row.at("event") == "fold-nu" || row.at("event") == "fold-momentum") {
          ASSERT_FALSE(row.at("side").empty()) << name;
          EXPECT_EQ(number(row.at("criticality")) > 0.0, row.at("side") == "after");
          if (k > 0) expect(row, sheet[k - 1], row.at("side"));
          if (k + 1 < sheet.size()) expect(row, sheet[k + 1], row.at("side"));
        }
        const bool end = k == 0 || k + 1 == sheet.size();
        if (!end || sheet.size() < 2 || (row.at("event") != "tilt" && row.at("event") != "ellipse"))
          continue;
        // The sheet begins here: the side is told by the sheet that it leaves.
        const auto at = std::ranges::find_if(told, [&](const Sided& each) {
          return each.event == row.at("event") &&
                 std::abs(each.nu - length(row, "nu")) <= 1e-9 * each.nu;
        });
        ASSERT_NE(at, told.end()) << name << " sheet " << row.at("sheet");
        expect(row, k == 0 ? sheet[1] : sheet[k - 1], at->side);
      }
    }
  }
  EXPECT_GE(compared["fold-nu"], 10);
  EXPECT_GE(compared["fold-momentum"], 6);
  EXPECT_GE(compared["tilt"], 8);
  EXPECT_GE(compared["ellipse"], 2);
}

/// The metadata say how well each coefficient is known.
TEST(AtlasSides, HaveTheErrorOfEachCoefficient) {
  int compared = 0;
  for (const char* name : {"fold", "broken_pitchfork", "inertia"}) {
    const TemporaryDirectory directory;
    const Outcome outcome =
        run_program({"continue", shipped(std::string(name) + ".toml"), "-o", directory / "x.csv",
                     "-q", "--set", "output.spectrum=false"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    const std::vector<Row> rows = rows_of(text_of(directory / "x.csv"));
    for (const auto& event : metadata["events"]) {
      if (event["point"].is_null()) continue;
      const Row& row = rows.at(event["point"].get<std::size_t>());
      ASSERT_EQ(event["event"], row.at("event"));
      ASSERT_EQ(event.contains("criticality_error"), !row.at("criticality").empty()) << name;
      if (!event.contains("criticality_error")) continue;
      const double coefficient = std::abs(number(row.at("criticality")));
      EXPECT_GT(event["criticality_error"].get<double>(), 0.0);
      EXPECT_LT(event["criticality_error"].get<double>(), 1e-6 * coefficient) << name;
      ++compared;
    }
  }
  EXPECT_GE(compared, 4);
}

TEST(LeastEnergy, HasAFileOfItsOwn) {
  const TemporaryDirectory directory;
  const auto refused = [&](const std::string& least, const std::string& words) {
    const Outcome outcome = run_program(
        {"atlas", shipped("apart.toml"), "-o", directory / "x.csv", "--least-energy", least});
    EXPECT_EQ(outcome.code, 2) << least;
    EXPECT_THAT(outcome.err, HasSubstr(words)) << least;
    EXPECT_TRUE(directory.names().empty()) << least;
  };
  refused(directory / "x.csv", "is written by -o");
  refused(directory / "x.meta.json", "found the suffix \".json\"");
  refused("-", "standard output");
}

TEST(LeastEnergy, IsTheSameTableAsHdf5) {
  NEEDS_HDF5();
  const TemporaryDirectory directory;
  const auto least = [&](const char* name) {
    const Outcome outcome =
        run_program({"atlas", shipped("apart.toml"), "-q", "--checkpoints", "32", "--set",
                     "output.spectrum=false", "--least-energy", directory / name});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return open_table(directory / name);
  };
  TableReader text = least("least.csv");
  TableReader columns = least("least.h5");
  ASSERT_EQ(columns.columns(), text.columns());
  int rows = 0;
  while (text.next()) {
    ASSERT_TRUE(columns.next());
    for (std::size_t k = 0; k < text.columns().size(); ++k)
      EXPECT_EQ(columns.text(k), text.text(k)) << text.columns()[k];
    ++rows;
  }
  EXPECT_FALSE(columns.next());
  EXPECT_GE(rows, 1);
}

/// No row of any sheet has less energy than the motion named for its |pi|, and what is named is there.
TEST(LeastEnergy, IsTheLowerEnvelopeOfTheSheets) {
  int changes = 0;
  for (const char* name : {"apart", "circle", "double_well", "neo_hookean"}) {
    const TemporaryDirectory directory;
    const Outcome outcome =
        run_program({"atlas", shipped(std::string(name) + ".toml"), "-o", directory / "x.csv", "-q",
                     "--checkpoints", "32", "--set", "output.spectrum=false", "--least-energy",
                     directory / "least.csv"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto pieces = rows_of(text_of(directory / "least.csv"));
    ASSERT_FALSE(pieces.empty()) << name;
    const auto json = nlohmann::json::parse(text_of(directory / "x.meta.json"))["least_energy"];
    ASSERT_EQ(json.size(), pieces.size());
    std::map<std::string, int> on_pieces;
    int outside = 0;
    for (const auto& sheet : sheets_of(rows_of(text_of(directory / "x.csv")))) {
      for (const Row& row : sheet) {
        const double momentum = length(row, "pi");
        const double energy = number(row.at("energy"));
        const auto piece = std::ranges::find_if(pieces, [&](const Row& each) {
          return number(each.at("momentum_from")) <= momentum &&
                 momentum <= number(each.at("momentum_to"));
        });
        const bool in_box = std::ranges::all_of(
            std::array{"xi", "zeta", "rho"},
            [&](const char* s) { return number(row.at(s)) > 1.1e-3 && number(row.at(s)) < 900.0; });
        if (piece == pieces.end()) {
          outside += in_box;
          continue;
        }
        if (!in_box) continue;
        const double from = number(piece->at("momentum_from"));
        const double to = number(piece->at("momentum_to"));
        if (piece->at("sheet") == row.at("sheet")) ++on_pieces[row.at("sheet")];
        // E is not above its chord's end, nor below what the slopes at both ends bound.
        const double below = number(piece->at("energy_from"));
        const double least_slope =
            std::min(number(piece->at("spin_from")), number(piece->at("spin_to")));
        if (to - from < 1e-2 * to) {
          EXPECT_GE(energy, below + 0.5 * least_slope * (momentum - from) - 1e-9) << name;
        }
        EXPECT_GE(energy, below - 1e-9 * std::abs(below) - 1e-12) << name << ' ' << row.at("sheet");
      }
    }
    EXPECT_EQ(outside, 0) << name;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      EXPECT_EQ(json[k]["sheet"].dump(), pieces[k].at("sheet"));
      EXPECT_EQ(json[k]["branch"], pieces[k].at("branch"));
      EXPECT_LT(number(pieces[k].at("momentum_from")), number(pieces[k].at("momentum_to")));
      EXPECT_GE(on_pieces[pieces[k].at("sheet")], 1) << name;
      if (k == 0) continue;
      const Row& last = pieces[k - 1];
      const double at = number(pieces[k].at("momentum_from"));
      EXPECT_GE(at, number(last.at("momentum_to")));
      if (at > number(last.at("momentum_to"))) continue;
      // It changes hands where both have the same energy, or where the last sheet ends.
      ++changes;
      EXPECT_NE(last.at("sheet"), pieces[k].at("sheet"));
      EXPECT_LE(number(last.at("energy_to")), (1.0 + 1e-9) * number(pieces[k].at("energy_from")));
    }
  }
  EXPECT_GE(changes, 1);
}

TEST(LeastEnergy, OfAGridIsRefused) {
  const Outcome outcome =
      run_program({"atlas", shipped("apart.toml"), "--grid", "-o", "-", "--least-energy", "x.csv"});
  EXPECT_EQ(outcome.code, 2);
}

/// The table of results/ is of today's covers: of the cases that took less than 20 seconds, classes included.
TEST(Completeness, IsTheTableShipped) {
  std::map<std::string, std::vector<Row>> cases;
  for (const Row& row : rows_of(text_of(STATIONARY_RESULTS "/completeness.csv")))
    cases[row.at("case")].push_back(row);
  int compared = 0;
  for (const auto& [name, rows] : cases) {
    const auto is_long = [](const Row& row) { return number(row.at("seconds")) >= 20.0; };
    if (std::ranges::any_of(rows, is_long)) continue;
    const TemporaryDirectory directory;
    const Outcome outcome =
        run_program({"atlas", shipped(name + ".toml"), "-o", directory / "x.csv", "-q",
                     "--complete", "--checkpoints", "1", "--set", "output.spectrum=false"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    for (const Row& row : rows) {
      int proven = 0;
      bool joins = false;  // those cut for what is known outside the box, as one
      double left = 0.0;
      for (const auto& each : metadata["completeness"]) {
        if (each["branch"] != row.at("branch")) continue;
        if (each.value("plane", "") != row.at("plane")) continue;
        EXPECT_EQ(each["boxes"].dump(), row.at("boxes")) << name;
        const bool is_proven = each["status"] == "proven";
        if (is_proven)
          proven += !joins;
        else
          left += each["to"].get<double>() - each["from"].get<double>();
        joins = is_proven;
      }
      EXPECT_EQ(std::to_string(proven), row.at("proven_intervals")) << name;
      // Where both of two tilted sheets leave the box, a search between them is undecided.
      const double most = row.at("plane").empty() ? 1e-6 : 1e-4;
      EXPECT_LT(left, most * (number(row.at("to")) - number(row.at("from")))) << name;
      ++compared;
    }
  }
  EXPECT_GE(compared, 36);
}

}  // namespace
}  // namespace stationary::testing
