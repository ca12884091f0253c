// What vanishes where a motion about a material axis leaves a symmetry that it has: alpha = 0, or the circle of
// two stretches. Scaled to be of order one, so that signs can be compared with rounding.
#pragma once

#include <cmath>

#include "lib/balance/balance.hpp"
#include "lib/balance/sheared_balance.hpp"
#include "lib/body/body.hpp"
#include "lib/body/stretch.hpp"
#include "lib/material/gravitating/body_model.hpp"
#include "lib/material/potential.hpp"
#include "lib/number/double_double.hpp"

namespace stationary {

/// Of an isotropic body with gravity and J1 != J2, alpha = 0, at a stationary q with spin nu: K of
/// turning_forces() over the sum of its terms' sizes. In [-1, 1]; 0 where motions with alpha != 0 begin.
/// Its sign is certain where |value| > condition (the relative error of stretches and gravity): not where
/// xi and zeta differ by no more than that.
struct TurningStiffness {
  double value;
  double condition;
};
inline TurningStiffness turning_stiffness(const BodyModel<>& model, Branch branch, const Body& body,
                                          const Stretch& q, double nu) {
  const Inertia3<double> J{body.J1, body.J2, body.J3};
  const double V_T =
      gravity_derivatives<1>(model.g, J, planar_moment(J, q), q.xi * q.zeta, q.rho).plane.w_t;
  const TurningForces<double> turns = turning_forces(branch, J, q.xi, q.zeta, nu * nu, V_T);
  const double size = std::abs(turns.spin) + std::abs(turns.gravity);
  const double unequal = relative_difference(J.J1, J.J2);
  const double apart = relative_difference(q.xi, q.zeta);
  const double K = unequal / apart * (turns.spin - turns.gravity) / size;
  const double value = std::isinf(K) ? std::copysign(1.0, K) : K / (1.0 + std::abs(K));
  // (i), (ii): gravity's own part is a difference.
  const double parts = branch == Branch::iii
                           ? size
                           : size + 2.0 * V_T * (J.J1 * q.xi * q.xi + J.J2 * q.zeta * q.zeta);
  // Some rounding errors of each part, and that of xi - zeta; K's sign is wrong where they make up K.
  constexpr double roundings = 16.0;
  const double condition =
      (roundings * std::abs(unequal) * (parts / size) / (1.0 + std::abs(K)) + std::abs(value)) /
      std::abs(apart);
  return {value, condition};
}

/// (i), (ii), on the circle of the two stretches across the axis, at a stationary q with spin nu: F_ss of the
/// reduced energy F = V - T along s, half the logarithm of their ratio, the stretch along the axis held; over
/// itself and the spin's part of it. 0 where ellipses leave the circle. In extended precision: of a body stretched
/// far V's derivatives cancel.
template <class Model>
double stiffness_across_circle(const Model& model, Branch branch, const Body& body,
                               const Stretch& here, double nu) {
  const BasicStretch<DoubleDouble> q{here.alpha, here.xi, here.zeta, here.rho};
  const auto v = potential_derivatives<2>(model, q);
  const CentrifugalRates<DoubleDouble> c = axis_rates(body, branch, two_product(nu, nu));
  const int k = branch == Branch::i ? 2 : 1;
  const DoubleDouble& x = branch == Branch::i ? q.zeta : q.xi;
  const DoubleDouble pull = (branch == Branch::i ? c.zeta : c.xi) * x * x + c.rho * (q.rho * q.rho);
  const auto stiffness = double(x * (x * v.hessian(k, k) + v.gradient[k]) +
                                q.rho * (q.rho * v.hessian(3, 3) + v.gradient[3]) -
                                2.0 * (x * q.rho * v.hessian(k, 3)) - 2.0 * pull);
  return stiffness / (std::abs(stiffness) + 2.0 * double(pull));
}

}  // namespace stationary
