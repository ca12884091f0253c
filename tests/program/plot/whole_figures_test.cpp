// Whole figures by the program: of tables at the ends of the double range, of many tables, on small pages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/program/needs_gnuplot.hpp"
#include "tests/program/program.hpp"

namespace stationary::testing {
namespace {

using ::testing::HasSubstr;

class WholeFigure : public ::testing::Test {
 protected:
  Outcome plot(const std::string& text, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"plot", directory_.file("x.csv", text), "-o",
                                       directory_ / "x.svg"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }

  TemporaryDirectory directory_;
};

TEST_F(WholeFigure, OfValuesAtTheEndsOfTheDoubles) {
  NEEDS_GNUPLOT();
  for (const std::string value : {"1e300", "1.7e308", "-1.7e308", "1e-320", "5e-324", "0"}) {
    const Outcome outcome = plot(
        "branch,nu1,lambda,mu,rho,class,growth,im1\ni,0.1,1,1,1,stable,0,1\n"
        "i,0.2,2,1,1.7e308,stable,0," +
        value + "\ni,0.3," + value + ",1,1,unstable," + value + ",0\n");
    EXPECT_EQ(outcome.code, 0) << value << outcome.err;
    const Outcome map = plot("xi,status,nu,body.J.0\n" + value + ",solved,0," + "4e307\n" +
                             "1.7e308,solved,0.5,4e307\n1,solved,0,1\n1,solved,0.5,1\n");
    EXPECT_EQ(map.code, 0) << value << map.err;
  }
}

/// The palette begins at no growth, also where that is all there is.
TEST_F(WholeFigure, AMapWithoutGrowthHasTheColourOfNone) {
  NEEDS_GNUPLOT();
  for (const std::string growth : {"0", "0.5"}) {
    const Outcome outcome =
        plot("xi,class,growth,status,nu,body.J.0\n1,stable,0,solved,0,1\n1,stable," + growth +
                 ",solved,0.5,1\n1,stable,0,solved,0,2\n1,stable,0,solved,0.5,2\n",
             {"--show", "growth", "--script", directory_ / "x.gp"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(text_of(directory_ / "x.gp"), HasSubstr("set cbrange [0:")) << growth;
  }
}

/// Three branches, each with a spectrum.
const char* const three_branches =
    "branch,sheet,nu1,nu2,nu3,rho,lambda,mu,class,growth,im1\n"
    "i,1,0,0,0,1,1.1,0.9,stable,0,1\ni,1,1,0,0,1,1.2,0.9,stable,0,1\n"
    "ii,2,0,0,0,1,1.1,0.9,stable,0,1\nii,2,0,1,0,1,1.2,0.9,stable,0,1\n"
    "iii,3,0,0,0,1,1.1,0.9,stable,0,1\niii,3,0,0,1,1,1.2,0.9,stable,0,1\n";

TEST_F(WholeFigure, ASizeTooSmallToReadIsRefusedWithTheLeast) {
  NEEDS_GNUPLOT();
  const Outcome small = plot(three_branches, {"--size", "640x480"});
  EXPECT_EQ(small.code, 2);
  EXPECT_THAT(small.err, HasSubstr("--size 640x480: found too small a page"));
  const std::string expected = "expected at least ";
  const std::size_t at = small.err.find(expected);
  ASSERT_NE(at, std::string::npos);
  const std::string least =
      small.err.substr(at + expected.size(), small.err.find('\n', at) - at - expected.size());
  const Outcome enough = plot(three_branches, {"--size", least});
  EXPECT_EQ(enough.code, 0) << least << enough.err;
  const std::string map =
      "class,status,nu,body.J.0\nstable,solved,0,1\n,not-found,0.5,1\n"
      "stable,solved,0,2\nunstable,solved,0.5,2\n";
  EXPECT_THAT(plot(map, {"--size", "300x300"}).err, HasSubstr("expected at least 408x300"));
  EXPECT_EQ(plot(map, {"--size", "408x300"}).code, 0);
}

TEST_F(WholeFigure, OptionsWithoutAnEffectAreRefused) {
  const std::string family = "branch,nu1,rho,energy,pi1,pi2,pi3\ni,0,1,1,0,0,0\ni,1,1,2,1,0,0\n";
  const Outcome shown = plot(family, {"--diagram", "energy-momentum", "--show", "rho,nu1"});
  EXPECT_EQ(shown.code, 2);
  EXPECT_THAT(shown.err, HasSubstr("--show rho,nu1: found columns beside --diagram"));
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"--range", "rate=0:1"}, {"--range", "rate=0:1", "--diagram", "energy-momentum"}}) {
    const Outcome rates = plot(family, more);
    EXPECT_EQ(rates.code, 2);
    EXPECT_THAT(rates.err, HasSubstr("found a range of rate; expected a diagram with frequencies"));
  }
  const Outcome map = plot(
      "class,status,nu,body.J.0\nstable,solved,0,1\nstable,solved,0.5,1\n"
      "stable,solved,0,2\nunstable,solved,0.5,2\n",
      {"--range", "value=0:1"});
  EXPECT_EQ(map.code, 2);
  EXPECT_THAT(map.err, HasSubstr("found a range of value; expected a map of numbers"));
}

TEST_F(WholeFigure, CurvesOfAnotherBodyThanTheMapsAreToldOf) {
  NEEDS_GNUPLOT();
  const auto metadata = [](const std::string& j, const std::string& mu) {
    return R"({"case": {"body": {"J": [1, )" + j + R"(, 0.6]}, "potential": {"plane": {"mu": )" +
           mu + "}}}}";
  };
  const std::string curve = directory_.file("c.csv",
                                            "event,curve,point,special,branch,nu,body.J.1,nu1,rho\n"
                                            "tilt,1,0,,i,0,1,0,1\ntilt,1,1,,i,0.5,2,0.5,1\n");
  const std::string map =
      "class,status,nu,body.J.1\nstable,solved,0,1\nstable,solved,0.5,1\n"
      "stable,solved,0,3\nunstable,solved,0.5,3\n";
  const auto drawn = [&] {
    const Outcome outcome = plot(map, {curve, "--script", directory_ / "x.gp"});
    EXPECT_EQ(outcome.code, 0);
    return outcome.err;
  };
  EXPECT_EQ(drawn(), "");
  EXPECT_THAT(text_of(directory_ / "x.gp"), HasSubstr("set yrange [0:4]"));
  directory_.file("x.meta.json", metadata("2", "1"));
  EXPECT_EQ(drawn(), "") << "of the curve nothing is known";
  directory_.file("c.meta.json", metadata("1.5", "1"));
  EXPECT_EQ(drawn(), "") << "the body's J.1 is an axis";
  directory_.file("c.meta.json", metadata("2", "1.5"));
  EXPECT_THAT(drawn(), HasSubstr("c.csv: its curves are of another body than the map's"));
  // A million arrays in one another: what compares such trees runs out of stack.
  const std::string opening(1'000'000, '[');
  const std::string closing(opening.size(), ']');
  for (const char* const name : {"x.meta.json", "c.meta.json"})
    directory_.file(name, R"({"case": {"body": )" + opening + closing + "}}");
  EXPECT_EQ(drawn(), "") << "nothing is known";
}

TEST_F(WholeFigure, TheLegendNamesEveryTable) {
  NEEDS_GNUPLOT();
  std::vector<std::string> arguments{"plot"};
  constexpr int count = 60;
  for (int k = 0; k < count; ++k) {
    const std::string name = "t" + std::to_string(k) + ".csv";
    arguments.push_back(
        directory_.file(name, "branch,nu1,rho,class\ni,0,1,stable\ni,1,2,stable\n"));
  }
  arguments.insert(arguments.end(), {"-o", directory_ / "x.svg"});
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string image = text_of(directory_ / "x.svg");
  for (const char* const entry : {">a  t0<", ">z  t25<", ">aa  t26<", ">az  t51<", ">bh  t59<"})
    EXPECT_THAT(image, HasSubstr(entry));
  arguments.insert(arguments.end(), {"--size", "800x600"});
  EXPECT_THAT(run_program(arguments).err, HasSubstr("expected at least"));
}

/// gnuplot makes no image of one row of cells, or one column, nor says so.
TEST_F(WholeFigure, MapsOfOneRowOrColumnHaveTheirCells) {
  NEEDS_GNUPLOT();
  const std::string row =
      "xi,class,status,nu,body.J.0\n1,stable,solved,0,1\n1,unstable,solved,0.5,1\n";
  const std::string column =
      "xi,class,status,nu,body.J.0\n1,stable,solved,0,1\n2,unstable,solved,0,2\n";
  for (const std::string& cells : {row, column})
    for (const char* const quantity : {"class", "xi"}) {
      const Outcome outcome = plot(cells, {"--show", quantity});
      EXPECT_EQ(outcome.code, 0) << outcome.err;
      EXPECT_THAT(text_of(directory_ / "x.svg"), HasSubstr("<image"));
    }
}

/// Over a range of 1e-7 neither ticks nor cells all are one.
TEST_F(WholeFigure, NarrowRangesAreDrawnLessWhatTheyShare) {
  NEEDS_GNUPLOT();
  const auto script = [&](const std::string& text, std::vector<std::string> more) {
    more.insert(more.end(), {"--script", directory_ / "x.gp"});
    const Outcome outcome = plot(text, more);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return text_of(directory_ / "x.gp");
  };
  const std::string map = script(
      "energy,status,nu,body.J.0\n2.2690001,solved,0.3,1.7\n2.2690002,solved,0.3000001,1.7\n"
      "2.2690003,solved,0.3,1.7000001\n2.2690004,solved,0.3000001,1.7000001\n",
      {"--show", "energy"});
  for (const char* const part : {"less 0.3'", "less 1.7'", "less 2.269'"})
    EXPECT_THAT(map, HasSubstr(part));
  EXPECT_THAT(map, HasSubstr("1e-07 2e-07 \n3e-07 4e-07"));
  const std::string family =
      script("branch,nu1,lambda\ni,0.3,1\ni,0.30000001,1.25\ni,0.3000001,2\n", {});
  EXPECT_THAT(family, HasSubstr("less 0.3'"));
  EXPECT_THAT(family, HasSubstr("e-09 1.25\n"));
}

TEST_F(WholeFigure, AnAskedRangeOfColoursIsTheRange) {
  NEEDS_GNUPLOT();
  const Outcome outcome = plot(
      "rho,status,nu,body.J.0\n0.5,solved,0,1\n0.5,solved,0.5,1\n0.5,solved,0,2\n"
      "0.5,solved,0.5,2\n",
      {"--show", "rho", "--range", "value=0.4:0.6", "--script", directory_ / "x.gp"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(text_of(directory_ / "x.gp"), HasSubstr("set cbrange [0.4:0.6]"));
}

/// What a table is and what it is drawn against do not hang on columns that another tool adds or moves.
TEST_F(WholeFigure, OtherPeoplesColumnsChangeNothing) {
  NEEDS_GNUPLOT();
  for (const std::string family : {"branch,nu1,lambda,body.J.1\ni,0.5,1,1\ni,0.5,2,1.5\n",
                                   "branch,nu1,lambda,body.J.1,note\ni,0.5,1,1,a\ni,0.5,2,1.5,b\n",
                                   "body.J.1,branch,nu1,lambda\n1,i,0.5,1\n1.5,i,0.5,2\n"}) {
    EXPECT_EQ(plot(family, {"--script", directory_ / "x.gp"}).code, 0);
    EXPECT_THAT(text_of(directory_ / "x.gp"), HasSubstr("\n1 1\n1.5 2\n")) << family;
  }
  for (const std::string map :
       {"note,body.J.0,nu,xi,class,status\na,1,0,1,stable,solved\na,1,0.5,1,stable,solved\n"
        "a,2,0,1,stable,solved\na,2,0.5,1,stable,solved\n",
        "xi,class,status,body.J.0,nu,note\n1,stable,solved,1,0,a\n1,stable,solved,1,0.5,a\n"
        "1,stable,solved,2,0,a\n1,stable,solved,2,0.5,a\n"}) {
    const Outcome outcome = plot(map);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("2 by 2 cells")) << map;
  }
  const Outcome curve =
      plot("id,event,curve,nu,body.J.1\n1,tilt,1,0.1,1\n2,tilt,1,0.2,1.5\n3,tilt,1,0.3,2\n");
  EXPECT_EQ(curve.code, 0) << curve.err;
  EXPECT_THAT(curve.out, HasSubstr("curve"));
}

}  // namespace
}  // namespace stationary::testing
