// What a box of the unknowns holds of a motion about an axis in no plane (spatial_family.hpp).
#pragma once

#include <optional>

#include "solver/kind/spatial_family.hpp"
#include "solver/proof/certify.hpp"

namespace stationary {

class SpatialBoxes {
 public:
  SpatialBoxes(const SpatialEquations& equations, double nu, Inputs inputs)
      : equations_(equations), nu_(nu), inputs_(inputs) {}

  StretchBox stretch(const Box<3>& x) const {
    const auto q = state(x).at.q;
    return {q.xi, q.zeta, q.rho, q.alpha};
  }
  SpatialSquares<Interval> squares(const Box<3>& x) const {
    return spatial_squares(state(x), square(as_input(nu_, inputs_)));
  }
  /// Directions that nu/|nu| may have; nothing where that is not known.
  std::optional<Vector3<Interval>> axis(const Box<3>& x) const {
    const SpatialState<Interval> at = state(x);
    const auto square_of = squares(x);
    if (!square_of.in_plane.positive() || !square_of.normal.positive()) return std::nullopt;
    const auto n = spatial_direction<Interval>(J(), at);
    const Interval length = sqrt(square(n[0]) + square(n[1]));
    if (!length.positive()) return std::nullopt;
    const Interval speed = sqrt(square_of.in_plane + square_of.normal);
    const Interval in_plane = sqrt(square_of.in_plane) / speed;
    return Vector3<Interval>{in_plane * n[0] / length, in_plane * n[1] / length,
                             sqrt(square_of.normal) / speed};
  }
  Inertia3<Interval> J() const { return inertia_intervals(equations_.body, inputs_); }

 private:
  SpatialState<Interval> state(const Box<3>& x) const {
    return equations_.state(x, [this](double c) { return as_input(c, inputs_); });
  }

  const SpatialEquations& equations_;
  double nu_;
  Inputs inputs_;
};

}  // namespace stationary
