// Units in which the inertias, stiffnesses and rates of a state are of the size of one, where they are far
// from it: powers of two, so that nothing is rounded. The characteristic polynomial of four coordinates has
// products of four masses, which leave the range of doubles long before the body does.
#pragma once

#include <algorithm>
#include <cmath>

#include "lib/number/sloped.hpp"
#include "lib/stability/linearization.hpp"

namespace stationary {

struct StateUnits {
  double inertia = 1.0;
  double rate = 1.0;  ///< Lambda are multiplied by its square

  double stiffness() const { return inertia * (rate * rate); }
  bool are_own() const { return inertia == 1.0 && rate == 1.0; }
};

template <class S>
StateUnits units_of(const StraightState<S>& s) {
  const auto size = [](const S& x) { return std::abs(leading(x)); };
  const double J = std::max({size(s.J.J1), size(s.J.J2), size(s.J.J3)});
  const double omega = size(s.omega);
  const double stiffness =
      std::max({size(s.V_aa), size(s.V_xx), size(s.V_zz), size(s.V_rr), J * omega * omega});
  const auto is_near = [](double x) { return x < 0x1p60 && x > 0x1p-60; };
  StateUnits out;
  if ((is_near(J) && is_near(stiffness)) || !(J > 0.0) || !(stiffness > 0.0) || !std::isfinite(J) ||
      !std::isfinite(stiffness))
    return out;
  const int of_J = std::ilogb(J);
  out.inertia = std::ldexp(1.0, -of_J);
  out.rate = std::ldexp(1.0, -(std::ilogb(stiffness) - of_J) / 2);
  return out;
}

template <class S>
StraightState<S> in_units(const StraightState<S>& s, const StateUnits& units) {
  const double J = units.inertia;
  const double V = units.stiffness();
  return {{J * s.J.J1, J * s.J.J2, J * s.J.J3},
          s.xi,
          s.zeta,
          s.rho,
          units.rate * s.omega,
          V * s.V_aa,
          V * s.V_xx,
          V * s.V_xz,
          V * s.V_zz,
          V * s.V_xr,
          V * s.V_zr,
          V * s.V_rr};
}

}  // namespace stationary
