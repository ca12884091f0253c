#include "solver/program/plot/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "solver/program/plot/diagram_lines.hpp"
#include "solver/program/plot/gnuplot.hpp"
#include "solver/program/plot/plot_page.hpp"
#include "solver/program/plot/plot_style.hpp"

namespace stationary {
namespace {

/// By ImageFormat.
constexpr std::string_view terminals[] = {
    "svg noenhanced size 800,600 dynamic font 'sans-serif,13' background '#ffffff'",
    "pngcairo noenhanced size 1600,1200 font 'sans,13' fontscale 1.5 linewidth 2 pointscale 2.2 "
    "dashlength 1.6",
    "pdfcairo noenhanced size 8in,6in font 'sans,13' fontscale 0.55 linewidth 1.6 pointscale 0.8 "
    "dashlength 1.3"};

class Script {
 public:
  explicit Script(const Diagram& diagram) : diagram_(diagram), page_(diagram) {}
  std::string write(ImageFormat format, std::string_view title);

 private:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> form, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }
  void stretch_data();
  void stretch_row(std::size_t point);
  void event_data();
  void rate_row(const DiagramLine& line_of, std::size_t at);
  void rate_data();
  void begin_panel(double from, double to, std::string_view ordinate);
  void label_events();
  void stretch_panel();
  void spectrum_panel();
  void plot(const std::vector<std::string>& items);

