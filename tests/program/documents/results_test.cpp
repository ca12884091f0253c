// Every shipped result is what the program makes of its case today: a curve's rows on the curve,
// its events and ends the same, a solution's numbers the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

std::vector<std::string> stems_in(const std::string& directory, const std::string& extension) {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (entry.path().extension() == extension) out.push_back(entry.path().stem().string());
  std::ranges::sort(out);
  return out;
}

std::string case_path(const std::string& stem) { return STATIONARY_CASES "/" + stem + ".toml"; }
std::string result_of(const std::string& file) { return STATIONARY_RESULTS "/" + file; }

/// The spin and the logarithms of the stretches.
using Place = std::array<double, 4>;

Place place_of(const Row& row) {
  double nu = 0.0;
  for (const char* column : {"nu1", "nu2", "nu3"}) nu += number(row.at(column));
  return {nu, std::log(number(row.at("xi"))), std::log(number(row.at("zeta"))),
          std::log(number(row.at("rho")))};
}

double distance_to_line(const Place& p, const Place& a, const Place& b) {
  double along = 0.0;
  double length = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    along += (p[k] - a[k]) * (b[k] - a[k]);
    length += (b[k] - a[k]) * (b[k] - a[k]);
  }
  const double u = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  double square = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const double off = p[k] - a[k] - u * (b[k] - a[k]);
    square += off * off;
  }
  return std::sqrt(square);
}

void expect_on_the_curve(const std::vector<Row>& rows, const std::vector<Row>& curve) {
  std::vector<Place> line;
  for (const Row& row : curve) line.push_back(place_of(row));
  for (const Row& row : rows) {
    if (row.at("event") == "escape" || row.at("event") == "collapse") continue;
    const Place at = place_of(row);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < line.size(); ++k)
      least = std::min(least, distance_to_line(at, line[k - 1], line[k]));
    EXPECT_LE(least, 2e-3) << "point " << row.at("point");
  }
}

/// `negative` along the curve, once where it stays. At an event the sign of a zero may be either.
std::vector<std::string> negative_counts(const std::vector<Row>& rows) {
  std::vector<std::string> out;
  for (const Row& row : rows) {
    if (!row.at("event").empty()) continue;
    if (out.empty() || out.back() != row.at("negative")) out.push_back(row.at("negative"));
  }
  return out;
}

void expect_same_curve(const std::vector<Row>& rows, const std::vector<Row>& today) {
  const auto events = events_of(rows);
  const auto events_today = events_of(today);
  ASSERT_EQ(events.size(), events_today.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    const std::string& name = events[k].at("event");
    EXPECT_EQ(name, events_today[k].at("event"));
    const double nu = place_of(events_today[k])[0];
    const double tolerance = name == "escape" || name == "collapse" ? 1e-5 : 1e-10;
    EXPECT_NEAR(place_of(events[k])[0], nu, tolerance * (1.0 + std::abs(nu))) << name;
  }
  EXPECT_EQ(negative_counts(rows), negative_counts(today));
  expect_on_the_curve(rows, today);
  expect_on_the_curve(today, rows);
}

void expect_same_solutions(const std::vector<Row>& rows, const std::vector<Row>& today) {
  ASSERT_EQ(rows.size(), today.size());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (const auto& [column, cell] : rows[k]) {
      const std::string& now = today[k].at(column);
      const bool rounding =
          column == "residual" || column == "compatibility" || column == "error_bound";
      if (cell == now || rounding) continue;
      EXPECT_NEAR(number(cell), number(now), 1e-12 * (1.0 + std::abs(number(now)))) << column;
    }
  }
}

constexpr std::string_view atlas_suffix = "_atlas";

bool is_atlas(const std::string& stem) { return stem.ends_with(atlas_suffix); }

