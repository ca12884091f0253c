// Fibres along a material direction f, held at their natural length where f . S^2 f = 1:
//
//   V = (k/2) n^2,   n = f . S^2 f - 1 = |S f|^2 - 1,   f = (cos, sin) of an angle from axis 1.
//
// Polynomial; in q, since no function of the invariants: anisotropic.
#pragma once

#include "lib/body/direction.hpp"
#include "lib/material/models/potential_derivatives.hpp"

namespace stationary {

/// As the user gives them.
struct Fibre {
  double k;
  double degrees;

  friend bool operator==(const Fibre&, const Fibre&) = default;
};

template <class C>
struct FibreTerm {
  C k;
  Direction<C> along;

  /// Adds V and its derivatives to `out`.
  template <int order>
  void add(const BasicStretch<C>& q, PotentialDerivatives<C>& out) const {
    const C& c = along.cosine;
    const C& s = along.sine;
    const C a = q.xi * c + q.alpha * s;  // S f
    const C b = q.alpha * c + q.zeta * s;
    const C n = square(a) + square(b) - C(1.0);
    const C force = k * n;
    out.value += 0.5 * (force * n);
    if constexpr (order >= 1) {
      const C slope[3] = {2.0 * (a * s + b * c), 2.0 * (a * c), 2.0 * (b * s)};
      for (int i = 0; i < 3; ++i) out.gradient[i] += force * slope[i];
      if constexpr (order >= 2) {
        const C mixed = 2.0 * (c * s);
        const C curvature[3][3] = {{2.0 * (square(c) + square(s)), mixed, mixed},
                                   {mixed, 2.0 * square(c), C(0.0)},
                                   {mixed, C(0.0), 2.0 * square(s)}};
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            out.hessian(i, j) += k * (slope[i] * slope[j]) + force * curvature[i][j];
      }
    }
  }
};

}  // namespace stationary
