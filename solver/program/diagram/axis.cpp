#include "solver/program/diagram/axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_normal = std::numeric_limits<double>::min();

/// Of the finite values; low > high where there are none.
struct Extent : AxisRange {
  Extent() : AxisRange{infinity, -infinity} {}
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void add(const AxisRange& range) {
    add(range.low);
    add(range.high);
  }
  bool empty() const { return low > high; }
};

double way_of(const WeightedCurve& curve) {
  double out = 0.0;
  for (const WeightedValue& v : curve)
    if (std::isfinite(v.value)) out += v.weight;
  return out;
}

/// What a curve stays in but for a share of its way at either end.
AxisRange core_of(WeightedCurve curve, double share_below, double share_above) {
  std::erase_if(curve, [](const WeightedValue& v) { return !std::isfinite(v.value); });
  if (curve.empty()) return {infinity, -infinity};
  double all = way_of(curve);
  if (!(all > 0.0) || !std::isfinite(all)) {
    for (WeightedValue& v : curve) v.weight = 1.0;
    all = static_cast<double>(curve.size());
  }
  std::ranges::sort(curve, {}, &WeightedValue::value);
  double sum = 0.0;
  AxisRange out{curve.front().value, curve.back().value};
  bool below = true;
  for (const WeightedValue& v : curve) {
    sum += v.weight;
    if (below && sum >= share_below * all) out.low = v.value, below = false;
    if (sum >= (1.0 - share_above) * all) {
      out.high = v.value;
      break;
    }
  }
  return out;
}

Extent extent_of(const std::vector<WeightedCurve>& curves) {
  Extent out;
  for (const WeightedCurve& curve : curves)
    for (const WeightedValue& v : curve) out.add(v.value);
  return out;
}

/// With room at both ends; about a single value, or what rounding leaves of one, an interval.
AxisRange widened(const AxisRange& range, double fraction) {
  const double width = range.high - range.low;
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  constexpr double least = 1e-12;  // relative: ticks closer than this are written alike
  if (width > least * size) return {range.low - fraction * width, range.high + fraction * width};
  const double half = size > 0.0 ? std::max(0.05 * size, least_normal) : 1.0;
  return {range.low - half, range.high + half};
}

constexpr double room = 0.04;          ///< between the curves and the ends of an axis
constexpr double most_of_core = 2.3;   ///< beyond so many times the core it is cut
constexpr double beyond_core = 0.5;    ///< what is left of it there, of the core
constexpr double linear_ratio = 12.0;  ///< of a core

}  // namespace

AxisRange drawable(const AxisRange& range, bool logarithmic) {
  const double least = logarithmic ? least_normal : -largest_drawn;
  const double next = logarithmic ? 2.0 * least : 0.5 * least;
  return {std::clamp(range.low, least, 0.5 * largest_drawn),
          std::clamp(range.high, next, largest_drawn)};
}

double Axis::place(double value) const {
  if (!logarithmic) return (value - range.low) / (range.high - range.low);
  return (log(value) - log(range.low)) / (log(range.high) - log(range.low));
}

double Axis::value(double place) const {
  if (!logarithmic) return range.low + place * (range.high - range.low);
  return pow(range.low, 1.0 - place) * pow(range.high, place);
}

