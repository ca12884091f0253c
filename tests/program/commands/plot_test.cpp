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
#include "solver/program/plot/diagram_names.hpp"
#include "solver/program/plot/diagram_picture.hpp"
#include "solver/program/plot/gnuplot.hpp"
#include "tests/program/needs_gnuplot.hpp"
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

Diagram diagram_of(const std::string& csv, const DiagramChoice& choice = {}) {
  TableReader table(std::make_unique<std::istringstream>(csv), "x.csv");
  return read_diagram({&table}, choice);
}

const std::string& symbol_of(const Diagram& diagram) { return diagram.branches.front().parameter; }

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
  EXPECT_EQ(symbol_of(second), "ν₂");
  EXPECT_THAT(parameters(second), ElementsAre(-0.5, 0.25));
  const Diagram tilted =
      diagram_of("branch,nu1,nu2,nu3,rho\ntilted,3,0,4,1\ntilted,-3,0,-4,1\ntilted,3,0,-4,1\n");
  EXPECT_EQ(symbol_of(tilted), "ν");
  EXPECT_THAT(parameters(tilted), ElementsAre(5, -5, 5));
  const Diagram without_branch = diagram_of("nu1,nu2,nu3,rho\n-0.5,0,0,1\n");
  EXPECT_THAT(parameters(without_branch), ElementsAre(-0.5));
  const Diagram two_polar = diagram_of("branch,rho,omega\ntwo-polar,1,1.5\n");
  EXPECT_EQ(symbol_of(two_polar), "ω");
  EXPECT_THAT(parameters(two_polar), ElementsAre(1.5));
}

TEST(Diagram, TheParameterIsTheTrailingColumn) {
  const Diagram diagram = diagram_of("branch,nu1,rho,body.J.0\ni,0.5,1,1.25\n");
  EXPECT_EQ(symbol_of(diagram), "J₁");
  EXPECT_THAT(parameters(diagram), ElementsAre(1.25));
}

const char* const two_branches =
    "branch,sheet,nu1,nu2,nu3,rho,energy,pi1,pi2,pi3\n"
    "i,1,0,0,0,1,2,0,0,0\ni,1,1,0,0,1,3,3,4,0\ni,2,0,0,0,1,2,0,0,0\nii,3,0,0,0,1,2,0,0,1\n";

TEST(Diagram, PiecesEndWhereSheetOrBranchChange) {
  const Diagram diagram = diagram_of(two_branches);
  ASSERT_EQ(diagram.pieces.size(), 3U);
  EXPECT_EQ(diagram.pieces[0].end, 2U);
  EXPECT_EQ(diagram.pieces[1].label, "2");
  EXPECT_EQ(diagram.pieces[2].branch, 1U);
  ASSERT_EQ(diagram.branches.size(), 2U);
  EXPECT_EQ(diagram.branches[1].parameter, "ν₂");
  EXPECT_EQ(diagram_picture(diagram).panels.size(), 2U);
}

TEST(Diagram, OnlyWhatIsAskedFor) {
  DiagramChoice choice;
  choice.sheets = {"2"};
  EXPECT_EQ(diagram_of(two_branches, choice).points.size(), 1U);
  choice.sheets = {};
  choice.branches = {"i"};
  EXPECT_EQ(diagram_of(two_branches, choice).points.size(), 3U);
  choice.columns = {"energy"};
  EXPECT_EQ(diagram_of(two_branches, choice).points[1].ordinate[0], 3.0);
}

TEST(Diagram, EnergyAgainstMomentum) {
  DiagramChoice choice;
  choice.energy_momentum = true;
  const Diagram diagram = diagram_of(two_branches, choice);
  EXPECT_EQ(diagram.points[1].abscissa, 5.0);
  EXPECT_EQ(diagram.points[1].ordinate[0], 3.0);
  const DiagramPicture picture = diagram_picture(diagram);
  EXPECT_EQ(picture.panels.size(), 1U);
  EXPECT_EQ(picture.series.size(), 2U);
}

TEST(Diagram, SheetsOfSeveralTablesAreToldApart) {
  TableReader one(std::make_unique<std::istringstream>(tilting_table), "one.csv");
  TableReader two(std::make_unique<std::istringstream>(tilting_table), "two.csv");
  const Diagram diagram = read_diagram({&one, &two});
  ASSERT_EQ(diagram.pieces.size(), 2U);
  EXPECT_EQ(diagram.pieces[0].label, "a");
  EXPECT_EQ(diagram.pieces[1].label, "b");
  EXPECT_THAT(gnuplot_script(diagram, ImageFormat::svg, ""),
              AllOf(HasSubstr("'a  one'"), HasSubstr("'b  two'")));
}

