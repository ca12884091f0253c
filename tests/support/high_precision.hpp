// Reference solutions: the balance in the 50-digit source of lib, by Newton from a double solution.
// The inputs are the doubles themselves (exact), not the decimals they came from.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <stdexcept>

#include "lib/balance.hpp"
#include "solver/problem.hpp"

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
/// converge.
template <std::size_t N, class F>
std::array<Number50, N> newton_50(std::array<Number50, N> x, const F& linearize) {
  for (int step = 0; step < 100; ++step) {
    const auto [g, J] = linearize(x);
    const auto delta = solved<N>(J, g);
    Number50 size = 0;
    for (std::size_t i = 0; i < N; ++i) {
      x[i] *= exp(-delta[i]);
      if (abs(delta[i]) > size) size = abs(delta[i]);
    }
    if (size < Number50("1e-38")) return x;  // squared it is below 50 digits, near a fold too
  }
  throw std::runtime_error("the 50-digit Newton did not converge");
}

/// (xi, zeta, rho) near q, which must be a good approximation.
inline std::array<Number50, 3> reference_solution(const Problem& problem, double nu,
                                                  const Stretch& q) {
  const Number50 nu_squared = Number50(nu) * Number50(nu);
  const CentrifugalRates<Number50> c = problem.rates(nu_squared);
  using Vector2 = std::array<Number50, 2>;
  using Vector3 = std::array<Number50, 3>;
  return problem.potential().visit([&](const auto& model) -> Vector3 {
    if constexpr (requires { model.plane; }) {
      const auto plane = widened(model.plane);
      const Vector2 x = newton_50<2>({Number50(q.xi), Number50(q.zeta)}, [&](const Vector2& at) {
        const auto w = plane.template evaluate<2>(planar_invariants(at[0], at[1]));
        const auto b = planar_log_balance<2>(w, at[0], at[1], c);
        return std::pair{Vector2{b.g_xi, b.g_zeta},
                         std::array<Vector2, 2>{{{b.uu, b.uv}, {b.uv, b.vv}}}};
      });
      const auto thickness = widened(model.thickness);
      using Vector1 = std::array<Number50, 1>;
      const Vector1 rho = newton_50<1>({Number50(q.rho)}, [&](const Vector1& at) {
        const auto v = thickness.template evaluate<2>(at[0]);
        const Number50 pull = c.rho * at[0] * at[0];
        return std::pair{Vector1{v.v_r - pull}, std::array<Vector1, 1>{{{v.v_rr - 2 * pull}}}};
      });
      return {x[0], x[1], rho[0]};
    } else {
      const auto coupled = widened(model);
      return newton_50<3>(
          {Number50(q.xi), Number50(q.zeta), Number50(q.rho)}, [&](const Vector3& at) {
            const auto w = coupled.template evaluate<2>(planar_invariants(at[0], at[1]), at[2]);
            const auto b = coupled_log_balance<2>(w, at[0], at[1], at[2], c);
            return std::pair{Vector3{b.g_xi, b.g_zeta, b.g_rho},
                             std::array<Vector3, 3>{
                                 {{b.uu, b.uv, b.uw}, {b.uv, b.vv, b.vw}, {b.uw, b.vw, b.ww}}}};
          });
    }
  });
}

/// Largest relative error of (xi, zeta, rho).
inline double relative_error(const Stretch& q, const std::array<Number50, 3>& exact) {
  const double x[3] = {q.xi, q.zeta, q.rho};
  double worst = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    worst = std::max(worst, abs((Number50(x[i]) - exact[i]) / exact[i]).convert_to<double>());
  return worst;
}

}  // namespace stationary::testing
