// Relative equilibria of a potential that need not be isotropic: alpha is an unknown, and of a spin
// about an axis in the plane of axes 1 and 2 so is the axis,
//
//   nu = |nu| (cos phi, sin phi, 0)      "oblique".
//
// The balance is that V - q^T C(nu) q/2 be critical in q, taken in coordinates that keep S positive
// definite,
//
//   u = ln xi,  v = ln zeta,  w = ln rho,  a:  alpha = sqrt(xi zeta) tanh a,
//   so d = xi zeta sech^2 a
//
// and compatibility, in phi: nu is an eigenvector of the locked inertia I where
//
//   K = -(I22 - I11) sin(2 phi)/2 - I12 cos(2 phi) = 0.
//
// -K is 1/|nu|^2 times the derivative of q^T C q/2 by phi: all five are the gradient of one
// function, and regular down to |nu| = 0. An isotropic W(t, l, r) has
// t = e^u + e^v, l = u + v + 2 ln sech a:
//
//   F_u = xi W_t + W_l,  F_v = zeta W_t + W_l,  F_w = W_r,  F_a = -2 tanh(a) W_l.
//
// Where det S = C is held, w = ln C - u - v - 2 ln sech a is eliminated: the four are those of
// V(u, v, w(u, v, a), a) - q^T C(nu) q/2. w stays an unknown with k/2 (u + v + w + 2 ln sech a - ln C)^2 added
// to the function, for any k > 0 (held_volume.hpp), or is left out.
//
// a and phi are numbers x > 0 here too, a = ln x and phi = 2 gd(ln x) (Gudermann's function): all
// is rational in x but for sqrt(xi zeta), in any number type, and nothing happens where the axis
// passes a material one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <variant>

#include "lib/body/inertia.hpp"
#include "lib/body/motion.hpp"
#include "lib/material/anisotropic_potential.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {

/// tanh and sech of ln x.
template <class S>
struct Hyperbolic {
  S tanh;
  S sech;
};

template <class S>
Hyperbolic<S> hyperbolic(const S& x) {
  const S sum = x * x + 1.0;
  return {(x - 1.0) * (x + 1.0) / sum, 2.0 * x / sum};
}

/// Over an interval its ends decide, and 1 where x = 1 is in it. At an end in doubles: six roundings
/// of tanh, four of sech, and one of the bounds.
inline Hyperbolic<Interval> hyperbolic(const Interval& x) {
  const Hyperbolic<double> low = hyperbolic(x.lo);
  const Hyperbolic<double> high = hyperbolic(x.hi);
  if (!x.positive() || !std::isfinite(high.tanh)) return {Interval::entire(), Interval::entire()};
  constexpr double rounding = 0x1p-50;
  Interval tanh(low.tanh - rounding * std::abs(low.tanh),
                high.tanh + rounding * std::abs(high.tanh));
  Interval sech((1.0 - rounding) * std::min(low.sech, high.sech),
                (1.0 + rounding) * std::max(low.sech, high.sech));
  if (x.may_be(1.0)) sech.hi = 1.0;
  return {tanh, sech};
}

/// x with tanh(ln x) = t, |t| < 1.
inline double from_hyperbolic(double t) { return std::sqrt((1.0 + t) / (1.0 - t)); }

/// A stretch by its coordinates.
template <class S>
struct OrientedStretch {
  BasicStretch<S> q;
  S root;  ///< sqrt(xi zeta)
  S tanh;  ///< of a
  S sech;

  PlanarInvariants<S> invariants() const {
    const S difference = q.xi - q.zeta;
    return {q.xi + q.zeta, q.xi * q.zeta * square(sech),
            square(difference) + 4.0 * square(q.alpha)};
  }
};

template <class S>
OrientedStretch<S> oriented_stretch(const S& xi, const S& zeta, const S& rho, const S& x_a) {
  using std::sqrt;
  const Hyperbolic<S> a = hyperbolic(x_a);
  const S root = sqrt(xi * zeta);
  return {{root * a.tanh, xi, zeta, rho}, root, a.tanh, a.sech};
}

/// x_a of a stretch.
inline double shear_coordinate(const Stretch& q) {
  return from_hyperbolic(q.alpha / std::sqrt(q.xi * q.zeta));
}

