#include "solver/program/plot/map_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "lib/number/elementary.hpp"
#include "lib/stability/spectrum.hpp"
#include "solver/program/diagram/axis_name.hpp"
#include "solver/program/diagram/ticks.hpp"
#include "solver/program/plot/gnuplot.hpp"
#include "solver/program/plot/plot_page.hpp"
#include "solver/program/plot/script_lines.hpp"

namespace stationary {
namespace {

constexpr double map_legend = 134.0;       ///< its width
constexpr double wide_map_legend = 184.0;  ///< with the names of special points
constexpr double map_legend_line = 18.14;
constexpr double least_bar = 100.0;        ///< of the colours of numbers
constexpr double above_bar = 42.0;         ///< what is written there
constexpr std::size_t most_pixels = 1000;  ///< along an axis: beyond, cells are passed over

/// By status, of cells without a solution; none: hatched.
constexpr std::array<std::string_view, std::size(cell_status_names)> status_colours{
    "#d1d5db", "#ffffff", "", "#d946ef"};
constexpr std::string_view hatching = "#8b95a5";
constexpr std::array<std::string_view, std::size(cell_status_names)> status_titles{
    "not computed", "none exists", "not found", "failed"};

/// From dark to light, evenly in lightness; and of growth, which is 0 where nothing grows.
constexpr std::string_view palette =
    "0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 '#28ae80', 6 '#5ec962', "
    "7 '#addc30', 8 '#fde725'";
constexpr std::string_view growth_palette =
    "0 '#f3efe6', 0.001 '#f7d9a8', 2 '#f0a35e', 4 '#dc6b33', 6 '#b03a1e', 8 '#6b1713'";

double width_of_legend(const MapDiagram& diagram) {
  return diagram.lines.empty() ? map_legend : wide_map_legend;
}

/// Without the numbers' colours.
std::size_t map_legend_lines(const MapDiagram& diagram) {
  std::set<double> classes;
  std::set<CellStatus> statuses;
  for (std::size_t k = 0; k < diagram.values.size(); ++k) {
    if (!std::isfinite(diagram.values[k])) {
      statuses.insert(diagram.statuses[k].value_or(CellStatus::solved));
    } else if (diagram.of_class()) {
      classes.insert(diagram.values[k]);
    }
  }
  std::set<std::string> events;
  std::set<SpecialPoint> special;
  for (const EventLine& each : diagram.lines) {
    events.insert(each.event);
    for (const EventLine::Special& point : each.special) special.insert(point.type);
  }
  return classes.size() + statuses.size() + events.size() + special.size();
}

double map_legend_height(const MapDiagram& diagram) {
  return map_legend_line * static_cast<double>(map_legend_lines(diagram)) + 10.0;
}

PageSize page_of(const MapDiagram& diagram, const PageChoice& choice) {
  const PageSize least = least_page(diagram);
  const PageSize usual{};
  return choice.size.value_or(
      PageSize{std::max(usual.width, least.width), std::max(usual.height, least.height)});
}

class MapScript : private ScriptLines {
 public:
  MapScript(const MapDiagram& diagram, const PageChoice& choice)
      : diagram_(diagram),
        choice_(choice),
        size_(page_of(diagram, choice)),
        area_{page::left, size_.width - width_of_legend(diagram), page::bottom,
              size_.height - page::margin - page::title_height} {}
  std::string write(ImageFormat format, std::string_view title);

 private:
  std::size_t stride(const MapDiagramAxis& axis) const {
    return (axis.values.size() + most_pixels - 1) / most_pixels;
  }
  /// What its linear numbers are drawn less: where they all but share it.
  static double base(const MapDiagramAxis& axis) {
    if (axis.scale == AxisScale::log) return 0.0;
    const auto [low, high] = std::minmax(axis.values.front(), axis.values.back());
    return base_of({low, high});
  }
  static double place(const MapDiagramAxis& axis, double value) {
    return axis.scale == AxisScale::log ? log10(value) : value - base(axis);
  }
  static std::string name_of(const MapDiagramAxis& axis) {
    const double less = base(axis);
    return axis_name(axis.parameter) + (less == 0.0 ? "" : fmt::format(" less {}", less));
  }
  void choose_base();
  std::string pixels(const MapDiagramAxis& axis, int coordinate) const;
  void data();
  void set_axis(const MapDiagramAxis& axis, char letter);
  void set_colours();
  std::string keys() const;
  void line_data();
  std::string lines() const;

