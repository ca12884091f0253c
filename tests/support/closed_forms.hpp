// Closed-form stationary motions, in any number type: the oracles of solvers and spectra.
//
// reciprocal-determinant W = c/d + (k/2) tr S^2 with thickness a/rho + b rho^2/2, at alpha = 0:
//   xi^4 = c A2^(1/2) A1^(-3/2),  zeta^4 = c A1^(1/2) A2^(-3/2),
//   (i)    A1 = k,             A2 = k - J2 nu^2,  rho^3 = a/(b - J3 nu^2)
//   (ii)   A1 = k - J1 nu^2,   A2 = k,            rho^3 = a/(b - J3 nu^2)
//   (iii)  A1 = k - J1 nu^2,   A2 = k - J2 nu^2,  rho^3 = a/b
//   tilted in the 1-3 plane, nu = (nu1, 0, nu3):  A1 = k - J1 nu3^2,  A2 = k - J2 |nu|^2,
//          rho^3 = a/(b - J3 nu1^2),  and J3 rho^2 = J1 xi^2 ties nu1 to nu3.
// Unique, while A1, A2 and the stiffness left in rho are positive.
// hencky: nu turns on (i) at zeta = sqrt e, nu^2 = 2 mu (mu + lambda)/((2 mu + lambda) e J2).
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "lib/body/body.hpp"
#include "lib/body/motion.hpp"
#include "lib/body/stretch.hpp"
#include "lib/material/models/reciprocal_determinant.hpp"
#include "lib/material/models/thickness.hpp"

namespace stationary::support {

/// A state and its rotation.
template <class T>
struct SteadyMotion {
  BasicStretch<T> q;
  Vector3<T> nu;
};

template <class T>
class ReciprocalDeterminantSolution {
 public:
  ReciprocalDeterminantSolution(const Body& body, const ReciprocalDeterminant<T>& plane,
                                const ReciprocalQuadratic<T>& thickness)
      : body_(body), plane_(plane), thickness_(thickness) {}

  /// The one stationary motion of a branch at nu; nothing where it has none.
  std::optional<SteadyMotion<T>> on(Branch branch, const T& nu) const {
    const T n = nu * nu;
    const T A1 = branch == Branch::i ? plane_.k : T(plane_.k - body_.J1 * n);
    const T A2 = branch == Branch::ii ? plane_.k : T(plane_.k - body_.J2 * n);
    const T B = branch == Branch::iii ? thickness_.b : T(thickness_.b - body_.J3 * n);
    return state(A1, A2, B, angular_velocity(branch, nu));
  }

  /// The tilted motion in the 1-3 plane with this nu3, nu1 > 0; nothing where there is none.
  /// rho grows and xi falls with n = nu1^2, so J3 rho^2 = J1 xi^2 has at most one root: bisection.
  std::optional<SteadyMotion<T>> tilted(const T& nu3) const {
    const T n_plane = plane_.k / body_.J2 - nu3 * nu3;
    const T n_axial = thickness_.b / body_.J3;
    T low = T(0);
    T high = n_plane < n_axial ? n_plane : n_axial;
    const auto excess = [&](const T& n) -> std::optional<T> {
      const auto motion = tilted_state(n, nu3);
      if (!motion) return std::nullopt;
      const auto& q = motion->q;
      return T(body_.J3 * q.rho * q.rho - body_.J1 * q.xi * q.xi);
    };
    const auto start = excess(low);
    if (!(high > 0) || !start || *start >= 0) return std::nullopt;
    for (int step = 0; step < 4 * std::numeric_limits<T>::digits; ++step) {
      const T middle = (low + high) / 2;
      if (!(low < middle && middle < high)) break;
      const auto value = excess(middle);
      (value && *value < 0 ? low : high) = middle;
    }
    return tilted_state(low, nu3);
  }

  /// Speed at which the branch ends (A1, A2 or the thickness' stiffness vanishes).
  T limit(Branch branch) const {
    using std::sqrt;
    const T plane_1 = plane_.k / body_.J1;
    const T plane_2 = plane_.k / body_.J2;
    const T axial = thickness_.b / body_.J3;
    const auto least = [](const T& x, const T& y) { return x < y ? x : y; };
    if (branch == Branch::i) return sqrt(least(plane_2, axial));
    if (branch == Branch::ii) return sqrt(least(plane_1, axial));
    return sqrt(least(plane_1, plane_2));
  }

 private:
  std::optional<SteadyMotion<T>> tilted_state(const T& n1, const T& nu3) const {
    using std::sqrt;
    const T n3 = nu3 * nu3;
    return state(plane_.k - body_.J1 * n3, plane_.k - body_.J2 * (n1 + n3),
                 thickness_.b - body_.J3 * n1, Vector3<T>{sqrt(n1), T(0), nu3});
  }

  std::optional<SteadyMotion<T>> state(const T& A1, const T& A2, const T& B,
                                       const Vector3<T>& nu) const {
    using std::cbrt;
    using std::sqrt;
    if (!(A1 > 0 && A2 > 0 && B > 0)) return std::nullopt;
    const T root1 = sqrt(A1);
    const T root2 = sqrt(A2);
    const T xi = sqrt(sqrt(T(plane_.c * root2 / (root1 * root1 * root1))));
    const T zeta = sqrt(sqrt(T(plane_.c * root1 / (root2 * root2 * root2))));
    return SteadyMotion<T>{{T(0), xi, zeta, cbrt(T(thickness_.a / B))}, nu};
  }

  Body body_;
  ReciprocalDeterminant<T> plane_;
  ReciprocalQuadratic<T> thickness_;
};

/// Where nu turns on branch (i) of hencky; the plane alone. The balance in xi there:
/// (2 mu + lambda) ln xi + lambda ln zeta = 0.
template <class T>
struct HenckyFold {
  T xi;
  T zeta;
  T nu_squared;

  HenckyFold(double J2, const T& mu, const T& lambda) {
    using std::exp;
    using std::sqrt;
    zeta = exp(T(1) / 2);
    xi = exp(T(-lambda / (2 * (2 * mu + lambda))));
    nu_squared = 2 * mu * (mu + lambda) / ((2 * mu + lambda) * exp(T(1)) * J2);
  }
};

}  // namespace stationary::support