/// The axis by its coordinate.
template <class S>
struct AxisAngle {
  S cosine;
  S sine;
  S rate;  ///< d phi/d ln x
};

template <class S>
AxisAngle<S> axis_angle(const S& x) {
  const Hyperbolic<S> half = hyperbolic(x);
  return {1.0 - 2.0 * square(half.tanh), 2.0 * (half.sech * half.tanh), 2.0 * half.sech};
}

/// x of phi in (-pi, pi).
inline double axis_coordinate(double phi) { return from_hyperbolic(sin(0.5 * phi)); }

/// Of nu = |nu| (cosine, sine, 0).
template <class S>
SpinProducts<S> in_plane_products(const S& nu_squared, const S& cosine, const S& sine) {
  return {nu_squared * square(cosine), nu_squared * square(sine), S(0.0),
          nu_squared * (cosine * sine)};
}
/// About a material axis.
template <class S>
SpinProducts<S> axis_products(Branch branch, const S& nu_squared) {
  SpinProducts<S> out{S(0.0), S(0.0), S(0.0), S(0.0)};
  (branch == Branch::i    ? out.square_1
   : branch == Branch::ii ? out.square_2
                          : out.square_3) = nu_squared;
  return out;
}

/// Places of the coordinates.
namespace oriented {
constexpr std::size_t u = 0;
constexpr std::size_t v = 1;
constexpr std::size_t w = 2;
constexpr std::size_t a = 3;
constexpr std::size_t phi = 4;
}  // namespace oriented

/// The five equations and, of order 2, their slopes in (u, v, w, a, ln x_phi), rows first.
template <class S, int order = 2>
struct OrientedBalance {
  std::array<S, 5> g{};
  std::array<std::array<S, 5>, order >= 2 ? 5 : 0> slope{};
};

/// Adds the derivatives in (u, v, w, a) of a function of q from those in q.
template <int order, class S>
void add_in_logarithms(const OrientedStretch<S>& at, const Vector4<S>& gradient,
                       const Matrix4<S>& hessian, OrientedBalance<S, order>& out) {
  using namespace oriented;
  const auto& q = at.q;
  const S half = 0.5 * q.alpha;  // alpha_u = alpha_v
  const S alpha_a = at.root * square(at.sech);
  const S by_alpha = gradient[0] * half;
  out.g[u] += gradient[1] * q.xi + by_alpha;
  out.g[v] += gradient[2] * q.zeta + by_alpha;
  out.g[w] += gradient[3] * q.rho;
  out.g[a] += gradient[0] * alpha_a;
  if constexpr (order >= 2) {
    const auto& H = hessian;
    auto& s = out.slope;
    const S curved = 0.5 * by_alpha + H(0, 0) * square(half);  // alpha_uu = alpha/4
    s[u][u] +=
        H(1, 1) * square(q.xi) + 2.0 * (H(0, 1) * (q.xi * half)) + curved + gradient[1] * q.xi;
    s[v][v] += H(2, 2) * square(q.zeta) + 2.0 * (H(0, 2) * (q.zeta * half)) + curved +
               gradient[2] * q.zeta;
    s[w][w] += H(3, 3) * square(q.rho) + gradient[3] * q.rho;
    s[a][a] += H(0, 0) * square(alpha_a) - 2.0 * (gradient[0] * (at.tanh * alpha_a));
    const auto both = [&](std::size_t i, std::size_t j, const S& value) {
      s[i][j] += value;
      s[j][i] += value;
    };
    both(u, v, H(1, 2) * (q.xi * q.zeta) + (H(0, 1) * q.xi + H(0, 2) * q.zeta) * half + curved);
    both(u, w, (H(1, 3) * q.xi + H(0, 3) * half) * q.rho);
    both(v, w, (H(2, 3) * q.zeta + H(0, 3) * half) * q.rho);
    const S turned = H(0, 0) * half + 0.5 * gradient[0];
    both(u, a, (H(0, 1) * q.xi + turned) * alpha_a);
    both(v, a, (H(0, 2) * q.zeta + turned) * alpha_a);
    both(w, a, H(0, 3) * (q.rho * alpha_a));
  }
}

