// The diagram of a table: what of it is drawn and how; what is refused; what stands on disk.
#include "solver/program/plot/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <sstream>

#include "solver/program/diagram/diagram_lines.hpp"
#include "solver/program/plot/gnuplot.hpp"
#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;

/// Stable, a tilt in between, unstable: five rows of (i).
const char* const tilting_table =
    "branch,sheet,point,event,nu1,nu2,nu3,rho,lambda,mu,class,growth,im1,im2\n"
    "i,1,0,limit,0,0,0,0.7,1,0.9,stable,0,0.5,2\n"
    "i,1,1,,0.25,0,0,0.7,1.1,0.8,stable,0,0.25,2\n"
    "i,1,2,tilt,0.5,0,0,0.7,1.2,0.75,marginal,0,0,2\n"
    "i,1,3,,0.75,0,0,0.7,1.5,0.625,unstable,0.25,0,2\n"
    "i,1,4,limit,1,0,0,0.7,2,0.5,unstable,0.5,0,2\n";

Diagram diagram_of(const std::string& csv) {
  TableReader table(std::make_unique<std::istringstream>(csv), "x.csv");
  return read_diagram(table);
}

std::string script_of(const std::string& csv) {
  return gnuplot_script(diagram_of(csv), ImageFormat::svg, "Title");
}

/// What is between "$name << END_OF_DATA" and its end.
std::string block(const std::string& script, const std::string& name) {
  const std::string begin = "$" + name + " << END_OF_DATA\n";
  const std::size_t at = script.find(begin);
  if (at == std::string::npos) return "no such block";
  const std::size_t from = at + begin.size();
  return script.substr(from, script.find("END_OF_DATA", from) - from);
}

std::vector<double> parameters(const Diagram& diagram) {
  std::vector<double> out;
  for (const DiagramPoint& p : diagram.points) out.push_back(p.parameter);
  return out;
}

TEST(Diagram, TheParameterIsTheSpinAlongTheAxis) {
  const Diagram second = diagram_of("branch,nu2,rho\nii,-0.5,1\nii,0.25,1\n");
  EXPECT_EQ(second.parameter, "ν₂");
  EXPECT_THAT(parameters(second), ElementsAre(-0.5, 0.25));
  const Diagram tilted =
      diagram_of("branch,nu1,nu2,nu3,rho\ntilted,3,0,4,1\ntilted,-3,0,-4,1\ntilted,3,0,-4,1\n");
  EXPECT_EQ(tilted.parameter, "ν");
  EXPECT_THAT(parameters(tilted), ElementsAre(5, -5, 5));
  const Diagram without_branch = diagram_of("nu1,nu2,nu3,rho\n-0.5,0,0,1\n");
  EXPECT_THAT(parameters(without_branch), ElementsAre(-0.5));
  const Diagram two_polar = diagram_of("branch,rho,omega\ntwo-polar,1,1.5\n");
  EXPECT_EQ(two_polar.parameter, "ω");
  EXPECT_THAT(parameters(two_polar), ElementsAre(1.5));
}

TEST(Diagram, TheParameterIsTheTrailingColumn) {
  const Diagram diagram = diagram_of("branch,nu1,rho,body.J.0\ni,0.5,1,1.25\n");
  EXPECT_EQ(diagram.parameter, "body.J.0");
  EXPECT_THAT(parameters(diagram), ElementsAre(1.25));
}

TEST(Diagram, PiecesEndWhereSheetOrBranchChange) {
  EXPECT_THAT(
      diagram_of("branch,sheet,nu1,nu2,rho\ni,1,0,,1\ni,1,1,,1\ni,2,0,,1\nii,2,,0,1\n").pieces,
      ElementsAre(0, 2, 3));
}

TEST(Diagram, ALineIsCutAtAnEventWhichBothSidesShare) {
  // Whatever class the event's own row has, or none.
  for (const std::string verdict : {"marginal", "elliptic", ""}) {
    std::string table = tilting_table;
    table.replace(table.find("marginal"), std::string("marginal").size(), verdict);
    const auto lines = stretch_lines(diagram_of(table), {0.0, 1.0});
    ASSERT_EQ(lines.size(), 2U) << verdict;
    EXPECT_EQ(lines[0].verdict, StabilityClass::stable);
    EXPECT_THAT(lines[0].points, ElementsAre(0, 1, 2));
    EXPECT_EQ(lines[1].verdict, StabilityClass::unstable);
    EXPECT_THAT(lines[1].points, ElementsAre(2, 3, 4));
  }
}

