// The pictures of every shipped table: curves fill their panels, nothing lies on something else, an
// arrow stands where a curve leaves.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "solver/program/plot/diagram_picture.hpp"
#include "solver/program/plot/map_plot.hpp"
#include "solver/program/plot/page_layout.hpp"
#include "solver/program/plot/plot_style.hpp"

namespace stationary {
namespace {

/// Every table of a family in results/.
std::vector<std::string> tables() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(STATIONARY_RESULTS)) {
    const std::filesystem::path& path = entry.path();
    std::filesystem::path figure = path;
    if (path.extension() != ".csv" || !std::filesystem::exists(figure.replace_extension(".svg")))
      continue;
    TableReader table(path.string());
    if (table.column("lambda") && table.column("point") && table.next() && table.next())
      out.push_back(path.string());
  }
  std::ranges::sort(out);
  return out;
}

Diagram diagram_at(const std::string& path, const DiagramChoice& choice = {}) {
  TableReader table(path);
  return read_diagram({&table}, choice);
}

struct Spans {
  double low_x = 1e300;
  double high_x = -1e300;
  double low_y = 1e300;
  double high_y = -1e300;
  void add(const PagePoint& p) {
    low_x = std::min(low_x, p.x);
    high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y);
    high_y = std::max(high_y, p.y);
  }
};

class ShippedPicture : public ::testing::TestWithParam<std::string> {};

constexpr double share = 0.4;

TEST_P(ShippedPicture, CurvesFillTheirPanels) {
  const DiagramPicture picture = diagram_picture(diagram_at(GetParam()));
  for (const DiagramPanel& panel : picture.panels) {
    Spans all;
    for (const PictureCurve& curve : panel.curves)
      for (const Stroke& stroke : curve.strokes)
        for (const PagePoint& p : stroke) all.add(p);
    EXPECT_GE(all.high_x - all.low_x, share * panel.area.width());
    EXPECT_GE(all.high_y - all.low_y, share * panel.area.height());
    Spans rates;
    for (const PictureRates& each : panel.rates)
      for (const Stroke& stroke : each.strokes)
        for (const PagePoint& p : stroke) rates.add(p);
    if (panel.rates.empty()) continue;
    EXPECT_GE(rates.high_x - rates.low_x, share * panel.rate_area.width());
    EXPECT_GE(rates.high_y - rates.low_y, share * panel.rate_area.height());
  }
}

TEST_P(ShippedPicture, OfOneSheetEachCurveSpansItsPanel) {
  const Diagram diagram = diagram_at(GetParam());
  if (diagram.pieces.size() > 1) GTEST_SKIP() << "an atlas: its sheets share panels";
  const DiagramPicture picture = diagram_picture(diagram);
  const DiagramPanel& panel = picture.panels.front();
  for (std::size_t series = 0; series < picture.series.size(); ++series) {
    Spans own;
    for (const PictureCurve& curve : panel.curves)
      for (const Stroke& stroke : curve.strokes)
        if (curve.series == series)
          for (const PagePoint& p : stroke) own.add(p);
    EXPECT_TRUE(own.high_x - own.low_x >= share * panel.area.width() ||
                own.high_y - own.low_y >= share * panel.area.height())
        << picture.series[series];
  }
}

TEST_P(ShippedPicture, SheetsAreNumberedAndNoNumberLiesOnAnother) {
  const Diagram diagram = diagram_at(GetParam());
  const DiagramPicture picture = diagram_picture(diagram);
  std::size_t labels = 0;
  for (const DiagramPanel& panel : picture.panels) {
    labels += panel.labels.size();
    for (std::size_t a = 0; a < panel.labels.size(); ++a) {
      const PictureLabel& one = panel.labels[a];
      EXPECT_GE(one.at.x, 0.0);
      EXPECT_LE(one.at.x, panel.area.width());
      for (std::size_t b = 0; b < a; ++b) {
        const PictureLabel& other = panel.labels[b];
        EXPECT_TRUE(std::abs(one.at.x - other.at.x) >= 0.5 * (one.size.width + other.size.width) ||
                    std::abs(one.at.y - other.at.y) >= 0.5 * (one.size.height + other.size.height))
            << one.text << " on " << other.text;
      }
    }
  }
  EXPECT_EQ(labels, diagram.pieces.size() > 1 ? diagram.pieces.size() : 0);
}

TEST_P(ShippedPicture, AnArrowStandsWhereACurveLeaves) {
  const Diagram diagram = diagram_at(GetParam());
  const DiagramPicture picture = diagram_picture(diagram);
  constexpr double near = 10.0;
  for (const DiagramPanel& panel : picture.panels) {
    const auto arrow_at = [&](double x, PanelSide side) {
      return std::ranges::any_of(panel.arrows, [&](const PictureArrow& arrow) {
        return arrow.exit.side == side && std::abs(arrow.exit.place - x) < near;
      });
    };
    for (const DiagramPiece& piece : diagram.pieces) {
      if (diagram.branches[piece.branch].parameter != panel.abscissa_name ||
          picture.panels.size() != 1)
        continue;
      for (std::size_t row = piece.begin + 1; row < piece.end; ++row) {
        for (std::size_t k = 0; k < diagram.columns.size(); ++k) {
          const auto place = [&](std::size_t at) {
            return panel.ordinate.place(diagram.points[at].ordinate[k] - panel.base);
          };
          const double x = panel.abscissa.place(diagram.points[row].abscissa) * panel.area.width();
          const double before =
              panel.abscissa.place(diagram.points[row - 1].abscissa) * panel.area.width();
          if (std::abs(x - before) > 1.0) continue;  // where within the step is not known
          if (place(row - 1) < 1.0 && place(row) > 1.0) {
            EXPECT_TRUE(arrow_at(x, PanelSide::top)) << "row " << row;
          }
          if (place(row - 1) > 0.0 && place(row) < 0.0) {
            EXPECT_TRUE(arrow_at(x, PanelSide::bottom)) << "row " << row;
          }
        }
      }
    }
    for (const PictureCurve& curve : panel.curves)
      for (const Stroke& stroke : curve.strokes)
        for (const PagePoint& p : stroke) {
          ASSERT_GE(p.y, -1e-6);
          ASSERT_LE(p.y, panel.area.height() + 1e-6);
        }
  }
}