/// Those of an isotropic W.
template <int order, class S>
void add_in_logarithms(const OrientedStretch<S>& at, const CoupledDerivatives<S>& W,
                       OrientedBalance<S, order>& out) {
  using namespace oriented;
  const auto& [alpha, xi, zeta, rho] = at.q;
  const auto& p = W.plane;
  const S l_a = -2.0 * at.tanh;
  out.g[u] += xi * p.w_t + p.w_l;
  out.g[v] += zeta * p.w_t + p.w_l;
  out.g[w] += W.w_r;
  out.g[a] += l_a * p.w_l;
  if constexpr (order >= 2) {
    auto& s = out.slope;
    s[u][u] += xi * (p.w_t + xi * p.w_tt + 2.0 * p.w_tl) + p.w_ll;
    s[v][v] += zeta * (p.w_t + zeta * p.w_tt + 2.0 * p.w_tl) + p.w_ll;
    s[w][w] += W.w_rr;
    s[a][a] += square(l_a) * p.w_ll - 2.0 * (square(at.sech) * p.w_l);
    const auto both = [&](std::size_t i, std::size_t j, const S& value) {
      s[i][j] += value;
      s[j][i] += value;
    };
    both(u, v, xi * zeta * p.w_tt + (xi + zeta) * p.w_tl + p.w_ll);
    both(u, w, xi * W.w_tr + W.w_lr);
    both(v, w, zeta * W.w_tr + W.w_lr);
    both(u, a, l_a * (xi * p.w_tl + p.w_ll));
    both(v, a, l_a * (zeta * p.w_tl + p.w_ll));
    both(w, a, l_a * W.w_lr);
  }
}

/// A row of gravity in the logarithm of a stretch: positive, and the sum of all three is -V.
template <class S>
S gravity_row(const S& row, const CoupledDerivatives<S>& V) {
  if constexpr (std::is_same_v<S, Interval>) {
    return common(row, Interval(0.0, (-V.plane.w).hi));
  } else {
    return row;
  }
}

/// Those of gravity, from its derivatives in (T, l, r).
template <int order, class S>
void add_gravity_in_logarithms(const OrientedStretch<S>& at, const CoupledDerivatives<S>& V,
                               const GravitatingInertia<S>& J, OrientedBalance<S, order>& out) {
  using namespace oriented;
  const auto& p = V.plane;
  const S J_sum = J.J1 + J.J2;
  const S first = J.J1 * square(at.q.xi);
  const S second = J.J2 * square(at.q.zeta);
  const S shear = J_sum * square(at.q.alpha);
  const S root_squared = at.q.xi * at.q.zeta;
  const S narrow = square(at.sech);
  const std::array<S, 3> T{2.0 * first + shear, 2.0 * second + shear,
                           2.0 * (J_sum * root_squared * at.tanh * narrow)};
  const std::array<S, 3> l{S(1.0), S(1.0), -2.0 * at.tanh};
  constexpr std::array places{u, v, a};
  out.g[u] += gravity_row<S>(T[0] * p.w_t + p.w_l, V);
  out.g[v] += gravity_row<S>(T[1] * p.w_t + p.w_l, V);
  out.g[w] += gravity_row(V.w_r, V);
  out.g[a] += T[2] * p.w_t + l[2] * p.w_l;
  if constexpr (order >= 2) {
    const S T_aa = 2.0 * (J_sum * root_squared * narrow * (narrow - 2.0 * square(at.tanh)));
    const std::array<std::array<S, 3>, 3> curved{{{4.0 * first + shear, shear, T[2]},
                                                  {shear, 4.0 * second + shear, T[2]},
                                                  {T[2], T[2], T_aa}}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j)
        out.slope[places[i]][places[j]] += p.w_tt * (T[i] * T[j]) + p.w_ll * (l[i] * l[j]) +
                                           p.w_tl * (T[i] * l[j] + l[i] * T[j]) +
                                           p.w_t * curved[i][j];
      const S by_w = V.w_tr * T[i] + V.w_lr * l[i];
      out.slope[places[i]][w] += by_w;
      out.slope[w][places[i]] += by_w;
    }
    out.slope[w][w] += V.w_rr;
    out.slope[a][a] -= 2.0 * (narrow * p.w_l);
  }
}

