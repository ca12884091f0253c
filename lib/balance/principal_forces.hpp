// The balance of a body with fibres about axis 3, or about an axis (cos phi, sin phi, 0), along the
// principal axes of S,
//
//   S = L e e^T + s e' e'^T,  e = (cos theta, sin theta),  e' = (-sin theta, cos theta),  L >= s,
//
// where an isotropic V gives its rows at alpha = 0, the centrifugal force gathered with them
// (log_balance() of a model), and a fibre needs e alone: with
//
//   a = J1 cos^2 theta + J2 sin^2 theta,  a' = J1 sin^2 theta + J2 cos^2 theta,
//   b = (J2 - J1) sin(2 theta)/2,  A = sin(theta - phi),  B = cos(theta - phi),
//   m = L^2 (e.f)^2,  m' = s^2 (1 - (e.f)^2),  n = m + m' - 1,
//
// the derivatives of V - q^T C q/2 in ln L and ln s are
//
//   about axis 3   G_1(L, s; nu^2 a) + sum 2 k n m,   G_2(L, s; nu^2 a') + sum 2 k n m',
//   oblique        G_1(L, s; nu^2 A^2 a) - mixed + sum 2 k n m,
//                  G_2(L, s; nu^2 B^2 a') - mixed + sum 2 k n m',   mixed = nu^2 L s A B b,
//
// and that in theta, over s^2 - L^2 or, oblique, over -L^2, with r = s/L,
//
//   about axis 3   sum k n sin(2 theta - 2 f) + nu^2 b,
//   oblique        (1 - r^2) sum k n sin(2 theta - 2 f)
//                    + nu^2 (J2 - J1) ((A^2 - r^2 B^2) sin(2 theta) + 2 r A B cos(2 theta))/2,
//
// f the angle of a fibre. The last leaves out what is zero by compatibility,
//
//   sin(2 theta - 2 phi) (r^2 a' - a) - 2 r b cos(2 theta - 2 phi) = 0.
//
// Gravity adds 2 L^2 a V_T + V_l, 2 s^2 a' V_T + V_l and, in theta, -2 b V_T (oblique: times
// 1 - r^2); a held volume takes the derivative in ln rho from the first two.
//
// In (u, v, a) of anisotropic_balance.hpp each of these is a sum of terms that cancel where S is
// long and thin across a fibre: over boxes these are narrower by far.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <variant>

#include "lib/balance/anisotropic_balance.hpp"

