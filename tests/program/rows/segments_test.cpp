// What is told of a curve beside its rows: segments of one class between events, ends, and events
// that are known and not located; in the metadata, the table and the summary.
#include "solver/program/rows/segments.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "tests/program/json_schema.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr auto stable = StabilityClass::stable;
constexpr auto elliptic = StabilityClass::elliptic;
constexpr auto oscillatory = StabilityClass::oscillatory;
constexpr auto marginal = StabilityClass::marginal;

class Builder {
 public:
  int row(double p, StabilityClass verdict, EventType event = EventType::none) {
    return builder.row(point_++, {event, p}, verdict, event == EventType::none);
  }
  SegmentBuilder builder;

 private:
  long point_ = 0;
};

TEST(Segments, AreBoundedByEventsAndTurnWithTheCurve) {
  Builder rows;
  EXPECT_EQ(rows.row(0.0, stable, EventType::limit), 1);
  EXPECT_EQ(rows.row(0.1, elliptic), 1);
  EXPECT_EQ(rows.row(0.3, elliptic), 1);
  EXPECT_EQ(rows.row(0.4, marginal, EventType::hamiltonian_hopf), 1) << "the segment it ends";
  EXPECT_EQ(rows.row(0.5, oscillatory), 2);
  EXPECT_EQ(rows.row(0.9, oscillatory, EventType::fold_nu), 2);
  EXPECT_EQ(rows.row(0.2, oscillatory), 2);
  EXPECT_EQ(rows.row(0.1, oscillatory, EventType::escape), 2);
  const auto found = rows.builder.segments();
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].verdict, elliptic);
  EXPECT_EQ(found[0].from.event, EventType::limit);
  EXPECT_EQ(found[0].to.event, EventType::hamiltonian_hopf);
  EXPECT_EQ(found[0].to.parameter, 0.4);
  EXPECT_EQ(found[0].first_point, 0);
  EXPECT_EQ(found[0].last_point, 3);
  EXPECT_THAT(found[0].ranges, ElementsAre(std::array{0.0, 0.4}));
  EXPECT_EQ(found[1].from.parameter, 0.4);
  EXPECT_EQ(found[1].to.event, EventType::escape);
  EXPECT_THAT(found[1].ranges, ElementsAre(std::array{0.4, 0.9}, std::array{0.1, 0.9}));
}

TEST(Segments, BetweenTwoEventsOfOneStep) {
  Builder rows;
  rows.row(0.1, elliptic);
  rows.row(0.4, marginal, EventType::hamiltonian_hopf);
  rows.builder.between(oscillatory);
  EXPECT_EQ(rows.row(0.5, marginal, EventType::hamiltonian_hopf), 2);
  EXPECT_EQ(rows.row(0.6, elliptic), 3);
  const auto found = rows.builder.segments();
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[1].verdict, oscillatory);
  EXPECT_EQ(found[1].first_point, 2);
  EXPECT_EQ(found[1].last_point, 2);
  EXPECT_THAT(found[1].ranges, ElementsAre(std::array{0.4, 0.5}));
  EXPECT_EQ(found[2].from.parameter, 0.5);
}

/// What is not to be told half way is not taken from the stretch before an event.
TEST(Segments, AreMarginalBehindAnEventWhereNothingTells) {
  Builder rows;
  rows.row(0.1, elliptic);
  rows.row(0.4, marginal, EventType::hamiltonian_hopf);
  rows.builder.between(marginal);
  EXPECT_EQ(rows.row(0.5, marginal, EventType::escape), 2);
  EXPECT_EQ(rows.builder.segments().back().verdict, marginal);
  Builder folded;
  folded.row(0.1, elliptic);
  folded.row(0.4, elliptic, EventType::fold_nu);
  folded.builder.between(marginal);
  EXPECT_EQ(folded.row(0.3, marginal, EventType::limit), 1) << "a fold changes no class";
  EXPECT_EQ(folded.builder.segments().back().verdict, elliptic);
}