Axis fitted_axis(const std::vector<WeightedCurve>& curves) {
  const Extent all = extent_of(curves);
  if (all.empty()) return {};
  double longest = 0.0;
  for (const WeightedCurve& curve : curves) longest = std::max(longest, way_of(curve));
  Extent core;
  for (const WeightedCurve& curve : curves) {
    const double shortness = longest > 0.0 ? 1.0 - way_of(curve) / longest : 0.0;
    const double share = 0.02 + 0.18 * shortness * shortness;
    core.add(core_of(curve, share, share));
  }
  Axis out;
  out.logarithmic = all.low > 0.0 && core.high / core.low > linear_ratio;
  const auto scaled = [&](double value) { return out.logarithmic ? log(value) : value; };
  const AxisRange full{scaled(all.low), scaled(all.high)};
  AxisRange shown{scaled(core.low), scaled(core.high)};
  const double least = 0.05 * std::max(std::abs(shown.low), std::abs(shown.high));
  const double size = std::max(shown.high - shown.low, std::min(full.high - full.low, least));
  const bool cut = full.high - full.low > most_of_core * size;
  const bool cut_above = cut && full.high - shown.high > beyond_core * size;
  const bool cut_below = cut && shown.low - full.low > beyond_core * size;
  shown.high = cut_above ? shown.high + beyond_core * size : full.high;
  shown.low = cut_below ? shown.low - beyond_core * size : full.low;
  const AxisRange wide = widened(shown, room);
  if (!cut_above) shown.high = wide.high;
  if (!cut_below) shown.low = wide.low;
  // A stretch is positive: the picture ends there.
  if (!out.logarithmic && all.low > 0.0 && shown.low < 0.0) shown.low = 0.0;
  const auto back = [&](double value) { return out.logarithmic ? exp(value) : value; };
  out.range = drawable({back(shown.low), back(shown.high)}, out.logarithmic);
  return out;
}

Axis fitted_rate_axis(const std::vector<WeightedCurve>& curves) {
  std::vector<AxisRange> cores;
  double longest = 0.0;
  for (const WeightedCurve& curve : curves) longest = std::max(longest, way_of(curve));
  constexpr double short_way = 0.1;  // such a curve does not decide
  for (const WeightedCurve& curve : curves) {
    const AxisRange core = core_of(curve, 0.2, 0.1);
    if (core.high > 0.0 && std::isfinite(core.high) && way_of(curve) >= short_way * longest)
      cores.push_back(core);
  }
  const Extent all = extent_of(curves);
  const auto from_zero = [](double high) { return Axis{drawable({0.0, high}, false), false}; };
  if (cores.empty()) return from_zero(all.high > 0.0 ? (1.0 + room) * all.high : 1.0);
  std::ranges::sort(cores, {}, &AxisRange::high);
  constexpr double hidden = 15.0;
  constexpr double outgrown = 5.0;
  double highest = cores.back().high;
  bool flat = false;  // a curve would lie on the axis
  for (std::size_t k = 1; k < cores.size(); ++k) {
    const double below = cores[k - 1].high;
    // One that begins among the others and outgrows them is cut off.
    const bool runs_off = k + 1 == cores.size() && cores[k].low < 2.0 * below;
    if (runs_off && cores[k].high > outgrown * below) {
      highest = 1.5 * below;
    } else if (cores[k].high > hidden * below) {
      flat = true;
    }
  }
  if (!flat) {
    const bool cut = all.high > most_of_core * highest;
    return from_zero(cut ? (1.0 + beyond_core) * highest : (1.0 + room) * all.high);
  }
  // Frequencies fall to zero: only so much of that is shown.
  constexpr double decades = 8.0;
  const double high = all.high < 30.0 * highest ? all.high : 3.0 * highest;
  const double least = std::max(0.1 * cores.front().high, high * pow(10.0, -decades));
  return {drawable({least, high * pow(high / least, room)}, true), true};
}

Axis whole_axis(const std::vector<WeightedCurve>& curves) {
  const Extent all = extent_of(curves);
  return all.empty() ? Axis{} : Axis{drawable(widened(all, 0.02), false), false};
}

Axis asked_axis(const AxisRange& range, bool logarithmic) {
  return {range, logarithmic && range.low >= least_normal};
}

double base_of(const AxisRange& range) {
  constexpr double narrow = 1e-4;  // of the numbers themselves
  const double width = range.high - range.low;
  if (!(width > 0.0 && width < narrow * std::abs(range.high))) return 0.0;
  const double decades = std::ceil(log10(width));
  const double unit = pow(10.0, std::abs(decades));
  // A division by a power of ten leaves the nearest double to a decimal.
  return decades < 0.0 ? std::round(range.low * unit) / unit : unit * std::round(range.low / unit);
}

}  // namespace stationary