TEST(Diagram, WhereTheLowestModeIsMissingTheOthersKeepTheirLines) {
  const Diagram diagram =
      diagram_of("branch,nu1,rho,im1,im2,im3,im4,im5\ni,0,1,1,2,3,4,\ni,0.1,1,0.1,1,2,3,4\n");
  EXPECT_TRUE(std::isnan(diagram.points[0].frequency[0]));
  for (std::size_t k = 1; k < mode_count; ++k)
    EXPECT_EQ(diagram.points[0].frequency[k], diagram.points[1].frequency[k]) << k;
}

TEST(Diagram, ThinningKeepsEndsAndExtremes) {
  Diagram diagram;
  diagram.pieces = {0};
  constexpr std::size_t count = 300000;
  for (std::size_t k = 0; k < count; ++k) {
    DiagramPoint point{};
    point.parameter = static_cast<double>(k) / static_cast<double>(count);
    point.stretch = {1.0, 2.0, 3.0};
    diagram.points.push_back(point);
  }
  diagram.points[123456].stretch[1] = 7.0;
  diagram.points[234567].stretch[2] = 0.1;
  diagram.points[200000].frequency[4] = 5.0;
  const auto lines = stretch_lines(diagram, {0.0, 1.0});
  ASSERT_EQ(lines.size(), 1U);
  const auto& kept = lines.front().points;
  EXPECT_LT(kept.size(), 4 * static_cast<std::size_t>(image_columns));
  EXPECT_TRUE(std::ranges::is_sorted(kept));
  for (const std::size_t k : {std::size_t{0}, std::size_t{123456}, std::size_t{234567}, count - 1})
    EXPECT_TRUE(std::ranges::binary_search(kept, k)) << k;
  const auto rates = spectrum_lines(diagram, {0.0, 1.0});
  ASSERT_EQ(rates.size(), 1U);
  EXPECT_TRUE(std::ranges::binary_search(rates.front().points, std::size_t{200000}));
}

TEST(PlotScript, LinesByClassAndMarksByEvent) {
  const std::string script = script_of(tilting_table);
  EXPECT_EQ(block(script, "lines_stable"), "0 1 0.9 0.7\n0.25 1.1 0.8 0.7\n0.5 1.2 0.75 0.7\n\n");
  EXPECT_EQ(block(script, "lines_unstable"),
            "0.5 1.2 0.75 0.7\n0.75 1.5 0.625 0.7\n1 2 0.5 0.7\n\n");
  EXPECT_EQ(block(script, "event_0"), "0.5 1.2 0.75 0.7\n");
  EXPECT_THAT(script, HasSubstr("set label 'tilt'"));
  EXPECT_THAT(script, Not(HasSubstr("limit")));
  EXPECT_THAT(script,
              AllOf(HasSubstr("title 'stable'"), HasSubstr("title 'unstable'"),
                    Not(HasSubstr("title 'marginal'")), Not(HasSubstr("title 'elliptic'"))));
  EXPECT_THAT(script, HasSubstr("set xlabel 'ν₁'"));
  EXPECT_THAT(script, HasSubstr("set label 'Title'"));
}

TEST(PlotScript, RatesComeDownToTheAxisButDoNotRunInIt) {
  EXPECT_EQ(block(script_of(tilting_table), "rates_lines"),
            "0 0.5 2 nan nan nan nan\n0.25 0.25 2 nan nan nan nan\n0.5 0 2 nan nan nan 0\n"
            "0.75 nan 2 nan nan nan 0.25\n1 nan 2 nan nan nan 0.5\n\n");
}

TEST(PlotScript, WithoutClassesAndSpectrum) {
  const std::string script = script_of("branch,nu1,lambda\ni,0,1\ni,1,1.5\n");
  EXPECT_EQ(block(script, "lines_no_class"), "0 1 nan nan\n1 1.5 nan nan\n\n");
  EXPECT_THAT(script, AllOf(HasSubstr("title 'λ'"), Not(HasSubstr("title 'μ'")),
                            Not(HasSubstr("$rates")), Not(HasSubstr("'growth'"))));
}

TEST(PlotScript, ALogarithmicAxisForWideRanges) {
  EXPECT_THAT(script_of("nu1,nu2,nu3,rho\n0,0,0,1\n1,0,0,29\n"), Not(HasSubstr("set logscale")));
  EXPECT_THAT(script_of("nu1,nu2,nu3,rho\n0,0,0,1\n1,0,0,31\n"), HasSubstr("set logscale y"));
}