/// What an event cannot change it is not blamed for; without any event the segments end at rows.
TEST(Segments, AClassThatChangesWithoutAnEvent) {
  Builder rows;
  rows.row(0.1, elliptic);
  rows.row(0.2, elliptic, EventType::fold_momentum);
  rows.row(0.3, elliptic, EventType::inertia_exchange);
  rows.row(0.4, stable);
  rows.row(0.5, marginal);
  rows.row(0.6, marginal);
  const auto found = rows.builder.segments();
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].to.event, EventType::fold_momentum);
  EXPECT_EQ(found[1].to.event, EventType::none);
  EXPECT_EQ(found[1].to.parameter, 0.4);
  EXPECT_EQ(found[2].from.parameter, 0.5);
  EXPECT_EQ(found[2].verdict, marginal);
}

TEST(Segments, NoneWithoutASpectrum) {
  SegmentBuilder rows;
  rows.row(0, {EventType::limit, 0.0}, std::nullopt, false);
  rows.row(1, {EventType::none, 0.1}, std::nullopt, true);
  EXPECT_TRUE(rows.segments().empty());
}

Json schema() { return Json::parse(text_of(STATIONARY_SCHEMA)); }

TEST(Schema, SeesWhatIsWrong) {
  const Json of = schema();
  const TemporaryDirectory directory;
  ASSERT_EQ(run_program({"continue", shipped("fold.toml"), "-o", directory / "x.csv"}).code, 0);
  const Json good = Json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(schema_fault(good, of), "");
  Json bad = good;
  bad.erase("ends");
  EXPECT_THAT(schema_fault(bad, of), HasSubstr("no key \"ends\""));
  bad = good;
  bad["schema"] = 1;
  EXPECT_THAT(schema_fault(bad, of), HasSubstr("/schema: const 2"));
  bad = good;
  bad["segments"][0]["class"] = "wobbly";
  EXPECT_THAT(schema_fault(bad, of), HasSubstr("/segments/0/class: enum"));
  bad = good;
  bad["events"][0]["bracket"] = {1.0};
  EXPECT_THAT(schema_fault(bad, of), HasSubstr("/events/0/bracket: minItems"));
  bad = good;
  bad["ends"][0]["surprise"] = 1;
  EXPECT_THAT(schema_fault(bad, of), HasSubstr("surprise"));
}

TEST(Schema, HoldsForEveryCommand) {
  const Json of = schema();
  const TemporaryDirectory directory;
  const auto expect_valid = [&](std::vector<std::string> arguments, int code = 0) {
    arguments.insert(arguments.end(), {"-o", directory / "x.csv"});
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, code) << outcome.err;
    EXPECT_EQ(schema_fault(Json::parse(text_of(directory / "x.meta.json")), of), "")
        << arguments[0] << " " << arguments[1];
  };
  expect_valid({"solve", shipped("disc.toml")});
  expect_valid({"solve", shipped("apart.toml"), "--set", "solve.all=true"});
  expect_valid({"solve", shipped("too_fast.toml")}, 3);
  expect_valid(
      {"map", shipped("map_biot_log.toml"), "--set", "map.x.count=3", "--set", "map.y.count=2"});
  expect_valid({"atlas", shipped("apart.toml"), "--checkpoints", "4"});
  const std::string over = directory.file("over.csv", "motion.nu,_tag\n0.3,a\nfast,b\n");
  for (const char* task : {"solve", "continue"})
    expect_valid({"study", shipped("disc.toml"), "--over", over, "--do", task});
  for (const char* name : {"disc.toml", "fold.toml", "circle.toml", "apart.toml", "tilted.toml",
                           "two_polar.toml", "fibre.toml"})
    expect_valid({"continue", shipped(name)});
}

