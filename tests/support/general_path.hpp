// The general problem (lib/stability/general_spectrum.hpp) at a motion that has blocks, from its
// 50-digit solution; at J1 = J2 also seen from material axes turned by theta, where alpha != 0.
#pragma once

#include "lib/stability/general_spectrum.hpp"
#include "tests/support/numbers/wide_spectrum.hpp"

namespace stationary::testing {

inline DoubleDouble extended(const Number50& x) {
  const double hi = x.convert_to<double>();
  return {hi, Number50(x - hi).convert_to<double>()};
}

inline Spectrum general(const SolvedMotion& motion, double theta = 0.0) {
  const auto wide = wide_motion(motion).state;
  const Number50 c = cos(Number50(theta));
  const Number50 s = sin(Number50(theta));
  const BasicStretch<DoubleDouble> q{
      extended((wide.xi - wide.zeta) * s * c), extended(wide.xi * c * c + wide.zeta * s * s),
      extended(wide.xi * s * s + wide.zeta * c * c), extended(wide.rho)};
  const auto n = angular_velocity(motion.problem.branch(), Number50(motion.nu()));
  const Vector3<DoubleDouble> nu{extended(n[0] * c - n[1] * s), extended(n[0] * s + n[1] * c),
                                 extended(n[2])};
  return general_spectrum(motion.problem.body(), motion.problem.potential(), q, nu,
                          uncertainty(motion.at));
}

}  // namespace stationary::testing