TEST(Diagram, LongNamesOfTablesHaveTheirBeginningAndTheirEnd) {
  Diagram diagram;
  diagram.tables = {"here/twenty_one_characters.csv", "a_table_of_twenty_two_1.csv",
                    "a_table_of_twenty_two_2.csv", "größere_Körper_mit_ν_und_ϱ_1.h5"};
  EXPECT_EQ(table_name(diagram, 0), "a  twenty_one_characters");
  EXPECT_EQ(table_name(diagram, 1), "b  a_table_of…enty_two_1");
  EXPECT_EQ(table_name(diagram, 2), "c  a_table_of…enty_two_2");
  EXPECT_EQ(table_name(diagram, 3), "d  größere_Kö…_ν_und_ϱ_1");
}

TEST(Diagram, ALineIsCutAtAnEventWhichBothSidesShare) {
  // Whatever class the event's own row has, or none.
  for (const std::string verdict : {"marginal", "elliptic", ""}) {
    std::string table = tilting_table;
    table.replace(table.find("marginal"), std::string("marginal").size(), verdict);
    const Diagram diagram = diagram_of(table);
    const auto lines = class_lines(diagram, diagram.pieces.front(), {{0.0, 1.0}});
    ASSERT_EQ(lines.size(), 2U) << verdict;
    EXPECT_EQ(lines[0].verdict, StabilityClass::stable);
    EXPECT_THAT(lines[0].points, ElementsAre(0, 1, 2));
    EXPECT_EQ(lines[1].verdict, StabilityClass::unstable);
    EXPECT_THAT(lines[1].points, ElementsAre(2, 3, 4));
  }
}

TEST(Diagram, ThinningKeepsEndsAndExtremes) {
  Diagram diagram;
  constexpr std::size_t count = 300000;
  diagram.pieces = {{0, count, 0, "1"}};
  for (std::size_t k = 0; k < count; ++k) {
    DiagramPoint point{};
    point.abscissa = static_cast<double>(k) / static_cast<double>(count);
    point.ordinate = {1.0, 2.0, 3.0};
    diagram.points.push_back(point);
  }
  diagram.points[123456].ordinate[1] = 7.0;
  diagram.points[234567].ordinate[2] = 0.1;
  diagram.points[200000].frequency[4] = 5.0;
  const auto lines = class_lines(diagram, diagram.pieces.front(), {{0.0, 1.0}});
  ASSERT_EQ(lines.size(), 1U);
  const auto& kept = lines.front().points;
  EXPECT_LT(kept.size(), 4 * static_cast<std::size_t>(image_columns));
  EXPECT_TRUE(std::ranges::is_sorted(kept));
  for (const std::size_t k : {std::size_t{0}, std::size_t{123456}, std::size_t{234567}, count - 1})
    EXPECT_TRUE(std::ranges::binary_search(kept, k)) << k;
  const auto rates = spectrum_rows(diagram, diagram.pieces.front(), {{0.0, 1.0}});
  EXPECT_TRUE(std::ranges::binary_search(rates, std::size_t{200000}));
}

TEST(PlotScript, LinesByClassAndMarksByEvent) {
  const std::string script = script_of(tilting_table);
  EXPECT_EQ(block(script, "curve_0_0_stable"), "0 1\n0.25 1.1\n0.5 1.2\n\n");
  EXPECT_EQ(block(script, "event_0"), "0.5 1.2\n0.5 0.75\n0.5 0.7\n");
  EXPECT_THAT(script, HasSubstr("pt 5 ps 0.8 lc rgb 'black' title 'tilt'"));
  EXPECT_THAT(script, Not(HasSubstr("limit")));
  EXPECT_THAT(script,
              AllOf(HasSubstr("title 'stable'"), HasSubstr("title 'unstable'"),
                    Not(HasSubstr("title 'marginal'")), Not(HasSubstr("title 'elliptic'"))));
  EXPECT_THAT(script, HasSubstr("set label 'ν₁'"));
  EXPECT_THAT(script, HasSubstr("set label 'Title'"));
}

TEST(PlotScript, RatesComeDownToTheAxisButDoNotRunInIt) {
  const std::string script = script_of(tilting_table);
  EXPECT_EQ(block(script, "rates_growth"), "0.5 0\n0.75 0.25\n1 0.5\n\n");
  EXPECT_THAT(block(script, "rates_undetermined"), HasSubstr("0 0.5\n0.25 0.25\n0.5 0\n\n"));
}

