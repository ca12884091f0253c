// The linearized dynamics on the leaf |pi| = const, for any stationary motion (alpha != 0, tilted
// and oblique axes included), in canonical coordinates x = (b1, alpha, xi, zeta, rho; b2, p_alpha,
// ...):
//
//   x' = J E'' x,   J = [[0, 1], [-1, 0]],   E = H - kappa |pi|^2/2,  kappa = nu . pi/|pi|^2
//
// delta pi = sqrt|pi| (b1 e1 + b2 e2) with (e1, e2, pi/|pi|) right-handed: pi' = nu x pi then reads
// b1' = dE/db2, b2' = -dE/db1. With m = (pi, p), N = d(m)/dq at fixed velocity and M from
// inertia.hpp, r = dm - N dq:
//
//   E''(m, q) = r^T M^-1 r + dq^T (V_qq - C(nu)) dq - kappa |d pi|^2,
//   r^T M^-1 r = (I22 r1^2 - 2 I12 r1 r2 + I11 r2^2)/(I11 I22 - I12^2)
//                + [(J1 + J2) s^2 + 2 g s r_alpha + (J1 xi^2 + J2 zeta^2) r_alpha^2]/D
//                + r_xi^2/J1 + r_zeta^2/J2 + r_rho^2/J3,
//   s = r3 + alpha (r_zeta - r_xi),  g = J1 xi - J2 zeta,  D = J1 J2 (xi + zeta)^2,
//   I11 I22 - I12^2 = J1 J2 d^2 + J3 rho^2 (I11 + I22 - J3 rho^2),  d = xi zeta - alpha^2.
//
// Where det S = C is held rho is C/d, and rho and p_rho are no coordinates: with b = grad rho of
// (alpha, xi, zeta), N becomes N + N_rho b^T, C(nu) has b's part of J3 (nu1^2 + nu2^2) rho^2/2 in
// its second derivatives, V_qq is V's along the volume, and the mass M + J3 b b^T leaves
//   r^T M^-1 r - (b^T M^-1 r)^2/(1/J3 + b^T M^-1 b).
//
// Which coordinates the others do not see: leaf_parts.hpp.
//
// A symmetry of the motion leaves exact zeros, which cost nothing. At pi = 0 there is no b: 8
// dimensions. q must be a stationary motion (not checked).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "lib/body/body.hpp"
#include "lib/body/inertia.hpp"
#include "lib/matrix/characteristic.hpp"
#include "lib/number/dual.hpp"
#include "lib/number/elementary.hpp"
#include "lib/number/first_order_bound.hpp"
#include "lib/number/interval.hpp"

namespace stationary {

/// 2 pairs x 2 pairs of these are used.
template <class S>
using LeafForm = SquareForm<S, 10>;

struct Leaf {
  std::size_t pairs;  ///< 5, or 4 at pi = 0, one less of a held volume; less of a part of it
  LeafForm<DoubleDouble> second_variation;
  /// |change| of an entry <= u magnitude for inputs of relative uncertainty u; 0 only where a
  /// symmetry forces a zero.
  LeafForm<double> magnitude;
};

namespace leaf_detail {

/// 0, whatever the inputs.
inline bool vanishes(const Interval& x) { return x.lo == 0.0 && x.hi == 0.0; }
template <class T, std::size_t N>
bool vanishes(const Dual<T, N>& x) {
  return vanishes(x.value) &&
         std::ranges::all_of(x.slope, [](const T& slope) { return vanishes(slope); });
}
template <class S>
bool vanishes(const S& x) {
  if constexpr (requires { x.condition; }) {
    return x.value == 0.0 && x.condition == 0.0;
  } else {
    return leading(x) == 0.0;
  }
}

/// A linear form of the ten coordinates.
template <class S>
struct LinearForm {
  std::array<S, 10> c;
  std::array<std::size_t, 10> at;  ///< where it is not zero, ascending
  std::size_t count = 0;

