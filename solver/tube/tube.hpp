// A piece of a curve G(y) = 0 (curve_equations.hpp), proven: in the parallelotope
//
//   y = y0 + s tau + B d,   |s| <= h,  |d_i| <= r_i,
//
// tau about the tangent at y0 and B across it, every cross-section s = const has exactly one point
// of the curve. So folds in nu, where tau has no component along q, are passed like any other
// point. The proof is Krawczyk's, with the section as a parameter: for D = [-r, r] and A = dG/dy
// over the parallelotope,
//
//   K(D) = -Y (G(y0) + A tau [-h, h]) + (1 - Y A B) D   in the interior of D,   Y about (A B)^-1.
//
// For every s the map d -> d - Y G(y0 + s tau + B d) then has one fixed point in D, and A B is
// regular: the points of all sections are one smooth curve, parametrized by s. Source: R. Krawczyk,
// Computing 4 (1969) 187; J. G. Kearfott, Z. Xing, SIAM J. Numer. Anal. 31 (1994) 892.
#pragma once

#include <optional>

#include "solver/tube/curve_equations.hpp"

namespace stationary {

template <int N>
class Tube {
 public:
  using Equations = CurveEquations<N>;
  using Point = TubePoint<N>;

  /// Of half-length h about y0, or nothing where that is not proven.
  static std::optional<Tube> proven(const Equations& equations, const Point& y0,
                                    const Point& tangent, double h);

  /// The same of a tube that someone claims, with |d_i| <= radius everywhere: nothing unless the test
  /// shows that there is one point in every section.
  static std::optional<Tube> claimed(const Equations& equations, const Point& y0,
                                     const Point& tangent, double h, double radius);

  /// Widens the cross-section while the proof holds.
  void fatten(const Equations& equations);

  double half_length() const { return half_length_; }
  const Point& center() const { return center_; }
  Point tangent() const { return axes_.col(0); }

  /// All of the place lies in the tube: its points of the curve are the tube's.
  bool holds(const CurveBox<N>& place) const;

  /// The curve over sections s: holds y(s) and dy/ds; slopes are entire where they are not bounded.
  struct Slice {
    CurveBox<N> y;
    CurveBox<N> velocity;
  };
  /// s within [-h, h].
  Slice slice(const Equations& equations, const Interval& s) const;

 private:
  using Square = Eigen::Matrix<double, N, N>;
  using Frame = Eigen::Matrix<double, N + 1, N + 1>;

  Tube(const Point& y0, const Point& tangent);
  static std::optional<Tube> prepared(const Equations& equations, const Point& y0,
                                      const Point& tangent, double h);
  /// K(D) for sections s, about the point of s0 and d0, both among s and D; and 1 - Y A B, -Y A tau.
  struct Image {
    Box<N> d;
    std::array<Box<N>, static_cast<std::size_t>(N)> rest;
    Box<N> along;
  };
  Image image(const Equations& equations, const Square& Y, double s0, const Box<N>& d0,
              const Interval& s, const Box<N>& d) const;
  bool maps_inside(const Equations& equations, const Box<N>& d) const;
  CurveBox<N> place(const Interval& s, const Box<N>& d) const;
  Square precondition_at(const Equations& equations, const Interval& s, const Box<N>& d) const;
  Box<N> narrowed(const Equations& equations, const Square& Y, const Interval& s, Box<N> d) const;
  void set_hull();

  Point center_;
  Frame axes_;            ///< tau, B
  Frame inverse_;         ///< about
  double inverse_error_;  ///< bound of |1 - inverse axes|, by rows
  Square precondition_;   ///< Y
  double half_length_ = 0.0;
  Box<N> section_;  ///< D
  Box<N> core_;     ///< D before it was widened: the curve is in there
  CurveBox<N> hull_;
};

/// Bound of |x|, x = a + R x, |a| <= along, |R| <= rest < 1 in any norm.
double fixed_point_bound(double along, double rest);

/// Of dG/dy in the middle of its intervals: a unit null vector, at random oriented.
template <int N>
TubePoint<N> tangent_of(const CurveLinearized<N>& at);

/// The nearest point of the curve by Gauss-Newton steps in double, or nothing.
template <int N>
std::optional<TubePoint<N>> corrected_point(const CurveEquations<N>& equations, TubePoint<N> y);

/// The place that is one point of doubles.
template <int N>
CurveBox<N> point_box(const TubePoint<N>& y) {
  CurveBox<N> out;
  for (int i = 0; i <= N; ++i) out[static_cast<std::size_t>(i)] = y[i];
  return out;
}
template <int N>
TubePoint<N> middle_of(const CurveBox<N>& place) {
  TubePoint<N> out;
  for (int i = 0; i <= N; ++i) out[i] = place[static_cast<std::size_t>(i)].mid();
  return out;
}

}  // namespace stationary