/// The table's column and the metadata tell the same; each segment is bounded by what stands in the
/// table, and its ranges hold its rows.
void expect_consistent(const std::string& csv, const Json& metadata) {
  const auto rows = rows_of(csv);
  std::map<std::pair<std::string, std::string>, std::vector<Row>> members;
  for (const Row& row : rows) members[{row.at("sheet"), row.at("segment")}].push_back(row);
  EXPECT_FALSE(metadata["segments"].empty());
  for (const Json& segment : metadata["segments"]) {
    const auto& in = members[{segment["sheet"].dump(), segment["segment"].dump()}];
    ASSERT_FALSE(in.empty()) << segment;
    EXPECT_EQ(in.front().at("point"), segment["first_point"].dump());
    EXPECT_EQ(in.back().at("point"), segment["last_point"].dump());
    for (const Row& row : in) {
      double nu = 0.0;
      for (const char* column : {"nu1", "nu2", "nu3"}) nu = std::hypot(nu, number(row.at(column)));
      if (row.at("event").empty() && nu != 0.0) {
        EXPECT_EQ(row.at("class"), segment["class"].get<std::string>());
      }
      EXPECT_TRUE(std::ranges::any_of(segment["ranges"],
                                      [&](const Json& range) {
                                        return range[0].get<double>() <= nu * (1.0 + 1e-12) &&
                                               nu <= range[1].get<double>() * (1.0 + 1e-12);
                                      }))
          << segment << " " << nu;
    }
    for (const char* side : {"from", "to"}) {
      const Json& bound = segment[side];
      if (bound["event"] == "") continue;
      EXPECT_TRUE(std::ranges::any_of(rows, [&](const Row& row) {
        return row.at("sheet") == segment["sheet"].dump() && row.at("event") == bound["event"];
      })) << segment;
    }
  }
  for (const Json& event : metadata["events"]) {
    if (event["status"] == "unresolved") continue;
    const auto at = std::ranges::find_if(rows, [&](const Row& row) {
      return row.at("sheet") == event["sheet"].dump() && row.at("point") == event["point"].dump();
    });
    ASSERT_NE(at, rows.end()) << event;
    EXPECT_EQ(at->at("event"), event["event"]);
  }
  EXPECT_EQ(metadata["ends"].size() % 2, 0U);
}

