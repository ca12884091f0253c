// continue from outside: its columns, other parameters than nu, what is asked for, what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "tests/program/continued.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* without_spectrum =
    "branch,sheet,point,event,nu1,nu2,nu3,alpha,xi,zeta,rho,lambda,mu,angle,pi1,pi2,pi3,energy,"
    "residual,compatibility,error_bound";
constexpr const char* spectral =
    ",class,growth,negative,re1,im1,krein1,re2,im2,krein2,re3,im3,krein3,re4,im4,krein4,re5,im5,"
    "krein5,segment";
constexpr const char* of_events = ",criticality,side";

TEST(Continue, ColumnsInTheirOrder) {
  const Outcome outcome = continued(shipped("disc.toml"));
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_EQ(header_of(outcome.out), std::string(without_spectrum) + spectral + of_events);
  EXPECT_TRUE(outcome.out.ends_with("\n"));
  EXPECT_EQ(outcome.out.find('\r'), std::string::npos);
  const Outcome plain = continued(shipped("disc.toml"), {"output.spectrum=false"});
  EXPECT_EQ(header_of(plain.out), std::string(without_spectrum) + of_events);
  const Outcome other = continued(
      shipped("disc.toml"), {"continuation.parameter=potential.plane.c", "continuation.from=0.5"});
  EXPECT_EQ(header_of(other.out),
            std::string(without_spectrum) + spectral + of_events + ",potential.plane.c");
}

TEST(Continue, ChosenColumnsKeepTheirOrder) {
  const std::string columns = R"(output.columns=["class", "nu1", "omega", "event", "xi"])";
  const Outcome outcome = continued(shipped("disc.toml"), {columns});
  EXPECT_EQ(header_of(outcome.out), "event,nu1,xi,class");
  EXPECT_THAT(outcome.out, HasSubstr("\nlimit,0,0.8408964152537145,"));
  // The parameter that varies is always there.
  const Outcome other = continued(
      shipped("disc.toml"),
      {columns, "continuation.parameter=body.J.1", "continuation.from=1", "continuation.to=2"});
  EXPECT_EQ(header_of(other.out), "event,nu1,xi,class,body.J.1");
  const Outcome only = continued(
      shipped("disc.toml"),
      {R"(output.columns=["omega"])", "continuation.from=0.5", "continuation.parameter=body.J.1"});
  EXPECT_EQ(header_of(only.out), "body.J.1");
  const Outcome none = continued(shipped("disc.toml"), {R"(output.columns=["omega"])"});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("output.columns: found no column that continue computes"));
}

/// An empty line is no row to many readers.
TEST(Continue, AColumnByItselfHasALineForEveryRow) {
  const TemporaryDirectory directory;
  const std::string target = directory / "x.csv";
  ASSERT_EQ(continued(shipped("fold.toml"), {"output.columns=[\"event\"]"}, target).code, 0);
  const std::string text = text_of(target);
  EXPECT_EQ(text.find("\n\n"), std::string::npos);
  const auto metadata = nlohmann::json::parse(text_of(directory / "x.meta.json"));
  EXPECT_EQ(std::ranges::count(text, '\n'), metadata["rows"].get<long>() + 1);
  EXPECT_EQ(rows_of(text).size(), metadata["rows"]);
}

TEST(Continue, SpectrumOffChangesNoOtherCell) {
  const std::vector<std::string> quick{"continuation.tolerance=1e-6"};
  const auto with = rows_of(continued(shipped("disc.toml"), quick).out);
  const auto without =
      rows_of(continued(shipped("disc.toml"), {quick[0], "output.spectrum=false"}).out);
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t k = 0; k < with.size(); ++k)
    for (const auto& [column, cell] : without[k]) EXPECT_EQ(with[k].at(column), cell) << column;
}

TEST(Continue, OverridesOfTheContinuation) {
  const auto with = [](const std::string& override) {
    auto all = along_nu("0", "1.05");
    all.push_back(override);
    return rows_of(continued(shipped("disc.toml"), all).out);
  };
  EXPECT_LT(3 * with("continuation.tolerance=1e-6").size(),
            with("continuation.tolerance=1e-10").size());
  EXPECT_EQ(with("continuation.tolerance=1e-20"), with("continuation.tolerance=1e-13"));
  const auto rows = with("continuation.step=0.001");
  // The step is an arc of ln S and of nu over its range.
  EXPECT_NEAR(number(rows[1], "nu1"), 0.001 * 1.05, 1e-6);
  EXPECT_EQ(continued(shipped("disc.toml"), {"continuation.parameter=motion.nu"}).out,
            continued(shipped("disc.toml")).out);
}