  LinearForm() { c.fill(S(0.0)); }
  void find() {
    count = 0;
    for (std::size_t k = 0; k < 10; ++k)
      if (!vanishes(c[k])) at[count++] = k;
  }
};

/// a x + b y.
template <class S>
LinearForm<S> combined(const S& a, const LinearForm<S>& x, const S& b, const LinearForm<S>& y) {
  LinearForm<S> out;
  if (!vanishes(a))
    for (std::size_t k = 0; k < x.count; ++k) out.c[x.at[k]] = a * x.c[x.at[k]];
  if (!vanishes(b)) {
    for (std::size_t k = 0; k < y.count; ++k) {
      S& entry = out.c[y.at[k]];
      const S term = b * y.c[y.at[k]];
      entry = vanishes(entry) ? term : S(entry + term);
    }
  }
  out.find();
  return out;
}

/// The upper triangle of x y^T; with others to come that make the sum symmetric.
template <class S>
void add_product(const LinearForm<S>& x, const LinearForm<S>& y, LeafForm<S>& out) {
  for (std::size_t a = 0; a < x.count; ++a) {
    const std::size_t i = x.at[a];
    for (std::size_t b = 0; b < y.count; ++b) {
      const std::size_t j = y.at[b];
      if (j >= i) out[i][j] = out[i][j] + x.c[i] * y.c[j];
    }
  }
}

}  // namespace leaf_detail

namespace leaf_detail {

/// A held volume's part of E'', of a motion with the forms s, r_alpha of the leaf.
template <class S, class Inertias>
void add_held_volume(const Inertias& body, const BasicStretch<S>& q, const Vector3<S>& nu,
                     const LinearForm<S>& s, const LinearForm<S>& r_alpha, LeafForm<S>& out) {
  constexpr std::size_t alpha = 1, xi = 2, zeta = 3, p_xi = 7, p_zeta = 8;
  const S one(1.0);
  const S none(0.0);
  const S per_d = one / (q.xi * q.zeta - q.alpha * q.alpha);
  const bool straight = vanishes(q.alpha);
  // l = grad ln d, b = -rho l.
  const std::array<S, 3> l{straight ? none : S(-2.0 * (q.alpha * per_d)), q.zeta * per_d,
                           q.xi * per_d};
  const std::array<S, 3> b{straight ? none : S(-(q.rho * l[0])), -(q.rho * l[1]), -(q.rho * l[2])};
  LinearForm<S> r_xi, r_zeta;
  r_xi.c[p_xi] = one;
  r_zeta.c[p_zeta] = one;
  if (!vanishes(nu[2])) {
    r_xi.c[alpha] = -(S(body.J1) * nu[2]);
    r_zeta.c[alpha] = S(body.J2) * nu[2];
  }
  r_xi.find();
  r_zeta.find();
  LinearForm<S> across = combined(S(b[1] / body.J1), r_xi, S(b[2] / body.J2), r_zeta);
  S size = one / S(body.J3) + b[1] * b[1] / body.J1 + b[2] * b[2] / body.J2;
  if (!straight) {
    const S sum = q.xi + q.zeta;
    const S per_D = one / (body.J1 * (body.J2 * (sum * sum)));
    const S g = (body.J1 * q.xi - body.J2 * q.zeta) * per_D;
    const S plane = (body.J1 * (q.xi * q.xi) + body.J2 * (q.zeta * q.zeta)) * per_D;
    const S both = (S(body.J1) + body.J2) * per_D;
    const S of_s = q.alpha * (b[2] - b[1]);
    const S by_s = both * of_s + g * b[0];
    const S by_alpha = g * of_s + plane * b[0];
    across = combined(one, across, one, combined(by_s, s, by_alpha, r_alpha));
    size = size + of_s * by_s + b[0] * by_alpha;
  }
  add_product(combined(S(-(one / size)), across, none, across), across, out);

  const S pull = body.J3 * (nu[0] * nu[0] + nu[1] * nu[1]) * (q.rho * q.rho);
  if (vanishes(pull)) return;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      if (vanishes(l[i]) && i != j) continue;
      S slope = 3.0 * (l[i] * l[j]);
      if (i == 0 && j == 0) slope = slope + 2.0 * per_d;
      if (i == 1 && j == 2) slope = slope - per_d;
      out[alpha + i][alpha + j] = out[alpha + i][alpha + j] - pull * slope;
    }
  }
  static_assert(xi == alpha + 1 && zeta == alpha + 2);
}

}  // namespace leaf_detail

