// Reference solutions: the balance in the 50-digit source of lib, by Newton from a double solution.
// The inputs are the doubles themselves (exact), not the decimals they came from.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <stdexcept>

#include "lib/balance/balance.hpp"
#include "lib/stability/linearization.hpp"
#include "solver/motion/problem.hpp"

namespace stationary::testing {

/// 50 digits, without expression templates, which lib's templates would have to name.
using Number50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                               boost::multiprecision::et_off>;

template <template <class> class Model>
Model<Number50> widened(const Model<double>& model) {
  const auto p = model.coefficients();
  return {Number50(p[0]), Number50(p[1])};
}

/// A x = b for N = 1, 2, 3 by Gaussian elimination with row exchange.
template <std::size_t N>
std::array<Number50, N> solved(std::array<std::array<Number50, N>, N> A,
                               std::array<Number50, N> b) {
  for (std::size_t k = 0; k < N; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < N; ++i)
      if (abs(A[i][k]) > abs(A[pivot][k])) pivot = i;
    std::swap(A[k], A[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < N; ++i) {
      const Number50 f = A[i][k] / A[k][k];
      for (std::size_t j = k; j < N; ++j) A[i][j] -= f * A[k][j];
      b[i] -= f * b[k];
    }
  }
  for (std::size_t k = N; k-- > 0;) {
    for (std::size_t j = k + 1; j < N; ++j) b[k] -= A[k][j] * b[j];
    b[k] /= A[k][k];
  }
  return b;
}

/// Newton in ln x on `linearize(x) -> (g, J)`; throws std::runtime_error where it does not
/// converge. A nearly singular J leaves more than 1e-38: then to where the steps stop shrinking.
template <std::size_t N, class F>
std::array<Number50, N> newton_50(std::array<Number50, N> x, const F& linearize) {
  Number50 last = 1;
  for (int step = 0; step < 100; ++step) {
    const auto [g, J] = linearize(x);
    const auto delta = solved<N>(J, g);
    Number50 size = 0;
    for (std::size_t i = 0; i < N; ++i) {
      x[i] *= exp(-delta[i]);
      if (abs(delta[i]) > size) size = abs(delta[i]);
    }
    if (size < Number50("1e-38")) return x;  // squared it is below 50 digits, near a fold too
    if (size < Number50("1e-26") && size >= last) return x;
    last = size;
  }
  throw std::runtime_error("the 50-digit Newton did not converge");
}

template <std::size_t N>
using Linearized50 = std::pair<std::array<Number50, N>, std::array<std::array<Number50, N>, N>>;

using Inertia50 = Inertia3<Number50>;

/// The balance of a separable potential's plane, which has none of the terms with rho,
inline LogBalance<Number50> planar_log_balance_50(const Potential& potential,
                                                  const CentrifugalRates<Number50>& c,
                                                  const std::array<Number50, 2>& x) {
  return std::visit(
      [&](const auto& model) {
        const auto w = widened(model).template evaluate<2>(planar_invariants(x[0], x[1]));
        return planar_log_balance<2>(w, x[0], x[1], c);
      },
      potential.plane());
}

/// of its thickness, which has only those,
inline LogBalance<Number50> thickness_log_balance_50(const Potential& potential,
                                                     const CentrifugalRates<Number50>& c,
                                                     const Number50& rho) {
  return std::visit(
      [&](const auto& model) {
        const auto v = widened(model).template evaluate<2>(rho);
        const Number50 pull = c.rho * rho * rho;
        LogBalance<Number50> out;
        out.g_rho = v.v_r - pull;
        out.ww = v.v_rr - 2 * pull;
        return out;
      },
      potential.thickness());
}

/// and of a coupled one.
inline LogBalance<Number50> coupled_log_balance_50(const Potential& potential,
                                                   const CentrifugalRates<Number50>& c,
                                                   const std::array<Number50, 3>& x) {
  return std::visit(
      [&](const auto& model) {
        const auto w = widened(model).template evaluate<2>(planar_invariants(x[0], x[1]), x[2]);
        return coupled_log_balance<2>(w, x[0], x[1], x[2], c);
      },
      potential.coupled());
}

/// G and dG/d ln x of the unknowns a separable potential leaves, (xi, zeta) and rho alone,
inline Linearized50<2> planar_balance_50(const Problem& problem, const Number50& nu_squared,
                                         const std::array<Number50, 2>& x) {
  const auto b = planar_log_balance_50(problem.potential(), problem.rates(nu_squared), x);
  return {{b.g_xi, b.g_zeta}, {{{b.uu, b.uv}, {b.uv, b.vv}}}};
}
inline Linearized50<1> thickness_balance_50(const Problem& problem, const Number50& nu_squared,
                                            const std::array<Number50, 1>& x) {
  const auto b = thickness_log_balance_50(problem.potential(), problem.rates(nu_squared), x[0]);
  return {{b.g_rho}, {{{b.ww}}}};
}

/// and of (xi, zeta, rho) of a coupled one.
inline Linearized50<3> coupled_balance_50(const Problem& problem, const Number50& nu_squared,
                                          const std::array<Number50, 3>& x) {
  const auto b = coupled_log_balance_50(problem.potential(), problem.rates(nu_squared), x);
  return {{b.g_xi, b.g_zeta, b.g_rho},
          {{{b.uu, b.uv, b.uw}, {b.uv, b.vv, b.vw}, {b.uw, b.vw, b.ww}}}};
}

/// All three equations at x = (xi, zeta, rho), of any potential.
inline LogBalance<Number50> log_balance_50(const Potential& potential,
                                           const CentrifugalRates<Number50>& c,
                                           const std::array<Number50, 3>& x) {
  if (!potential.is_separable()) return coupled_log_balance_50(potential, c, x);
  LogBalance<Number50> out = planar_log_balance_50(potential, c, {x[0], x[1]});
  const LogBalance<Number50> thickness = thickness_log_balance_50(potential, c, x[2]);
  out.g_rho = thickness.g_rho;
  out.ww = thickness.ww;
  out.uw = out.vw = 0;
  return out;
}

/// (xi, zeta, rho) near q, which must be a good approximation.
inline std::array<Number50, 3> reference_solution(const Problem& problem, double nu,
                                                  const Stretch& q) {
  const Number50 s = Number50(nu) * Number50(nu);
  const Number50 xi(q.xi);
  const Number50 zeta(q.zeta);
  const Number50 rho(q.rho);
  if (!problem.potential().is_separable())
    return newton_50<3>({xi, zeta, rho},
                        [&](const auto& x) { return coupled_balance_50(problem, s, x); });
  const auto x =
      newton_50<2>({xi, zeta}, [&](const auto& at) { return planar_balance_50(problem, s, at); });
  const auto r =
      newton_50<1>({rho}, [&](const auto& at) { return thickness_balance_50(problem, s, at); });
  return {x[0], x[1], r[0]};
}

/// Largest relative error of (xi, zeta, rho).
inline double relative_error(const Stretch& q, const std::array<Number50, 3>& exact) {
  const double x[3] = {q.xi, q.zeta, q.rho};
  double worst = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    worst = std::max(worst, abs((Number50(x[i]) - exact[i]) / exact[i]).convert_to<double>());
  return worst;
}

/// Half a unit in the last place, relative to the number: correct rounding.
constexpr double half_unit = 0x1p-53 * (1.0 + 1e-3);
/// Half a unit, and what the accepted correction may leave of its square (refine.hpp).
constexpr double refined_half_unit = 0x1p-53 + 0x1p-56;

}  // namespace stationary::testing
