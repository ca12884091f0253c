#include "solver/program/plot/plot_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace stationary {
namespace {

constexpr double panel_gap = 16.0;
constexpr double lower_share = 0.36;
constexpr double label_pitch = 14.0;
constexpr double character_width = 6.2;  // of a label, about
constexpr std::size_t longest_label = 24;
constexpr double narrow = 1e-4;  ///< range of the stretches, of themselves
constexpr double largest_linear_ratio = 30.0;

/// Of the finite values; low > high where there are none.
struct Extent : AxisRange {
  Extent()
      : AxisRange{std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()} {}
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// With room at both ends; about a single value, or what rounding leaves of one, an interval.
AxisRange widened(const AxisRange& range, double fraction) {
  const double width = range.high - range.low;
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  constexpr double least = 1e-12;  // relative: ticks closer than this are written alike
  if (width > least * size) return {range.low - fraction * width, range.high + fraction * width};
  const double half = size > 0.0 ? 0.05 * size : 1.0;
  return {range.low - half, range.high + half};
}

/// The rate above which less than `share` of the curves' way in the parameter lies: where a stretch
/// escapes rates grow beyond bounds over next to no range, and would leave the rest on the axis.
double largest_seen(const Diagram& diagram, double share) {
  std::vector<std::pair<double, double>> rates;  // and the way each stands for
  double all = 0.0;
  for (std::size_t k = 0; k < diagram.points.size(); ++k) {
    const DiagramPoint& p = diagram.points[k];
    Extent own;
    for (const double f : p.frequency) own.add(f);
    own.add(p.growth);
    if (!(own.high >= own.low)) continue;
    const bool goes_on =
        k + 1 < diagram.points.size() && !std::ranges::binary_search(diagram.pieces, k + 1);
    const double width = goes_on ? std::abs(diagram.points[k + 1].parameter - p.parameter) : 0.0;
    rates.emplace_back(own.high, std::isfinite(width) ? width : 0.0);
    all += rates.back().second;
  }
  std::ranges::sort(rates, std::greater<>{});
  double left = share * all;
  for (const auto& [rate, width] : rates) {
    left -= width;
    if (left < 0.0) return rate;
  }
  return rates.empty() ? 0.0 : rates.front().first;
}

}  // namespace

PlotPage::PlotPage(const Diagram& diagram) {
  Extent all_parameters;
  Extent all_stretches;
  Extent all_rates;
  for (const DiagramPoint& p : diagram.points) {
    all_parameters.add(p.parameter);
    for (const double s : p.stretch) all_stretches.add(s);
    for (const double f : p.frequency) all_rates.add(f);
    all_rates.add(p.growth);
  }
  parameters = widened(all_parameters, 0.02);
  constexpr double out_of_proportion = 2.0;
  const double seen = largest_seen(diagram, 0.02);
  if (all_rates.high > out_of_proportion * seen && seen > 0.0) all_rates.high = seen;
  rates = {0.0, all_rates.high > 0.0 ? 1.05 * all_rates.high : 1.0};
  logarithmic =
      all_stretches.low > 0.0 && all_stretches.high / all_stretches.low > largest_linear_ratio;
  if (logarithmic) {
    const double room = std::pow(all_stretches.high / all_stretches.low, 0.04);
    stretches = {all_stretches.low / room, all_stretches.high * room};
  } else {
    const double range = all_stretches.high - all_stretches.low;
    if (range > 0.0 && range < narrow * all_stretches.high) {
      const double unit = std::pow(10.0, std::ceil(std::log10(range)));
      stretch_base = unit * std::round(all_stretches.low / unit);
    }
    stretches = widened(all_stretches, 0.05);
    stretches = {stretches.low - stretch_base, stretches.high - stretch_base};
  }

  const double per_unit = (right - left) / (parameters.high - parameters.low);
  std::vector<NamedPlace> named;
  for (const DiagramEvent& event : diagram.events) {
    const double at = diagram.points[event.point].parameter;
    if (is_marked(event.name) && std::isfinite(at))
      named.push_back({event.name, left + (at - parameters.low) * per_unit});
  }
  labels = event_labels(std::move(named), {left, right}, label_pitch);
  std::size_t longest = 0;
  for (EventLabel& label : labels) {
    if (label.count > 1) label.name = fmt::format("{} × {}", label.count, label.name);
    longest = std::max(longest, label.name.size());
  }
  if (longest > 0) {
    upper_top -=
        leader_height + character_width * static_cast<double>(std::min(longest, longest_label));
  }
  if (diagram.has_spectrum) {
    lower_top = bottom + lower_share * (upper_top - bottom);
    upper_bottom = lower_top + panel_gap;
  }
}

double PlotPage::parameter_at(double place) const {
  return parameters.low + (place - left) / (right - left) * (parameters.high - parameters.low);
}

}  // namespace stationary
