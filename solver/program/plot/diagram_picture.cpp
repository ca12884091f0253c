#include "solver/program/plot/diagram_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lib/number/elementary.hpp"
#include "solver/program/diagram/diagram_lines.hpp"
#include "solver/program/plot/diagram_names.hpp"
#include "solver/program/plot/page_layout.hpp"
#include "solver/program/plot/plot_style.hpp"
#include "solver/program/plot/sheet_labels.hpp"

namespace stationary {
namespace {

PanelSize size_of(const PageArea& area) { return {area.width(), area.height()}; }

/// How much of the parameter's way each row of a piece stands for.
std::vector<double> ways(const Diagram& diagram, const DiagramPiece& piece) {
  std::vector<double> out(piece.end - piece.begin, 0.0);
  for (std::size_t k = piece.begin; k + 1 < piece.end; ++k) {
    const double way = std::abs(diagram.points[k + 1].parameter - diagram.points[k].parameter);
    if (!std::isfinite(way)) continue;
    out[k - piece.begin] += 0.5 * way;
    out[k + 1 - piece.begin] += 0.5 * way;
  }
  return out;
}

template <class Value>
WeightedCurve weighted(const Diagram& diagram, const DiagramPiece& piece, const Value& value) {
  const std::vector<double> way = ways(diagram, piece);
  WeightedCurve out;
  for (std::size_t k = piece.begin; k < piece.end; ++k)
    out.push_back({value(diagram.points[k]), way[k - piece.begin]});
  return out;
}

/// A point of a line, and how many curves lie on it there.
struct LinePoint {
  PagePoint at;
  int lower;
};

bool within(const PagePoint& p, const PanelSize& panel) {
  return p.x >= 0.0 && p.x <= panel.width && p.y >= 0.0 && p.y <= panel.height;
}

/// Draws one panel's pieces.
class PanelDrawing {
 public:
  PanelDrawing(const Diagram& diagram, std::vector<std::size_t> pieces, const PageChoice& choice,
               DiagramPanel& panel)
      : diagram_(diagram), pieces_(std::move(pieces)), panel_(panel) {
    choose_axes(choice);
  }

  void draw() {
    for (const std::size_t at : pieces_) {
      draw_curves(diagram_.pieces[at]);
      if (has_rates(diagram_)) draw_rates(diagram_.pieces[at]);
    }
    std::ranges::sort(panel_.curves, {}, [](const PictureCurve& c) {
      return std::pair{-c.lower, c.series};
    });
    std::ranges::sort(panel_.rates, {}, &PictureRates::kind);
    thin_arrows(panel_.arrows);
    thin_arrows(panel_.rate_arrows);
    mark_events();
    const bool numbered = diagram_.pieces.size() > 1;
    if (numbered) panel_.labels = sheet_labels(paths_, size_of(panel_.area), obstacles());
  }

 private:
  void choose_axes(const PageChoice& choice);
  std::size_t series(const DiagramPiece& piece, std::size_t ordinate) const {
    return diagram_.of_energy_and_momentum ? piece.branch : ordinate;
  }
  PagePoint place(std::size_t row, std::size_t ordinate) const {
    const DiagramPoint& p = diagram_.points[row];
    return {panel_.abscissa.place(p.abscissa) * panel_.area.width(),
            panel_.ordinate.place(p.ordinate[ordinate] - panel_.base) * panel_.area.height()};
  }
  int curves_above(std::size_t row, std::size_t ordinate) const;
  PictureCurve& curve(std::size_t series, std::optional<StabilityClass> verdict, int lower);
  PictureRates& rates(RateKind kind);
  void draw_curves(const DiagramPiece& piece);
  std::vector<LinePoint> line_points(const DiagramLine& line, std::size_t ordinate) const;
  void draw_line(const DiagramPiece& piece, const DiagramLine& line, std::size_t ordinate);
  void draw_rates(const DiagramPiece& piece);
  void mark_events();
  static void thin_arrows(std::vector<PictureArrow>& arrows);
  std::vector<PagePoint> obstacles() const;