namespace stationary {

template <class S>
struct PrincipalFrame {
  S large;   ///< L
  S small;   ///< s
  S cosine;  ///< of 2 theta
  S sine;
};

/// What is zero at a motion.
template <class S>
struct PrincipalForces {
  S along;   ///< in ln L
  S across;  ///< in ln s
  S sum;     ///< of the two
  /// In theta. About axis 3 a condition where L > s only; none where the axis leaves alpha no
  /// equation, in (i) and (ii).
  std::optional<S> turning;
  std::optional<S> compatibility;  ///< of an oblique axis
};

/// Holds an L, s and theta of every S in a box.
inline PrincipalFrame<Interval> principal_frame(const OrientedStretch<Interval>& at) {
  struct Range {
    double least;
    double most;

    explicit Range(const Interval& x)
        : least(x.may_be(0.0) ? 0.0 : std::min(std::abs(x.lo), std::abs(x.hi))),
          most(x.magnitude()) {}
  };
  const auto& q = at.q;
  // L and s rise with xi and zeta at fixed a; L rises and s falls with |a|.
  const auto large = [](double xi, double zeta, double tanh) {
    const Interval shear = 4.0 * (Interval(xi) * zeta * square(Interval(tanh)));
    return 0.5 * (Interval(xi) + zeta + sqrt(square(Interval(xi) - zeta) + shear));
  };
  const auto small = [&](double xi, double zeta, double tanh, double sech) {
    return Interval(xi) * zeta * square(Interval(sech)) / large(xi, zeta, tanh);
  };
  const Range tanh(at.tanh);
  PrincipalFrame<Interval> out;
  out.large = {large(q.xi.lo, q.zeta.lo, tanh.least).lo, large(q.xi.hi, q.zeta.hi, tanh.most).hi};
  out.small = {small(q.xi.lo, q.zeta.lo, tanh.most, at.sech.lo).lo,
               small(q.xi.hi, q.zeta.hi, tanh.least, at.sech.hi).hi};
  // (cosine, sine) = (D, 2 tanh a) over their length, D = (xi - zeta)/sqrt(xi zeta).
  const auto difference = [](double xi, double zeta) {
    return (Interval(xi) - zeta) / sqrt(Interval(xi) * zeta);
  };
  const Interval x{difference(q.xi.lo, q.zeta.hi).lo, difference(q.xi.hi, q.zeta.lo).hi};
  const Interval y = 2.0 * at.tanh;
  constexpr Interval any(-1.0, 1.0);
  const Range x_size(x);
  const Range y_size(y);
  if (x_size.least == 0.0 && y_size.least == 0.0) {
    out.cosine = out.sine = any;
    return out;
  }
  // x/sqrt(x^2 + y^2) rises with x, and falls in size with |y|.
  const auto share = [&](const Interval& of, const Range& beside) {
    const auto at_end = [&](double end, double other) {
      return end == 0.0 ? Interval(0.0)
                        : Interval(end) / sqrt(square(Interval(end)) + square(Interval(other)));
    };
    return common(any, {at_end(of.lo, of.lo <= 0.0 ? beside.least : beside.most).lo,
                        at_end(of.hi, of.hi >= 0.0 ? beside.least : beside.most).hi});
  };
  out.cosine = share(x, y_size);
  out.sine = share(y, x_size);
  return out;
}

/// Of a frame of `at`, at whose rho a held volume is. axis: of an unknown one, else nullptr and
/// branch. None of a model that is no function of the invariants and fibres.
template <class S>
std::optional<PrincipalForces<S>> principal_forces(
    const Inertia3<S>& J, const AnisotropicModel<S>& model, const OrientedStretch<S>& at,
    const PrincipalFrame<S>& frame, const S& nu_squared, const AxisAngle<S>* axis, Branch branch) {
  const auto within_one = [](const S& x) {
    if constexpr (std::is_same_v<S, Interval>) {
      return common(x, {-1.0, 1.0});
    } else {
      return x;
    }
  };
  const S& large = frame.large;
  const S& small = frame.small;
  const S& cosine = frame.cosine;
  const S& sine = frame.sine;
  const S one(1.0);
  const S quarter(0.25);
  const S ratio_squared = square(small / large);
  const S mean = 0.5 * (J.J1 + J.J2);
  const S half_difference = 0.5 * (J.J2 - J.J1);
  const S first = mean - half_difference * cosine;
  const S second = mean + half_difference * cosine;
  const S b = half_difference * sine;

  PrincipalForces<S> out;
  CentrifugalRates<S> rates{nu_squared * first, nu_squared * second, S(0.0)};
  S mixed(0.0);
  S shape = one;  // of the fibres' turning
  if (axis == nullptr && branch == Branch::iii) {
    out.turning = nu_squared * b;
  } else {
    S axis_cosine = branch == Branch::ii ? -one : one;  // of 2 phi
    S axis_sine(0.0);
    if (axis != nullptr) {
      axis_cosine = one - 2.0 * square(axis->sine);
      axis_sine = 2.0 * (axis->sine * axis->cosine);
    }
    // 2 theta - 2 phi
    const S apart_cosine = within_one(cosine * axis_cosine + sine * axis_sine);
    const S apart_sine = within_one(sine * axis_cosine - cosine * axis_sine);
    const S A_squared = 0.5 * (one - apart_cosine);
    const S B_squared = 0.5 * (one + apart_cosine);
    const S AB = 0.5 * apart_sine;
    rates = {rates.xi * A_squared, rates.zeta * B_squared, nu_squared * J.J3};
    mixed = nu_squared * (large * small * (AB * b));
    if (axis != nullptr) {
      const S ratio = small / large;
      shape = one - ratio_squared;
      out.compatibility =
          apart_sine * (ratio_squared * second - first) - 2.0 * (ratio * b * apart_cosine);
      out.turning =
          nu_squared * (half_difference * ((A_squared - ratio_squared * B_squared) * sine +
                                           2.0 * (ratio * AB * cosine)));
    }
  }

  S rho_row(0.0);
  const auto take = [&](const auto& m) {
    if constexpr (requires(PotentialDerivatives<S> & directed) {
                    m.template add<1>(at.q, directed);
                  }) {
      return false;
    } else if constexpr (requires { m.log_balance(large, small, rates.xi, rates.zeta); }) {
      const auto rows = m.log_balance(large, small, rates.xi, rates.zeta);
      out.along = rows.g_xi;
      out.across = rows.g_zeta;
      return true;
    } else if constexpr (requires {
                           m.log_balance(large, small, at.q.rho, rates.xi, rates.zeta, rates.rho);
                         }) {
      const auto rows = m.log_balance(large, small, at.q.rho, rates.xi, rates.zeta, rates.rho);
      out.along = rows.g_xi;
      out.across = rows.g_zeta;
      rho_row = rows.g_rho;
      return true;
    } else {
      return false;
    }
  };
  if (const auto* separate = std::get_if<typename AnisotropicModel<S>::Separate>(&model.base)) {
    if (!std::visit(take, separate->plane)) return std::nullopt;
    rho_row = separate->thickness ? S(separate->thickness->log_balance(at.q.rho, rates.rho).g_rho)
                                  : S(-(rates.rho * square(at.q.rho)));
  } else if (!std::visit(take, std::get<OrientedCoupledModels<S>>(model.base))) {
    return std::nullopt;
  }
  out.along -= mixed;
  out.across -= mixed;
  if (model.body.gravitates) {
    const auto& own = model.body.J;
    const auto V = gravity_derivatives<1>(model.body.g, own, planar_moment(own, at.q),
                                          at.invariants().d, at.q.rho);
    const S& V_T = V.plane.w_t;
    out.along += gravity_row<S>(2.0 * (square(large) * first * V_T) + V.plane.w_l, V);
    out.across += gravity_row<S>(2.0 * (square(small) * second * V_T) + V.plane.w_l, V);
    rho_row += gravity_row(V.w_r, V);
    if (out.turning) *out.turning -= 2.0 * (shape * b * V_T);
  }
  if (model.body.volume) {
    out.along -= rho_row;
    out.across -= rho_row;
  }
  out.sum = out.along + out.across;
  for (std::size_t k = 0; k < model.fibre_count; ++k) {
    const auto& [c, s] = model.fibres[k].along;
    const S& stiffness = model.fibres[k].k;
    const S fibre_cosine = square(c) - square(s);
    const S fibre_sine = 2.0 * (c * s);
    const S apart_cosine = within_one(cosine * fibre_cosine + sine * fibre_sine);
    const S apart_sine = within_one(sine * fibre_cosine - cosine * fibre_sine);
    const S m = square(large) * (0.5 * (one + apart_cosine));
    const S m_across = square(small) * (0.5 * (one - apart_cosine));
    S whole = square(at.q.xi * c + at.q.alpha * s) + square(at.q.alpha * c + at.q.zeta * s);
    if constexpr (std::is_same_v<S, Interval>) whole = common(whole, m + m_across);
    // 2 k n m with n = m + m' - 1, and 2 k n (n + 1) >= -k/2.
    const S both = m * m_across - quarter;
    out.along += 2.0 * (stiffness * (square(m - 0.5) + both));
    out.across += 2.0 * (stiffness * (square(m_across - 0.5) + both));
    out.sum += 2.0 * (stiffness * (square(whole - 0.5) - quarter));
    if (out.turning) *out.turning += shape * (stiffness * ((whole - one) * apart_sine));
  }
  return out;
}

}  // namespace stationary
