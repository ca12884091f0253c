// Branch "tilted" from outside: one motion, the family from branch to branch, going on with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string tilted_case = STATIONARY_CASES "/tilted.toml";

TEST(TiltedCase, CheckSaysWhatIsComputed) {
  const Outcome outcome = run_program({"check", tilted_case});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("tilted in the 1-3 plane, |nu| = 1.07"));
  EXPECT_THAT(outcome.out, HasSubstr("sqrt(J1/J3) xi"));
  const Outcome other = run_program({"check", tilted_case, "--set", "motion.plane=\"23\""});
  EXPECT_THAT(other.out, HasSubstr("tilted in the 2-3 plane"));
  EXPECT_THAT(other.out, HasSubstr("sqrt(J2/J3) zeta"));
}

TEST(TiltedCase, OneMotionAsARow) {
  const Outcome outcome = run_program({"solve", tilted_case, "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  auto row = only_row(outcome.out);
  EXPECT_EQ(row["branch"], "tilted");
  EXPECT_NEAR(std::atan2(number(row["nu3"]), number(row["nu1"])), 0.5526723959, 5e-11);
  EXPECT_EQ(row["nu2"], "0");
  EXPECT_NEAR(number(row["xi"]), 0.57054735, 5e-9);
  EXPECT_NEAR(number(row["pi1"]) * number(row["nu3"]), number(row["pi3"]) * number(row["nu1"]),
              1e-13);
  EXPECT_EQ(row["class"], "unstable");
  EXPECT_NEAR(number(row["growth"]), 0.20382668, 5e-9);
  const Outcome summary = run_program({"solve", tilted_case});
  EXPECT_THAT(summary.out, HasSubstr("from rest to the tilt of branch (i)"));
  EXPECT_THAT(summary.out, HasSubstr("connection    rest"));
}

TEST(TiltedCase, FromAStartTheSameMotion) {
  const auto from = [](const std::vector<std::string>& more) {
    std::vector<std::string> all{"solve", tilted_case, "-o", "-"};
    all.insert(all.end(), more.begin(), more.end());
    return only_row(run_program(all).out);
  };
  auto walked = from({});
  auto started = from({"--set", "solve.start=[0, 0.6, 3, 0.7]"});
  for (const char* column : {"nu1", "nu3", "xi", "zeta", "rho"})
    EXPECT_NEAR(number(walked[column]), number(started[column]), 1e-13) << column;
}

TEST(TiltedCase, OneMotionProven) {
  const Outcome outcome = run_program({"solve", tilted_case, "--certify", "-o", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  auto row = only_row(outcome.out);
  EXPECT_EQ(row["certified"], "yes");
  EXPECT_EQ(row["class_certified"], "yes");
  EXPECT_LT(number(row["error_bound"]), 1e-13);
}

TEST(TiltedCase, AllOfThemOrProvenThatThereIsNone) {
  const std::vector<std::string> all{"solve", tilted_case, "-o", "-", "--set", "solve.all=true"};
  const Outcome outcome = run_program(all);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_NEAR(number(only_row(outcome.out)["xi"]), 0.57054735, 5e-9);
  // Neither needs a start or a sheet through rest.
  auto beyond = all;
  beyond.insert(beyond.end(), {"--set", "motion.nu=1.3"});
  const Outcome none = run_program(beyond);
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, HasSubstr("no stationary ellipsoid in the box searched"));
  EXPECT_THAT(none.err, HasSubstr("proven that there is none"));
  EXPECT_TRUE(rows_of(none.out).empty());
}

/// A case without motion.plane; J1 = J2 makes each plane's motions the other's.
std::string either_plane(const TemporaryDirectory& directory, const char* J) {
  std::string text = text_of(tilted_case);
  const auto replace = [&text](const std::string& old, const std::string& with) {
    const std::size_t at = text.find(old);
    ASSERT_NE(at, std::string::npos) << old;
    text.replace(at, old.size(), with);
  };
  replace("plane = \"13\"\n", "");
  replace("[1.0, 1.7, 0.6]", J);
  return directory.file("either.toml", text);
}

TEST(TiltedCase, WithoutAPlaneBothAreLookedIn) {
  const TemporaryDirectory directory;
  const std::string path = either_plane(directory, "[1.0, 1.7, 0.6]");
  EXPECT_THAT(run_program({"check", path}).out, HasSubstr("in the 1-3 or the 2-3 plane"));
  const Outcome one = run_program({"solve", path, "-o", directory / "x.csv"});
  ASSERT_EQ(one.code, 0) << one.err;
  EXPECT_EQ(only_row(text_of(directory / "x.csv"))["nu2"], "0");
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_THAT(metadata["message"].get<std::string>(), HasSubstr("1-3 plane: from rest"));
  EXPECT_THAT(metadata["message"].get<std::string>(), HasSubstr("2-3 plane: "));
  EXPECT_FALSE(metadata["case"]["motion"].contains("plane"));
  // Continued, the family is the one of the plane that has one.
  const Outcome followed = run_program({"continue", path, "-o", "-"});
  ASSERT_EQ(followed.code, 0) << followed.err;
  EXPECT_EQ(rows_of(followed.out).front().at("event"), "tilt");
  // Exit code 3 is for both planes.
  const Outcome none =
      run_program({"solve", path, "--set", "solve.all=true", "--set", "motion.nu=1.3", "-o", "-"});
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, HasSubstr("1-3 plane: stretches in [0.001, 1000]: proven"));
  EXPECT_THAT(none.err, HasSubstr("2-3 plane: stretches in [0.001, 1000]: proven"));
}

TEST(TiltedCase, WithoutAPlaneARowForEach) {
  const TemporaryDirectory directory;
  const std::string path = either_plane(directory, "[1.0, 1.0, 1.4]");
  const std::string nu = "motion.nu=1.05";
  for (const char* all : {"solve.all=false", "solve.all=true"}) {
    const Outcome outcome =
        run_program({"solve", path, "--certify", "-o", "-", "--set", nu, "--set", all});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty());
    auto rows = rows_of(outcome.out);
    ASSERT_EQ(rows.size(), 2U) << all;
    EXPECT_EQ(rows[0]["nu2"], "0");
    EXPECT_EQ(rows[1]["nu1"], "0");
    EXPECT_EQ(rows[0]["xi"], rows[1]["zeta"]);
    EXPECT_EQ(rows[1]["sheet"], "2");
    for (auto& row : rows) {
      EXPECT_EQ(row["class"], "stable");
      EXPECT_EQ(row["class_certified"], "yes");
    }
  }
  const Outcome outcome = run_program({"continue", path, "-o", "-", "--set", nu});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("motion.plane: found no such key"));
  EXPECT_THAT(outcome.err, HasSubstr("in both planes"));
}

