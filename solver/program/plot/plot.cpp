#include "solver/program/plot/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "solver/program/diagram/ticks.hpp"
#include "solver/program/plot/diagram_names.hpp"
#include "solver/program/plot/gnuplot.hpp"
#include "solver/program/plot/plot_style.hpp"
#include "solver/program/plot/script_lines.hpp"

namespace stationary {
namespace {

/// The dashes of a class in the legend.
std::string key_dashes(const ClassStyle& style) {
  if (style.dashes.empty()) return "dt solid";
  std::string out;
  for (std::size_t k = 0; k < style.dashes.size(); ++k) {
    const double next = k + 1 < style.dashes.size() ? style.dashes[k + 1].from
                                                    : style.dashes.front().from + dash_period;
    fmt::format_to(std::back_inserter(out), "{}{},{}", k > 0 ? "," : "",
                   style.dashes[k].to - style.dashes[k].from, next - style.dashes[k].to);
  }
  return "dt (" + out + ")";
}

std::string colour_of(std::size_t series) {
  return std::string(series_colours[series % series_colours.size()]);
}

class Script : private ScriptLines {
 public:
  Script(const Diagram& diagram, const PageChoice& choice)
      : diagram_(diagram), picture_(diagram_picture(diagram, choice)) {}
  std::string write(ImageFormat format, std::string_view title);

 private:
  void strokes(const std::string& name, const std::vector<Stroke>& all, const DiagramPanel& panel,
               bool of_rates);
  void points(const std::string& name, const std::vector<PagePoint>& all, const DiagramPanel& panel,
              bool of_rates);
  void begin_panel(const DiagramPanel& panel, bool of_rates, bool names_abscissa);
  void set_ticks(const Axis& axis, char letter, const PageArea& area);
  void arrows(const DiagramPanel& panel, bool of_rates);
  void curve_panel(const DiagramPanel& panel, bool names_abscissa);
  void rate_panel(const DiagramPanel& panel);
  void plot(const std::vector<std::string>& items);
  std::vector<std::string> legend() const;
  void draw_legend(ImageFormat format);

