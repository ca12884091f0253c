// The part of vectors and equations in (ln x[, p]) that keeps two stretches equal, for a curve of circles. Where ellipses
// branch off it, the balance is singular along the difference of the two, which such a curve has no part in.
#pragma once

#include <Eigen/Core>

#include "lib/body/circle.hpp"

namespace stationary {

/// Of a vector in (ln x[, p]), or of G. Rounding must not leave the circle: a predictor would make it grow.
template <class Vector>
void make_equal(Circle circle, Vector& y) {
  if (circle == Circle::none) return;
  const auto [a, b, c] = places(circle);
  y[a] = y[b] = 0.5 * (y[a] + y[b]);
}

/// Of G where its third row may be that of a held volume: on a circle whose two stretches are not both of the plane, that
/// row has no mirror image, and the plane's row of the two adds nothing to it. Half of each would, off the circle, be as
/// stiff as what breaks the circle, and vanish where it breaks.
template <class Vector>
void make_rows_equal(Circle circle, bool volume_row, Vector& g) {
  if (volume_row && circle != Circle::none) {
    if (const auto [a, b, c] = places(circle); b == 2) g[a] = g[b];
  }
  make_equal(circle, g);
}

/// Of a linearization (jacobian, slope, and g where it has it): restricted to the circle, the
/// difference of the two stretches is given an eigenvalue. volume_row: as above. across: that eigenvalue, > 0 and of
/// the size of G's terms.
template <int N, class Linearization>
void keep_to_circle(Circle circle, Linearization& at, bool volume_row = false,
                    double across = 1.0) {
  if (circle == Circle::none) return;
  auto& J = at.jacobian;
  const auto [a, b, c] = places(circle);
  if (volume_row && b == 2) J.row(a) = J.row(b).eval();
  const double along = 0.5 * (J(a, a) + J(a, b) + J(b, a) + J(b, b));
  J(a, a) = J(b, b) = 0.5 * (along + across);
  J(a, b) = J(b, a) = 0.5 * (along - across);
  if constexpr (N == 3) {
    J(a, c) = J(b, c) = 0.5 * (J(a, c) + J(b, c));
    J(c, a) = J(c, b) = 0.5 * (J(c, a) + J(c, b));
  }
  if constexpr (requires { at.g; }) make_rows_equal(circle, volume_row, at.g);
  make_rows_equal(circle, volume_row, at.slope);
  if constexpr (requires { at.nu_slope; }) make_rows_equal(circle, volume_row, at.nu_slope);
}

}  // namespace stationary
