// Affine forms: a number that depends on coordinates epsilon_j in [-1, 1],
//
//   y = c + sum_j s_j epsilon_j + r,   |r| <= radius,   and y in range besides,
//
// so that what two numbers have in common cancels in their difference, as in interval arithmetic it
// does not. exp and log take their Chebyshev line: slope m from the ends of the range, and an
// interval that holds f(y) - m y. Rounding errors go into the radius.
// Source: J. Stolfi, L. H. de Figueiredo, Self-Validated Numerical Methods (1997), chapter 3.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lib/number/interval.hpp"

namespace stationary {

template <int D>
struct AffineForm {
  double center = 0.0;
  std::array<double, D> slope{};
  double radius = 0.0;
  Interval range;

  /// c + half epsilon_j.
  static AffineForm coordinate(int j, const Interval& x) {
    AffineForm out;
    out.center = x.mid();
    const double half = above(std::max(x.hi - out.center, out.center - x.lo));
    out.slope[static_cast<std::size_t>(j)] = half;
    out.range = x;
    return out;
  }
  /// Of an interval that depends on nothing.
  static AffineForm constant(const Interval& x) {
    AffineForm out;
    out.center = x.mid();
    out.radius = above(std::max(x.hi - out.center, out.center - x.lo));
    out.range = x;
    return out;
  }

  bool bounded() const { return range.bounded() && std::isfinite(radius + center); }

  /// Sum of |s_j|.
  double spread() const {
    double out = 0.0;
    for (const double s : slope) out = above(out + std::abs(s));
    return out;
  }

  /// The range, narrowed to what the form allows.
  void narrow() {
    const double reach = above(spread() + radius);
    const Interval of_form = Interval::outward(center - reach, center + reach);
    if (of_form.apart_from(range)) return;  // by rounding alone: either holds
    range = common(range, of_form);
  }
};

/// What the roundings of a form's own numbers may amount to.
template <int D>
double rounding_of(const AffineForm<D>& x) {
  double size = std::abs(x.center);
  for (const double s : x.slope) size += std::abs(s);
  return above(0x1.0000000000004p-53 * size + 0x1p-1020);
}

template <int D>
AffineForm<D> operator+(const AffineForm<D>& x, const AffineForm<D>& y) {
  AffineForm<D> out;
  out.center = x.center + y.center;
  for (std::size_t j = 0; j < D; ++j) out.slope[j] = x.slope[j] + y.slope[j];
  out.radius = above(above(x.radius + y.radius) + rounding_of(out));
  out.range = x.range + y.range;
  out.narrow();
  return out;
}

template <int D>
AffineForm<D> operator+(const AffineForm<D>& x, const Interval& c) {
  AffineForm<D> out = x;
  const double middle = c.mid();
  out.center += middle;
  const double rest = above(std::max(c.hi - middle, middle - c.lo));
  out.radius = above(above(x.radius + rest) + rounding_of(out));
  out.range = x.range + c;
  out.narrow();
  return out;
}

template <int D>
AffineForm<D> operator*(const Interval& k, const AffineForm<D>& x) {
  AffineForm<D> out;
  const double middle = k.mid();
  const double rest = above(std::max(k.hi - middle, middle - k.lo));
  out.center = middle * x.center;
  for (std::size_t j = 0; j < D; ++j) out.slope[j] = middle * x.slope[j];
  const double size = above(above(std::abs(x.center) + x.spread()) + x.radius);
  out.radius = above(above(std::abs(middle) * x.radius) + above(rest * size));
  out.radius = above(out.radius + rounding_of(out));
  out.range = k * x.range;
  out.narrow();
  return out;
}

template <int D>
AffineForm<D> operator*(const AffineForm<D>& x, const AffineForm<D>& y) {
  AffineForm<D> out;
  out.center = x.center * y.center;
  for (std::size_t j = 0; j < D; ++j) out.slope[j] = x.center * y.slope[j] + x.slope[j] * y.center;
  const double of_x = above(x.spread() + x.radius);
  const double of_y = above(y.spread() + y.radius);
  const double linear =
      above(above(std::abs(x.center) * y.radius) + above(std::abs(y.center) * x.radius));
  out.radius = above(above(linear + above(of_x * of_y)) + 2.0 * rounding_of(out));
  // The slopes are sums of two products, each rounded.
  double products = 0.0;
  for (std::size_t j = 0; j < D; ++j)
    products += std::abs(x.center * y.slope[j]) + std::abs(x.slope[j] * y.center);
  out.radius = above(out.radius + above(0x1p-51 * products));
  out.range = x.range * y.range;
  out.narrow();
  return out;
}

/// A sum of forms, each times a number that lies within `rest` of `middle`; the roundings of all of
/// it are bounded once, by how many there were and what was added.
template <int D>
class AffineSum {
 public:
  void add(double middle, double rest, const AffineForm<D>& x) {
    center_ += middle * x.center;
    double size = std::abs(x.center);
    for (std::size_t j = 0; j < D; ++j) {
      slope_[j] += middle * x.slope[j];
      size += std::abs(x.slope[j]);
    }
    const double weight = std::abs(middle);
    radius_ += weight * x.radius + rest * (size + x.radius);
    size_ += weight * size;
    const double a = middle * x.range.lo;
    const double b = middle * x.range.hi;
    const double far = x.range.magnitude();
    lower_ += std::min(a, b) - rest * far;
    upper_ += std::max(a, b) + rest * far;
    far_ += weight * far;
    ++count_;
  }
  void add(const Interval& k, const AffineForm<D>& x) {
    const double middle = k.mid();
    add(middle, std::max(k.hi - middle, middle - k.lo), x);
  }

