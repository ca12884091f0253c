// The state of a pack's cells (spectrum_kernel.hpp) from the models' derivatives in (u, v, w) =
// ln (xi, zeta, rho): with G the balance there and C the centrifugal terms,
//
//   V_xx - C = diag(1/q) G' diag(1/q) at equilibrium,  V_aa = 2 (V_xi - V_zeta)/(xi - zeta)
//                                                           = 2 (C_xi - C_zeta)/(xi - zeta),
// on the circle 2 (V_xi,xi - V_xi,zeta).
#pragma once

#include "lib/number/running_error.hpp"
#include "lib/stability/linearization.hpp"
#include "solver/batch/march_kernel.hpp"
#include "solver/batch_spectrum/spectrum_tile.hpp"

namespace stationary {

template <class V>
struct LaneDerivative {
  Pair<V> value;
  V units;

  [[gnu::always_inline]] static LaneDerivative load(const SpectrumTile::Derivative& from,
                                                    std::size_t i) {
    return {{V::load(from.head + i), V::load(from.tail + i)}, V::load(from.units + i)};
  }
  [[gnu::always_inline]] void store(SpectrumTile::Derivative& to, std::size_t i) const {
    value.hi.store(to.head + i);
    value.lo.store(to.tail + i);
    units.store(to.units + i);
  }
};

/// Of the same derivative, with its error and as a pair.
template <class V>
[[gnu::always_inline]] inline LaneDerivative<V> lane_derivative(const RunningError<V>& bounded,
                                                                const Pair<V>& pair, bool modes) {
  return {modes ? pair : Pair<V>(bounded.value), bounded.units};
}

/// The part's derivatives and what rounding left of its x: of xi and zeta, or of rho.
template <class V, class System>
[[gnu::flatten]] void lane_derivatives(const SpectrumTile::Numbers* coefficient,
                                       const SpectrumTile::Numbers* q,
                                       const SpectrumTile::Numbers* pull, bool modes,
                                       SpectrumTile& tile, SpectrumTile::Numbers* tail) {
  using Error = RunningError<V>;
  constexpr int n = System::unknowns;
  for (std::size_t i = 0; i < SpectrumTile::size; i += V::lanes) {
    System system;
    for (int k = 0; k < 2; ++k) system.coefficient[k] = V::load(coefficient[k] + i);
    const V nu = V::load(tile.nu + i);
    V x[2];
    Error x_error[2];
    Error rate_error[2];
    const Error nu_error = Error::input(nu);
    for (int k = 0; k < n; ++k) {
      x[k] = V::load(q[k] + i);
      const V inertia = V::load(pull[k] + i);
      system.rate[k] = Pair<V>(inertia) * two_product(nu, nu);
      x_error[k] = Error::input(x[k]);
      rate_error[k] = Error::input(inertia) * (nu_error * nu_error);
    }
    const auto bounded = system.template balance<Error>(x_error, rate_error);
    LogBalance<Pair<V>> pairs;
    if (modes) {
      LaneLinearized<V> here = system.linearize(x);
      system.extended_residual(x, here.g);
      const V scale = 1.0 / (here.uu * here.vv - here.uv * here.uv);
      const V step[2] = {(here.vv * here.g[0] - here.uv * here.g[1]) * scale,
                         (here.uu * here.g[1] - here.uv * here.g[0]) * scale};
      Pair<V> corrected[2];
      for (int k = 0; k < n; ++k) {
        // As extended_solution(): beyond the last place it says the Jacobian is useless here.
        const V move = select(abs(step[k]) < V(1e-10), -(x[k] * step[k]), V(0.0));
        corrected[k] = two_sum(x[k], move);
        // Heads stay what they are in nearly every cell; where not, the scalar path is right too.
        ((corrected[k].hi - x[k]) + corrected[k].lo).store(tail[k] + i);
      }
      pairs = system.template balance<Pair<V>>(corrected, system.rate);
    }
    if constexpr (n == 2) {
      lane_derivative(bounded.uu, pairs.uu, modes).store(tile.uu, i);
      lane_derivative(bounded.uv, pairs.uv, modes).store(tile.uv, i);
      lane_derivative(bounded.vv, pairs.vv, modes).store(tile.vv, i);
    } else {
      lane_derivative(bounded.ww, pairs.ww, modes).store(tile.ww, i);
    }
  }
}

template <class V, template <class> class Model>
void plane_derivatives(SpectrumTile& tile, bool modes) {
  lane_derivatives<V, PlanarLanes<V, Model>>(tile.plane, tile.q, tile.pull, modes, tile, tile.tail);
}
template <class V, template <class> class Model>
void thickness_derivatives(SpectrumTile& tile, bool modes) {
  lane_derivatives<V, ThicknessLanes<V, Model>>(tile.thickness, tile.q + 2, tile.pull + 2, modes,
                                                tile, tile.tail + 2);
}

/// One pack of a tile's cells in the number type S; (iii) where normal, else (i).
template <bool normal, class S, class Mask>
[[gnu::always_inline]] inline StraightState<S> lane_state(const Inertia3<S>& J, const S (&q)[3],
                                                          const S& omega, const S& uu, const S& uv,
                                                          const S& vv, const S& ww,
                                                          const Mask& circle) {
  const S inverse[3] = {S(1.0) / q[0], S(1.0) / q[1], S(1.0) / q[2]};
  const S square = omega * omega;
  StraightState<S> s{J, q[0], q[1], q[2], omega, {}, {}, {}, {}, S(0.0), S(0.0), {}};
  s.V_xx = uu * (inverse[0] * inverse[0]);
  s.V_xz = uv * (inverse[0] * inverse[1]);
  s.V_zz = vv * (inverse[1] * inverse[1]) + J.J2 * square;
  s.V_rr = ww * (inverse[2] * inverse[2]);
  if constexpr (normal) {
    s.V_xx = s.V_xx + J.J1 * square;
    s.V_aa = select(circle, 2.0 * (s.V_xx - s.V_xz),
                    2.0 * square * (J.J1 * q[0] - J.J2 * q[1]) / (q[0] - q[1]));
  } else {
    s.V_rr = s.V_rr + J.J3 * square;
    s.V_aa = -(2.0 * square * (J.J2 * q[1]) / (q[0] - q[1]));
  }
  return s;
}

template <int bytes>
[[gnu::always_inline]] inline RunningError<Pack<bytes>> select(const PackMask<bytes>& where,
                                                               const RunningError<Pack<bytes>>& x,
                                                               const RunningError<Pack<bytes>>& y) {
  return {select(where, x.value, y.value), select(where, x.units, y.units)};
}

}  // namespace stationary