TEST_P(ShippedPicture, NothingIsOutsideThePage) {
  const DiagramPicture picture = diagram_picture(diagram_at(GetParam()));
  double below = picture.size.height;
  for (const DiagramPanel& panel : picture.panels) {
    EXPECT_LT(panel.area.right, picture.legend_left);
    EXPECT_LT(panel.area.top, below);
    EXPECT_GT(panel.area.bottom, 0.0);
    EXPECT_GT(panel.area.height(), 100.0);
    below = panel.area.bottom;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedPicture, ::testing::ValuesIn(tables()), [](const auto& param) {
  return std::filesystem::path(param.param).stem().string();
});

TEST(ShippedPictures, SomeCurveLeavesItsPanel) {
  ASSERT_GE(tables().size(), 20U);
  EXPECT_FALSE(
      diagram_picture(diagram_at(STATIONARY_RESULTS "/fold.csv")).panels.front().arrows.empty());
}

TEST(Picture, AskedRangesAndSizeHold) {
  PageChoice choice;
  choice.size = PageSize{640.0, 480.0};
  choice.x = AxisRange{0.0, 0.5};
  choice.y = AxisRange{0.5, 2.0};
  const DiagramPicture picture =
      diagram_picture(diagram_at(STATIONARY_RESULTS "/fold.csv"), choice);
  EXPECT_EQ(picture.size.width, 640.0);
  EXPECT_EQ(picture.panels.front().ordinate.range.high, 2.0);
  EXPECT_EQ(picture.panels.front().abscissa.range.high, 0.5);
}

TEST_P(ShippedPicture, IsLargerThanItsLeastPage) {
  const Diagram diagram = diagram_at(GetParam());
  const PageSize least = least_page(diagram);
  PageChoice choice;
  choice.size = least;
  const DiagramPicture smallest = diagram_picture(diagram, choice);
  for (const DiagramPanel& panel : smallest.panels) {
    EXPECT_GE(panel.area.width(), 150.0);
    EXPECT_GE(panel.area.height(), 95.0);
    if (has_rates(diagram)) {
      EXPECT_GE(panel.rate_area.height(), 70.0);
    }
  }
  const double legend = page::legend_line * static_cast<double>(most_legend_lines(diagram));
  EXPECT_GE(smallest.panels.front().area.top + 6.0, legend);
  const PageSize usual = diagram_picture(diagram).size;
  EXPECT_GE(usual.width, least.width);
  EXPECT_GE(usual.height, least.height);
}

/// What the legend names is taken from the panels.
TEST(Picture, HoldsNoKindOfCurveThatIsOutOfView) {
  const Diagram diagram = diagram_at(STATIONARY_RESULTS "/fold.csv");
  PageChoice choice;
  choice.rate = AxisRange{3.0, 4.0};
  const DiagramPicture picture = diagram_picture(diagram, choice);
  const std::vector<PictureRates>& rates = picture.panels.front().rates;
  ASSERT_EQ(rates.size(), 1U);
  EXPECT_EQ(rates.front().kind, RateKind::positive);
}

TEST(Picture, CurvesOnOneAnotherAreToldApartByWidth) {
  // On a circle lambda is mu.
  const DiagramPicture picture = diagram_picture(diagram_at(STATIONARY_RESULTS "/circle.csv"));
  int wider = 0;
  for (const PictureCurve& curve : picture.panels.front().curves) {
    EXPECT_EQ(curve.lower > 0, curve.series == 0) << curve.series;
    if (curve.lower > 0) ++wider;
  }
  EXPECT_GT(wider, 0);
}

/// Of 100.
double grey(std::string_view colour) {
  const auto part = [&](std::size_t from) {
    return std::stoi(std::string(colour.substr(from, 2)), nullptr, 16);
  };
  return (0.299 * part(1) + 0.587 * part(3) + 0.114 * part(5)) / 2.55;
}

TEST(Picture, ClassesOfMapsDifferInGrey) {
  for (std::size_t a = 0; a < class_colours.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_GE(std::abs(grey(class_colours[a]) - grey(class_colours[b])), 15.0) << a << ' ' << b;
}

TEST(Picture, StretchesDifferInGrey) {
  for (std::size_t a = 0; a < most_ordinates; ++a)
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_GE(std::abs(grey(series_colours[a]) - grey(series_colours[b])), 15.0) << a << ' ' << b;
}

TEST(Picture, EverySymbolIsAnotherEvents) {
  for (const EventStyle& a : event_styles)
    for (const EventStyle& b : event_styles)
      EXPECT_TRUE(&a == &b || a.point_type != b.point_type) << a.name << ' ' << b.name;
}

}  // namespace
}  // namespace stationary