  bool empty() const { return count_ == 0; }
  AffineForm<D> form() const {
    const double unit = 0x1p-51 * (count_ + 4.0);
    AffineForm<D> out;
    out.center = center_;
    out.slope = slope_;
    out.radius = (radius_ + unit * size_) * (1.0 + unit) + 0x1p-1000;
    const double rounding = unit * (far_ + std::abs(lower_) + std::abs(upper_)) + 0x1p-1000;
    out.range = Interval(lower_ - rounding, upper_ + rounding);
    if (!std::isfinite(out.radius) || !out.range.bounded())
      return AffineForm<D>::constant(Interval::entire());
    out.narrow();
    return out;
  }

 private:
  double center_ = 0.0;
  std::array<double, D> slope_{};
  double radius_ = 0.0;
  double size_ = 0.0;
  double lower_ = 0.0;
  double upper_ = 0.0;
  double far_ = 0.0;
  int count_ = 0;
};

/// m x + rest, with a range that is known besides.
template <int D>
AffineForm<D> on_line(const AffineForm<D>& x, double m, const Interval& rest,
                      const Interval& range) {
  AffineForm<D> out;
  const double middle = rest.mid();
  out.center = m * x.center + middle;
  for (std::size_t j = 0; j < D; ++j) out.slope[j] = m * x.slope[j];
  const double of_rest = above(std::max(rest.hi - middle, middle - rest.lo));
  out.radius = above(above(std::abs(m) * x.radius) + of_rest);
  out.radius = above(out.radius + above(rounding_of(out) + 0x1p-52 * std::abs(m * x.center)));
  out.range = range;
  out.narrow();
  return out;
}

/// f(x) - m x for a convex f is largest at an end of the range, and least where f' = m.
template <int D>
AffineForm<D> exp(const AffineForm<D>& x) {
  const Interval& y = x.range;
  if (!x.bounded() || !(y.hi < 700.0)) return AffineForm<D>::constant(Interval::entire());
  // Below -699 nothing but its sign is told.
  constexpr double lowest = -699.0;
  const Interval at_low =
      y.lo > lowest ? exp_of_double(y.lo) : Interval(0.0, exp_of_double(lowest).hi);
  const Interval at_high = y.hi > lowest ? exp_of_double(y.hi) : at_low;
  const Interval range(at_low.lo, at_high.hi);
  const double m = y.hi > y.lo ? (at_high.mid() - at_low.mid()) / (y.hi - y.lo) : 0.0;
  if (!(m > 0x1p-1000)) return AffineForm<D>::constant(range);
  const Interval slope(m);
  const Interval ends = hull(at_low - slope * Interval(y.lo), at_high - slope * Interval(y.hi));
  const Interval least = slope - slope * log_of_double(m);
  return on_line(x, m, Interval(std::min(least.lo, ends.lo), ends.hi), range);
}

/// Likewise of a concave one, x > 0.
template <int D>
AffineForm<D> log(const AffineForm<D>& x) {
  const Interval& y = x.range;
  if (!x.bounded() || !(y.lo > 0x1p-1000)) return AffineForm<D>::constant(Interval::entire());
  const Interval at_low = log_of_double(y.lo);
  const Interval at_high = log_of_double(y.hi);
  const Interval range(at_low.lo, at_high.hi);
  const double m = y.hi > y.lo ? (at_high.mid() - at_low.mid()) / (y.hi - y.lo) : 0.0;
  if (!(m > 0x1p-1000)) return AffineForm<D>::constant(range);
  const Interval slope(m);
  const Interval ends = hull(at_low - slope * Interval(y.lo), at_high - slope * Interval(y.hi));
  const Interval most = -(log_of_double(m) + Interval(1.0));
  return on_line(x, m, Interval(ends.lo, std::max(most.hi, ends.lo)), range);
}

/// The part of [-1, 1]^D that is left of a box of coordinates.
template <int D>
struct AffineBox {
  std::array<Interval, D> epsilon;
  bool empty = false;