/// The balance, in (u, v, w, a), of V's derivatives there; of phi nothing.
template <int order, class S>
OrientedBalance<S, order> oriented_balance(const Inertia3<S>& J, const AnisotropicDerivatives<S>& V,
                                           const OrientedStretch<S>& at, const SpinProducts<S>& n) {
  OrientedBalance<S, order> out;
  add_in_logarithms<order>(at, V.isotropic, out);
  if (V.gravity) add_gravity_in_logarithms<order>(at, V.gravity->V, V.gravity->J, out);
  const Matrix4<S> C = centrifugal_matrix(J, n);
  const Vector4<S> q = at.q.vector();
  Vector4<S> gradient = V.directed.gradient;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (i == j || (i + j <= 2 && i * j == 0)) gradient[i] -= C(i, j) * q[j];
  if constexpr (order >= 2) {
    add_in_logarithms<order>(at, gradient, Matrix4<S>(V.directed.hessian - C), out);
  } else {
    add_in_logarithms<order>(at, gradient, V.directed.hessian, out);
  }
  return out;
}

/// At rho = volume/d.
template <class S>
OrientedStretch<S> at_volume(const S& volume, OrientedStretch<S> at) {
  at.q.rho = volume / (at.q.xi * at.q.zeta * square(at.sech));
  return at;
}

/// From the balance at at_volume() that of the held volume without an equation of w.
template <int order, class S>
OrientedBalance<S, order> held(const OrientedBalance<S, order>& b, const OrientedStretch<S>& at) {
  using namespace oriented;
  OrientedBalance<S, order> out;
  const S w_a = 2.0 * at.tanh;  // w_u = w_v = -1
  out.g[u] = b.g[u] - b.g[w];
  out.g[v] = b.g[v] - b.g[w];
  out.g[a] = b.g[a] + w_a * b.g[w];
  if constexpr (order >= 2) {
    const auto& s = b.slope;
    out.slope[u][u] = s[u][u] - 2.0 * s[u][w] + s[w][w];
    out.slope[v][v] = s[v][v] - 2.0 * s[v][w] + s[w][w];
    out.slope[u][v] = out.slope[v][u] = s[u][v] - s[u][w] - s[v][w] + s[w][w];
    for (const std::size_t i : {u, v})
      out.slope[i][a] = out.slope[a][i] = s[i][a] - s[w][a] + w_a * (s[i][w] - s[w][w]);
    out.slope[a][a] =
        s[a][a] + w_a * (2.0 * s[a][w] + w_a * s[w][w]) + 2.0 * (square(at.sech) * b.g[w]);
  }
  return out;
}

/// Adds the equation of a volume held, k > 0.
template <int order, class S>
void add_volume(const OrientedStretch<S>& at, const S& volume, double k,
                OrientedBalance<S, order>& out) {
  using namespace oriented;
  const S excess = log(S(at.q.xi * at.q.zeta * square(at.sech) * at.q.rho / volume));
  const S pull = k * excess;
  const S by_a = -2.0 * at.tanh;
  for (const std::size_t i : {u, v, w}) out.g[i] += pull;
  out.g[a] += by_a * pull;
  if constexpr (order >= 2) {
    for (const std::size_t i : {u, v, w}) {
      for (const std::size_t j : {u, v, w}) out.slope[i][j] += S(k);
      out.slope[i][a] += k * by_a;
      out.slope[a][i] += k * by_a;
    }
    out.slope[a][a] += k * square(by_a) - 2.0 * (square(at.sech) * pull);
  }
}

/// Over a box the pull on rho is gathered with the force of a thickness (its log_balance()): where the
/// two nearly cancel, each alone is as wide as the box. J is what is left for the balance of V.
template <class S>
Inertia3<S> gather_thickness(const Inertia3<S>& J, const AnisotropicModel<S>& model, const S& rho,
                             const SpinProducts<S>& n, AnisotropicDerivatives<S>& V) {
  if constexpr (std::is_same_v<S, Interval>) {
    using Separate = typename AnisotropicModel<S>::Separate;
    const auto* separate = std::get_if<Separate>(&model.base);
    if (separate != nullptr && separate->thickness) {
      const auto rate = centrifugal_rates<S>(J, n.square_1, n.square_2, n.square_3).rho;
      const auto axial = separate->thickness->log_balance(rho, rate);
      V.isotropic.w_r = axial.g_rho;
      V.isotropic.w_rr = axial.ww;
      return {J.J1, J.J2, S(0.0)};
    }
  }
  return J;
}

