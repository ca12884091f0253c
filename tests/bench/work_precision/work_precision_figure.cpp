#include "tests/bench/work_precision/work_precision_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "solver/program/diagram/diagram_lines.hpp"
#include "solver/program/plot/gnuplot.hpp"
#include "solver/program/table/atomic_file.hpp"

namespace stationary::bench {
namespace {

struct Mark {
  double error;
  double cost;
};

struct Line {
  std::string label;
  std::string colour;
  int point_type;
  std::vector<Mark> marks;  ///< by tolerance, the loosest first
  bool joined = true;
};

/// Okabe and Ito's colours; the library's own filled, peers open.
struct MethodStyle {
  const char* method;
  const char* label;
  const char* colour;
  int point_type;
};
constexpr MethodStyle method_styles[] = {
    {"sweep", "sweep", "#0072b2", 7},
    {"sweep-bounded", "sweep, error bound", "#0072b2", 5},
    {"sweep-certified", "sweep, certified", "#0072b2", 13},
    {"reduced-newton", "reduced Newton, in double", "#009e73", 7},
    {"reduced-corrected", "reduced Newton, corrected", "#0072b2", 9},
    {"solve", "solve (walk, Ceres)", "#0072b2", 7},
    {"solve-certified", "solve, certified", "#0072b2", 13},
    {"solve-newton", "solve, Newton", "#0072b2", 5},
    {"solve-nlopt", "NLopt, polished", "#cc79a7", 5},
    {"newton-4x4", "4×4 Newton", "#d55e00", 6},
    {"newton-4x4-last", "4×4 Newton, last point", "#d55e00", 4},
    {"tiny-solver", "TinySolver", "#e69f00", 8},
    {"tiny-solver-default", "TinySolver, its defaults", "#e69f00", 1},
    {"ceres", "ceres::Solve", "#cc79a7", 12},
    {"minpack-hybrj", "MINPACK hybrj", "#56b4e9", 10},
    {"scipy-hybr", "SciPy hybr", "#000000", 14},
    {"blocks", "blocks", "#0072b2", 7},
    {"general", "general path", "#009e73", 5},
    {"eigen-qr-11x11", "Eigen QR, 11×11", "#d55e00", 6},
    {"follow", "equilibria", "#0072b2", 7},
    {"follow-spectra", "with spectra", "#009e73", 5},
    {"auto", "AUTO-07p", "#d55e00", 6},
    {"auto-events", "AUTO-07p, its events", "#e69f00", 4}};

struct Panel {
  std::string title;
  std::string cost;
  AxisRange errors;
  AxisRange costs;
  std::vector<Line> lines;
};

using Cost = double (*)(const Measured&);
double item_seconds(const Measured& m) { return m.seconds; }
double all_seconds(const Measured& m) { return m.seconds * static_cast<double>(m.entry->items); }
double items(const Measured& m) { return static_cast<double>(m.entry->items); }

/// One line of all entries that `takes` takes.
template <class Takes>
Line line_of(const std::vector<Measured>& results, Cost cost, const Takes& takes) {
  struct Sum {
    double error = 0.0;
    double log_cost = 0.0;
    int count = 0;
  };
  std::map<double, Sum, std::greater<>> by_tolerance;
  for (const Measured& m : results) {
    if (!takes(*m.entry) || !(m.error_worst > 0.0) || !std::isfinite(m.error_worst)) continue;
    Sum& sum = by_tolerance[m.entry->tolerance.value_or(0.0)];
    sum.error = std::max(sum.error, m.error_worst);
    sum.log_cost += std::log(cost(m));
    ++sum.count;
  }
  Line out;
  for (const auto& [tolerance, sum] : by_tolerance)
    out.marks.push_back({sum.error, std::exp(sum.log_cost / sum.count)});
  return out;
}

/// Without tolerances: a mark of its own for every case.
Line marks_of(const std::vector<Measured>& results, const std::string& what, const char* method) {
  Line out;
  out.joined = false;
  for (const Measured& m : results) {
    if (m.entry->what == what && m.entry->method == method && m.error_worst > 0.0)
      out.marks.push_back({m.error_worst, m.seconds});
  }
  return out;
}

void add_methods(const std::vector<Measured>& results, const std::string& what, Cost cost,
                 std::span<const std::string_view> left_out, Panel& panel) {
  for (const MethodStyle& style : method_styles) {
    if (std::ranges::find(left_out, style.method) != left_out.end()) continue;
    Line line = what == "spectrum" ? marks_of(results, what, style.method)
                                   : line_of(results, cost, [&](const Entry& e) {
                                       return e.what == what && e.method == style.method;
                                     });
    if (line.marks.empty()) continue;
    line.label = style.label;
    line.colour = style.colour;
    line.point_type = style.point_type;
    panel.lines.push_back(line);
  }
}

void add_cases(const std::vector<Measured>& results, Panel& panel) {
  constexpr std::array<const char*, 6> colours{"#0072b2", "#56b4e9", "#d55e00",
                                               "#e69f00", "#009e73", "#cc79a7"};
  std::vector<std::pair<std::string, Branch>> cases;
  for (const Measured& m : results) {
    const std::pair at{m.entry->model, m.entry->branch};
    if (std::ranges::find(cases, at) == cases.end()) cases.push_back(at);
  }
  for (std::size_t k = 0; k < cases.size(); ++k) {
    Line line = line_of(results, items, [&](const Entry& e) {
      return e.what == "curve" && e.method == "follow" && e.model == cases[k].first &&
             e.branch == cases[k].second;
    });
    line.label = fmt::format("{} ({})", cases[k].first, name(cases[k].second));
    line.colour = colours[k % colours.size()];
    line.point_type = k % 2 == 0 ? 7 : 6;
    panel.lines.push_back(line);
  }
}

/// Room for the marks, and for the labels left of them.
void fit(Panel& panel) {
  AxisRange errors{1.0, 1e-300};
  AxisRange costs{1e300, 0.0};
  for (const Line& line : panel.lines) {
    for (const Mark& mark : line.marks) {
      errors = {std::min(errors.low, mark.error), std::max(errors.high, mark.error)};
      costs = {std::min(costs.low, mark.cost), std::max(costs.high, mark.cost)};
    }
  }
  const double decades = std::log10(errors.high / errors.low);
  constexpr double label_share = 0.47;
  constexpr double right_share = 0.05;
  const double width = decades / (1.0 - label_share - right_share);
  panel.errors = {errors.low * std::pow(10.0, -label_share * width),
                  errors.high * std::pow(10.0, right_share * width)};
  const double margin = std::pow(costs.high / costs.low, 0.07);
  panel.costs = {costs.low / margin, costs.high * margin};
}

/// Heights (0 to 1) of labels, in the order given, moved apart where they would meet.
std::vector<double> spread(std::vector<double> at, double pitch) {
  std::vector<std::size_t> order(at.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::sort(order, {}, [&](std::size_t k) { return at[k]; });
  for (int round = 0; round < 200; ++round) {
    for (std::size_t k = 1; k < order.size(); ++k) {
      double& low = at[order[k - 1]];
      double& high = at[order[k]];
      const double missing = pitch - (high - low);
      if (missing <= 0.0) continue;
      low -= 0.5 * missing;
      high += 0.5 * missing;
    }
    for (double& y : at) y = std::clamp(y, 0.5 * pitch, 1.0 - 0.5 * pitch);
  }
  return at;
}

/// Each label left of its line's leftmost mark, joined to it by a thin leader.
std::string labels(const Panel& panel) {
  const double log_low = std::log(panel.costs.low);
  const double log_range = std::log(panel.costs.high) - log_low;
  const double log_left = std::log(panel.errors.low);
  const double log_width = std::log(panel.errors.high) - log_left;
  const auto across = [&](double error) { return (std::log(error) - log_left) / log_width; };
  const auto up = [&](double cost) { return (std::log(cost) - log_low) / log_range; };
  std::vector<double> heights;
  std::vector<Mark> leftmost;
  for (const Line& line : panel.lines) {
    leftmost.push_back(*std::ranges::min_element(line.marks, {}, &Mark::error));
    heights.push_back(up(leftmost.back().cost));
  }
  heights = spread(heights, 0.072);
  double edge = 1.0;
  for (const Mark& mark : leftmost) edge = std::min(edge, across(mark.error));
  edge -= 0.07;
  std::string out = "unset label\nunset arrow\n";
  for (std::size_t k = 0; k < panel.lines.size(); ++k) {
    out += fmt::format("set label {} at graph {:.4f},{:.4f} right front tc rgb '{}'\n",
                       in_gnuplot_quotes(panel.lines[k].label), edge, heights[k],
                       panel.lines[k].colour);
    out += fmt::format(
        "set arrow from graph {:.4f},{:.4f} to graph {:.4f},{:.4f} nohead back lc rgb '#9ca3af' "
        "lw 0.7\n",
        edge + 0.01, heights[k], across(leftmost[k].error) - 0.012, up(leftmost[k].cost));
  }
  return out;
}

std::string panel_script(const Panel& panel, int number) {
  std::string out;
  for (std::size_t k = 0; k < panel.lines.size(); ++k) {
    out += fmt::format("$p{}l{} << EOD\n", number, k);
    for (const Mark& mark : panel.lines[k].marks)
      out += fmt::format("{} {}\n", mark.error, mark.cost);
    out += "EOD\n";
  }
  out += labels(panel);
  out += fmt::format("set title {}\nset ylabel {}\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
                     in_gnuplot_quotes(panel.title), in_gnuplot_quotes(panel.cost),
                     panel.errors.low, panel.errors.high, panel.costs.low, panel.costs.high);
  // Ticks only where marks can be.
  const int step = std::log10(panel.errors.high / panel.errors.low) > 14.0 ? 4 : 2;
  out += "set xtics (";
  bool first = true;
  double least = 1.0;
  for (const Line& line : panel.lines)
    for (const Mark& mark : line.marks) least = std::min(least, mark.error);
  for (int exponent = -16; exponent <= 0; exponent += step) {
    const double value = std::pow(10.0, exponent);
    if (value < 0.1 * least || value > panel.errors.high) continue;
    out += fmt::format("{}'10^{{{}}}' 1e{}", first ? "" : ", ", exponent, exponent);
    first = false;
  }
  out += ")\nplot ";
  for (std::size_t k = 0; k < panel.lines.size(); ++k) {
    const Line& line = panel.lines[k];
    out += fmt::format("{}$p{}l{} with {} lc rgb '{}' pt {} lw 1.6 notitle", k == 0 ? "" : ", ",
                       number, k, line.joined ? "linespoints" : "points", line.colour,
                       line.point_type);
  }
  return out + '\n';
}

std::vector<Panel> panels_of(const std::vector<Measured>& results) {
  // A Newton of its own before the correction is what the sweep has no need of.
  constexpr std::string_view in_the_table[] = {"reduced-corrected"};
  std::vector<Panel> out(6);
  out[0].title = "Equilibria, warm: a sweep over 1,000 ν";
  add_methods(results, "warm", item_seconds, in_the_table, out[0]);
  out[1].title = "Equilibria, warm: a sweep over 50 ν";
  add_methods(results, "warm-coarse", item_seconds, in_the_table, out[1]);
  out[2].title = "Equilibria, cold: from the rest state";
  add_methods(results, "cold", item_seconds, {}, out[2]);
  out[3].title = "Spectra: six cases, worst relative error of a Λ = s²";
  add_methods(results, "spectrum", item_seconds, {}, out[3]);
  out[4].title = "Curves: from rest to where they end, tolerance 10^{-3} … 10^{-13}";
  add_methods(results, "curve", all_seconds, {}, out[4]);
  out[5].title = "Curves: rows needed";
  add_cases(results, out[5]);
  for (std::size_t k = 0; k < out.size(); ++k) {
    out[k].cost = k < 3    ? "processor seconds a solution"
                  : k == 3 ? "processor seconds a spectrum"
                  : k == 4 ? "processor seconds a curve"
                           : "rows a curve";
    fit(out[k]);
  }
  return out;
}

}  // namespace

void draw_work_precision(const std::vector<Measured>& results, const std::filesystem::path& into) {
  const bool svg = into.extension() == ".svg";
  std::string script =
      svg ? "set terminal svg enhanced size 1180,1180 dynamic font 'sans-serif,12.5' background "
            "'#ffffff'\n"
          : "set terminal pngcairo enhanced size 1770,1770 font 'sans,12' fontscale 1.3 linewidth "
            "1.5 pointscale 1.5 background '#ffffff'\n";
  script +=
      "set encoding utf8\nset logscale xy\nset format y '10^{%L}'\nset border 3 lc rgb '#404040'\n"
      "set tics nomirror out scale 0.6\nset mxtics 1\nset mytics 1\n"
      "set grid ytics lc rgb '#e5e7eb' lw 0.8\nset key off\nset pointsize 1\n"
      "set xlabel 'worst relative error' offset 0,0.4\n"
      "set multiplot layout 3,2 margins 0.08,0.985,0.05,0.965 spacing 0.095,0.085\n";
  const std::vector<Panel> panels = panels_of(results);
  for (std::size_t k = 0; k < panels.size(); ++k) {
    if (k == 4) script += "set xlabel 'worst distance of the interpolated rows from the curve'\n";
    script += panel_script(panels[k], static_cast<int>(k));
  }
  script += "unset multiplot\n";
  AtomicFile file(into);
  file.write(run_gnuplot(script));
  file.commit();
}

}  // namespace stationary::bench