  const Diagram& diagram_;
  DiagramPicture picture_;
  bool fresh_ = true;  ///< no panel yet: the title is a label of the first
};

/// As it is drawn: less the base.
Axis drawn_abscissa(const DiagramPanel& panel) {
  Axis out = panel.abscissa;
  out.range = {out.range.low - panel.abscissa_base, out.range.high - panel.abscissa_base};
  return out;
}

std::string place_text(const DiagramPanel& panel, const PagePoint& p, bool of_rates) {
  const PageArea& area = of_rates ? panel.rate_area : panel.area;
  const Axis& ordinate = of_rates ? panel.rate : panel.ordinate;
  return fmt::format("{:.10g} {:.10g}\n", drawn_abscissa(panel).value(p.x / area.width()),
                     ordinate.value(p.y / area.height()));
}

void Script::strokes(const std::string& name, const std::vector<Stroke>& all,
                     const DiagramPanel& panel, bool of_rates) {
  line("${} << END_OF_DATA", name);
  for (const Stroke& stroke : all) {
    for (const PagePoint& p : stroke) text_ += place_text(panel, p, of_rates);
    text_ += '\n';
  }
  line("END_OF_DATA");
}

void Script::points(const std::string& name, const std::vector<PagePoint>& all,
                    const DiagramPanel& panel, bool of_rates) {
  line("${} << END_OF_DATA", name);
  for (const PagePoint& p : all) text_ += place_text(panel, p, of_rates);
  line("END_OF_DATA");
}

void Script::set_ticks(const Axis& axis, char letter, const PageArea& area) {
  const AxisWay way = letter == 'x' ? AxisWay::level : AxisWay::upright;
  const double length = letter == 'x' ? area.width() : area.height();
  line("unset logscale {}", letter);
  line("set {}tics {}", letter,
       axis.logarithmic ? "autofreq" : linear_ticks(axis.range, length, way));
  line("set {}range [{}:{}]", letter, axis.range.low, axis.range.high);
  if (!axis.logarithmic) return;
  line("set logscale {}", letter);
  const std::string ticks = logarithmic_ticks(axis.range, most_ticks(length, way));
  if (ticks.find(',') != std::string::npos) line("set {}tics ({})", letter, ticks);
}

/// At the edges by which curves leave.
void Script::arrows(const DiagramPanel& panel, bool of_rates) {
  constexpr double inside = 11.0;
  constexpr double outside = 3.0;
  const PageArea& area = of_rates ? panel.rate_area : panel.area;
  for (const PictureArrow& arrow : of_rates ? panel.rate_arrows : panel.arrows) {
    PagePoint edge{area.left + arrow.exit.place, area.bottom + arrow.exit.place};
    PagePoint way{0.0, 0.0};
    switch (arrow.exit.side) {
      case PanelSide::bottom:
        edge.y = area.bottom, way.y = -1.0;
        break;
      case PanelSide::top:
        edge.y = area.top, way.y = 1.0;
        break;
      case PanelSide::left:
        edge.x = area.left, way.x = -1.0;
        break;
      case PanelSide::right:
        edge.x = area.right, way.x = 1.0;
        break;
    }
    const std::string colour =
        of_rates ? std::string(rate_styles[arrow.series].colour) : colour_of(arrow.series);
    line("set arrow from {} to {} head filled front size screen {:.4g},22 lc rgb '{}' lw 1.6",
         on_page(picture_.size, edge.x - inside * way.x, edge.y - inside * way.y),
         on_page(picture_.size, edge.x + outside * way.x, edge.y + outside * way.y),
         9.0 / picture_.size.width, colour);
  }
}

/// Its edges, the guides of the events, and the names of its axes: labels instead of gnuplot's own,
/// whose distance from the axis depends on the numbers there.
void Script::begin_panel(const DiagramPanel& panel, bool of_rates, bool names_abscissa) {
  const PageArea& area = of_rates ? panel.rate_area : panel.area;
  if (!fresh_) line("unset label\nunset arrow");
  fresh_ = false;
  text_ += panel_margins(picture_.size, area);
  set_ticks(drawn_abscissa(panel), 'x', area);
  set_ticks(of_rates ? panel.rate : panel.ordinate, 'y', area);
  line("set format x '{}'", names_abscissa ? "%g" : "");
  if (names_abscissa) {
    std::string abscissa = panel.abscissa_name;
    if (panel.abscissa_base != 0.0) abscissa += fmt::format(" less {}", panel.abscissa_base);
    line("set label {} at {} center", in_gnuplot_quotes(abscissa),
         on_page(picture_.size, 0.5 * (area.left + area.right), area.bottom - 34.0));
  }
  for (const double at : panel.guides)
    line("set arrow from graph {0:.6g}, graph 0 to graph {0:.6g}, graph 1 nohead back {1}", at,
         guide_style);
  std::string ordinate = of_rates ? "rate" : ordinate_name(diagram_);
  if (!of_rates && panel.base != 0.0) ordinate += fmt::format(" less {}", panel.base);
  line("set label {} at {} center rotate by 90", in_gnuplot_quotes(ordinate),
       on_page(picture_.size, std::max(page::margin, area.left - 58.0),
               0.5 * (area.bottom + area.top)));
  if (!of_rates && !panel.title.empty()) {
    line("set label {} at {} left font ',13'", in_gnuplot_quotes(panel.title),
         on_page(picture_.size, area.left, area.top + 14.0));
  }
  arrows(panel, of_rates);
}

void Script::plot(const std::vector<std::string>& items) {
  line("plot NaN notitle{}", items.empty() ? "" : ", \\");
  for (std::size_t k = 0; k < items.size(); ++k)
    line("  {}{}", items[k], k + 1 < items.size() ? ", \\" : "");
}

/// Curves, classes, rates, events, tables: what there is of each.
std::vector<std::string> Script::legend() const {
  std::vector<std::string> out;
  const auto space = [&] {
    if (!out.empty()) out.emplace_back("keyentry with lines lt nodraw title ' '");
  };
  std::set<std::optional<StabilityClass>> classes;
  std::set<RateKind> kinds;
  std::set<std::string> events;
  std::set<std::size_t> series;
  for (const DiagramPanel& panel : picture_.panels) {
    for (const PictureCurve& each : panel.curves) {
      classes.insert(each.verdict);
      series.insert(each.series);
    }
    for (const PictureDot& each : panel.dots) {
      classes.insert(each.verdict);
      series.insert(each.series);
    }
    for (const PictureRates& each : panel.rates) kinds.insert(each.kind);
    for (const PictureMark& each : panel.marks) events.insert(each.event);
  }
  for (const std::size_t each : series) {
    out.push_back(fmt::format("keyentry with lines lc rgb '{}' lw 2.8 title {}", colour_of(each),
                              in_gnuplot_quotes(picture_.series[each])));
  }
  if (!classes.empty()) space();
  const auto add_class = [&](std::optional<StabilityClass> verdict) {
    const ClassStyle& look = style(verdict);
    out.push_back(fmt::format("keyentry with lines lc rgb '{}' lw {} {} title '{}'",
                              class_key_colour, look.width, key_dashes(look), look.title));
  };
  for (const auto& verdict : classes)
    if (verdict) add_class(verdict);
  if (classes.contains(std::nullopt)) add_class(std::nullopt);
  if (!kinds.empty()) space();
  for (const RateKind kind : kinds) {
    const bool unsigned_one = kind == RateKind::undetermined && diagram_.has_krein;
    out.push_back(fmt::format("keyentry with lines lc rgb '{}' lw {} title '{}'",
                              style(kind).colour, style(kind).width,
                              unsigned_one ? "frequency, Krein 0" : style(kind).title));
  }
  if (!events.empty()) space();
  for (const std::string& event : events) {
    out.push_back(fmt::format("keyentry with points pt {} ps 0.8 lc rgb 'black' title {}",
                              point_type(event), in_gnuplot_quotes(event)));
  }
  if (diagram_.tables.size() > 1) {
    space();
    for (std::size_t k = 0; k < diagram_.tables.size(); ++k) {
      out.push_back(fmt::format("keyentry with lines lt nodraw title {}",
                                in_gnuplot_quotes(table_name(diagram_, k))));
    }
  }
  return out;
}

void Script::curve_panel(const DiagramPanel& panel, bool names_abscissa) {
  std::vector<std::string> items;
  std::size_t number = 0;
  for (const PictureCurve& each : panel.curves) {
    if (each.strokes.empty()) continue;
    const std::string name =
        fmt::format("curve_{}_{}_{}", number++, each.series, style(each.verdict).name);
    strokes(name, each.strokes, panel, false);
    items.push_back(fmt::format("${} with lines lc rgb '{}' lw {} notitle", name,
                                colour_of(each.series),
                                style(each.verdict).width + width_of_lower * each.lower));
  }
  for (std::size_t series = 0; series < picture_.series.size(); ++series) {
    std::vector<PagePoint> dots;
    for (const PictureDot& dot : panel.dots)
      if (dot.series == series) dots.push_back(dot.at);
    if (dots.empty()) continue;
    const std::string name = fmt::format("dots_{}", series);
    points(name, dots, panel, false);
    items.push_back(
        fmt::format("${} with points pt 7 ps 0.6 lc rgb '{}' notitle", name, colour_of(series)));
  }
  std::set<std::string> events;
  for (const PictureMark& mark : panel.marks) events.insert(mark.event);
  number = 0;
  for (const std::string& event : events) {
    std::vector<PagePoint> marks;
    for (const PictureMark& mark : panel.marks)
      if (mark.event == event) marks.push_back(mark.at);
    const std::string name = fmt::format("event_{}", number++);
    points(name, marks, panel, false);
    items.push_back(fmt::format("${} with points pt {} ps {} lc rgb 'black' notitle", name,
                                point_type(event), picture_.panels.size() > 1 ? 0.6 : 0.75));
  }
  begin_panel(panel, false, names_abscissa);
  for (const PictureLabel& label : panel.labels) {
    line("set label {} at {} center front boxed font ',11'", in_gnuplot_quotes(label.text),
         on_page(picture_.size, panel.area.left + label.at.x, panel.area.bottom + label.at.y));
  }
  line("unset key");
  plot(items);
}

void Script::rate_panel(const DiagramPanel& panel) {
  std::vector<std::string> items;
  for (const PictureRates& each : panel.rates) {
    const RateStyle& look = style(each.kind);
    const std::string name = fmt::format("rates_{}", look.name);
    strokes(name, each.strokes, panel, true);
    points("dots_of_" + name, each.dots, panel, true);
    if (!each.strokes.empty())
      items.push_back(
          fmt::format("${} with lines lc rgb '{}' lw {} notitle", name, look.colour, look.width));
    if (!each.dots.empty())
      items.push_back(fmt::format("$dots_of_{} with points pt 7 ps 0.6 lc rgb '{}' notitle", name,
                                  look.colour));
  }
  begin_panel(panel, true, true);
  line("unset key");
  plot(items);
}

/// A plot of its own, over the whole page: gnuplot leaves out entries beyond the height of a plot.
void Script::draw_legend(ImageFormat format) {
  line("unset label\nunset arrow\nunset border\nunset tics\nunset logscale");
  text_ += panel_margins(picture_.size, {0.0, picture_.size.width, 0.0, picture_.size.height});
  line("set xrange [0:1]\nset yrange [0:1]");
  line("set key at {} left top Left reverse samplen 2.6 spacing {:.3g} font ',12'",
       on_page(picture_.size, picture_.legend_left, picture_.panels.front().area.top + 6.0),
       key_spacing(format, page::legend_line));
  plot(legend());
}

std::string Script::write(ImageFormat format, std::string_view title) {
  text_ += page_head(format, title, picture_.size);
  line("set multiplot");
  line("set border 3 lw 0.8");
  line("set tics nomirror font ',12'");
  line("set format y '%g'");
  line("set style textbox opaque fillcolor rgb 'white' noborder margins 0.4,0.4");
  const bool stacked = has_rates(diagram_) && picture_.panels.size() == 1;
  for (const DiagramPanel& panel : picture_.panels) {
    curve_panel(panel, !stacked);
    if (has_rates(diagram_)) rate_panel(panel);
  }
  draw_legend(format);
  line("unset multiplot");
  return std::move(text_);
}

}  // namespace

std::optional<ImageFormat> image_format(std::string_view extension) {
  const auto at = std::ranges::find(image_extensions, extension);
  if (at == image_extensions.end()) return std::nullopt;
  return static_cast<ImageFormat>(at - image_extensions.begin());
}

double key_spacing(ImageFormat format, double line) {
  constexpr double line_of_svg = 18.0;
  constexpr double line_of_others = 13.95;
  return line / (format == ImageFormat::svg ? line_of_svg : line_of_others);
}

std::string page_head(ImageFormat format, std::string_view title, const PageSize& size) {
  std::string terminal;
  switch (format) {
    case ImageFormat::svg:
      terminal = fmt::format(
          "svg noenhanced size {:.0f},{:.0f} fixed font 'sans-serif,13' background '#ffffff'",
          size.width, size.height);
      break;
    case ImageFormat::png:
      terminal = fmt::format(
          "pngcairo noenhanced size {:.0f},{:.0f} font 'sans,13' fontscale 1.5 linewidth 2 "
          "pointscale 2.2 dashlength 1.6",
          2.0 * size.width, 2.0 * size.height);
      break;
    case ImageFormat::pdf:
      terminal = fmt::format(
          "pdfcairo noenhanced size {:.4g}in,{:.4g}in font 'sans,13' fontscale 0.55 linewidth 1.6 "
          "pointscale 0.8 dashlength 1.3",
          size.width / 100.0, size.height / 100.0);
      break;
  }
  std::string out = fmt::format(
      "# gnuplot draws this to its standard output: gnuplot SCRIPT > IMAGE\n"
      "set terminal {}\nset encoding utf8\n",
      terminal);
  if (title.empty()) return out;
  constexpr double largest = 15.0;
  const double fitting = size.width / 10.0;  // characters, in the largest font
  const double font = largest * std::min(1.0, fitting / static_cast<double>(title.size()));
  return out + fmt::format("set label {} at {} center font ',{:.1f}'\n", in_gnuplot_quotes(title),
                           on_page(size, 0.5 * size.width,
                                   size.height - page::margin - 0.3 * page::title_height),
                           font);
}

std::string gnuplot_script(const Diagram& diagram, ImageFormat format, std::string_view title,
                           const PageChoice& choice) {
  return Script(diagram, choice).write(format, title);
}

}  // namespace stationary