TEST(PlotScript, WithoutClassesAndSpectrum) {
  const std::string script = script_of("branch,nu1,lambda\ni,0,1\ni,1,1.5\n");
  EXPECT_EQ(block(script, "curve_0_0_no_class"), "0 1\n1 1.5\n\n");
  EXPECT_THAT(script, AllOf(HasSubstr("title 'λ'"), Not(HasSubstr("title 'μ'")),
                            Not(HasSubstr("$rates")), Not(HasSubstr("'growth rate'"))));
}

TEST(PlotScript, StretchesThatHardlyDifferAreDrawnLessWhatTheyShare) {
  const std::string script = gnuplot_script(
      diagram_of("branch,nu1,lambda\ni,0,1.0\ni,1,1.000000004\n"), ImageFormat::svg, "");
  EXPECT_THAT(script, HasSubstr("principal stretch less 1'"));
}

TEST(PlotScript, OneRowIsADot) {
  const std::string script = script_of("branch,nu1,lambda,class,im1\ni,0.5,1,stable,2\n");
  EXPECT_EQ(block(script, "dots_0"), "0.5 1\n");
  EXPECT_EQ(block(script, "dots_of_rates_undetermined"), "0.5 2\n");
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
  NEEDS_GNUPLOT();
  const Outcome outcome = plot("x.svg");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, directory_ / "x.svg" + ": 5 rows, 1 sheet, 1 event, 2 ends\n");
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_THAT(text_of(directory_ / "x.svg"), HasSubstr("</svg>"));
  EXPECT_THAT(texts("x.svg"), IsSupersetOf({"tilt", "ν₁", "unstable", "growth rate", "x.csv"}));
  EXPECT_THAT(plot("x.png", {"--quiet"}).out, IsEmpty());
  EXPECT_THAT(text_of(directory_ / "x.png").substr(0, 4), "\x89PNG");
  EXPECT_EQ(plot("x.pdf").code, 0);
  EXPECT_THAT(text_of(directory_ / "x.pdf").substr(0, 4), "%PDF");
  EXPECT_THAT(directory_.names(), ElementsAre("x.csv", "x.pdf", "x.png", "x.svg"));
}

