// Where everything of a diagram is on its page: panels, axes, curves cut and dashed, marks of
// events, numbers of sheets, arrows where a curve leaves.
//
// One branch: the curves above, the rates below. Several: a row of panels each, the curves on the
// left and the rates on the right. Energy against momentum: all branches in one panel, told apart by
// colour.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "solver/program/diagram/axis.hpp"
#include "solver/program/diagram/diagram.hpp"
#include "solver/program/diagram/rate_tracks.hpp"
#include "solver/program/plot/plot_page.hpp"
#include "solver/program/plot/sheet_labels.hpp"
#include "solver/program/plot/strokes.hpp"

namespace stationary {

/// Curves drawn alike; places are within the panel.
struct PictureCurve {
  std::size_t series;
  std::optional<StabilityClass> verdict;
  int lower = 0;  ///< how many curves lie on these
  std::vector<Stroke> strokes;
};

struct PictureRates {
  RateKind kind;
  std::vector<Stroke> strokes;
  std::vector<PagePoint> dots;
};

struct PictureDot {
  std::size_t series;
  std::optional<StabilityClass> verdict;
  PagePoint at;
};

struct PictureMark {
  std::string event;
  PagePoint at;
};

/// series: of a curve, or RateKind of a rate.
struct PictureArrow {
  CurveExit exit;
  std::size_t series;
};

struct DiagramPanel {
  std::string title;
  std::string abscissa_name;
  PageArea area;
  PageArea rate_area;
  Axis abscissa;
  Axis ordinate;  ///< less base
  /// What all values all but share: they are drawn less it, for ticks that can be read.
  double base = 0.0;
  double abscissa_base = 0.0;  ///< likewise; the axis is not less it
  Axis rate;
  std::vector<PictureCurve> curves;
  std::vector<PictureRates> rates;
  std::vector<PictureDot> dots;
  std::vector<PictureMark> marks;
  std::vector<PictureArrow> arrows;
  std::vector<PictureArrow> rate_arrows;
  std::vector<double> guides;  ///< places of events, from the left
  std::vector<PictureLabel> labels;
};

struct DiagramPicture {
  PageSize size;
  double legend_left;
  std::vector<std::string> series;  ///< names in the legend
  std::vector<DiagramPanel> panels;
};

/// Whether its panels have one of the rates beside them.
bool has_rates(const Diagram& diagram);

DiagramPicture diagram_picture(const Diagram& diagram, const PageChoice& choice = {});

}  // namespace stationary
