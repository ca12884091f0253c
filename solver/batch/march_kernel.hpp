// A march of march.hpp in packs: the reduced Newton of refine.hpp, its steps, acceptance and
// error bound, in all lanes at once and with the models' own log_balance(),
//
//   G(x) = 0 in ln x,   delta = -J^-1 G,   accepted where kappa delta^2 <= 2^-56,
//
// lanes that are accepted keep their x while others go on. A lane is given up where its predictor
// was off by more than 1%, its Jacobian is not positive definite (the rest state's is; the circle
// of J1 = J2 excepted, where ellipses branch off) or so badly conditioned that the residual does
// not suffice: the scalar path takes over (batch.hpp).
#pragma once

#include <limits>

#include "lib/number/simd_pack.hpp"
#include "solver/batch/march.hpp"
#include "solver/batch/term_magnitude.hpp"

namespace stationary {

constexpr double march_accepted = 0x1p-56;  ///< kappa delta^2, as in refine()
constexpr double march_first_step = 0.01;   ///< largest first correction, in ln x
constexpr double march_extended = 0x1p-68;  ///< error of a residual in pairs, of its terms
constexpr double march_plain = 0x1p-50;     ///< of one in double
constexpr double march_rounding = 0x1p-57;  ///< what a residual in pairs may leave of x
constexpr int march_most_corrections = 6;

/// The lanes' numbers in the number type S.
template <class S, class V>
[[gnu::always_inline]] inline S lane_number(const V& x) {
  if constexpr (std::is_same_v<S, V>) {
    return x;
  } else if constexpr (requires { S::input(x); }) {
    return S::input(x);
  } else if constexpr (requires(S s) { s.value; }) {
    return S(abs(x));
  } else {
    return S(x);
  }
}
template <class S, class V>
[[gnu::always_inline]] inline S lane_number(const Pair<V>& x) {
  if constexpr (requires(S s) { s.hi; }) {
    return x;
  } else {
    return lane_number<S>(V(x));
  }
}

/// What a correction needs to know at x: J = [[uu, uv], [uv, vv]] and sizes, all in double.
template <class V>
struct LaneLinearized {
  V g[2];
  V uu;
  V uv;
  V vv;
  V terms;      ///< of G, the larger of both rows
  V curvature;  ///< of G in ln x: half its second derivative at most (powers of x up to 4)
  V pull;       ///< the larger centrifugal term
};

template <class V, template <class> class Model>
struct PlanarLanes {
  static constexpr int unknowns = 2;
  V coefficient[2];
  Pair<V> rate[2];

  template <class S>
  [[gnu::always_inline]] LogBalance<S> balance(const V* x) const {
    return balance<S>(x, rate);
  }
  template <class S, class X, class C>
  [[gnu::always_inline]] LogBalance<S> balance(const X* x, const C* c) const {
    const Model<S> model{lane_number<S>(coefficient[0]), lane_number<S>(coefficient[1])};
    return model.log_balance(lane_number<S>(x[0]), lane_number<S>(x[1]), lane_number<S>(c[0]),
                             lane_number<S>(c[1]));
  }
  [[gnu::always_inline]] LaneLinearized<V> linearize(const V* x) const {
    const LogBalance<V> b = balance<V>(x);
    const LogBalance<TermSize<V>> size = balance<TermSize<V>>(x);
    return {{b.g_xi, b.g_zeta},
            b.uu,
            b.uv,
            b.vv,
            larger(size.g_xi.value, size.g_zeta.value),
            2.0 * (size.uu.value + 2.0 * size.uv.value + size.vv.value),
            larger(rate[0].hi * (x[0] * x[0]), rate[1].hi * (x[1] * x[1]))};
  }
  [[gnu::always_inline]] void extended_residual(const V* x, V* g) const {
    const LogBalance<Pair<V>> b = balance<Pair<V>>(x);
    g[0] = V(b.g_xi);
    g[1] = V(b.g_zeta);
  }
};

template <class V, template <class> class Model>
struct ThicknessLanes {
  static constexpr int unknowns = 1;
  V coefficient[2];
  Pair<V> rate[2];

