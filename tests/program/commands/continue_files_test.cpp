// continue from outside: the table's file, the metadata beside it and the summary; what a run that
// fails, is refused or stops early leaves of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "tests/program/continued.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

TEST(Continue, MaxPointsEndsTheTableOpen) {
  const TemporaryDirectory directory;
  for (const auto& [most, from] : {std::pair{2, "0"}, {17, "0"}, {2, "-1"}, {17, "-1"}}) {
    const Outcome outcome = continued(shipped("disc.toml"),
                                      {"continuation.max_points=" + std::to_string(most),
                                       std::string("continuation.from=") + from},
                                      directory / "x.csv");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("continuation.max_points; --resume goes on"));
    const auto rows = rows_of(text_of(directory / "x.csv"));
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(most)) << from;
    EXPECT_EQ(rows.back().at("event"), "");
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    EXPECT_EQ(metadata["status"], "stopped at max_points");
    EXPECT_THAT(metadata["last_end"].get<std::string>(),
                HasSubstr("continuation.max_points is reached"));
  }
  const Outcome piped = continued(shipped("disc.toml"), {"continuation.max_points=17"});
  EXPECT_THAT(piped.err, HasSubstr("continuation.max_points"));
  EXPECT_THAT(piped.err, Not(HasSubstr("--resume"))) << "no file stays";
}

TEST(Continue, MetadataTellTheEventsOfTheTable) {
  const TemporaryDirectory directory;
  for (const char* file : {"fold.toml", "circle.toml", "apart.toml", "disc.toml"}) {
    const Outcome outcome = continued(shipped(file), along_nu("0", "3"), directory / "x.csv");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("one end"));  // the summary, beside the table too
    EXPECT_THAT(directory.names(), ElementsAre("x.csv", "x.meta.json"));
    const auto rows = rows_of(text_of(directory / "x.csv"));
    const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
    EXPECT_EQ(metadata["command"], "continue");
    EXPECT_EQ(metadata["status"], "done");
    EXPECT_EQ(metadata["rows"], rows.size());
    EXPECT_EQ(metadata["case"]["continuation"]["to"], 3.0);
    EXPECT_EQ(metadata["overrides"]["continuation.to"], "--set continuation.to=3");
    EXPECT_THAT(metadata["first_end"].get<std::string>(),
                StartsWith(rows.front().at("event") + " at nu = "));
    EXPECT_THAT(metadata["last_end"].get<std::string>(),
                StartsWith(rows.back().at("event") + " at nu = "));
    const auto& counts = metadata["counts"];
    EXPECT_EQ(counts["spectra"], counts["points_evaluated"]);
    EXPECT_GE(counts["points_evaluated"], rows.size() - 1);
    EXPECT_GE(counts["continuation_jacobians"], counts["continuation_steps"]);

    std::vector<Row> events;
    for (const Row& row : rows)
      if (!row.at("event").empty() && !is_end_name(row.at("event"))) events.push_back(row);
    ASSERT_EQ(metadata.contains("events") ? metadata["events"].size() : 0, events.size()) << file;
    const std::string nu =
        "nu" + std::to_string(1 + axis(read_case(shipped(file)).problem().branch()));
    for (std::size_t k = 0; k < events.size(); ++k) {
      const auto& event = metadata["events"][k];
      EXPECT_EQ(event["event"], events[k].at("event"));
      const double at = event["parameter"];
      EXPECT_EQ(at, number(events[k], nu));
      EXPECT_EQ(event["status"], "located");
      // A turn of nu is passed on one side of it.
      for (const double end : event["bracket"]) EXPECT_NEAR(end, at, 1e-13 * at) << event;
    }
  }
}

TEST(Continue, SummaryForAPerson) {
  const Outcome outcome = run_program(continue_command(shipped("fold.toml"), along_nu("0", "3")));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  for (const char* words :
       {"branch (i) in nu, from 0 to 3", "walk from the rest state", "limit at nu = 0",
        "escape at nu = ", "fold-nu           nu = 0.54910552293", "tilt", "unstable", "stable"})
    EXPECT_THAT(outcome.out, HasSubstr(words));
  auto quiet = continue_command(shipped("fold.toml"), along_nu("0", "3"));
  quiet.emplace_back("--quiet");
  EXPECT_THAT(run_program(quiet).out, IsEmpty());
}

TEST(Continue, NoneAtTheStartIsThreeAndLeavesTheOldTable) {
  const TemporaryDirectory directory;
  const std::string target = directory.file("x.csv", "old\n");
  const Outcome outcome = continued(shipped("too_fast.toml"), along_nu("2.4", "3"), target);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err,
              HasSubstr("at the start nu = 2.5: no stationary ellipsoid exists: V_rho'"));
  EXPECT_EQ(text_of(target), "old\n");
  EXPECT_THAT(directory.names(), ElementsAre("x.csv"));
}

TEST(Continue, AnOldTableIsReplacedOnlyByAWholeOne) {
  const TemporaryDirectory directory;
  const std::string target = directory.file("x.csv", "old\n");
  EXPECT_EQ(continued(shipped("disc.toml"), {"continuation.step=9"}, target).code, 2);
  EXPECT_EQ(text_of(target), "old\n");
  EXPECT_EQ(continued(shipped("disc.toml"), {}, target).code, 0);
  EXPECT_EQ(text_of(target), continued(shipped("disc.toml")).out);
  EXPECT_EQ(continued(shipped("disc.toml"), {}, directory / "no/x.csv").code, 2);
  EXPECT_THAT(directory.names(), ElementsAre("x.csv", "x.meta.json"));
}

TEST(Continue, AFullDiskIsAFailure) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const Outcome outcome = continued(shipped("disc.toml"), {}, "/dev/full");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("No space left"));
  auto streamed = continue_command(shipped("disc.toml"), {});
  streamed.insert(streamed.end(), {"-o", "-"});
  EXPECT_EQ(run_program(streamed, {.standard_output = "/dev/full"}).code, 4);
}

/// The stream is written to, and no file in its place or beside its name.
TEST(Continue, ToTheNameOfAStream) {
  const TemporaryDirectory directory;
  const std::string target = directory / "x";
  const Outcome outcome = run_program({"continue", shipped("disc.toml"), "-q", "-o", "/dev/stdout"},
                                      {.standard_output = target});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(text_of(target), continued(shipped("disc.toml")).out);
  EXPECT_THAT(directory.names(), ElementsAre("x"));
  EXPECT_FALSE(std::filesystem::exists("/dev/stdout.meta.json"));
}

}  // namespace
}  // namespace stationary::testing