/// What of the ten coordinates is left: no b at rest, no rho of a held volume.
struct LeafShape {
  bool turns;  ///< nu is not 0
  bool held;   ///< det S is, and V_qq is along it
  std::size_t pairs() const { return 3 + std::size_t{turns} + std::size_t{!held}; }
};

/// Of which axis pi has the least.
template <class S>
std::size_t least_component(const std::array<S, 3>& pi) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(leading(pi[k])) < std::abs(leading(pi[least]))) least = k;
  return least;
}

/// |pi|, and e1, e2 that make (e1, e2, pi/|pi|) right-handed. pi is not 0.
template <class S>
struct LeafFrame {
  S size;
  std::array<S, 3> e1;
  std::array<S, 3> e2;
};

/// e1 is across axis `aside`, which pi is not along. Leaves that are to be compared have the same.
template <class S>
LeafFrame<S> leaf_frame(const std::array<S, 3>& pi, std::size_t aside) {
  using leaf_detail::vanishes;
  using std::sqrt;
  const S one(1.0);
  const S none(0.0);
  const S size = sqrt(S(pi[0] * pi[0] + pi[1] * pi[1] + pi[2] * pi[2]));
  const std::array<S, 3> axis{pi[0] / size, pi[1] / size, pi[2] / size};
  // e1 = e_aside x axis, of length one; e2 = axis x e1.
  const std::size_t next = (aside + 1) % 3;
  const std::size_t last = (aside + 2) % 3;
  std::array<S, 3> e1{none, none, none};
  std::array<S, 3> e2{none, none, none};
  e1[next] = -axis[last];
  e1[last] = axis[next];
  e2[aside] = one;
  if (!vanishes(axis[aside])) {
    const S length = sqrt(S(axis[next] * axis[next] + axis[last] * axis[last]));
    e1[next] = e1[next] / length;
    e1[last] = e1[last] / length;
    e2[aside] = length;
    e2[next] = -(axis[aside] * axis[next] / length);
    e2[last] = -(axis[aside] * axis[last] / length);
  }
  return {size, e1, e2};
}

template <class S>
LeafFrame<S> leaf_frame(const std::array<S, 3>& pi) {
  return leaf_frame(pi, least_component(pi));
}

/// A frame, and kappa |pi|, which is |nu| of a stationary motion.
template <class S>
struct LeafSpin {
  LeafFrame<S> frame;
  S rate;
};

