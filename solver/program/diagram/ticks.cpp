#include "solver/program/diagram/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

constexpr double line_height = 15.0;     ///< of a number at a tick
constexpr double character_width = 7.2;  ///< likewise
constexpr double between_numbers = 5.0;  ///< beside one another
constexpr double widest_power = 45.0;    ///< "1e+100"

/// The digits at which a decade has ticks, from many to few.
constexpr std::array<std::array<bool, 9>, 4> digit_choices{
    {{true, true, true, true, true, true, true, true, true},
     {true, true, true, false, true, false, true, false, false},
     {true, true, false, false, true, false, false, false, false},
     {true, false, false, false, false, false, false, false, false}}};

/// Which of these an axis with room has.
std::size_t choice_of(double decades) {
  return decades < 0.7 ? 0 : decades < 1.3 ? 1 : decades < 2.5 ? 2 : 3;
}

/// 1, 2 or 5 times a power of ten.
struct Step {
  int digit;
  double power;

  double size() const { return digit * power; }
  Step next() const {
    if (digit == 5) return {1, 10.0 * power};
    return {digit == 1 ? 2 : 5, power};
  }
};

/// gnuplot's own for a range of this width (quantize_normal_tics).
Step own_step(double width) {
  const double power = pow(10.0, std::floor(log10(width)));
  const double leading = width / power;
  if (leading < 2.0) return {2, 0.1 * power};
  if (leading < 5.0) return {5, 0.1 * power};
  return {1, power};
}

double widest_number(const AxisRange& range, const Step& step) {
  constexpr int most = 20;  // more would be crowded
  const double first = std::ceil(range.low / step.size());
  std::size_t longest = 0;
  for (int k = 0; k < most && (first + k) * step.size() <= range.high; ++k)
    longest = std::max(longest, fmt::format("{:g}", (first + k) * step.size()).size());
  return character_width * static_cast<double>(longest);
}

}  // namespace

double most_ticks(double length, AxisWay way) {
  return length / (way == AxisWay::level ? widest_power : line_height);
}

std::string logarithmic_ticks(const AxisRange& asked, double most, bool decades) {
  if (!(asked.low > 0.0) || !(asked.high > asked.low)) return {};
  const AxisRange range = drawable(asked, true);
  const double first = log10(range.low);
  const double last = log10(range.high);
  const int stride =
      std::max(1, static_cast<int>(std::ceil((last - first) / std::clamp(most, 2.0, 7.0))));
  constexpr double rounding = 1e-9;
  std::string out;
  for (std::size_t choice = choice_of(last - first); choice < digit_choices.size(); ++choice) {
    out.clear();
    double count = 0.0;
    for (int power = static_cast<int>(std::floor(first)); power <= std::ceil(last); ++power) {
      if (power % stride != 0) continue;
      for (int digit = 1; digit < 10; ++digit) {
        const double at = power + log10(digit);
        if (!digit_choices[choice][static_cast<std::size_t>(digit - 1)] || at < first - rounding ||
            at > last + rounding)
          continue;
        ++count;
        fmt::format_to(std::back_inserter(out), "{}'{:g}' {:.12g}", out.empty() ? "" : ", ",
                       digit * pow(10.0, power), decades ? at : digit * pow(10.0, power));
      }
    }
    if (count <= most) break;
  }
  return out;
}

std::string linear_ticks(const AxisRange& range, double length, AxisWay way) {
  const double width = range.high - range.low;
  constexpr double least_width = 1e-300;  // of which the steps are normal numbers
  if (!(width > least_width)) return "autofreq";
  const Step own = own_step(width);
  const auto crowded = [&](const Step& step) {
    const double room = step.size() / width * length;
    return room <
           (way == AxisWay::upright ? line_height : widest_number(range, step) + between_numbers);
  };
  Step step = own;
  while (2.0 * step.size() < width && crowded(step)) step = step.next();
  return step.size() == own.size() ? "autofreq" : fmt::format("{:.12g}", step.size());
}

}  // namespace stationary
