// What a box of the unknowns holds of a motion with alpha != 0 (sheared_family.hpp).
#pragma once

#include <optional>

#include "solver/family/sheared_family.hpp"
#include "solver/proof/certify.hpp"

namespace stationary {

template <int N>
class ShearedBoxes {
 public:
  ShearedBoxes(const ShearedEquations<N>& equations, double nu, Inputs inputs)
      : equations_(equations), nu_(nu), inputs_(inputs) {}

  StretchBox stretch(const Box<N>& x) const {
    const auto q = state(x).at.q;
    return {q.xi, q.zeta, q.rho, q.alpha};
  }
  ShearedSquares<Interval> squares(const Box<N>& x) const {
    return sheared_squares<Interval>(equations_.axis, state(x), square_nu());
  }
  /// Directions that nu/|nu| may have; nothing where that is not known.
  std::optional<Vector3<Interval>> axis(const Box<N>& x) const {
    const Interval none(0.0);
    if (equations_.axis == ShearedAxis::third)
      return Vector3<Interval>{none, none, Interval(nu_ < 0.0 ? -1.0 : 1.0)};
    const ShearedPoint<Interval> at = state(x);
    const auto n = sheared_direction<Interval>(J(), at);
    const Interval length = sqrt(square(n[0]) + square(n[1]));
    if (!length.positive()) return std::nullopt;
    if (equations_.axis == ShearedAxis::oblique)
      return Vector3<Interval>{n[0] / length, n[1] / length, none};
    const auto square_of = squares(x);
    if (!square_of.in_plane.positive() || !square_of.normal.positive()) return std::nullopt;
    const Interval speed = sqrt(square_of.in_plane + square_of.normal);
    const Interval in_plane = sqrt(square_of.in_plane) / speed;
    return Vector3<Interval>{in_plane * n[0] / length, in_plane * n[1] / length,
                             sqrt(square_of.normal) / speed};
  }
  Inertia3<Interval> J() const { return inertia_intervals(equations_.body, inputs_); }

 private:
  ShearedPoint<Interval> state(const Box<N>& x) const {
    return equations_.state(x, as_input(nu_, inputs_),
                            [this](double c) { return as_input(c, inputs_); });
  }
  Interval square_nu() const { return square(as_input(nu_, inputs_)); }

  const ShearedEquations<N>& equations_;
  double nu_;
  Inputs inputs_;
};

}  // namespace stationary