/// From the first collision over a fold and back: a line of the summary names both, and both runs.
TEST(Segments, OfACurveThatTurns) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_program({"continue", shipped("broken_pitchfork.toml"), "-o", directory / "x.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json metadata = Json::parse(text_of(directory / "x.meta.json"));
  expect_consistent(text_of(directory / "x.csv"), metadata);
  const auto found = std::ranges::find_if(metadata["segments"], [](const Json& segment) {
    return segment["class"] == "oscillatory" && segment["ranges"].size() == 2;
  });
  ASSERT_NE(found, metadata["segments"].end());
  std::vector<double> bounds{(*found)["from"]["parameter"], (*found)["to"]["parameter"]};
  std::ranges::sort(bounds);
  EXPECT_NEAR(bounds[0], 0.32268, 1e-5);
  EXPECT_NEAR(bounds[1], 0.32310, 1e-5);
  for (const char* side : {"from", "to"}) EXPECT_EQ((*found)[side]["event"], "hamiltonian-hopf");
  for (const Json& range : (*found)["ranges"]) EXPECT_NEAR(range[1], 0.94931, 1e-5);

  const Outcome person = run_program({"continue", shipped("broken_pitchfork.toml")});
  EXPECT_THAT(person.out, HasSubstr("oscillatory  from hamiltonian-hopf 0.32"));
  EXPECT_THAT(person.out, HasSubstr("0.949312"));
}

/// Between an event and an end of the sheet, or rest and an event, no row may lie: the class is that of the
/// curve there, as a solve half way has it.
TEST(Segments, BesideEndsAndRestAreThoseOfTheCurve) {
  struct Asked {
    std::string text;
    std::vector<std::string> classes;
  };
  const std::string tilted = R"([motion]
branch = "tilted"
plane = "13"
nu = 1.0
[continuation]
from = 0.05
to = 3.0
)";
  const Asked all[] = {{R"([body]
J = [1.716, 1.037, 0.4305]
[potential]
plane     = { model = "saint-venant-kirchhoff", mu = 0.5467, lambda = 2.316 }
thickness = { model = "reciprocal-quadratic", a = 0.8089, b = 1.079 }
)" + tilted + "tolerance = 1e-4\n",
                        {"elliptic", "oscillatory", "elliptic", "oscillatory"}},
                       {R"([body]
J = [0.5442, 1.361, 0.544]
volume = 1.134
[gravity]
g = 1.309
[potential]
coupled = { model = "neo-hookean-3d", mu = 0.6712, lambda = 1.081 }
[motion]
branch = "i"
nu = 0.3
[continuation]
from = 0.0
to = 0.5
tolerance = 1e-6
)",
                        {"unstable", "stable"}},
                       {R"([body]
J = [0.8712, 0.8132, 1.722]
volume = 1.017
[gravity]
g = 0.9843
[potential]
plane     = { model = "biot", mu = 0.9281, lambda = 1.763 }
thickness = { model = "reciprocal-quadratic", a = 0.9015, b = 1.759 }
)" + tilted,
                        {"elliptic", "oscillatory", "unstable"}}};
  const TemporaryDirectory directory;
  for (const Asked& each : all) {
    const std::string path = directory.file("case.toml", each.text);
    const Outcome outcome = run_program({"continue", path, "-o", directory / "x.csv"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json metadata = Json::parse(text_of(directory / "x.meta.json"));
    expect_consistent(text_of(directory / "x.csv"), metadata);
    std::vector<std::string> classes;
    for (const Json& segment : metadata["segments"]) {
      classes.push_back(segment["class"]);
      const auto& range = segment["ranges"].at(0);
      const double middle = 0.5 * (range.at(0).get<double>() + range.at(1).get<double>());
      const Outcome there = run_program({"solve", path, "--quiet", "-o", "-", "--set",
                                         "motion.nu=" + std::to_string(middle), "--set",
                                         "output.columns=[\"class\"]"});
      EXPECT_EQ(rows_of(there.out).at(0).at("class"), classes.back()) << middle << there.err;
    }
    EXPECT_EQ(classes, each.classes);
    // What has come of one run is what is gone on with.
    const Outcome again = run_program({"continue", path, "-o", directory / "x.csv", "--resume"});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(Json::parse(text_of(directory / "x.meta.json"))["segments"], metadata["segments"]);
  }
}

TEST(Segments, OfAnAtlas) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_program(
      {"atlas", shipped("apart.toml"), "--checkpoints", "8", "-o", directory / "x.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json metadata = Json::parse(text_of(directory / "x.meta.json"));
  expect_consistent(text_of(directory / "x.csv"), metadata);
  EXPECT_EQ(metadata["ends"].size(), 2 * metadata["sheets"].size());
}

/// Near escape, at stretches of 1e4, two frequencies can no longer be told apart: where they seem
/// to collide differs with the tolerance, and is said of none.
TEST(Segments, WhatIsNotResolvedIsNoEvent) {
  const TemporaryDirectory directory;
  const std::string path = directory.file("x.toml", R"case(
[body]
J = [1.0, 1.7, 0.6]
[potential]
coupled = { expression = "a*(I1+rho^2-3) + b*(d^2+rho^2*I1-3) + c*((d*rho)^2-1) - (a+2*b+c)*log((d*rho)^2)", a = 0.4, b = 0.1, c = 0.3 }
[motion]
branch = "ii"
nu = 0.3
[continuation]
parameter = "nu"
from = 0.0
to = 3.0
)case");
  for (const char* tolerance : {"1e-6", "1e-8", "1e-9"}) {
    const Outcome outcome = run_program({"continue", path, "-o", directory / "x.csv", "--set",
                                         std::string("continuation.tolerance=") + tolerance});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto rows = rows_of(text_of(directory / "x.csv"));
    std::vector<std::string> events;
    int open = 0;
    for (const Row& row : rows) {
      if (!row.at("event").empty()) events.push_back(row.at("event"));
      for (const char* k : {"1", "2", "3", "4", "5"}) {
        if (row.at(std::string("re") + k).empty()) continue;
        const bool imaginary = number(row.at(std::string("re") + k)) == 0.0 &&
                               number(row.at(std::string("im") + k)) > 0.0;
        const std::string& krein = row.at(std::string("krein") + k);
        if (imaginary) {
          EXPECT_NE(krein, "0") << "point " << row.at("point");
          open += krein.empty();
        } else {
          EXPECT_EQ(krein, "0") << "point " << row.at("point");
        }
      }
    }
    EXPECT_THAT(events, ElementsAre("limit", "inertia-exchange", "fold-nu", "escape"));
    EXPECT_GT(open, 0);
  }
}

}  // namespace
}  // namespace stationary::testing
