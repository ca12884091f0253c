// The self-gravity of a homogeneous ellipsoid whose reference body has the inertias J: with y1, y2
// the eigenvalues of S J S in the plane and z = J3 rho^2,
//
//   V_g = -g F(T, D, z),   T = y1 + y2 = I33(q),   D = y1 y2 = J1 J2 d^2,
//
// (ellipsoid_integral.hpp), g = 15 G (M/5)^(5/2) and pi G rho_0 = g/(4 sqrt(J1 J2 J3)). At alpha =
// 0 the eigenvalues are J1 xi^2, J2 zeta^2, and in the logarithms of the stretches
//
//   gamma_k = dV_g/d ln s_k = -2 g y_k F_k > 0,   sum gamma_k = g F,
//   d^2 V_g/d ln s_i d ln s_j = -4 g y_i y_j F_ij (i != j),   rows add up to -gamma_i,
//
// with F_12 = -F_D/2, F_13 = F_Tz + y2 F_Dz: no derivative but F_T, F_D, F_z, F_Tz, F_Dz, and no
// sum of numbers of both signs but on the diagonal.
#pragma once

#include <array>

#include "lib/gravity/ellipsoid_integral.hpp"
#include "lib/gravity/moment_units.hpp"

namespace stationary {

/// gamma and the upper triangle of the second derivatives: 11, 12, 13, 22, 23, 33.
template <class S>
struct GravityBalance {
  std::array<S, 3> pull;
  std::array<S, 6> slope;
};

/// y: positive. order 2; 1 leaves the slopes 0.
template <int order, class S>
GravityBalance<S> gravity_balance(const S& g, const S& y1, const S& y2, const S& z) {
  const S T = y1 + y2;
  if (const MomentUnits units(leading(T)); !units.are_own()) {
    const double u = units.moment;
    return gravity_balance<order, S>(units.strength * g, u * y1, u * y2, u * z);
  }
  const S D = y1 * y2;
  const PowerSeries<S, order> F = ellipsoid_integral<order>(T, D, z);
  const S F_T = F.derivative({1, 0, 0});
  const S twice = -2.0 * g;
  const S of_area = twice * (D * F.derivative({0, 1, 0}));
  GravityBalance<S> out;
  out.slope.fill(S(0.0));
  out.pull = {twice * (y1 * F_T) + of_area, twice * (y2 * F_T) + of_area,
              twice * (z * F.derivative({0, 0, 1}))};
  if constexpr (std::is_same_v<S, Interval>) {
    // Each is positive, and their sum g F: much narrower in a wide box.
    const Interval all(0.0, (g * F.derivative({0, 0, 0})).hi);
    for (Interval& pull : out.pull) pull = common(pull, all);
  }
  if constexpr (order >= 2) {
    const S F_Tz = F.derivative({1, 0, 1});
    const S F_Dz = F.derivative({0, 1, 1});
    const S mixed = 2.0 * (twice * z);
    const S s12 = -of_area;
    const S s13 = mixed * (y1 * (F_Tz + y2 * F_Dz));
    const S s23 = mixed * (y2 * (F_Tz + y1 * F_Dz));
    out.slope = {-(out.pull[0] + s12 + s13), s12, s13,
                 -(out.pull[1] + s12 + s23), s23, -(out.pull[2] + s13 + s23)};
  }
  return out;
}

// Compiled once, in duplication.cpp.
#define STATIONARY_GRAVITY_BALANCES(keyword)                                               \
  keyword GravityBalance<DoubleDouble> gravity_balance<1>(                                 \
      const DoubleDouble&, const DoubleDouble&, const DoubleDouble&, const DoubleDouble&); \
  keyword GravityBalance<DoubleDouble> gravity_balance<2>(                                 \
      const DoubleDouble&, const DoubleDouble&, const DoubleDouble&, const DoubleDouble&); \
  keyword GravityBalance<Interval> gravity_balance<1>(const Interval&, const Interval&,    \
                                                      const Interval&, const Interval&);   \
  keyword GravityBalance<Interval> gravity_balance<2>(const Interval&, const Interval&,    \
                                                      const Interval&, const Interval&);
STATIONARY_GRAVITY_BALANCES(extern template)

}  // namespace stationary