  const MapDiagram& diagram_;
  const PageChoice& choice_;
  PageSize size_;
  PageArea area_;
  std::set<int> classes_;
  std::set<CellStatus> statuses_;  ///< of cells that show no number
  std::vector<double> shown_;      ///< the numbers less their base, later ascending
  double base_ = 0.0;              ///< of the numbers
};

void MapScript::choose_base() {
  if (diagram_.of_class() || diagram_.quantity == "growth") return;
  AxisRange range{largest_drawn, -largest_drawn};
  for (const double value : diagram_.values) {
    if (!std::isfinite(value)) continue;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  if (choice_.value) range = *choice_.value;
  base_ = base_of(range);
}

/// $codes: the index of the cell's colour; $numbers: the quantity where it is a number. One row of cells, or
/// one column, stands there twice: gnuplot draws no such image.
void MapScript::data() {
  choose_base();
  const std::size_t columns = diagram_.x.values.size();
  const int times_over = columns == 1 ? 2 : 1;
  const int times_up = diagram_.y.values.size() == 1 ? 2 : 1;
  const std::size_t over = stride(diagram_.x);
  const std::size_t up = stride(diagram_.y);
  std::string numbers;
  line("$codes << END_OF_DATA");
  for (std::size_t row = 0; row < diagram_.y.values.size(); row += up) {
    std::string codes;
    std::string row_numbers;
    for (std::size_t column = 0; column < columns; column += over) {
      const double value = diagram_.values[row * columns + column];
      const auto status = diagram_.statuses[row * columns + column];
      const bool shown = std::isfinite(value);
      int code = static_cast<int>(class_colours.size());
      if (shown && diagram_.of_class()) {
        code = static_cast<int>(value);
        classes_.insert(code);
      } else if (shown) {
        shown_.push_back(std::clamp(value, -largest_drawn, largest_drawn) - base_);
      } else {
        const CellStatus what = status.value_or(CellStatus::solved);
        statuses_.insert(what);
        code += static_cast<int>(what);
      }
      for (int k = 0; k < times_over; ++k) {
        fmt::format_to(std::back_inserter(codes), "{} ", code);
        if (shown) {
          fmt::format_to(std::back_inserter(row_numbers), "{:.6g} ",
                         std::clamp(value, -largest_drawn, largest_drawn) - base_);
        } else {
          row_numbers += "NaN ";
        }
      }
    }
    for (int k = 0; k < times_up; ++k) {
      line("{}", codes);
      numbers += row_numbers + '\n';
    }
  }
  line("END_OF_DATA");
  if (!diagram_.of_class()) line("$numbers << END_OF_DATA\n{}END_OF_DATA", numbers);
}

/// The coordinate of a pixel's centre from its column or row.
std::string MapScript::pixels(const MapDiagramAxis& axis, int coordinate) const {
  const double first = place(axis, axis.values.front());
  const double last = place(axis, axis.values.back());
  const double steps = static_cast<double>(std::max<std::size_t>(axis.values.size() - 1, 1));
  if (axis.values.size() == 1) return fmt::format("({} + 0.5 * ${})", first - 0.25, coordinate);
  const double step = (last - first) / steps;
  return fmt::format("({} + {} * ${})", first, step * static_cast<double>(stride(axis)),
                     coordinate);
}

void MapScript::set_axis(const MapDiagramAxis& axis, char letter) {
  const double first = place(axis, axis.values.front());
  const double last = place(axis, axis.values.back());
  const double steps = static_cast<double>(std::max<std::size_t>(axis.values.size() - 1, 1));
  const double cell = axis.values.size() > 1 ? (last - first) / steps : 1.0;
  const double half = diagram_.has_cells() ? 0.5 * cell : 0.0;
  AxisRange shown{first - half, last + half};
  const bool is_log = axis.scale == AxisScale::log;
  // Of positive numbers, such as J, none are shown that are not.
  if (!is_log && axis.values.front() > 0.0) shown.low = std::max(shown.low, -base(axis));
  const std::optional<AxisRange>& asked = letter == 'x' ? choice_.x : choice_.y;
  if (asked) shown = {place(axis, asked->low), place(axis, asked->high)};
  shown = drawable(shown, false);
  line("set {}range [{}:{}]", letter, shown.low, shown.high);
  const AxisWay way = letter == 'x' ? AxisWay::level : AxisWay::upright;
  const double length = letter == 'x' ? area_.width() : area_.height();
  if (!is_log) {
    line("set {}tics {}", letter, linear_ticks(shown, length, way));
    return;
  }
  // The axis is linear in the logarithm.
  const std::string ticks = logarithmic_ticks({pow(10.0, shown.low), pow(10.0, shown.high)},
                                              most_ticks(length, way), true);
  line("set {}tics ({})", letter, ticks);
}

void MapScript::set_colours() {
  std::string colour = "0";
  std::vector<std::string_view> colours(class_colours.begin(), class_colours.end());
  colours.insert(colours.end(), status_colours.begin(), status_colours.end());
  for (std::size_t k = colours.size(); k-- > 0;) {
    // As 0xAARRGGBB; alpha 0 lets the hatching behind be seen.
    const std::string code = colours[k].empty() ? "0" : "0xFF" + std::string(colours[k].substr(1));
    colour = fmt::format("c == {} ? {} : {}", k, code, colour);
  }
  line("colour(c) = {}", colour);
  line("part(c, shift) = (colour(c) >> shift) & 255");
  if (shown_.empty()) return;
  std::ranges::sort(shown_);
  double low = shown_.front();
  double high = shown_.back();
  const double most_of_all = high;
  // Where a stretch escapes a few cells would take most of the colours for themselves.
  constexpr double out_of_proportion = 2.0;
  const double seen = shown_[(shown_.size() - 1) * 98 / 100];
  const bool cut = high - low > out_of_proportion * (seen - low) && seen > low;
  if (cut) high = seen;
  const bool growth = diagram_.quantity == "growth";
  line("set palette defined ({})", growth ? growth_palette : palette);
  constexpr double largest_linear_ratio = 30.0;
  if (!growth && base_ == 0.0 && low > 0.0 && high / low > largest_linear_ratio)
    line("set logscale cb");
  if (growth) low = 0.0;
  double room = high > low ? 0.0 : std::max(0.05 * std::abs(high), 1e-12);
  if (choice_.value)
    low = choice_.value->low - base_, high = choice_.value->high - base_, room = 0.0;
  if (choice_.value) line("unset logscale cb");
  const AxisRange colours_of = drawable({growth ? low : low - room, high + room}, false);
  line("set cbrange [{}:{}]", colours_of.low, colours_of.high);
  const double bar_height =
      std::min(0.6 * area_.height(), area_.height() - above_bar - map_legend_height(diagram_));
  line("set colorbox user origin {} size {}", on_page(size_, area_.right + 16.0, area_.bottom),
       on_page(size_, 16.0, bar_height));
  line("set cbtics font ',11' offset -0.5,0");
  line("set format cb '%.4g'");
  std::string quantity = axis_name(diagram_.quantity);
  if (base_ != 0.0) quantity += fmt::format(" less {}", base_);
  line("set label {} at {} left font ',12'", in_gnuplot_quotes(quantity),
       on_page(size_, area_.right + 16.0, area_.bottom + bar_height + (cut ? 28.0 : 14.0)));
  if (!cut || choice_.value) return;
  line("set label {} at {} left font ',11'",
       in_gnuplot_quotes(fmt::format("up to {:.3g}", most_of_all)),
       on_page(size_, area_.right + 16.0, area_.bottom + bar_height + 12.0));
}

std::string MapScript::keys() const {
  std::string out;
  const auto add = [&](std::string_view colour, std::string_view title) {
    out += fmt::format(
        ", \\\n  keyentry with boxes fs solid 1 border rgb '#9ca3af' fc rgb '{}' title '{}'",
        colour, title);
  };
  for (const int each : classes_)
    add(class_colours[static_cast<std::size_t>(each)],
        stability_names[static_cast<std::size_t>(each)]);
  for (const CellStatus each : statuses_) {
    const auto k = static_cast<std::size_t>(each);
    if (!status_colours[k].empty()) {
      add(status_colours[k], status_titles[k]);
    } else {
      out += fmt::format(
          ", \\\n  keyentry with boxes fs pattern 4 border rgb '#9ca3af' fc rgb '{}' title '{}'",
          hatching, status_titles[k]);
    }
  }
  return out;
}

/// $lines: a block of points a curve; $special_K: those of type K.
void MapScript::line_data() {
  line("$lines << END_OF_DATA");
  for (const EventLine& each : diagram_.lines) {
    for (const auto& [x, y] : each.points)
      line("{:.10g} {:.10g}", place(diagram_.x, x), place(diagram_.y, y));
    line("\n");
  }
  line("END_OF_DATA");
  for (std::size_t k = 1; k < std::size(special_point_names); ++k) {
    std::string points;
    for (const EventLine& each : diagram_.lines)
      for (const EventLine::Special& special : each.special)
        if (special.type == static_cast<SpecialPoint>(k))
          points += fmt::format("{:.10g} {:.10g}\n", place(diagram_.x, special.at[0]),
                                place(diagram_.y, special.at[1]));
    if (!points.empty()) line("$special_{} << END_OF_DATA\n{}END_OF_DATA", k, points);
  }
}

/// Dark on a light edge, so that a line is seen on any colour; an event a dash.
std::string MapScript::lines() const {
  std::string out;
  std::vector<std::string> events;
  const auto item = [&](const std::string& text) {
    out += (out.empty() && !diagram_.has_cells() ? " " : ", \\\n  ") + text;
  };
  for (std::size_t k = 0; k < diagram_.lines.size(); ++k)
    item(fmt::format("$lines index {} using 1:2 with lines lw 3.6 lc rgb '#ffffff' notitle", k));
  for (std::size_t k = 0; k < diagram_.lines.size(); ++k) {
    const std::string& event = diagram_.lines[k].event;
    const auto known = std::ranges::find(events, event);
    const auto dash = known - events.begin() + 1;
    const bool first = known == events.end();
    item(fmt::format("$lines index {} using 1:2 with lines lw 1.6 dt {} lc rgb '#111827' {}", k,
                     dash, first ? "title " + in_gnuplot_quotes(event) : std::string("notitle")));
    if (first) events.push_back(event);
  }
  constexpr std::array<int, std::size(special_point_names)> symbols{0, 9, 7, 5, 13};
  for (std::size_t k = 1; k < std::size(special_point_names); ++k) {
    const auto is_of = [&](const EventLine::Special& special) {
      return special.type == static_cast<SpecialPoint>(k);
    };
    const bool any = std::ranges::any_of(diagram_.lines, [&](const EventLine& each) {
      return std::ranges::any_of(each.special, is_of);
    });
    if (any)
      item(fmt::format("$special_{} using 1:2 with points pt {} ps 0.9 lc rgb '#111827' title '{}'",
                       k, symbols[k], special_point_names[k]));
  }
  return out;
}

std::string MapScript::write(ImageFormat format, std::string_view title) {
  text_ = page_head(format, title, size_);
  if (diagram_.has_cells()) data();
  if (!diagram_.lines.empty()) line_data();
  if (diagram_.has_cells()) set_colours();
  line("set border lw 0.8 front");
  line("set tics out nomirror font ',12' front");
  line("set format x '%g'");
  line("set format y '%g'");
  text_ += panel_margins(size_, area_);
  line(
      "set key at graph 1.02, graph 1.0 left top Left reverse samplen 1.2 spacing {:.3g} font "
      "',12'",
      key_spacing(format, map_legend_line));
  line("set xlabel {} offset 0,0.4", in_gnuplot_quotes(name_of(diagram_.x)));
  line("set label {} at {} center rotate by 90", in_gnuplot_quotes(name_of(diagram_.y)),
       on_page(size_, page::margin, 0.5 * (area_.bottom + area_.top)));
  if (statuses_.contains(CellStatus::not_found))
    line(
        "set object rectangle from graph 0, graph 0 to graph 1, graph 1 behind fs pattern 4 "
        "noborder "
        "fc rgb '{}'",
        hatching);
  set_axis(diagram_.x, 'x');
  set_axis(diagram_.y, 'y');
  if (!diagram_.has_cells()) {
    line("plot{}", lines());
    return std::move(text_);
  }
  const std::string at = pixels(diagram_.x, 1) + ':' + pixels(diagram_.y, 2);
  std::string items = fmt::format(
      "plot $codes matrix using {}:(part($3, 16)):(part($3, 8)):(part($3, 0)):(part($3, 24)) with "
      "rgbalpha notitle",
      at);
  if (!shown_.empty())
    items += fmt::format(", \\\n  $numbers matrix using {}:3 with image notitle", at);
  line("{}{}{}", items, lines(), keys());
  return std::move(text_);
}

}  // namespace

PageSize least_page(const MapDiagram& diagram) {
  constexpr double least_area = 200.0;
  const bool has_bar = diagram.has_cells() && !diagram.of_class();
  const double height =
      std::max(least_area, map_legend_height(diagram) + (has_bar ? least_bar + above_bar : 0.0));
  return {std::ceil(page::left + least_area + width_of_legend(diagram)),
          std::ceil(page::margin + page::title_height + page::bottom + height)};
}

std::string gnuplot_script(const MapDiagram& diagram, ImageFormat format, std::string_view title,
                           const PageChoice& choice) {
  return MapScript(diagram, choice).write(format, title);
}

}  // namespace stationary
