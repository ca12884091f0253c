// V at a stretch, evaluated in extended precision: the terms of a formula may be far larger than
// what they leave.
#pragma once

#include "lib/material/potential.hpp"

namespace stationary {

/// model: isotropic with its coefficients as doubles, or an AnisotropicModel of extended numbers.
template <class Model>
double elastic_energy(const Model& model, const Stretch& q) {
  const BasicStretch<DoubleDouble> at{DoubleDouble(q.alpha), DoubleDouble(q.xi),
                                      DoubleDouble(q.zeta), DoubleDouble(q.rho)};
  return double(potential_derivatives<0>(model, at).value);
}

}  // namespace stationary
