// Where a line changes its class: at the rows of events, and half-way between two other rows.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <sstream>

#include "solver/program/diagram/diagram_lines.hpp"
#include "solver/program/plot/plot.hpp"

namespace stationary {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A row a class, at the parameters 0, 1, ..., λ being the parameter.
Diagram diagram_of(const std::vector<std::string>& classes) {
  std::string csv = "branch,nu1,lambda,class\n";
  for (std::size_t k = 0; k < classes.size(); ++k) {
    const std::string at = std::to_string(k);
    csv += "i," + at + "," + at + "," + classes[k] + "\n";
  }
  TableReader table(std::make_unique<std::istringstream>(csv), "x.csv");
  return read_diagram({&table});
}

std::vector<DiagramLine> lines_of(const Diagram& diagram) {
  return class_lines(diagram, diagram.pieces.front(), {{0.0, 10.0}});
}

/// From where to where a class is drawn, stroke by stroke, of the parameter.
using Reaches = std::vector<std::pair<double, double>>;
Reaches reaches(const Diagram& diagram, std::optional<StabilityClass> verdict) {
  Reaches out;
  const DiagramPicture picture = diagram_picture(diagram);
  const DiagramPanel& panel = picture.panels.front();
  const auto at = [&](const PagePoint& p) {
    const double parameter = panel.abscissa.value(p.x / panel.area.width());
    return std::round(1e6 * parameter) / 1e6;
  };
  for (const PictureCurve& curve : panel.curves)
    if (curve.verdict == verdict)
      for (const Stroke& stroke : curve.strokes)
        out.emplace_back(at(stroke.front()), at(stroke.back()));
  return out;
}

/// Rows are left out where they fall into one column of the image, which on a logarithmic axis are a factor wide.
TEST(ClassLines, KeepWhatALogarithmicAxisShows) {
  std::string csv = "branch,nu1,lambda,class\n";
  for (int k = 0; k < 1000; ++k)
    csv += fmt::format("i,{},{},stable\n", std::pow(10.0, 0.012 * k - 6.0), k);
  TableReader table(std::make_unique<std::istringstream>(csv), "x.csv");
  const Diagram diagram = read_diagram({&table});
  const auto kept = [&](const Axis& axis) {
    return class_lines(diagram, diagram.pieces.front(), axis).front().points.size();
  };
  EXPECT_EQ(kept({{1e-6, 1e6}, true}), 1000U);
  EXPECT_LT(kept({{1e-6, 1e6}, false}), 500U);
}

/// Of an asked range no event is drawn that is outside it; elsewhere one stands on the edge by which its curve left.
TEST(ClassLines, EventsOutsideAnAskedRangeAreNotDrawn) {
  std::string csv = "branch,event,nu1,lambda,class\n";
  for (int k = 0; k <= 10; ++k)
    csv += fmt::format("i,{},{},{},stable\n", k == 5 ? "tilt" : "", k, k);
  TableReader table(std::make_unique<std::istringstream>(csv), "x.csv");
  const Diagram diagram = read_diagram({&table});
  const auto marks = [&](std::optional<AxisRange> y) {
    PageChoice choice;
    choice.y = y;
    return diagram_picture(diagram, choice).panels.front().marks.size();
  };
  EXPECT_EQ(marks(std::nullopt), 1U);
  EXPECT_EQ(marks(AxisRange{4.0, 6.0}), 1U);
  EXPECT_EQ(marks(AxisRange{0.0, 4.0}), 0U);
}

/// Rest, where |pi| = 0, leaves a logarithmic axis to the decades of the others.
TEST(ClassLines, RestForbidsNoLogarithmicMomentum) {
  std::string csv = "branch,nu1,pi1,pi2,pi3,energy,class\n";
  for (int k = 0; k <= 40; ++k)
    csv += fmt::format("i,{},{},0,0,{},stable\n", k, k == 0 ? 0.0 : std::pow(10.0, 0.2 * k), k + 1);
  TableReader table(std::make_unique<std::istringstream>(csv), "x.csv");
  DiagramChoice choice;
  choice.energy_momentum = true;
  const Diagram diagram = read_diagram({&table}, choice);
  EXPECT_TRUE(diagram_picture(diagram).panels.front().abscissa.logarithmic);
}

TEST(ClassLines, ChangeHalfwayBetweenTwoRows) {
  const Diagram diagram = diagram_of({"elliptic", "stable", "stable", "stable", "elliptic"});
  const auto lines = lines_of(diagram);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_THAT(lines[1].points, ElementsAre(1, 2, 3));
  EXPECT_EQ(lines[1].before, 0U);
  EXPECT_EQ(lines[1].after, 4U);
  EXPECT_EQ(reaches(diagram, StabilityClass::stable), (Reaches{{0.5, 3.5}}));
  EXPECT_EQ(reaches(diagram, StabilityClass::elliptic), (Reaches{{0.0, 0.5}, {3.5, 4.0}}));
}

TEST(ClassLines, OneRowHasItsHalves) {
  const Diagram diagram = diagram_of({"elliptic", "elliptic", "stable", "", "elliptic"});
  EXPECT_EQ(reaches(diagram, StabilityClass::stable), (Reaches{{1.5, 2.5}}));
  EXPECT_EQ(reaches(diagram, std::nullopt), (Reaches{{2.5, 3.5}}));
  EXPECT_TRUE(diagram_picture(diagram).panels.front().dots.empty());
}

TEST(ClassLines, ARowWithoutAClassIsNamedInTheLegend) {
  const auto script = [](const Diagram& diagram) {
    return gnuplot_script(diagram, ImageFormat::svg, "");
  };
  EXPECT_THAT(script(diagram_of({"", "", ""})), HasSubstr("title 'no class'"));
  EXPECT_THAT(script(diagram_of({"stable", "stable"})), Not(HasSubstr("title 'no class'")));
  EXPECT_THAT(script(diagram_of({"stable", "stable", "", "unstable"})),
              AllOf(HasSubstr("title 'stable'"), HasSubstr("title 'no class'"),
                    HasSubstr("title 'unstable'")));
}

}  // namespace
}  // namespace stationary