  template <class S>
  [[gnu::always_inline]] LogBalance<S> balance(const V* x) const {
    return balance<S>(x, rate);
  }
  template <class S, class X, class C>
  [[gnu::always_inline]] LogBalance<S> balance(const X* x, const C* c) const {
    const Model<S> model{lane_number<S>(coefficient[0]), lane_number<S>(coefficient[1])};
    return model.log_balance(lane_number<S>(x[0]), lane_number<S>(c[0]));
  }
  [[gnu::always_inline]] LaneLinearized<V> linearize(const V* x) const {
    const LogBalance<V> b = balance<V>(x);
    const LogBalance<TermSize<V>> size = balance<TermSize<V>>(x);
    return {{b.g_rho, V(0.0)},         b.ww, V(0.0), V(1.0), size.g_rho.value, 2.0 * size.ww.value,
            rate[0].hi * (x[0] * x[0])};
  }
  [[gnu::always_inline]] void extended_residual(const V* x, V* g) const {
    g[0] = V(balance<Pair<V>>(x).g_rho);
    g[1] = V(0.0);
  }
};

/// One step's state: where the lanes are and which of them still march.
template <class V>
struct LaneState {
  V x[2];
  typename V::Mask alive;
  V error_bound;
};

/// Corrects the lanes that are alive; those that cannot be are so no longer.
template <class System, class V>
[[gnu::always_inline]] inline void correct_lanes(const System& system,
                                                 const typename V::Mask& circle, bool extended,
                                                 bool bounded, LaneState<V>& at) {
  using Mask = typename V::Mask;
  Mask active = at.alive;
  for (int corrections = 0; corrections < march_most_corrections; ++corrections) {
    LaneLinearized<V> here = system.linearize(at.x);
    if (extended) system.extended_residual(at.x, here.g);
    const V determinant = here.uu * here.vv - here.uv * here.uv;
    const V scale = 1.0 / determinant;
    const V step[2] = {(here.vv * here.g[0] - here.uv * here.g[1]) * scale,
                       (here.uu * here.g[1] - here.uv * here.g[0]) * scale};
    const V size = larger(abs(step[0]), abs(step[1]));
    const V inverse = (larger(abs(here.uu), abs(here.vv)) + abs(here.uv)) * abs(scale);
    if (corrections == 0) {
      const Mask trusted = (size <= march_first_step) & ((V(0.0) < determinant) | circle);
      active = active & trusted;
      at.alive = active;
    }
    const V kappa = inverse * here.curvature;
    const V quadratic = kappa * size * size;
    Mask accepted = active & (quadratic <= march_accepted);
    const V noise = inverse * (here.terms + here.curvature);
    if (extended) accepted = accepted & (noise * march_extended <= march_rounding);
    for (int i = 0; i < System::unknowns; ++i) {
      const V moved = at.x[i] - at.x[i] * (step[i] - 0.5 * step[i] * step[i]);
      at.x[i] = select(active, moved, at.x[i]);
    }
    if (bounded) {
      const V linear = inverse * (0x1p-53 * (here.terms + 2.0 * here.pull)) +
                       noise * (extended ? march_extended : march_plain) +
                       kappa * size * (size + 0x1p-50) + 0x1p-53;
      // e = linear + kappa e^2, its smaller root, by two steps from below and a little more.
      const V once = linear * (1.0 + kappa * linear);
      const V e = linear + kappa * once * once;
      const Mask small = kappa * linear <= 0x1p-6;
      const V bound =
          select(small, e * (1.0 + 0x1p-12), V(std::numeric_limits<double>::infinity()));
      at.error_bound = select(accepted, bound, at.error_bound);
    }
    active = active & ~accepted;
    if (!any(active)) return;
  }
  at.alive = at.alive & ~active;
}

/// Flattened: a balance left as a call would pass its pairs of packs through memory.
template <class V, class System>
[[gnu::flatten]] void march(const March& m) {
  using Mask = typename V::Mask;
  constexpr int n = System::unknowns;
  System system;
  V inertia[2];
  for (int i = 0; i < 2; ++i) {
    system.coefficient[i] = V::load(m.coefficient[i]);
    inertia[i] = V::load(m.inertia[i]);
  }
  const V speed = V::load(m.speed);
  const Mask circle = inertia[0] == inertia[1];
  const V rest = V::load(m.rest);
  LaneState<V> at{{rest, rest}, speed == speed, V(0.0)};
  V past[4][2];
  for (auto& point : past)
    for (V& x : point) x = rest;
  V end(static_cast<double>(m.step_count));
  for (std::ptrdiff_t k = 0; k < m.step_count; ++k) {
    const MarchStep& step = m.steps[k];
    const V nu = speed * step.s;
    const Pair<V> square = two_product(nu, nu);
    for (int i = 0; i < n; ++i) {
      system.rate[i] = Pair<V>(inertia[i]) * square;
      at.x[i] = (step.weight[0] * past[0][i] + step.weight[1] * past[1][i]) +
                (step.weight[2] * past[2][i] + step.weight[3] * past[3][i]);
    }
    const Mask before = at.alive;
    correct_lanes<System, V>(system, circle, m.extended && step.slot >= 0,
                             m.bounded && step.slot >= 0, at);
    // As Sweep: from a circle towards what is pulled more, and never through one.
    if constexpr (n == 2) {
      const V more = inertia[0] - inertia[1];
      at.alive = at.alive & ~((at.x[0] - at.x[1]) * more < -0x1p-40 * (at.x[0] * abs(more)));
    }
    end = select(before & ~at.alive, V(static_cast<double>(k)), end);
    if (!any(at.alive)) break;
    for (int i = 0; i < n; ++i) {
      past[3][i] = past[2][i];
      past[2][i] = past[1][i];
      past[1][i] = past[0][i];
      past[0][i] = at.x[i];
    }
    if (step.slot < 0) continue;
    for (int i = 0; i < n; ++i) at.x[i].store(m.x[i] + step.slot * m.stride);
    if (m.bounded) at.error_bound.store(m.error_bound + step.slot * m.stride);
  }
  for (int lane = 0; lane < V::lanes; ++lane) {
    const double value = lane < V::half ? end.a[lane] : end.b[lane - V::half];
    m.end[lane] = static_cast<std::ptrdiff_t>(value);
  }
}

/// A kernel a model, in the order of its variant.
template <class Lanes, template <class> class... Model>
constexpr decltype(MarchKernels::plane) plane_marches(const std::variant<Model<double>...>*) {
  return {&march<Lanes, PlanarLanes<Lanes, Model>>...};
}
template <class Lanes, template <class> class... Model>
constexpr decltype(MarchKernels::thickness) thickness_marches(
    const std::variant<Model<double>...>*) {
  return {&march<Lanes, ThicknessLanes<Lanes, Model>>...};
}

/// All of them in packs of these lanes.
template <class Lanes>
const MarchKernels& march_kernels() {
  static constexpr MarchKernels kernels{Lanes::lanes, plane_marches<Lanes>(models<PlanarPotential>),
                                        thickness_marches<Lanes>(models<ThicknessPotential>)};
  return kernels;
}

}  // namespace stationary