  static AffineBox whole() {
    AffineBox out;
    out.epsilon.fill(Interval(-1.0, 1.0));
    return out;
  }
  static AffineBox nothing() {
    AffineBox out = whole();
    out.empty = true;
    return out;
  }
  void join(const AffineBox& other) {
    if (other.empty) return;
    if (empty) {
      *this = other;
    } else {
      for (std::size_t j = 0; j < D; ++j) epsilon[j] = hull(epsilon[j], other.epsilon[j]);
    }
  }

  /// Every epsilon_j to where the form can take one of the values.
  void keep(const AffineForm<D>& form, const Interval& values);
};

template <int D>
void AffineBox<D>::keep(const AffineForm<D>& form, const Interval& values) {
  if (empty || !form.bounded()) return;
  const Interval rest(-form.radius, form.radius);
  Interval all = Interval(form.center) + rest;
  std::array<Interval, D> part;
  for (std::size_t j = 0; j < D; ++j) {
    part[j] = form.slope[j] * epsilon[j];
    all += part[j];
  }
  if (all.apart_from(values) || form.range.apart_from(values)) {
    empty = true;
    return;
  }
  for (std::size_t j = 0; j < D; ++j) {
    if (form.slope[j] == 0.0) continue;
    Interval others = Interval(form.center) + rest;
    for (std::size_t i = 0; i < D; ++i)
      if (i != j) others += part[i];
    // slope epsilon = value - others
    Interval bound = Interval(-others.hi, -others.lo);
    bound = Interval(below(bound.lo + values.lo), above(bound.hi + values.hi));
    Interval side = Interval(bound.lo / form.slope[j], bound.hi / form.slope[j]);
    if (form.slope[j] < 0.0) std::swap(side.lo, side.hi);
    side = Interval(below(side.lo), above(side.hi));
    if (std::isnan(side.lo) || std::isnan(side.hi)) continue;
    if (side.apart_from(epsilon[j])) {
      empty = true;
      return;
    }
    epsilon[j] = common(epsilon[j], side);
    part[j] = form.slope[j] * epsilon[j];
  }
}

}  // namespace stationary