  const Diagram& diagram_;
  std::vector<std::size_t> pieces_;
  DiagramPanel& panel_;
  std::vector<SheetPath> paths_;
  bool asked_ordinate_ = false;
};

void PanelDrawing::choose_axes(const PageChoice& choice) {
  std::vector<WeightedCurve> abscissas;
  std::vector<WeightedCurve> ordinates;
  std::vector<WeightedCurve> rate_curves;
  const auto positive = [](double value) {
    return value > 0.0 ? value : std::numeric_limits<double>::quiet_NaN();
  };
  // Of a momentum that is 0 in the row of rest the others' decades count.
  const bool of_momentum = diagram_.of_energy_and_momentum;
  for (const std::size_t at : pieces_) {
    const DiagramPiece& piece = diagram_.pieces[at];
    abscissas.push_back(weighted(diagram_, piece, [&](const DiagramPoint& p) {
      return of_momentum ? positive(p.abscissa) : p.abscissa;
    }));
    for (std::size_t k = 0; k < diagram_.columns.size(); ++k) {
      ordinates.push_back(
          weighted(diagram_, piece, [k](const DiagramPoint& p) { return p.ordinate[k]; }));
    }
    for (std::size_t k = 0; k < mode_count; ++k) {
      rate_curves.push_back(weighted(
          diagram_, piece, [&](const DiagramPoint& p) { return positive(p.frequency[k]); }));
    }
    rate_curves.push_back(
        weighted(diagram_, piece, [&](const DiagramPoint& p) { return positive(p.growth); }));
  }
  panel_.abscissa = of_momentum ? fitted_axis(abscissas) : whole_axis(abscissas);
  const bool has_rest = of_momentum && std::ranges::any_of(diagram_.points, [](const auto& each) {
                          return each.abscissa == 0.0;
                        });
  if (has_rest && !panel_.abscissa.logarithmic) panel_.abscissa.range.low = 0.0;
  if (choice.x) panel_.abscissa = asked_axis(*choice.x, panel_.abscissa.logarithmic);
  panel_.ordinate = fitted_axis(ordinates);
  asked_ordinate_ = choice.y.has_value();
  if (choice.y) panel_.ordinate = asked_axis(*choice.y, panel_.ordinate.logarithmic);
  panel_.rate = fitted_rate_axis(rate_curves);
  if (choice.rate) panel_.rate = asked_axis(*choice.rate, panel_.rate.logarithmic);

  AxisRange& range = panel_.ordinate.range;
  panel_.base = base_of(range);
  if (panel_.base != 0.0) {
    range = {range.low - panel_.base, range.high - panel_.base};
    panel_.ordinate.logarithmic = false;
  }
  if (!panel_.abscissa.logarithmic) panel_.abscissa_base = base_of(panel_.abscissa.range);
}

/// Of those drawn later, how many are within the width of a line.
int PanelDrawing::curves_above(std::size_t row, std::size_t ordinate) const {
  constexpr double near = 0.8;
  int out = 0;
  for (std::size_t k = ordinate + 1; k < diagram_.columns.size(); ++k)
    if (std::abs(place(row, k).y - place(row, ordinate).y) < near) ++out;
  return out;
}

PictureCurve& PanelDrawing::curve(std::size_t series, std::optional<StabilityClass> verdict,
                                  int lower) {
  const auto at = std::ranges::find_if(panel_.curves, [&](const PictureCurve& c) {
    return c.series == series && c.verdict == verdict && c.lower == lower;
  });
  if (at != panel_.curves.end()) return *at;
  panel_.curves.push_back({series, verdict, lower, {}});
  return panel_.curves.back();
}

PictureRates& PanelDrawing::rates(RateKind kind) {
  const auto at = std::ranges::find(panel_.rates, kind, &PictureRates::kind);
  if (at != panel_.rates.end()) return *at;
  panel_.rates.push_back({kind, {}, {}});
  return panel_.rates.back();
}

void PanelDrawing::draw_curves(const DiagramPiece& piece) {
  SheetPath path{piece.label, {}};
  for (std::size_t k = 0; k < diagram_.columns.size(); ++k) {
    for (std::size_t row = piece.begin; row < piece.end; ++row)
      path.points.push_back(place(row, k));
    path.points.push_back({std::numeric_limits<double>::quiet_NaN(), 0.0});
  }
  paths_.push_back(std::move(path));
  for (const DiagramLine& line : class_lines(diagram_, piece, panel_.abscissa))
    for (std::size_t k = 0; k < diagram_.columns.size(); ++k) draw_line(piece, line, k);
}

std::vector<LinePoint> PanelDrawing::line_points(const DiagramLine& line,
                                                 std::size_t ordinate) const {
  std::vector<LinePoint> out;
  const auto add_middle = [&](std::size_t own, std::size_t other) {
    const PagePoint a = place(own, ordinate);
    const PagePoint b = place(other, ordinate);
    out.push_back({{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}, curves_above(own, ordinate)});
  };
  if (line.before) add_middle(line.points.front(), *line.before);
  for (const std::size_t row : line.points)
    out.push_back({place(row, ordinate), curves_above(row, ordinate)});
  if (line.after) add_middle(line.points.back(), *line.after);
  return out;
}

/// In runs over which as many curves lie on it; where they only cross, none does. A row by itself is a
/// dot.
void PanelDrawing::draw_line(const DiagramPiece& piece, const DiagramLine& line,
                             std::size_t ordinate) {
  constexpr double crossing = 25.0;
  const std::vector<LinePoint> points = line_points(line, ordinate);
  const std::size_t count = points.size();
  if (count == 1) {
    const PagePoint& at = points.front().at;
    if (within(at, size_of(panel_.area)))
      panel_.dots.push_back({series(piece, ordinate), line.verdict, at});
    return;
  }
  const auto lower = [&](std::size_t at) {
    return std::min(points[at].lower, points[at + 1].lower);
  };
  const auto end_of_run = [&](std::size_t begin) {
    std::size_t end = begin + 1;
    while (end + 1 < count && lower(end) == lower(begin)) ++end;
    return end;
  };
  const auto length = [&](std::size_t begin, std::size_t end) {
    const PagePoint& a = points[begin].at;
    const PagePoint& b = points[end].at;
    return hypotenuse(b.x - a.x, b.y - a.y);
  };
  for (std::size_t begin = 0; begin + 1 < count;) {
    std::size_t end = end_of_run(begin);
    int now = lower(begin);
    if (now > 0 && length(begin, end) < crossing) now = 0;
    while (now == 0 && end + 1 < count) {
      const std::size_t next = end_of_run(end);
      if (lower(end) > 0 && length(end, next) >= crossing) break;
      end = next;
    }
    std::vector<PagePoint> path;
    for (std::size_t at = begin; at <= end; ++at) path.push_back(points[at].at);
    DrawnCurve out = drawn(path, size_of(panel_.area), style(line.verdict).dashes);
    if (!out.strokes.empty()) {
      PictureCurve& into = curve(series(piece, ordinate), line.verdict, now);
      std::ranges::move(out.strokes, std::back_inserter(into.strokes));
    }
    for (const CurveExit& exit : out.exits)
      panel_.arrows.push_back({exit, series(piece, ordinate)});
    begin = end;
  }
}

void PanelDrawing::draw_rates(const DiagramPiece& piece) {
  const std::vector<std::size_t> rows = spectrum_rows(diagram_, piece, panel_.abscissa);
  for (const RateTrack& track : rate_tracks(diagram_, rows)) {
    std::vector<PagePoint> path;
    for (const RatePoint& each : track.points) {
      // Zero is below all of a logarithmic axis.
      const double up =
          panel_.rate.logarithmic && each.rate <= 0.0 ? -1.0 : panel_.rate.place(each.rate);
      path.push_back(
          {panel_.abscissa.place(diagram_.points[each.row].abscissa) * panel_.rate_area.width(),
           up * panel_.rate_area.height()});
    }
    if (path.size() == 1) {
      if (within(path.front(), size_of(panel_.rate_area)))
        rates(track.kind).dots.push_back(path.front());
      continue;
    }
    DrawnCurve out = drawn(path, size_of(panel_.rate_area), {});
    if (!out.strokes.empty())
      std::ranges::move(out.strokes, std::back_inserter(rates(track.kind).strokes));
    for (const CurveExit& exit : out.exits) {
      // At the lower end of a linear axis is zero, where rates end.
      if (exit.side == PanelSide::bottom && panel_.rate.range.low == 0.0) continue;
      panel_.rate_arrows.push_back({exit, static_cast<std::size_t>(track.kind)});
    }
  }
}

/// Neighbours share an arrow.
void PanelDrawing::thin_arrows(std::vector<PictureArrow>& arrows) {
  constexpr double apart = 8.0;
  std::vector<PictureArrow> out;
  for (const PictureArrow& arrow : arrows) {
    const bool there = std::ranges::any_of(out, [&](const PictureArrow& other) {
      return other.exit.side == arrow.exit.side &&
             std::abs(other.exit.place - arrow.exit.place) < apart;
    });
    if (!there) out.push_back(arrow);
  }
  arrows = std::move(out);
}

/// On every curve that is in the picture there; where none is, on the edge by which it left, unless the range was
/// asked for.
void PanelDrawing::mark_events() {
  for (const DiagramEvent& event : diagram_.events) {
    const bool here = std::ranges::any_of(pieces_, [&](std::size_t at) {
      return event.point >= diagram_.pieces[at].begin && event.point < diagram_.pieces[at].end;
    });
    const double x = panel_.abscissa.place(diagram_.points[event.point].abscissa);
    if (!here || !is_marked(event.name) || !(x >= 0.0 && x <= 1.0)) continue;
    const auto in_height = [&](double y) { return y >= 0.0 && y <= panel_.area.height(); };
    std::vector<PagePoint> places;
    for (std::size_t k = 0; k < diagram_.columns.size(); ++k)
      if (const PagePoint at = place(event.point, k); !std::isnan(at.y)) places.push_back(at);
    if (places.empty()) continue;
    const bool seen =
        std::ranges::any_of(places, [&](const PagePoint& at) { return in_height(at.y); });
    for (PagePoint at : places) {
      if ((seen || asked_ordinate_) && !in_height(at.y)) continue;
      at.y = std::clamp(at.y, 0.0, panel_.area.height());
      panel_.marks.push_back({event.name, at});
    }
    constexpr double apart = 0.003;
    if (std::ranges::none_of(panel_.guides, [&](double g) { return std::abs(g - x) < apart; }))
      panel_.guides.push_back(x);
  }
}

std::vector<PagePoint> PanelDrawing::obstacles() const {
  std::vector<PagePoint> out;
  for (const PictureMark& mark : panel_.marks) out.push_back(mark.at);
  return out;
}

}  // namespace

bool has_rates(const Diagram& diagram) {
  return diagram.has_spectrum && !diagram.of_energy_and_momentum;
}

DiagramPicture diagram_picture(const Diagram& diagram, const PageChoice& choice) {
  DiagramPicture out;
  const bool together = diagram.of_energy_and_momentum;
  out.series = series_names(diagram);
  std::vector<std::vector<std::size_t>> pieces(together ? 1 : diagram.branches.size());
  for (std::size_t k = 0; k < diagram.pieces.size(); ++k)
    pieces[together ? 0 : diagram.pieces[k].branch].push_back(k);
  out.panels.resize(pieces.size());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    out.panels[k].title = together ? std::string() : panel_title(diagram.branches[k].name);
    out.panels[k].abscissa_name =
        together ? "size of the angular momentum |π|" : diagram.branches[k].parameter;
  }
  if (!together && pieces.size() == 1) out.panels.front().title.clear();
  lay_out(diagram, choice, out);
  for (std::size_t k = 0; k < pieces.size(); ++k)
    PanelDrawing(diagram, pieces[k], choice, out.panels[k]).draw();
  return out;
}

}  // namespace stationary