class ShippedResult : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedResult, IsWhatTheProgramMakesOfItsCase) {
  const std::string& stem = GetParam();
  const bool curve = text_of(case_path(stem)).find("\n[continuation]") != std::string::npos;
  const TemporaryDirectory directory;
  const std::string path = directory / "today.csv";
  const Outcome run =
      run_program({curve ? "continue" : "solve", case_path(stem), "-o", path, "-q"});
  EXPECT_EQ(run.code, stem == "too_fast" ? 3 : 0) << run.err;
  const std::string shipped = text_of(result_of(stem + ".csv"));
  const std::string today = text_of(path);
  EXPECT_EQ(header_of(shipped), header_of(today));
  if (curve) {
    expect_same_curve(rows_of(shipped), rows_of(today));
    for (const char* extension : {".svg", ".png"})
      EXPECT_GT(std::filesystem::file_size(result_of(stem + extension)), 1000U) << extension;
  } else {
    expect_same_solutions(rows_of(shipped), rows_of(today));
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedResult,
                         ::testing::ValuesIn(stems_in(STATIONARY_CASES, ".toml")),
                         [](const auto& param) { return param.param; });

/// The atlases among them: sheet by sheet.
TEST(ShippedResults, AtlasesAreWhatTheProgramMakesOfTheirCases) {
  int compared = 0;
  for (const std::string& stem : stems_in(STATIONARY_RESULTS, ".csv")) {
    if (!is_atlas(stem)) continue;
    const TemporaryDirectory directory;
    const std::string path = directory / "today.csv";
    const std::string toml = case_path(stem.substr(0, stem.size() - atlas_suffix.size()));
    std::vector<std::string> arguments{"atlas", toml, "-o", path, "-q"};
    // Its searches take seconds, and its sheets are all connected to rest.
    if (text_of(toml).find("\nfibre ") != std::string::npos)
      arguments.insert(arguments.end(), {"--checkpoints", "4"});
    const Outcome run = run_program(arguments);
    ASSERT_EQ(run.code, 0) << run.err;
    const auto shipped = sheets_of(rows_of(text_of(result_of(stem + ".csv"))));
    const auto today = sheets_of(rows_of(text_of(path)));
    ASSERT_EQ(shipped.size(), today.size()) << stem;
    for (std::size_t k = 0; k < shipped.size(); ++k) expect_same_curve(shipped[k], today[k]);
    ++compared;
  }
  EXPECT_GE(compared, 3);
}

/// dE = |nu| d|pi| along a family in nu: between two rows |nu| lies between theirs.
TEST(ShippedResults, EnergyChangesByNuTimesTheMomentum) {
  int tables = 0;
  int steps = 0;
  for (const std::string& stem : stems_in(STATIONARY_RESULTS, ".csv")) {
    const std::string table = text_of(result_of(stem + ".csv"));
    const std::string header(header_of(table));
    const bool in_nu = header.find(",body.") == std::string::npos &&
                       header.find(",potential.") == std::string::npos &&
                       header.find(",omega") == std::string::npos;
    if (!in_nu || header.find(",event,") == std::string::npos) continue;
    ++tables;
    const auto rows = rows_of(table);
    for (std::size_t k = 1; k < rows.size(); ++k) {
      const Row& a = rows[k - 1];
      const Row& b = rows[k];
      if (a.at("sheet") != b.at("sheet")) continue;
      const double change = number(b.at("energy")) - number(a.at("energy"));
      const double momentum = length(b, "pi") - length(a, "pi");
      const double mean = 0.5 * (length(a, "nu") + length(b, "nu"));
      const double spread = 0.5 * std::abs((length(b, "nu") - length(a, "nu")) * momentum);
      const double rounding = 1e-13 * std::abs(number(b.at("energy"))) + 1e-15;
      EXPECT_LE(std::abs(change - mean * momentum), spread + rounding)
          << stem << ", sheet " << b.at("sheet") << ", point " << b.at("point");
      ++steps;
    }
  }
  EXPECT_GE(tables, 25);
  EXPECT_GE(steps, 10000);
}

/// Metadata made with another table than the one beside them have another checksum.
TEST(ShippedResults, MetadataAreOfTheirTables) {
  int gone_on_with = 0;
  for (const std::string& stem : stems_in(STATIONARY_CASES, ".toml")) {
    const std::string table = text_of(result_of(stem + ".csv"));
    if (header_of(table).find(",sheet,point,event,") == std::string::npos) continue;
    const TemporaryDirectory directory;
    for (const char* extension : {".csv", ".meta.json"})
      std::filesystem::copy_file(result_of(stem + extension), directory / (stem + extension));
    const Outcome run =
        run_program({"continue", case_path(stem), "-o", directory / (stem + ".csv"), "--resume"});
    EXPECT_EQ(run.code, 0) << stem << ": " << run.err;
    ++gone_on_with;
  }
  EXPECT_GE(gone_on_with, 20);
}

TEST(ShippedResults, AreOfTheCasesAndNothingElse) {
  const auto cases = stems_in(STATIONARY_CASES, ".toml");
  const auto of_cases = [](std::vector<std::string> stems) {
    std::erase_if(stems, is_atlas);
    // Measured: work_precision_test.cpp; the whole of stress_test.cpp. A page seen in a browser. Two
    // cases in one figure, and curves of events of one. By tests/python/classical_test.py.
    const std::set<std::string> others{"maclaurin_jacobi",
                                       "work_precision",
                                       "completeness",
                                       "explorer",
                                       "elastic_sphere_ellipse",
                                       "elastic_sphere_fold_nu",
                                       "riemann",
                                       "elastic_sphere_curves",
                                       "elastic_sphere_hamiltonian_hopf",
                                       "spin_eccentricity",
                                       "event_curves"};
    std::erase_if(stems, [&](const std::string& stem) {
      return others.contains(stem) || stem.starts_with("stress");
    });
    return stems;
  };
  EXPECT_EQ(of_cases(stems_in(STATIONARY_RESULTS, ".csv")), cases);
  for (const char* extension : {".svg", ".png"})
    EXPECT_THAT(cases, ::testing::IsSupersetOf(of_cases(stems_in(STATIONARY_RESULTS, extension))));
}

/// What is shipped; today's curves are held against such events in tests/solver/event_curve.
TEST(ShippedResults, CurvesOfEventsAreTheEventsOfSingleFamilies) {
  int types = 0;
  for (const Row& row : rows_of(text_of(STATIONARY_RESULTS "/event_curves.csv"))) {
    ++types;
    EXPECT_GE(number(row.at("values")), 50) << row.at("event");
    EXPECT_GE(number(row.at("found")), 48) << row.at("event");
    EXPECT_LE(number(row.at("largest_difference")), 1e-12) << row.at("event");
  }
  EXPECT_EQ(types, 10);
}

}  // namespace
}  // namespace stationary::testing