// Other parameters: the spin is held.

class ContinueIn : public ::testing::TestWithParam<std::tuple<const char*, const char*>> {
 protected:
  std::string case_file() const { return shipped(std::get<0>(GetParam())); }
  std::string parameter() const { return std::get<1>(GetParam()); }
};

/// "potential.plane.c" of the case's tree.
double own_value(const Case& input, const std::string& key) {
  if (key.starts_with("body")) {
    const double J[] = {input.body.J1, input.body.J2, input.body.J3};
    return J[key.back() - '0'];
  }
  for (const ModelChoice& model : input.models)
    for (std::size_t k = 0; k < model.coefficients.size(); ++k)
      if (key == "potential." + model.slot + "." + model.description.parameters[k])
        return model.coefficients[k];
  ADD_FAILURE() << key;
  return 0.0;
}

TEST_P(ContinueIn, RowsAreWhatSolveFinds) {
  const Case input = read_case(case_file());
  const double own = own_value(input, parameter());
  const Outcome outcome = continued(
      case_file(),
      {"continuation.parameter=" + parameter(), "continuation.from=" + std::to_string(0.9 * own),
       "continuation.to=" + std::to_string(1.1 * own), "continuation.tolerance=1e-5"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(header_of(outcome.out).ends_with("krein5,segment,criticality,side," + parameter()));
  const auto rows = rows_of(outcome.out);
  ASSERT_GE(rows.size(), 3U);
  EXPECT_EQ(rows.front().at("event"), "limit");
  EXPECT_EQ(rows.back().at("event"), "limit");
  for (std::size_t k = 0; k < rows.size(); k += 1 + rows.size() / 4) {
    const Row& row = rows[k];
    const Outcome solved = run_program(
        {"solve", case_file(), "-o", "-", "--set", parameter() + "=" + row.at(parameter())});
    ASSERT_EQ(solved.code, 0) << solved.err;
    const Row cold = only_row(solved.out);
    const double bounds = number(row, "error_bound") + number(cold, "error_bound");
    for (const char* column : {"xi", "zeta", "rho"})
      EXPECT_NEAR(number(row, column), number(cold, column), 1.01 * bounds * number(cold, column));
    for (const char* column : {"branch", "nu1", "nu2", "nu3", "alpha", "compatibility", "class",
                               "negative", "krein1", "krein5"})
      EXPECT_EQ(row.at(column), cold.at(column)) << column;
    for (const char* column : {"energy", "pi1", "pi2", "pi3", "im4", "growth"}) {
      EXPECT_NEAR(number(row, column), number(cold, column),
                  1e-13 * (1.0 + std::abs(number(cold, column))))
          << column;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ContinueIn,
    ::testing::Values(std::tuple{"disc.toml", "body.J.0"}, std::tuple{"disc.toml", "body.J.1"},
                      std::tuple{"disc.toml", "body.J.2"},
                      std::tuple{"disc.toml", "potential.plane.c"},
                      std::tuple{"neo_hookean.toml", "potential.plane.lambda"},
                      std::tuple{"second_axis.toml", "potential.plane.mu"},
                      std::tuple{"second_axis.toml", "potential.thickness.b"},
                      std::tuple{"third_axis.toml", "potential.thickness.rest"},
                      std::tuple{"third_axis.toml", "potential.thickness.k"},
                      std::tuple{"third_axis.toml", "body.J.2"},
                      std::tuple{"thick.toml", "potential.thickness.rest"},
                      std::tuple{"coupled.toml", "potential.coupled.lambda"},
                      std::tuple{"coupled.toml", "body.J.0"}),
    [](const auto& info) {
      std::string text = std::string(std::get<0>(info.param)) + "_" + std::get<1>(info.param);
      for (char& c : text)
        if (c == '.') c = '_';
      return text;
    });

/// Only the events named are in the table, where they were; the spectrum comes with those that need
/// it; residuals and energy with their columns.
TEST(Continue, EventsAndColumnsAskedFor) {
  const std::string path = shipped("apart.toml");
  const Outcome all = continued(path, {});
  const Outcome some = continued(path, {"continuation.events=[\"tilt\",\"krein-pass\"]",
                                        "output.columns=[\"event\",\"nu3\",\"xi\"]"});
  ASSERT_EQ(some.code, 0) << some.err;
  std::vector<std::pair<std::string, std::string>> expected;
  for (auto& row : rows_of(all.out))
    if (row["event"] == "tilt" || row["event"] == "krein-pass")
      expected.emplace_back(row["event"], row["nu3"]);
  ASSERT_EQ(expected.size(), 2U);
  std::vector<std::pair<std::string, std::string>> found;
  for (auto& row : rows_of(some.out))
    if (row["event"] == "tilt" || row["event"] == "krein-pass" || row["event"] == "fold-momentum")
      found.emplace_back(row["event"], row["nu3"]);
  EXPECT_EQ(found, expected);

  const TemporaryDirectory directory;
  const Outcome bare = run_program({"continue", path, "-o", directory / "x.csv", "--set",
                                    "output.columns=[\"event\",\"nu3\",\"xi\"]"});
  ASSERT_EQ(bare.code, 0) << bare.err;
  const auto counts = nlohmann::json::parse(text_of(directory / "x.meta.json"))["counts"];
  for (const char* skipped : {"spectra", "potentials", "second_derivatives", "certificates"})
    EXPECT_EQ(counts[skipped], 0) << skipped;
  EXPECT_GT(counts["continuation_extended_residuals"], counts["continuation_steps"]);

  const Outcome wrong = continued(path, {"continuation.events=[\"tilts\"]"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("\"tilt\"?"));
}

// What is refused.

struct Refused {
  const char* file;
  std::vector<std::string> overrides;
  const char* message;
};

TEST(Continue, WrongInputIsTwoAndNamesThePlace) {
  const std::vector<Refused> all{
      {"disc.toml", {"continuation.step=0.6"}, "--set continuation.step=0.6: continuation.step: "},
      {"disc.toml", {"continuation.step=0"}, "continuation.step: found 0"},
      {"disc.toml", {"continuation.from=2"}, "disc.toml:25:6: continuation.to: found the empty"},
      {"disc.toml", {"continuation.to=0"}, "continuation.to: found the empty range from 0 to 0"},
      {"disc.toml", {"continuation.tolerance=0"}, "continuation.tolerance: found 0"},
      {"disc.toml", {"continuation.tolerance=2"}, "continuation.tolerance: found 2"},
      {"disc.toml", {"continuation.tolerance=nan"}, "continuation.tolerance: found"},
      {"disc.toml", {"continuation.to=inf"}, "continuation.to: found"},
      {"disc.toml", {"continuation.max_points=1"}, "continuation.max_points: found 1"},
      {"disc.toml", {"continuation.max_points=9.5"}, "continuation.max_points: found 9.5"},
      {"disc.toml", {"continuation.parameter=potential.plane.z"}, "\"potential.plane.c\"?"},
      {"disc.toml", {"continuation.parameter=body.J.3"}, "continuation.parameter: found"},
      {"disc.toml", {"continuation.parameter=motion.omega"}, "continuation.parameter: found"},
      {"disc.toml",
       {"continuation.parameter=body.J.0"},
       "disc.toml:24:8: continuation.from: found body.J.0 = 0; expected J1 > 0"},
      {"disc.toml",
       {"continuation.parameter=potential.plane.k", "continuation.from=-1"},
       "continuation.from: found potential.plane.k = -1"},
      {"neo_hookean.toml",
       {"continuation.parameter=potential.plane.lambda", "continuation.from=-5"},
       "continuation.from: found potential.plane.lambda = -5"},
      {"disc.toml",
       {"solve.start=[0,1,1,0.7]", "continuation.from=0.6"},
       "disc.toml:20:6: motion.nu: found nu = 0.5, outside the range"},
      {"two_polar.toml", {"continuation.parameter=nu"}, "continuation.parameter: found"},
      {"two_polar.toml", {"continuation.parameter=body.J.0"}, "continuation.parameter: found"},
      {"too_fast.toml", {}, "too_fast.toml:1:1: continuation: found no such key"},
      {"two_polar.toml",
       {"continuation={from=0.0,to=1.0}"},
       "continuation.parameter: found no such key; expected one of \"motion.omega\""},
  };
  for (const Refused& each : all) {
    const Outcome outcome = continued(shipped(each.file), each.overrides);
    EXPECT_EQ(outcome.code, 2) << each.message;
    EXPECT_THAT(outcome.err, HasSubstr(each.message));
    EXPECT_THAT(outcome.out, IsEmpty());
  }
}

TEST(Continue, TheParameterIsNuUnlessAnotherIsNamed) {
  const Outcome named = continued(shipped("disc.toml"), {"continuation.to=1"});
  EXPECT_EQ(continued(shipped("disc.toml"), {"continuation={from=0.0,to=1.0,tolerance=1e-10}"}).out,
            named.out);
}

}  // namespace
}  // namespace stationary::testing
