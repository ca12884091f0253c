// Commands, options, help, version; what the command line itself gets wrong ends with 2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "lib/material/potential.hpp"
#include "solver/newton/ceres_solve.hpp"
#include "solver/newton/nlopt_seed.hpp"
#include "tests/program/needs_gnuplot.hpp"
#include "tests/program/needs_hdf5.hpp"
#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

TEST(CommandLine, NoCommandPrintsHelpAndFails) {
  const Outcome outcome = run_program({});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, HasSubstr("Usage: stationary"));
}

TEST(CommandLine, HelpAndVersion) {
  for (const auto& arguments : std::vector<std::vector<std::string>>{{"--help"},
                                                                     {"solve", "--help"},
                                                                     {"continue", "--help"},
                                                                     {"check", "--help"},
                                                                     {"models", "--help"},
                                                                     {"plot", "--help"},
                                                                     {"help"},
                                                                     {"help", "map"}}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, StartsWith("Usage: stationary"));
    EXPECT_THAT(outcome.err, IsEmpty());
  }
  for (const auto& arguments : std::vector<std::vector<std::string>>{{"--version"},
                                                                     {"solve", "--version"},
                                                                     {"continue", "--version"},
                                                                     {"check", "--version"},
                                                                     {"plot", "--version"}}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, StartsWith("stationary " STATIONARY_VERSION "\n"));
    for (const char* part : {"compiler", "Eigen", "oneTBB", "Boost", "CLI11", "fmt", "toml\\+\\+",
                             "nlohmann-json", "PEGTL"}) {
      EXPECT_THAT(outcome.out,
                  ::testing::ContainsRegex(std::string("\n") + part + " +[^\n]*[0-9]+\\.[0-9]"));
    }
    const auto says = [&](const std::string& part, bool there) {
      EXPECT_THAT(outcome.out,
                  ::testing::ContainsRegex("\n" + part +
                                           (there ? " +[0-9]+\\.[0-9]" : " +built without; ")));
    };
    says("Ceres Solver", !version_of_ceres().empty());
    says("NLopt", !version_of_nlopt().empty());
    says("HDF5", has_hdf5);
    EXPECT_THAT(outcome.out,
                ::testing::ContainsRegex(has_gnuplot() ? "\ngnuplot +[0-9]+\\.[0-9]"
                                                       : "\ngnuplot +not found; the command plot"));
  }
}

TEST(CommandLine, HelpOfACommandIsThatCommandsOwn) {
  EXPECT_EQ(run_program({"help"}).out, run_program({"--help"}).out);
  for (const char* command : {"solve", "continue", "atlas", "map", "check", "models", "plot"})
    EXPECT_EQ(run_program({"help", command}).out, run_program({command, "--help"}).out) << command;
  EXPECT_THAT(run_program({"help", "help"}).out, HasSubstr("[COMMAND]"));
  const Outcome unknown = run_program({"help", "mop"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("unknown command \"mop\"; did you mean \"map\"?"));
  // It runs none.
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"models", "biot"}, {"solve", "plot"}, {"solve", "x.toml", "-q"}}) {
    std::vector<std::string> arguments{"help"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("help takes one command; found \"" + more[1] + "\""));
    EXPECT_EQ(outcome.out, "");
  }
}

TEST(CommandLine, HelpThatCannotBeWrittenIsAFailure) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--help"}, {"--version"}, {"solve", "--help"}}) {
    const Outcome outcome = run_program(arguments, {.standard_output = "/dev/full"});
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.err, HasSubstr("No space left"));
  }
}

/// Libraries that compute with threads have nothing to say of how many there are.
TEST(CommandLine, MoreThreadsThanProcessorsAreNoMatter) {
  const std::vector<std::vector<std::string>> commands{
      {"atlas", shipped("apart.toml"), "--checkpoints", "2"},
      {"map", shipped("map_biot_log.toml"), "--set", "map.x.count=9", "--set", "map.y.count=9"},
      {"solve", shipped("disc.toml"), "--set", "solve.method=ceres"}};
  for (const std::vector<std::string>& command : commands) {
    std::string of_one;
    for (const char* const threads : {"1", "512"}) {
      std::vector<std::string> words = command;
      words.insert(words.end(), {"-o", "-", "--threads", threads});
      const Outcome outcome = run_program(words);
      EXPECT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_EQ(outcome.err, "") << command[0] << ' ' << threads;
      if (of_one.empty()) of_one = outcome.out;
      EXPECT_TRUE(outcome.out == of_one) << command[0];
    }
  }
}

TEST(CommandLine, MisspeltCommandsAndOptions) {
  struct Line {
    std::vector<std::string> arguments;
    const char* fragment;
  };
  const std::vector<Line> lines{
      {{"slove", "x.toml"}, "unknown command \"slove\"; did you mean \"solve\"?"},
      {{"continu", "x.toml"}, "did you mean \"continue\"?"},
      {{"continue", "x.toml", "--resme"}, "did you mean \"--resume\"?"},
      {{"modles"}, "did you mean \"models\"?"},
      {{"--set", "motion.nu=0.3", "solve", "x.toml"},
       "\"--set\" stands before the command; the options of solve stand after it"},
      {{"-q", "solve", "x.toml"},
       "\"-q\" stands before the command; the options of solve stand after it"},
      {{"solve", "x.toml", "--quite"}, "unknown option \"--quite\"; did you mean \"--quiet\"?"},
      {{"solve", "x.toml", "--outptu=y"}, "did you mean \"--output\"?"},
      {{"solve", "--thread"}, "did you mean \"--threads\"?"},
      {{"solve"}, "CASE is required"},
      {{"solve", "x.toml", "y.toml"}, "unknown argument \"y.toml\""},
      {{"solve", "x.toml", "--threads", "0"}, "--threads"},
      {{"solve", "x.toml", "--threads", "many"}, "--threads"},
      {{"solve", "x.toml", "-o"}, "-o"},
      {{"solve", "x.toml", "-o", ""}, "found an empty name"},
      {{"plot", "x.csv", "-o", ""}, "found an empty name"},
      {{"plto", "x.csv"}, "did you mean \"plot\"?"},
      {{"plot", "x.csv", "--titel=y"}, "did you mean \"--title\"?"},
      {{"plot", "x.csv"}, "--output is required"},
      {{"models", "hencki"}, "did you mean \"hencky\"?"},
      {{""}, "stationary: "},
  };
  for (const Line& line : lines) {
    const Outcome outcome = run_program(line.arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, HasSubstr(line.fragment));
  }
}

TEST(Models, ListsAllOfThemWithFormulaParametersAndDomain) {
  const Outcome outcome = run_program({"models"});
  EXPECT_EQ(outcome.code, 0);
  std::vector<ModelDescription> all = model_descriptions();
  all.insert(all.end(), anisotropic_descriptions().begin(), anisotropic_descriptions().end());
  for (const ModelDescription& model : all) {
    const Outcome one = run_program({"models", std::string(model.name)});
    EXPECT_EQ(one.code, 0);
    for (const std::string& text : {outcome.out, one.out}) {
      EXPECT_THAT(text, HasSubstr(std::string(model.name)));
      EXPECT_THAT(text, HasSubstr(std::string(model.formula)));
      for (const std::string& inequality : model.domain) EXPECT_THAT(text, HasSubstr(inequality));
    }
  }
}

}  // namespace
}  // namespace stationary::testing
