// The root of a square system in extended precision, and how far the inputs' rounding moves it.
//
//   F(y; inputs) = 0,   unknowns y by their relative changes,
//
// Newton with F in pairs of doubles and its Jacobian from central differences of the same values,
// h = 2^-27:  their errors, h^2 of a third derivative and 2^-82/h of a value, are both at 2^-54.
// To first order the root moves by
//
//   |dy| <= 2^-53 sum over inputs |A^-1 dF/d ln input|   decimals, half a unit of each
//         + |A^-1| 2^-80 (size of F's terms)             F's own rounding
//
// with each input's own sign in all equations: what is common to them cancels. This is what an
// event asks, whose own equations are regular where the balance alone is not. Where |dy| is more
// than 2^-36, A is looked at as far away as twice that, and by how much it differs widens the bound.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "lib/matrix/scaled_rows.hpp"
#include "lib/number/double_double_functions.hpp"
#include "lib/number/first_order_bound_functions.hpp"

namespace stationary {

/// One of the inputs is larger by a relative amount; none where there is no such input.
struct InputChange {
  std::size_t input = std::numeric_limits<std::size_t>::max();
  double relative = 0.0;

  /// Input number k, of this value.
  DoubleDouble operator()(double value, std::size_t k) const {
    return k == input ? DoubleDouble(value) + two_product(value, relative) : DoubleDouble(value);
  }
  /// Of the inputs from number k on.
  InputChange from(std::size_t k) const {
    return input == InputChange().input || input < k ? InputChange()
                                                     : InputChange{input - k, relative};
  }
};

template <int N>
using ExtendedVector = std::array<DoubleDouble, static_cast<std::size_t>(N)>;

template <int N>
struct ExtendedRoot {
  ExtendedVector<N> y;
  std::array<double, static_cast<std::size_t>(N)> error;  ///< bounds, relative to each of y
};

/// System: dimension, inputs(), values(y, change) in extended precision, and conditioned(y, exact),
/// the same with its conditioning, the problem's numbers exact or inputs; has_decimals(), whether
/// there are others, written out in a formula, that are inputs in any case.
template <class System>
class ExtendedRootFinder {
 public:
  static constexpr int N = System::dimension;

  explicit ExtendedRootFinder(const System& system) : system_(&system) {}

  /// The root near y; nothing where the equations are singular there.
  std::optional<ExtendedRoot<N>> from(ExtendedVector<N> y) {
    constexpr int most = 16;
    double before = std::numeric_limits<double>::infinity();
    for (int k = 0; k < most; ++k) {
      linearize(y);
      const Numbers step = rows_.solve(leading(system_->values(y, {})));
      const double size = largest(step);
      if (!std::isfinite(size) || size > 0.3) return std::nullopt;
      if (size < 0x1p-45 && size >= 0.25 * before) return bounded(y, size);  // at rounding
      for (std::size_t i = 0; i < y.size(); ++i) y[i] = renormalized(y[i] - y[i] * step[i]);
      if (size < 0x1p-80) return bounded(y, size);
      before = size;
    }
    return std::nullopt;
  }

 private:
  using Numbers = typename ScaledRows<N>::Numbers;

  static Numbers leading(const ExtendedVector<N>& values) {
    Numbers out;
    for (std::size_t i = 0; i < values.size(); ++i) out[i] = double(values[i]);
    return out;
  }
  /// NaN where one is.
  static double largest(const Numbers& step) {
    double out = 0.0;
    for (const double each : step) {
      if (std::isnan(each)) return each;
      out = std::max(out, std::abs(each));
    }
    return out;
  }
  static Numbers difference(const ExtendedVector<N>& a, const ExtendedVector<N>& b) {
    Numbers out;
    for (std::size_t i = 0; i < a.size(); ++i) out[i] = double(a[i] - b[i]) / (2.0 * h);
    return out;
  }

  using Columns = std::array<Numbers, static_cast<std::size_t>(N)>;