TEST(PlotScript, StretchesThatHardlyDifferAreDrawnLessWhatTheyShare) {
  const std::string script = gnuplot_script(
      diagram_of("branch,nu1,lambda\ni,0,1.0\ni,1,1.000000004\n"), ImageFormat::svg, "");
  EXPECT_THAT(script, HasSubstr("principal stretch less 1'"));
  EXPECT_THAT(script, HasSubstr("using 1:($2 - 1)"));
}

TEST(PlotScript, OneRowIsADot) {
  const std::string script = script_of("branch,nu1,lambda,class,im1\ni,0.5,1,stable,2\n");
  EXPECT_THAT(block(script, "lines_stable"), IsEmpty());
  EXPECT_EQ(block(script, "dots_stable"), "0.5 1 nan nan\n\n");
  EXPECT_EQ(block(script, "rates_dots"), "0.5 2 nan nan nan nan nan\n\n");
}

TEST(Gnuplot, NoTextIsMisread) {
  EXPECT_EQ(in_gnuplot_quotes("a"), "'a'");
  EXPECT_EQ(in_gnuplot_quotes("it's"), "'it''s'");
  EXPECT_EQ(in_gnuplot_quotes("a\nquit"), "'a\\x0Aquit'");
  EXPECT_EQ(in_gnuplot_quotes("ν\xFF \xCE \xED\xA0\x80"), "'ν\uFFFD \uFFFD \uFFFD\uFFFD\uFFFD'");
}

class Plot : public ::testing::Test {
 protected:
  Outcome plot(const std::string& output, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"plot", table_, "-o", directory_ / output};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }

  /// What stands written in an SVG.
  std::vector<std::string> texts(const std::string& image) const {
    const std::string svg = text_of(directory_ / image);
    const std::string begin = "<text>";
    std::vector<std::string> out;
    for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at)) {
      at += begin.size();
      out.push_back(svg.substr(at, svg.find("</text>", at) - at));
    }
    return out;
  }

  TemporaryDirectory directory_;
  std::string table_ = directory_.file("x.csv", tilting_table);
};

TEST_F(Plot, WritesEachFormat) {
  const Outcome outcome = plot("x.svg");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, directory_ / "x.svg" + ": 5 rows, 1 sheet, 3 events\n");
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(text_of(directory_ / "x.svg"), HasSubstr("</svg>"));
  EXPECT_THAT(texts("x.svg"), IsSupersetOf({"tilt", "ν₁", "unstable", "growth", "x.csv"}));
  EXPECT_THAT(plot("x.png", {"--quiet"}).out, IsEmpty());
  EXPECT_THAT(text_of(directory_ / "x.png").substr(0, 4), "\x89PNG");
  EXPECT_EQ(plot("x.pdf").code, 0);
  EXPECT_THAT(text_of(directory_ / "x.pdf").substr(0, 4), "%PDF");
  EXPECT_THAT(directory_.names(), ElementsAre("x.csv", "x.pdf", "x.png", "x.svg"));
}

