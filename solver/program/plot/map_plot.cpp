#include "solver/program/plot/map_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "lib/stability/spectrum.hpp"
#include "solver/program/plot/gnuplot.hpp"
#include "solver/program/plot/plot_page.hpp"

namespace stationary {
namespace {

constexpr std::size_t most_pixels = 1000;  ///< along an axis: beyond, cells are passed over

/// By class; then by status, of cells without a solution.
constexpr std::array<std::string_view, std::size(stability_names)> class_colours{
    "#24507a", "#7fb2d6", "#c2410c", "#efb366", "#111111"};
constexpr std::array<std::string_view, std::size(cell_status_names)> status_colours{
    "#ffffff", "#e4e6ea", "#b3b8c0", "#d946ef"};
constexpr std::array<std::string_view, std::size(cell_status_names)> status_titles{
    "not computed", "none exists", "not found", "failed"};

/// From dark to light, evenly in lightness; and of growth, which is 0 where nothing grows.
constexpr std::string_view palette =
    "0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 '#28ae80', 6 '#5ec962', "
    "7 '#addc30', 8 '#fde725'";
constexpr std::string_view growth_palette =
    "0 '#f3efe6', 0.001 '#f7d9a8', 2 '#f0a35e', 4 '#dc6b33', 6 '#b03a1e', 8 '#6b1713'";

std::string_view symbol(std::string_view column) {
  constexpr std::pair<std::string_view, std::string_view> symbols[] = {
      {"nu", "ν"},
      {"nu1", "ν₁"},
      {"nu2", "ν₂"},
      {"nu3", "ν₃"},
      {"xi", "ξ"},
      {"zeta", "ζ"},
      {"rho", "ϱ"},
      {"lambda", "λ"},
      {"mu", "μ"},
      {"pi1", "π₁"},
      {"pi2", "π₂"},
      {"pi3", "π₃"},
      {"angle", "θ"},
      {"growth", "growth rate"},
      {"error_bound", "error bound of S"}};
  const auto* const at =
      std::ranges::find(symbols, column, &std::pair<std::string_view, std::string_view>::first);
  return at == std::end(symbols) ? column : at->second;
}

class MapScript {
 public:
  explicit MapScript(const MapDiagram& diagram) : diagram_(diagram) {}
  std::string write(ImageFormat format, std::string_view title);

 private:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> form, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  std::size_t stride(const MapDiagramAxis& axis) const {
    return (axis.values.size() + most_pixels - 1) / most_pixels;
  }
  double place(const MapDiagramAxis& axis, double value) const {
    return axis.scale == AxisScale::log ? std::log10(value) : value;
  }
  std::string pixels(const MapDiagramAxis& axis, int coordinate) const;
  void data();
  void set_axis(const MapDiagramAxis& axis, char letter);
  void set_colours();
  std::string keys() const;