  const Diagram& diagram_;
  PlotPage page_;
  std::set<std::string> events_;                     ///< names that are marked
  std::set<std::optional<StabilityClass>> classes_;  ///< of lines and dots
  std::string text_;
};

void Script::stretch_row(std::size_t point) {
  const DiagramPoint& p = diagram_.points[point];
  line("{} {} {} {}", p.parameter, p.stretch[0], p.stretch[1], p.stretch[2]);
}

/// One block a class, $lines_stable and so on, its lines apart by empty lines; dots for pieces of
/// one point.
void Script::stretch_data() {
  const std::vector<DiagramLine> lines = stretch_lines(diagram_, page_.parameters);
  for (const DiagramLine& each : lines) classes_.insert(each.verdict);
  for (const auto& verdict : classes_) {
    for (const bool dots : {false, true}) {
      line("${}_{} << END_OF_DATA", dots ? "dots" : "lines", style(verdict).name);
      for (const DiagramLine& each : lines) {
        if (each.verdict != verdict || (each.points.size() == 1) != dots) continue;
        for (const std::size_t point : each.points) stretch_row(point);
        line("");
      }
      line("END_OF_DATA");
    }
  }
}

void Script::event_data() {
  for (const DiagramEvent& event : diagram_.events)
    if (is_marked(event.name)) events_.insert(event.name);
  std::size_t number = 0;
  for (const std::string& name : events_) {
    line("$event_{} << END_OF_DATA", number++);
    for (const DiagramEvent& event : diagram_.events)
      if (event.name == name) stretch_row(event.point);
    line("END_OF_DATA");
  }
}

/// A point of $rates_...: the parameter, the frequencies, the growth rate. Zero rates are drawn
/// only beside others: a line comes down to the axis but does not run in it.
void Script::rate_row(const DiagramLine& line_of, std::size_t at) {
  const auto rate = [&](std::size_t place, std::size_t k) {
    const DiagramPoint& p = diagram_.points[line_of.points[place]];
    return k < mode_count ? p.frequency[k] : p.growth;
  };
  std::string row = fmt::format("{}", diagram_.points[line_of.points[at]].parameter);
  for (std::size_t k = 0; k <= mode_count; ++k) {
    const bool is_seen = rate(at, k) > 0.0 || (at > 0 && rate(at - 1, k) > 0.0) ||
                         (at + 1 < line_of.points.size() && rate(at + 1, k) > 0.0);
    fmt::format_to(std::back_inserter(row), " {}",
                   is_seen ? rate(at, k) : std::numeric_limits<double>::quiet_NaN());
  }
  line("{}", row);
}

void Script::rate_data() {
  const std::vector<DiagramLine> lines = spectrum_lines(diagram_, page_.parameters);
  for (const bool dots : {false, true}) {
    line("$rates_{} << END_OF_DATA", dots ? "dots" : "lines");
    for (const DiagramLine& each : lines) {
      if ((each.points.size() == 1) != dots) continue;
      for (std::size_t at = 0; at < each.points.size(); ++at) rate_row(each, at);
      line("");
    }
    line("END_OF_DATA");
  }
}

/// Its edges, the line that leads each event through it, and the name of its ordinate: a label
/// instead of gnuplot's own, whose distance from the axis depends on the numbers there.
void Script::begin_panel(double from, double to, std::string_view ordinate) {
  line("set bmargin at screen {}", from / PlotPage::height);
  line("set tmargin at screen {}", to / PlotPage::height);
  for (const EventLabel& label : page_.labels) {
    const double at = page_.parameter_at(label.anchor);
    line("set arrow from first {}, graph 0 to first {}, graph 1 nohead back {} dt (2,3)", at, at,
         leader_style);
  }
  line("set label '{}' at {} center rotate by 90", ordinate,
       on_page(PlotPage::margin, 0.5 * (from + to)));
}

void Script::label_events() {
  for (const EventLabel& label : page_.labels) {
    const double text_bottom = page_.upper_top + PlotPage::leader_height;
    constexpr double gap = 3.0;
    line("set arrow from {} to {} nohead {} dt solid", on_page(label.anchor, page_.upper_top),
         on_page(label.place, text_bottom - gap), leader_style);
    line("set label {} at {} left rotate by 90 font ',11'", in_gnuplot_quotes(label.name),
         on_page(label.place, text_bottom));
  }
}

void Script::plot(const std::vector<std::string>& items) {
  line("plot \\");
  for (std::size_t k = 0; k < items.size(); ++k)
    line("  {}{}", items[k], k + 1 < items.size() ? ", \\" : "");
}

void Script::stretch_panel() {
  const double base = page_.stretch_base;
  begin_panel(page_.upper_bottom, page_.upper_top,
              base == 0.0 ? "principal stretch" : fmt::format("principal stretch less {}", base));
  const auto ordinate = [&](std::size_t k) {
    return base == 0.0 ? fmt::format("{}", k + 2) : fmt::format("(${} - {})", k + 2, base);
  };
  label_events();
  if (page_.logarithmic) line("set logscale y");
  line("set yrange [{}:{}]", page_.stretches.low, page_.stretches.high);
  std::vector<std::string> items;
  for (const auto& verdict : classes_) {
    for (std::size_t k = 0; k < stretch_styles.size(); ++k) {
      if (!diagram_.has_stretch[k]) continue;
      const std::string_view colour = stretch_styles[k].colour;
      items.push_back(fmt::format("$lines_{} using 1:{} with lines lc rgb '{}' {} notitle",
                                  style(verdict).name, ordinate(k), colour, style(verdict).line));
      items.push_back(fmt::format("$dots_{} using 1:{} with points pt 7 ps 0.6 lc rgb '{}' notitle",
                                  style(verdict).name, ordinate(k), colour));
    }
  }
  std::size_t number = 0;
  for (const std::string& name : events_) {
    for (std::size_t k = 0; k < stretch_styles.size(); ++k) {
      if (!diagram_.has_stretch[k]) continue;
      items.push_back(
          fmt::format("$event_{} using 1:{} with points pt {} ps 0.7 lc rgb 'black' notitle",
                      number, ordinate(k), point_type(name)));
    }
    ++number;
  }
  for (std::size_t k = 0; k < stretch_styles.size(); ++k) {
    if (!diagram_.has_stretch[k]) continue;
    items.push_back(fmt::format("keyentry with lines lc rgb '{}' lw 2.8 title '{}'",
                                stretch_styles[k].colour, stretch_styles[k].symbol));
  }
  if (diagram_.has_classes) items.emplace_back("keyentry with lines lt nodraw title ' '");
  for (const auto& verdict : classes_) {
    if (!verdict) continue;
    items.push_back(fmt::format("keyentry with lines lc rgb '{}' {} title '{}'", class_key_colour,
                                style(verdict).line, style(verdict).name));
  }
  plot(items);
}

void Script::spectrum_panel() {
  line("unset label");
  line("unset arrow");
  begin_panel(PlotPage::bottom, page_.lower_top, "rate");
  line("unset logscale y");
  line("set yrange [{}:{}]", page_.rates.low, page_.rates.high);
  std::vector<std::string> items;
  const auto draw = [&](int column, const RateStyle& style) {
    items.push_back(fmt::format("$rates_lines using 1:{} with lines lc rgb '{}' {} notitle", column,
                                style.colour, style.line));
    items.push_back(
        fmt::format("$rates_dots using 1:{} with points pt 7 ps 0.6 lc rgb '{}' notitle", column,
                    style.colour));
  };
  const auto name = [&](std::string_view title, const RateStyle& style) {
    items.push_back(fmt::format("keyentry with lines lc rgb '{}' {} title '{}'", style.colour,
                                style.line, title));
  };
  for (int k = 0; k < mode_count; ++k) draw(k + 2, frequency_style);
  draw(mode_count + 2, growth_style);
  name("frequency", frequency_style);
  const bool grows =
      std::ranges::any_of(diagram_.points, [](const DiagramPoint& p) { return p.growth > 0.0; });
  if (grows) name("growth", growth_style);
  plot(items);
}

std::string Script::write(ImageFormat format, std::string_view title) {
  text_ += page_head(format, title);
  stretch_data();
  event_data();
  if (diagram_.has_spectrum) rate_data();
  line("set multiplot");
  line("set border 3 lw 0.8");
  line("set tics nomirror font ',12'");
  line("set format y '%g'");
  line("set lmargin at screen {}", PlotPage::left / PlotPage::width);
  line("set rmargin at screen {}", PlotPage::right / PlotPage::width);
  line("set key at graph 1.03, graph 1.0 left top Left reverse samplen 2.2 spacing 1.2 font ',12'");
  line("set xrange [{}:{}]", page_.parameters.low, page_.parameters.high);
  const auto name_parameter = [&] {
    line("set xlabel {} offset 0,0.4", in_gnuplot_quotes(diagram_.parameter));
  };
  if (diagram_.has_spectrum) {
    line("set format x ''");
    stretch_panel();
    line("set format x '%g'");
    name_parameter();
    spectrum_panel();
  } else {
    line("set format x '%g'");
    name_parameter();
    stretch_panel();
  }
  line("unset multiplot");
  return std::move(text_);
}

}  // namespace

std::optional<ImageFormat> image_format(std::string_view extension) {
  const auto at = std::ranges::find(image_extensions, extension);
  if (at == image_extensions.end()) return std::nullopt;
  return static_cast<ImageFormat>(at - image_extensions.begin());
}

std::string on_page(double x, double y) {
  return fmt::format("screen {}, screen {}", x / PlotPage::width, y / PlotPage::height);
}

std::string page_head(ImageFormat format, std::string_view title) {
  std::string out = fmt::format("set terminal {}\nset encoding utf8\n",
                                terminals[static_cast<std::size_t>(format)]);
  if (title.empty()) return out;
  constexpr double largest = 15.0;
  constexpr double fitting = 80.0;  // characters, in the largest font
  const double size = largest * std::min(1.0, fitting / static_cast<double>(title.size()));
  return out + fmt::format("set label {} at {} center font ',{:.1f}'\n", in_gnuplot_quotes(title),
                           on_page(0.5 * PlotPage::width, PlotPage::height - PlotPage::margin -
                                                              0.3 * PlotPage::title_height),
                           size);
}

std::string gnuplot_script(const Diagram& diagram, ImageFormat format, std::string_view title) {
  return Script(diagram).write(format, title);
}

}  // namespace stationary