TEST(TiltedCase, AFollowedFamilyIsProvenUpToItsEnds) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run_program({"continue", tilted_case, "--certify", "-o", directory / "x.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  // Its ends, where the axis is a material one, by the equations of a tilt.
  for (const Row& row : rows_of(text_of(directory / "x.csv")))
    EXPECT_EQ(row.at("certified"), "yes") << row.at("xi");
}

TEST(TiltedCase, WhereThereIsNoneItSaysWhereTheFamilyEnds) {
  const Outcome outcome = run_program({"solve", tilted_case, "--set", "motion.nu=1.3"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, HasSubstr("branch (i) at nu = 1.05486"));
  EXPECT_THAT(outcome.err, HasSubstr("to 1.08359 (tilt)"));
}

TEST(TiltedCase, TheFamilyFromBranchToBranch) {
  const TemporaryDirectory directory;
  const Outcome outcome = run_program({"continue", tilted_case, "-o", directory / "x.csv"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(text_of(directory / "x.csv"));
  ASSERT_GE(rows.size(), 10U);
  EXPECT_EQ(rows.front().at("event"), "tilt");
  EXPECT_EQ(rows.front().at("nu3"), "0");
  EXPECT_EQ(rows.back().at("event"), "tilt");
  EXPECT_EQ(rows.back().at("nu1"), "0");
  double tilt = -1.0;
  for (const Row& row : rows) {
    const double next = std::atan2(number(row.at("nu3")), number(row.at("nu1")));
    EXPECT_GT(next, tilt);
    tilt = next;
  }
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(metadata["case"]["motion"]["plane"], "13");
  ASSERT_EQ(metadata["events"].size(), 2U);
  EXPECT_EQ(metadata["events"][0]["event"], "tilt");
}

/// Lambda that meet in the step that ends a family, at a coarse tolerance: found, or told as what they are. True:
/// 70 digits, from the Lagrangian.
TEST(TiltedCase, MeetingsInTheLastStep) {
  const std::string written = R"(plane = { expression = "mu/2*(I1 - 2*log(d)) + la/2*log(d)^2", )";
  const struct {
    std::string body;
    std::string range;
    std::vector<std::pair<std::string, double>> events;  ///< the last before the end
  } cases[] = {{"[body]\nJ = [1.239, 1.286, 0.3445]\n[potential]\n" + written +
                    "mu = 0.3449, la = 1.423 }\n"
                    "thickness = { model = \"reciprocal-quadratic\", a = 1.434, b = 0.6756 }\n",
                "nu = 0.5\n[continuation]\nfrom = 0.3\nto = 1.002\n",
                {{"hamiltonian-hopf", 0.527735934227476}, {"real-collision", 0.528784534891634}}},
               {"[body]\nJ = [0.9772, 1.17264, 0.981]\n[potential]\n" + written +
                    "mu = 1.749, la = 0.5614 }\n"
                    "thickness = { model = \"reciprocal-quadratic\", a = 0.3895, b = 0.4611 }\n",
                "nu = 1.19\n[continuation]\nfrom = 0.001\nto = 2.242\n",
                {{"real-collision", 1.33789849866187},
                 {"fold-nu", 1.33790413502084},
                 {"real-collision", 1.33789487167122}}},
               {"[body]\nJ = [0.8617, 0.89617, 0.2378]\n[potential]\n" + written +
                    "mu = 2.703, la = 1.459 }\n"
                    "thickness = { model = \"harmonic\", k = 0.8892, rest = 0.5628 }\n",
                "nu = 1.595\n[continuation]\nfrom = 0.001\nto = 2.042\n",
                {{"hamiltonian-hopf", 1.74931809197162}, {"real-collision", 1.7711134129739}}}};
  const TemporaryDirectory directory;
  int unlocated = 0;
  for (const auto& each : cases) {
    const std::string file =
        directory.file("x.toml", each.body + "[motion]\nbranch = \"tilted\"\nplane = \"23\"\n" +
                                     each.range + "tolerance = 1e-6\n");
    const Outcome outcome = run_program({"continue", file, "-o", directory / "x.csv", "-q"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    const auto& events = metadata["events"];
    ASSERT_GT(events.size(), each.events.size()) << events;
    // No class is told of where one that is not located may lie; the other side of a fold has its own.
    for (const auto& event : events) {
      if (event["status"] != "unresolved" || each.events.size() > 2) continue;
      ++unlocated;
      for (const auto& segment : metadata["segments"])
        for (const auto& range : segment["ranges"])
          EXPECT_FALSE(range[0] < event["bracket"][1] && event["bracket"][0] < range[1])
              << metadata;
    }
    EXPECT_EQ(events.back()["event"], "tilt");
    const std::size_t first = events.size() - 1 - each.events.size();
    for (std::size_t k = 0; k < each.events.size(); ++k) {
      const auto& [type, parameter] = each.events[k];
      const auto& found = events[first + k];
      EXPECT_EQ(found["event"], type) << events;
      EXPECT_LE(found["bracket"][0].get<double>(), parameter * (1.0 + 1e-13)) << events;
      EXPECT_GE(found["bracket"][1].get<double>(), parameter * (1.0 - 1e-13)) << events;
    }
  }
  EXPECT_GT(unlocated, 0) << "no case is left in which one is not located";
}

/// Two meetings between two rows, of which the signatures of the rows tell: with steps of any length. True: steps
/// of a tolerance of 1e-12; to six digits, 70 digits from the Lagrangian.
TEST(TiltedCase, MeetingsBetweenTwoRows) {
  const TemporaryDirectory directory;
  const std::string file =
      directory.file("x.toml",
                     "[body]\nJ = [0.8965, 0.93236, 1.0583]\n[potential]\n"
                     "plane = { model = \"biot-log\", mu = 0.4417, lambda = 2.87 }\n"
                     "thickness = { model = \"reciprocal-quadratic\", a = 2.985, b = 0.3077 }\n"
                     "[motion]\nbranch = \"tilted\"\nnu = 0.8717\nplane = \"23\"\n"
                     "[continuation]\nfrom = 0.001\nto = 1.358\n");
  const std::vector<double> meetings{0.78574247966188, 0.78649655953956, 0.91564893175582};
  for (const char* tolerance : {"1e-5", "1e-7", "1e-8", "1e-9"}) {
    const Outcome outcome = run_program({"continue", file, "-o", directory / "x.csv", "-q", "--set",
                                         std::string("continuation.tolerance=") + tolerance});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    std::vector<double> found;
    const auto events = nlohmann::json::parse(text_of(directory / "x.meta.json"))["events"];
    for (const auto& event : events)
      if (event["event"] == "hamiltonian-hopf") found.push_back(event["parameter"]);
    ASSERT_EQ(found.size(), meetings.size()) << tolerance;
    for (std::size_t k = 0; k < meetings.size(); ++k)
      EXPECT_NEAR(found[k], meetings[k], 1e-13) << tolerance;
  }
}

TEST(TiltedCase, AnInterruptedTableGoesOn) {
  const TemporaryDirectory directory;
  const std::vector<std::string> command{"continue", tilted_case, "-o", directory / "x.csv"};
  ASSERT_EQ(run_program(command).code, 0);
  const auto whole = rows_of(text_of(directory / "x.csv"));
  auto stopped = command;
  stopped.insert(stopped.end(), {"--set", "continuation.max_points=5"});
  ASSERT_EQ(run_program(stopped).code, 0);
  auto resumed = command;
  resumed.emplace_back("--resume");
  const Outcome outcome = run_program(resumed);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto rows = rows_of(text_of(directory / "x.csv"));
  for (const auto end : {0, 1}) {
    const Row& a = end == 0 ? whole.front() : whole.back();
    const Row& b = end == 0 ? rows.front() : rows.back();
    EXPECT_EQ(a.at("event"), b.at("event"));
    for (const char* column : {"nu1", "nu3", "xi", "rho"})
      EXPECT_NEAR(number(a.at(column)), number(b.at(column)), 1e-12) << column;
  }
}

}  // namespace
}  // namespace stationary::testing