  const MapDiagram& diagram_;
  std::set<int> classes_;
  std::set<CellStatus> statuses_;  ///< of cells that show no number
  std::vector<double> shown_;      ///< the numbers, later ascending
  std::string text_;
};

/// $codes: the index of the cell's colour; $numbers: the quantity where it is a number.
void MapScript::data() {
  const std::size_t columns = diagram_.x.values.size();
  const std::size_t over = stride(diagram_.x);
  const std::size_t up = stride(diagram_.y);
  std::string numbers;
  line("$codes << END_OF_DATA");
  for (std::size_t row = 0; row < diagram_.y.values.size(); row += up) {
    std::string codes;
    for (std::size_t column = 0; column < columns; column += over) {
      const double value = diagram_.values[row * columns + column];
      const auto status = diagram_.statuses[row * columns + column];
      const bool shown = std::isfinite(value);
      int code = static_cast<int>(class_colours.size());
      if (shown && diagram_.of_class()) {
        code = static_cast<int>(value);
        classes_.insert(code);
      } else if (shown) {
        shown_.push_back(value);
      } else {
        const CellStatus what = status.value_or(CellStatus::solved);
        statuses_.insert(what);
        code += static_cast<int>(what);
      }
      fmt::format_to(std::back_inserter(codes), "{} ", code);
      if (shown) {
        fmt::format_to(std::back_inserter(numbers), "{:.6g} ", value);
      } else {
        numbers += "NaN ";
      }
    }
    line("{}", codes);
    numbers += '\n';
  }
  line("END_OF_DATA");
  if (!diagram_.of_class()) line("$numbers << END_OF_DATA\n{}END_OF_DATA", numbers);
}

/// The coordinate of a pixel's centre from its column or row.
std::string MapScript::pixels(const MapDiagramAxis& axis, int coordinate) const {
  const double first = place(axis, axis.values.front());
  const double last = place(axis, axis.values.back());
  const double steps = static_cast<double>(std::max<std::size_t>(axis.values.size() - 1, 1));
  const double step = axis.values.size() > 1 ? (last - first) / steps : 1.0;
  return fmt::format("({} + {} * ${})", first, step * static_cast<double>(stride(axis)),
                     coordinate);
}

void MapScript::set_axis(const MapDiagramAxis& axis, char letter) {
  const double first = place(axis, axis.values.front());
  const double last = place(axis, axis.values.back());
  const double steps = static_cast<double>(std::max<std::size_t>(axis.values.size() - 1, 1));
  const double half = axis.values.size() > 1 ? 0.5 * (last - first) / steps : 0.5;
  line("set {}range [{}:{}]", letter, first - half, last + half);
  if (axis.scale == AxisScale::linear) return;
  // The axis is linear in the logarithm; its ticks are powers of ten, between them 2 and 5 where
  // there is room.
  const bool few = last - first < 2.5;
  std::string ticks;
  for (int power = static_cast<int>(std::floor(first)); power <= std::ceil(last); ++power) {
    for (const int digit : {1, 2, 5}) {
      const double at = power + std::log10(digit);
      if ((digit > 1 && !few) || at < first - half || at > last + half) continue;
      fmt::format_to(std::back_inserter(ticks), "{}'{:g}' {}", ticks.empty() ? "" : ", ",
                     digit * std::pow(10.0, power), at);
    }
  }
  line("set {}tics ({})", letter, ticks);
}

void MapScript::set_colours() {
  std::string red = "0";
  std::string green = "0";
  std::string blue = "0";
  std::vector<std::string_view> colours(class_colours.begin(), class_colours.end());
  colours.insert(colours.end(), status_colours.begin(), status_colours.end());
  for (std::size_t k = colours.size(); k-- > 0;) {
    const auto part = [&](std::size_t from) { return std::string(colours[k].substr(from, 2)); };
    for (auto& [formula, from] :
         {std::pair<std::string&, std::size_t>{red, 1}, {green, 3}, {blue, 5}})
      formula = fmt::format("c == {} ? 0x{} : {}", k, part(from), formula);
  }
  line("red(c) = {}", red);
  line("green(c) = {}", green);
  line("blue(c) = {}", blue);
  if (shown_.empty()) return;
  std::ranges::sort(shown_);
  double low = shown_.front();
  double high = shown_.back();
  // Where a stretch escapes a few cells would take most of the colours for themselves.
  constexpr double out_of_proportion = 2.0;
  const double seen = shown_[(shown_.size() - 1) * 98 / 100];
  const bool cut = high - low > out_of_proportion * (seen - low) && seen > low;
  if (cut) high = seen;
  const bool growth = diagram_.quantity == "growth";
  line("set palette defined ({})", growth ? growth_palette : palette);
  constexpr double largest_linear_ratio = 30.0;
  if (!growth && low > 0.0 && high / low > largest_linear_ratio) line("set logscale cb");
  if (growth) low = 0.0;
  const double room = high > low ? 0.0 : std::max(0.05 * std::abs(high), 1e-12);
  line("set cbrange [{}:{}]", low - room, high + room);
  line("set colorbox user origin {} size {}", on_page(PlotPage::right + 14.0, PlotPage::bottom),
       on_page(16.0, 0.62 * (PlotPage::height - PlotPage::bottom)));
  line("set cbtics font ',11'");
  const std::string most = cut ? fmt::format(" (to {:.3g})", shown_.back()) : std::string();
  line("set label {} at {} left font ',12'",
       in_gnuplot_quotes(std::string(symbol(diagram_.quantity)) + most),
       on_page(PlotPage::right + 14.0,
               PlotPage::bottom + 0.62 * (PlotPage::height - PlotPage::bottom) + 14.0));
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
  for (const CellStatus each : statuses_)
    add(status_colours[static_cast<std::size_t>(each)],
        status_titles[static_cast<std::size_t>(each)]);
  return out;
}

std::string MapScript::write(ImageFormat format, std::string_view title) {
  text_ = page_head(format, title);
  data();
  set_colours();
  line("set border lw 0.8 front");
  line("set tics out nomirror font ',12' front");
  line("set format x '%g'");
  line("set format y '%g'");
  line("set lmargin at screen {}", PlotPage::left / PlotPage::width);
  line("set rmargin at screen {}", PlotPage::right / PlotPage::width);
  line("set bmargin at screen {}", PlotPage::bottom / PlotPage::height);
  line("set tmargin at screen {}",
       (PlotPage::height - PlotPage::margin - PlotPage::title_height) / PlotPage::height);
  line("set key at graph 1.02, graph 1.0 left top Left reverse samplen 1.2 spacing 1.3 font ',12'");
  line("set xlabel {} offset 0,0.4", in_gnuplot_quotes(symbol(diagram_.x.parameter)));
  line("set label {} at {} center rotate by 90", in_gnuplot_quotes(symbol(diagram_.y.parameter)),
       on_page(PlotPage::margin, 0.5 * (PlotPage::bottom + PlotPage::height - PlotPage::margin -
                                        PlotPage::title_height)));
  set_axis(diagram_.x, 'x');
  set_axis(diagram_.y, 'y');
  const std::string at = pixels(diagram_.x, 1) + ':' + pixels(diagram_.y, 2);
  std::string items = fmt::format(
      "plot $codes matrix using {}:(red($3)):(green($3)):(blue($3)) with rgbimage notitle", at);
  if (!shown_.empty())
    items += fmt::format(", \\\n  $numbers matrix using {}:3 with image notitle", at);
  line("{}{}", items, keys());
  return std::move(text_);
}

}  // namespace

std::string gnuplot_script(const MapDiagram& diagram, ImageFormat format, std::string_view title) {
  return MapScript(diagram).write(format, title);
}

}  // namespace stationary