TEST_F(Plot, TitleOfTheCaseOrAsAsked) {
  NEEDS_GNUPLOT();
  directory_.file("x.meta.json", R"({"case": {"title": "A <b> & {/*3 'c'} @x `y`"}})");
  EXPECT_EQ(plot("x.svg").code, 0);
  EXPECT_THAT(texts("x.svg"), Contains("A &lt;b> &amp; {/*3 'c'} @x `y`"));
  EXPECT_EQ(plot("x.svg", {"--title", "Mine"}).code, 0);
  EXPECT_THAT(texts("x.svg"), AllOf(Contains("Mine"), Not(Contains(HasSubstr("A &lt;")))));
  // Of another table, written beside it since: x.h5's, say.
  directory_.file("x.meta.json", R"({"case": {"title": "Another"}, "rows": 6})");
  EXPECT_EQ(plot("x.svg").code, 0);
  EXPECT_THAT(texts("x.svg"), AllOf(Contains("x.csv"), Not(Contains("Another"))));
  directory_.file("x.meta.json", R"({"case": {"title": "Its own"}, "rows": 5})");
  EXPECT_EQ(plot("x.svg").code, 0);
  EXPECT_THAT(texts("x.svg"), Contains("Its own"));
  directory_.file("x.meta.json", "no JSON");
  EXPECT_EQ(plot("x.svg").code, 0);
  EXPECT_THAT(texts("x.svg"), Contains("x.csv"));
}

TEST_F(Plot, HostileTextIsOnlyText) {
  NEEDS_GNUPLOT();
  // Of titles, columns, branches, sheets, events and file names, none is run or read as a command.
  const std::string hostile = "`touch gone` @x $(touch gone) '; system 'touch gone' #";
  const std::string quoted = "\"" + hostile + "\"";
  table_ = directory_.file("`touch gone`'.csv",
                           "branch,sheet,point,event,nu1,nu2,nu3,rho," + hostile + ".\n" + quoted +
                               ",1,0," + quoted + ",0,0,0,1,1\n" + quoted + "," + quoted +
                               ",0,,0,0,0,1,2\n" + quoted + "," + quoted + ",1,,0,0,0,1.5,3\n");
  RunOptions there;
  there.directory = directory_ / "";
  for (const char* output : {"x.svg", "x.png", "x.pdf"})
    EXPECT_EQ(run_program({"plot", table_, table_, "-o", directory_ / output, "--title", hostile,
                           "--script", directory_ / "x.gp"},
                          there)
                  .code,
              0);
  EXPECT_THAT(texts("x.svg"), Contains(HasSubstr("touch gone")));
  EXPECT_THAT(directory_.names(), Not(Contains("gone")));
}

TEST_F(Plot, ToStandardOutputWithItsScript) {
  NEEDS_GNUPLOT();
  const Outcome outcome = run_program({"plot", table_, "-o", "-", "--script", directory_ / "x.gp"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, ::testing::EndsWith("</svg>\n\n"));
  EXPECT_THAT(text_of(directory_ / "x.gp"), HasSubstr("set terminal svg"));
  EXPECT_THAT(run_program({"plot", table_, "-o", "-", "--format", "png"}).out.substr(0, 4),
              "\x89PNG");
  EXPECT_THAT(run_program({"plot", table_, "--script", "-", "--format", "pdf"}).out,
              HasSubstr("set terminal pdfcairo"));
  EXPECT_EQ(run_program({"plot", table_, "-o", "-", "--script", "-"}).code, 2);
  EXPECT_EQ(run_program({"plot", table_, "--script", table_}).code, 2);
  EXPECT_EQ(
      run_program({"plot", table_, "-o", directory_ / "y.svg", "--script", directory_ / "y.svg"})
          .code,
      2);
  EXPECT_EQ(text_of(table_), tilting_table);
}

TEST_F(Plot, ReplacesNoMetadataOfItsTable) {
  const std::string metadata = directory_.file("x.meta.json", "{}");
  for (const char* option : {"-o", "--script"}) {
    const Outcome outcome = run_program({"plot", table_, option, metadata, "--format", "svg"});
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_THAT(outcome.err, HasSubstr(std::string(option) + ' ' + metadata));
    EXPECT_THAT(outcome.err, HasSubstr("the metadata of the table"));
    const Outcome itself = run_program({"plot", table_, option, table_, "--format", "svg"});
    EXPECT_THAT(itself.err, HasSubstr(std::string(option) + ' ' + table_));
  }
  EXPECT_EQ(text_of(metadata), "{}");
}

/// What ends a CDATA section may stand in no text of XML.
TEST_F(Plot, ATitleLeavesTheImageWellFormed) {
  NEEDS_GNUPLOT();
  ASSERT_EQ(plot("x.svg", {"--title", "a]]>b & <c>"}).code, 0);
  EXPECT_THAT(text_of(directory_ / "x.svg"), Not(HasSubstr("]]>")));
  EXPECT_THAT(texts("x.svg"), Contains("a]]&gt;b &amp; &lt;c>"));
}

TEST_F(Plot, SaysWhatIsNoTableAndWhatIsOutOfRange) {
  NEEDS_GNUPLOT();
  const Outcome of_case = run_program({"plot", shipped("fold.toml"), "-o", directory_ / "x.svg"});
  EXPECT_EQ(of_case.code, 2);
  EXPECT_THAT(of_case.err, HasSubstr("found a case; expected tables of solve"));
  const Outcome nowhere = plot("y.svg", {"--range", "x=50:60"});
  EXPECT_EQ(nowhere.code, 0);
  EXPECT_THAT(nowhere.err, HasSubstr("no row is in the range of x asked for"));
}

TEST_F(Plot, ChoicesThatAreNone) {
  struct Choice {
    std::vector<std::string> options;
    const char* fragment;
  };
  const std::vector<Choice> choices{
      {{"--range", "z=0:1"}, "found the axis \"z\"; expected x=, y=, rate= or value="},
      {{"--range", "x=1:0"}, "expected LOW:HIGH"},
      {{"--range", "x=0:inf"}, "expected LOW:HIGH"},
      {{"--range", "x=-1e308:1e308"}, "between -4e307 and 4e307"},
      {{"--size", "800"}, "expected WIDTHxHEIGHT"},
      {{"--size", "8x6"}, "each from 300 to 4000"},
      {{"--sheet", "7"}, "--sheet 7: found no such sheet; expected one of \"1\""},
      {{"--branch", "ii"}, "--branch ii: found no such branch; expected one of \"i\""},
      {{"--show", "lamda"}, "did you mean \"lambda\"?"},
      {{"--show", "event"}, "found no such column of numbers"},
      {{"--diagram", "energy-momentum"}, "found not all of the columns pi1, pi2, pi3"},
      {{"--diagram", "phase"}, "phase not in"},
  };
  for (const Choice& choice : choices) {
    const Outcome outcome = plot("x.svg", choice.options);
    EXPECT_EQ(outcome.code, 2) << choice.fragment;
    EXPECT_THAT(outcome.err, HasSubstr(choice.fragment));
  }
  EXPECT_THAT(directory_.names(), ElementsAre("x.csv"));
}

TEST_F(Plot, AColumnSheetBranchRangeAndSize) {
  NEEDS_GNUPLOT();
  EXPECT_EQ(plot("x.svg", {"--show", "growth,mu", "--sheet", "1", "--branch", "i", "--range",
                           "x=0:0.5", "--range", "y=0:0.8", "--size", "640x480"})
                .code,
            0);
  EXPECT_THAT(texts("x.svg"), IsSupersetOf({"growth rate, μ", "growth rate"}));
  EXPECT_THAT(text_of(directory_ / "x.svg"), AllOf(HasSubstr("width=\"640\" height=\"480\""),
                                                   HasSubstr("viewBox=\"0 0 640 480\"")));
}

TEST_F(Plot, NamesOfFilesAreNotRead) {
  NEEDS_GNUPLOT();
  EXPECT_EQ(plot("| sh 'x' `y` $(z)\n.svg").code, 0);
  EXPECT_THAT(directory_.names(), ElementsAre("x.csv", "| sh 'x' `y` $(z)\n.svg"));
}

TEST_F(Plot, DrawsWhatSolveWrites) {
  NEEDS_GNUPLOT();
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
      {"curve,special,point,event,a,b,c\n1,,1,,0,1,2\n",
       "found none of the columns lambda, mu, rho"},
      {"branch,nu1,rho\nii,0,1\n",
       "x.csv: found no column \"nu2\", the parameter of branch \"ii\""},
      {"branch,nu1,rho\ntwo-polar,0,1\n", "found no column \"omega\""},
      {"nu1,nu2,rho\n0,0,1\n", "found no column \"nu3\", the parameter of its rows"},
      {"study_row,motion.nu,status,message,branch,nu1,rho\n1,0,solved,,i,0,1\n",
       "x.csv: found a table of study; expected tables of solve,"},
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

/// It can be read once: no metadata stand beside it.
TEST_F(Plot, ReadsAPipe) {
  NEEDS_GNUPLOT();
  const Outcome outcome = run_program(
      {"plot", "/dev/stdin", "-o", directory_ / "x.svg"},
      {.program = {"sh", "-c", "cat '" + table_ + "' | \"$0\" \"$@\"", program_path()}});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("5 rows, 1 sheet, 1 event, 2 ends"));
}

TEST_F(Plot, CurvesBesideAFamilyAndRangesOfNothing) {
  const std::string curve = directory_.file("c.csv",
                                            "event,curve,point,special,branch,nu,body.J.1,nu1,rho\n"
                                            "tilt,1,0,,i,1,2,1,1\ntilt,1,1,,i,1.1,2.1,1.1,1\n");
  for (const bool first : {true, false}) {
    const Outcome outcome = run_program(
        {"plot", first ? table_ : curve, first ? curve : table_, "-o", directory_ / "x.svg"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("expected"));
  }
  EXPECT_THAT(run_program({"plot", table_, curve, "-o", directory_ / "x.svg"}).err,
              HasSubstr("c.csv: found curves of events beside a family"));
  const Outcome outcome = plot("x.svg", {"--range", "value=0:1"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("found a range of value; expected a map"));
  const Outcome shown = run_program({"plot", curve, "--show", "nu1", "-o", directory_ / "x.svg"});
  EXPECT_EQ(shown.code, 2);
  EXPECT_THAT(shown.err, HasSubstr("found curves of events; expected no columns to show"));
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

/// gnuplot itself does not look whether the disk takes what it draws.
TEST_F(Plot, WhatTheDiskDoesNotTakeLeavesTheOldImage) {
  NEEDS_GNUPLOT();
  ASSERT_EQ(plot("x.svg").code, 0);
  const std::string whole = text_of(directory_ / "x.svg");
  directory_.file("x.svg", "old");
  const Outcome outcome = run_program({"plot", table_, "-o", directory_ / "x.svg"},
                                      {.file_size_limit = static_cast<long>(whole.size()) - 1});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("File too large"));
  EXPECT_EQ(text_of(directory_ / "x.svg"), "old");
  EXPECT_THAT(directory_.names(), ElementsAre("x.csv", "x.svg"));
}

TEST_F(Plot, InterruptedWritesNothing) {
  const Outcome outcome =
      run_program({"plot", table_, "-o", directory_ / "x.svg"}, {.pending_signal = SIGINT});
  EXPECT_EQ(outcome.code, 130);
  EXPECT_THAT(directory_.names(), ElementsAre("x.csv"));
}

}  // namespace
}  // namespace stationary::testing