  Columns columns_at(const ExtendedVector<N>& y) const {
    Columns columns;
    for (std::size_t k = 0; k < y.size(); ++k) {
      ExtendedVector<N> ahead = y;
      ExtendedVector<N> behind = y;
      ahead[k] = y[k] + h * y[k];
      behind[k] = y[k] - h * y[k];
      columns[k] = difference(system_->values(ahead, {}), system_->values(behind, {}));
    }
    return columns;
  }
  void linearize(const ExtendedVector<N>& y) { rows_.eliminate(columns_at(y)); }

  /// c: by how much of itself A differs within twice the error, to the first order; each unknown in
  /// units of its own error, |A^-1 dA| e <= c e. NaN where one is.
  double change_within(const ExtendedVector<N>& y, const Numbers& error) const {
    const Columns here = columns_at(y);
    Numbers sum{};
    for (std::size_t k = 0; k < y.size(); ++k) {
      Numbers most{};
      for (const double side : {-2.0, 2.0}) {
        ExtendedVector<N> aside = y;
        aside[k] = y[k] + side * error[k] * y[k];
        const Columns there = columns_at(aside);
        Numbers rows{};
        for (std::size_t j = 0; j < y.size(); ++j) {
          Numbers change;
          for (std::size_t i = 0; i < y.size(); ++i) change[i] = there[j][i] - here[j][i];
          const Numbers solved = rows_.solve(change);
          for (std::size_t i = 0; i < y.size(); ++i)
            rows[i] += std::abs(solved[i]) * (error[j] / error[i]);
        }
        for (std::size_t i = 0; i < y.size(); ++i)
          if (!(rows[i] <= most[i])) most[i] = rows[i];
      }
      for (std::size_t i = 0; i < y.size(); ++i) sum[i] += most[i];
    }
    return largest(sum);
  }

  std::optional<ExtendedRoot<N>> bounded(const ExtendedVector<N>& y, double last) {
    constexpr double rounding = 0x1p-80;
    constexpr double half_unit = 0x1p-53;
    std::array<Conditioned, static_cast<std::size_t>(N)> known;
    std::array<Conditioned, static_cast<std::size_t>(N)> rounded;
    for (std::size_t i = 0; i < y.size(); ++i) {
      known[i] = Conditioned(double(y[i]));
      rounded[i] = Conditioned::input(double(y[i]));
    }
    const auto sizes = system_->conditioned(rounded, false);
    Numbers spread;
    for (std::size_t i = 0; i < y.size(); ++i)
      spread[i] = rows_.scaled(i, rounding * sizes[i].condition);
    if (system_->has_decimals()) {
      const auto decimals = system_->conditioned(known, true);
      for (std::size_t i = 0; i < y.size(); ++i)
        spread[i] += rows_.scaled(i, half_unit * decimals[i].condition);
    }
    Numbers error = rows_.largest(spread);
    for (double& each : error) each += 2.0 * last + 0x1p-100;
    for (std::size_t k = 0; k < system_->inputs(); ++k) {
      const Numbers moved =
          rows_.solve(difference(system_->values(y, {k, h}), system_->values(y, {k, -h})));
      for (std::size_t i = 0; i < y.size(); ++i) error[i] += half_unit * std::abs(moved[i]);
    }
    // By Kantorovich: where A within twice the error differs by c < 1 of itself, the root is within
    // 2/(1 + sqrt(1 - c)) times the error; else nothing is told. What a last digit moves by less than
    // 2^-36 is farther than that from where A is singular: c is some second derivatives times |A^-1|
    // times the error, and the error 2^-53 |A^-1| or more.
    const double size = largest(error);
    double change = 4.0 * size + 0x1p59 * size * size;
    if (size > 0x1p-36) change = std::max(4.0 * size, change_within(y, error));
    if (!(change < 1.0)) return std::nullopt;
    ExtendedRoot<N> out{y, {}};
    for (std::size_t i = 0; i < y.size(); ++i)
      out.error[i] = error[i] * 2.0 / (1.0 + std::sqrt(1.0 - change));
    return out;
  }

  static constexpr double h = 0x1p-27;
  const System* system_;
  ScaledRows<N> rows_;
};

template <class System>
std::optional<ExtendedRoot<System::dimension>> extended_root(
    const System& system, const ExtendedVector<System::dimension>& y) {
  return ExtendedRootFinder<System>(system).from(y);
}

}  // namespace stationary