/// By the model; of a held volume without w's equation, whatever rho is.
template <int order, class S>
OrientedBalance<S, order> eliminated_balance(const Inertia3<S>& J, const AnisotropicModel<S>& model,
                                             const OrientedStretch<S>& at,
                                             const SpinProducts<S>& n) {
  const auto& volume = model.body.volume;
  const OrientedStretch<S> whole = volume ? at_volume<S>(*volume, at) : at;
  AnisotropicDerivatives<S> V = model.template evaluate<order>(whole.invariants(), whole.q);
  const Inertia3<S> pulling = gather_thickness(J, model, whole.q.rho, n, V);
  OrientedBalance<S, order> out = oriented_balance<order>(pulling, V, whole, n);
  if (volume) out = held<order>(out, whole);
  return out;
}

/// All four equations.
template <int order, class S>
OrientedBalance<S, order> oriented_balance(const Inertia3<S>& J, const AnisotropicModel<S>& model,
                                           const OrientedStretch<S>& at, const SpinProducts<S>& n) {
  auto out = eliminated_balance<order>(J, model, at, n);
  if (model.body.volume) add_volume<order>(at, *model.body.volume, model.body.stiffness, out);
  return out;
}

/// I22 - I11, I12, I11 + I22 of the locked inertia, in the plane.
template <class S>
struct InPlaneInertia {
  S difference;
  S product;
  S sum;
};
template <class S>
InPlaneInertia<S> in_plane_inertia(const Inertia3<S>& J, const BasicStretch<S>& q) {
  const S xi = J.J1 * square(q.xi);
  const S zeta = J.J2 * square(q.zeta);
  const S alpha = square(q.alpha);
  return {xi - zeta + (J.J2 - J.J1) * alpha, -((J.J1 * q.xi + J.J2 * q.zeta) * q.alpha),
          xi + zeta + (J.J1 + J.J2) * alpha + 2.0 * (J.J3 * square(q.rho))};
}

/// Adds phi: its own equation, and what it does to the others'.
template <int order, class S>
void add_axis(const Inertia3<S>& J, const OrientedStretch<S>& at, const S& nu_squared,
              const AxisAngle<S>& axis, OrientedBalance<S, order>& out) {
  using namespace oriented;
  const auto& q = at.q;
  const S sine = 2.0 * (axis.sine * axis.cosine);  // of 2 phi
  const S cosine = 1.0 - 2.0 * square(axis.sine);
  const auto I = in_plane_inertia(J, q);
  out.g[phi] = -(0.5 * (sine * I.difference) + cosine * I.product);
  if constexpr (order >= 2) {
    out.slope[phi][phi] = (2.0 * (sine * I.product) - cosine * I.difference) * axis.rate;
    // K's slope in q, which times |nu|^2 is also the balance's in phi.
    const S h = J.J1 * q.xi + J.J2 * q.zeta;
    Vector4<S> gradient{cosine * h - sine * ((J.J2 - J.J1) * q.alpha),
                        J.J1 * (cosine * q.alpha - sine * q.xi),
                        J.J2 * (cosine * q.alpha + sine * q.zeta), S(0.0)};
    OrientedBalance<S, 1> in_q;
    const Matrix4<S> none = Matrix4<S>::Zero();
    add_in_logarithms<1>(at, gradient, none, in_q);
    for (const std::size_t i : {u, v, w, a}) {
      out.slope[phi][i] = in_q.g[i];
      out.slope[i][phi] = nu_squared * (in_q.g[i] * axis.rate);
    }
  }
}

// Compiled once, in balance.cpp.
#define STATIONARY_ORIENTED_BALANCE(keyword, order, S)                                 \
  keyword OrientedBalance<S, order> oriented_balance<order>(                           \
      const Inertia3<S>&, const AnisotropicDerivatives<S>&, const OrientedStretch<S>&, \
      const SpinProducts<S>&);
#define STATIONARY_ORIENTED_BALANCES(keyword)           \
  STATIONARY_ORIENTED_BALANCE(keyword, 1, DoubleDouble) \
  STATIONARY_ORIENTED_BALANCE(keyword, 2, DoubleDouble) \
  STATIONARY_ORIENTED_BALANCE(keyword, 1, Interval)     \
  STATIONARY_ORIENTED_BALANCE(keyword, 2, Interval)
STATIONARY_ORIENTED_BALANCES(extern template)

}  // namespace stationary