/// E'' in any number type; V_qq in the same. The rows and columns of what is not left are left out.
/// spin: from pi its LeafSpin.
template <class S, class Inertias, class SpinOf>
LeafForm<S> second_variation(const Inertias& body, const BasicStretch<S>& q, const Vector3<S>& nu,
                             const LeafShape& shape, const Matrix4<S>& V_qq, const SpinOf& spin) {
  using leaf_detail::add_product;
  using leaf_detail::combined;
  using leaf_detail::LinearForm;
  using leaf_detail::vanishes;
  using std::sqrt;
  constexpr std::size_t b1 = 0, alpha = 1, xi = 2, zeta = 3, rho = 4;
  constexpr std::size_t b2 = 5, p_alpha = 6, p_xi = 7, p_zeta = 8, p_rho = 9;
  const auto& J1 = body.J1;
  const auto& J2 = body.J2;
  const auto& J3 = body.J3;
  LeafForm<S> out;
  for (auto& row : out) row.fill(S(0.0));

  const S one(1.0);
  const S none(0.0);
  const S thick = J3 * (q.rho * q.rho);
  const S alpha2 = q.alpha * q.alpha;
  const S plane = J1 * (q.xi * q.xi) + J2 * (q.zeta * q.zeta);  // I33 but for alpha
  const S side1 = J2 * (q.zeta * q.zeta) + J1 * alpha2;         // I11 but for rho
  const S side2 = J1 * (q.xi * q.xi) + J2 * alpha2;
  const S I11 = side1 + thick;
  const S I22 = side2 + thick;
  const S I12 = -((J1 * q.xi + J2 * q.zeta) * q.alpha);
  const S I33 = plane + (S(J1) + J2) * alpha2;

  LinearForm<S> r1, r2, r3, r_alpha;
  const Eigen::Matrix<S, 7, 4> N = steady_momenta_jacobian(body, q, nu);
  if (shape.held) {
    // N_rho b, in (pi1, pi2) alone.
    const S per_d = one / (q.xi * q.zeta - alpha2);
    const std::array<S, 3> b{2.0 * (q.rho * (q.alpha * per_d)), -(q.rho * (q.zeta * per_d)),
                             -(q.rho * (q.xi * per_d))};
    for (std::size_t k = 0; k < 3; ++k) {
      if (vanishes(b[k])) continue;
      if (!vanishes(N(0, 3))) r1.c[alpha + k] = -(N(0, 3) * b[k]);
      if (!vanishes(N(1, 3))) r2.c[alpha + k] = -(N(1, 3) * b[k]);
    }
  }
  for (int k = 0; k < (shape.held ? 3 : 4); ++k) {
    const auto column = alpha + static_cast<std::size_t>(k);
    r1.c[column] = vanishes(r1.c[column]) ? S(-N(0, k)) : S(r1.c[column] - N(0, k));
    r2.c[column] = vanishes(r2.c[column]) ? S(-N(1, k)) : S(r2.c[column] - N(1, k));
    r3.c[column] = -N(2, k);
    r_alpha.c[column] = -N(3, k);
  }
  r_alpha.c[p_alpha] = one;
  const std::array<S, 3> pi{I11 * nu[0] + I12 * nu[1], I12 * nu[0] + I22 * nu[1], I33 * nu[2]};
  if (shape.turns) {
    const LeafSpin<S> turning = spin(pi);
    const auto& [size, e1, e2] = turning.frame;
    const S root = sqrt(size);
    LinearForm<S>* const r[3] = {&r1, &r2, &r3};
    for (std::size_t k = 0; k < 3; ++k) {
      if (!vanishes(e1[k])) r[k]->c[b1] = root * e1[k];
      if (!vanishes(e2[k])) r[k]->c[b2] = root * e2[k];
    }
    out[b1][b1] = out[b2][b2] = -turning.rate;
  }

  // (pi1, pi2).
  r1.find();
  r2.find();
  if (vanishes(I12)) {
    add_product(r1, combined(S(one / I11), r1, none, r1), out);
    add_product(r2, combined(S(one / I22), r2, none, r2), out);
  } else {
    const S d = q.xi * q.zeta - alpha2;
    const S det = J1 * (J2 * (d * d)) + thick * (side1 + side2 + thick);
    const S mixed = -(I12 / det);
    add_product(r1, combined(S(I22 / det), r1, mixed, r2), out);
    add_product(r2, combined(mixed, r1, S(I11 / det), r2), out);
  }

  // (pi3, p_alpha), and of (p_xi, p_zeta) what moves with them.
  LinearForm<S>& s = r3;
  if (!vanishes(q.alpha)) {
    // r_zeta - r_xi = dp_zeta - dp_xi + (J1 + J2) nu3 d alpha
    s.c[p_xi] = -q.alpha;
    s.c[p_zeta] = q.alpha;
    if (!vanishes(nu[2])) s.c[alpha] = s.c[alpha] + q.alpha * ((S(J1) + J2) * nu[2]);
  }
  s.find();
  r_alpha.find();
  const S sum = q.xi + q.zeta;
  const S per_D = one / (J1 * (J2 * (sum * sum)));
  const S g = (J1 * q.xi - J2 * q.zeta) * per_D;
  add_product(s, combined(S((S(J1) + J2) * per_D), s, g, r_alpha), out);
  add_product(r_alpha, combined(g, s, S(plane * per_D), r_alpha), out);

  // r_xi = dp_xi - J1 nu3 d alpha, r_zeta = dp_zeta + J2 nu3 d alpha: their squares take nu3 from
  // C's alpha, alpha.
  const auto add = [&](std::size_t i, std::size_t j, const S& x) { out[i][j] = out[i][j] + x; };
  add(p_xi, p_xi, one / S(J1));
  add(p_zeta, p_zeta, one / S(J2));
  if (!shape.held) add(p_rho, p_rho, one / S(J3));
  if (!vanishes(nu[2])) {
    add(alpha, p_xi, -nu[2]);
    add(alpha, p_zeta, nu[2]);
  }
  const S square_1 = nu[0] * nu[0];
  const S square_2 = nu[1] * nu[1];
  const S square_3 = nu[2] * nu[2];
  add(alpha, alpha, V_qq(0, 0) - (J1 * square_1 + J2 * square_2));
  add(xi, xi, V_qq(1, 1) - J1 * (square_2 + square_3));
  add(zeta, zeta, V_qq(2, 2) - J2 * (square_1 + square_3));
  if (!shape.held) add(rho, rho, V_qq(3, 3) - J3 * (square_1 + square_2));
  const S product = nu[0] * nu[1];
  const bool in_plane = !vanishes(product);
  add(alpha, xi, in_plane ? S(V_qq(0, 1) + J1 * product) : V_qq(0, 1));
  add(alpha, zeta, in_plane ? S(V_qq(0, 2) + J2 * product) : V_qq(0, 2));
  add(xi, zeta, V_qq(1, 2));
  if (shape.held) {
    leaf_detail::add_held_volume(body, q, nu, s, r_alpha, out);
  } else {
    add(alpha, rho, V_qq(0, 3));
    add(xi, rho, V_qq(1, 3));
    add(zeta, rho, V_qq(2, 3));
  }

  if (!shape.turns || shape.held) {
    std::array<std::size_t, 10> left;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 10; ++k)
      if ((shape.turns || k % 5 != b1) && !(shape.held && k % 5 == rho)) left[count++] = k;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i; j < count; ++j) out[i][j] = out[left[i]][left[j]];
  }
  for (std::size_t i = 0; i < 10; ++i)
    for (std::size_t j = 0; j < i; ++j) out[i][j] = out[j][i];
  return out;
}

/// A frame's, with the kappa that nu and pi themselves have.
template <class S>
LeafSpin<S> leaf_spin(const LeafFrame<S>& frame, const Vector3<S>& nu, const std::array<S, 3>& pi) {
  return {frame, (nu[0] * pi[0] + nu[1] * pi[1] + nu[2] * pi[2]) / frame.size};
}

/// With the frame that pi itself asks for.
template <class S, class Inertias>
LeafForm<S> second_variation(const Inertias& body, const BasicStretch<S>& q, const Vector3<S>& nu,
                             const LeafShape& shape, const Matrix4<S>& V_qq) {
  return second_variation(body, q, nu, shape, V_qq, [&](const std::array<S, 3>& pi) {
    return leaf_spin(leaf_frame(pi), nu, pi);
  });
}

}  // namespace stationary