TEST_F(Plot, TitleOfTheCaseOrAsAsked) {
  directory_.file("x.meta.json", R"({"case": {"title": "A <b> & {/*3 'c'} @x `y`"}})");
  EXPECT_EQ(plot("x.svg").code, 0);
  EXPECT_THAT(texts("x.svg"), Contains("A &lt;b> &amp; {/*3 'c'} @x `y`"));
  EXPECT_EQ(plot("x.svg", {"--title", "Mine"}).code, 0);
  EXPECT_THAT(texts("x.svg"), AllOf(Contains("Mine"), Not(Contains(HasSubstr("A &lt;")))));
  directory_.file("x.meta.json", "no JSON");
  EXPECT_EQ(plot("x.svg").code, 0);
  EXPECT_THAT(texts("x.svg"), Contains("x.csv"));
}

TEST_F(Plot, NamesOfFilesAreNotRead) {
  EXPECT_EQ(plot("| sh 'x' `y` $(z)\n.svg").code, 0);
  EXPECT_THAT(directory_.names(), ElementsAre("x.csv", "| sh 'x' `y` $(z)\n.svg"));
}

TEST_F(Plot, DrawsWhatSolveWrites) {
  const std::string input = directory_.file("case.toml", good_case);
  ASSERT_EQ(run_program({"solve", input, "-o", table_}).code, 0);
  EXPECT_EQ(plot("x.svg").code, 0);
  EXPECT_THAT(texts("x.svg"), Contains("A case"));
}

TEST_F(Plot, TablesThatLackWhatIsNeeded) {
  struct Table {
    const char* text;
    const char* fragment;
  };
  const std::vector<Table> tables{
      {"", "x.csv: found an empty file"},
      {"branch,nu1,rho\n", "x.csv: found no rows"},
      {"branch,nu1,xi\ni,0,1\n", "x.csv: found none of the columns lambda, mu, rho"},
      {"branch,nu1,rho\nii,0,1\n",
       "x.csv: found no column \"nu2\", the parameter of branch \"ii\""},
      {"branch,nu1,rho\ntwo-polar,0,1\n", "found no column \"omega\""},
      {"nu1,nu2,rho\n0,0,1\n", "found no column \"nu3\", the parameter of its rows"},
      {"branch,nu1,rho\ni,0,\n", "x.csv: found no row with both ν₁ and a stretch"},
      {"branch,nu1,rho\ni,0\n", "x.csv:2:1: found 2 cells; expected 3"},
      {"branch,nu1,rho\ni,0,much\n", "x.csv:2:5: rho: found \"much\""},
      {"branch,nu1,rho,class\ni,0,1,fine\n", "x.csv:2:7: class: found \"fine\"; expected stable,"},
  };
  for (const Table& table : tables) {
    directory_.file("x.csv", table.text);
    const Outcome outcome = plot("x.svg");
    EXPECT_EQ(outcome.code, 2) << table.text;
    EXPECT_THAT(outcome.err, HasSubstr(table.fragment));
    EXPECT_THAT(directory_.names(), ElementsAre("x.csv"));
  }
}

TEST_F(Plot, OutputsThatAreNone) {
  EXPECT_THAT(plot("x.gif").err, HasSubstr("found the extension \".gif\"; expected .svg, .png"));
  EXPECT_THAT(plot("x").err, HasSubstr("found no extension"));
  for (const char* const output : {"x.gif", "x", "x.csv", "nowhere/x.svg"})
    EXPECT_EQ(plot(output).code, 2) << output;
  EXPECT_EQ(run_program({"plot", table_}).code, 2);
  const std::string misnamed = directory_.file("t.svg", tilting_table);
  const Outcome itself = run_program({"plot", misnamed, "-o", misnamed});
  EXPECT_EQ(itself.code, 2);
  EXPECT_THAT(itself.err, HasSubstr("is the table"));
  EXPECT_EQ(text_of(misnamed), tilting_table);
  EXPECT_EQ(run_program({"plot", directory_ / "none.csv", "-o", directory_ / "x.svg"}).code, 2);
}

/// With another gnuplot, or none, on the path.
class PlotWithoutGnuplot : public Plot {
 protected:
  PlotWithoutGnuplot() {
    ::mkdir((directory_ / "bin").c_str(), 0700);
    ::setenv("PATH", (directory_ / "bin").c_str(), 1);
  }
  ~PlotWithoutGnuplot() override { ::setenv("PATH", path_.c_str(), 1); }

  void gnuplot_is(const std::string& script) const {
    const std::string file = directory_.file("bin/gnuplot", "#!/bin/sh\n" + script);
    ::chmod(file.c_str(), 0700);
  }

  std::string path_ = std::getenv("PATH");
};

TEST_F(PlotWithoutGnuplot, IsAFailureThatLeavesNothing) {
  const Outcome outcome = plot("x.svg");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("gnuplot cannot be run: No such file or directory"));
  EXPECT_THAT(directory_.names(), ElementsAre("bin", "x.csv"));
}

TEST_F(PlotWithoutGnuplot, OneThatFailsIsHeardAndLeavesTheOldImage) {
  directory_.file("x.svg", "old");
  gnuplot_is("echo half an image\necho 'line 0: no such terminal' >&2\nexit 3\n");
  const Outcome failing = plot("x.svg");
  EXPECT_EQ(failing.code, 4);
  EXPECT_THAT(failing.err, HasSubstr("exit code 3: line 0: no such terminal"));
  gnuplot_is("echo half an image\nkill -9 $$\n");
  EXPECT_THAT(plot("x.svg").err, HasSubstr("signal 9"));
  gnuplot_is("echo 'a warning' >&2\n");
  const Outcome silent = plot("x.svg");
  EXPECT_EQ(silent.code, 4);
  EXPECT_THAT(silent.err, HasSubstr("gnuplot wrote nothing: a warning"));
  EXPECT_EQ(text_of(directory_ / "x.svg"), "old");
  EXPECT_THAT(directory_.names(), ElementsAre("bin", "x.csv", "x.svg"));
}

TEST_F(Plot, InterruptedWritesNothing) {
  const Outcome outcome =
      run_program({"plot", table_, "-o", directory_ / "x.svg"}, {.pending_signal = SIGINT});
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(directory_.names(), ElementsAre("x.csv"));
}

}  // namespace
}  // namespace stationary::testing
