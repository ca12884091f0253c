// The corrections of refine.hpp in packs, for the oriented balance (anisotropic_balance.hpp) of a
// separable potential with fibres about a material axis: (xi, zeta[, a]) and rho do not see each
// other. A point is accepted once kappa delta (delta + 2^-50) <= 2^-86, that is with what rounding x
// leaves of it known too, as alpha needs it; its bound is that of refine(). A point whose residual,
// in pairs with a shorter logarithm (simd_pack.hpp), may leave more than 2^-60 of x is not accepted.
#pragma once

#include <array>
#include <cstddef>

#include "lib/balance/anisotropic_balance.hpp"
#include "lib/number/dual.hpp"
#include "lib/number/simd_pack.hpp"
#include "solver/batch/oriented_lanes.hpp"
#include "solver/newton/refine.hpp"

namespace stationary {

/// A lane's potential and inertia in the number type S.
template <class S, template <class> class Plane>
struct LanePotential {
  Inertia3<S> J;
  Plane<S> plane;
  bool harmonic;
  std::array<S, 2> thickness;
  std::array<FibreTerm<S>, AnisotropicModel<double>::max_fibres> fibre;
  std::size_t fibres;

  template <int order>
  [[gnu::always_inline]] AnisotropicDerivatives<S> evaluate(const OrientedStretch<S>& at) const {
    const S none(0.0);
    AnisotropicDerivatives<S> out;
    out.isotropic = {plane.template evaluate<order>(at.invariants()), none, none, none, none};
    const auto axial =
        harmonic
            ? Harmonic<S>{thickness[0], thickness[1]}.template evaluate<order>(at.q.rho)
            : ReciprocalQuadratic<S>{thickness[0], thickness[1]}.template evaluate<order>(at.q.rho);
    out.isotropic.w_r = axial.v_r;
    out.isotropic.w_rr = axial.v_rr;
    out.directed = {none, Vector4<S>::Constant(none), Matrix4<S>::Constant(none)};
    for (std::size_t k = 0; k < fibres; ++k) fibre[k].template add<order>(at.q, out.directed);
    return out;
  }
};

/// Of pairs the directions in extended precision.
template <class S, class V, template <class> class Plane>
[[gnu::always_inline]] inline LanePotential<S, Plane> lane_potential(const OrientedLane& lane) {
  const auto number = [](double x) { return S(V(x)); };
  LanePotential<S, Plane> out{
      .J = {number(lane.inertia[0]), number(lane.inertia[1]), number(lane.inertia[2])},
      .plane = {number(lane.plane[0]), number(lane.plane[1])},
      .harmonic = lane.harmonic,
      .thickness = {number(lane.thickness[0]), number(lane.thickness[1])},
      .fibre = {},
      .fibres = lane.fibres};
  for (std::size_t k = 0; k < lane.fibres; ++k) {
    const auto& fibre = lane.fibre[k];
    out.fibre[k].k = number(fibre.k);
    if constexpr (std::is_same_v<S, Pair<V>>) {
      out.fibre[k].along = {{V(fibre.wide.cosine.hi), V(fibre.wide.cosine.lo)},
                            {V(fibre.wide.sine.hi), V(fibre.wide.sine.lo)}};
    } else {
      out.fibre[k].along = {number(fibre.along.cosine), number(fibre.along.sine)};
    }
  }
  return out;
}

/// Of the balance the unknowns' rows; a is no unknown where alpha = 0.
template <class V, template <class> class Plane, bool sheared>
class OrientedCorrection {
 public:
  static constexpr std::size_t n = sheared ? 3 : 2;
  /// Places in oriented:: of the plane's unknowns, and of x in OrientedPoints.
  static constexpr std::array<std::size_t, 3> place{oriented::u, oriented::v, oriented::a};

  explicit OrientedCorrection(const OrientedLane& lane)
      : lane_(lane),
        plain_(lane_potential<V, V, Plane>(lane)),
        wide_(lane_potential<Pair<V>, V, Plane>(lane)) {}

  /// Of one pack of points.
  [[gnu::always_inline]] void run(OrientedPoints& points, std::size_t i) {
    using Mask = typename V::Mask;
    const V nu = V::load(points.nu.data() + i);
    const V nu_squared = nu * nu;
    std::array<V, 4> x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = V::load(points.x[k].data() + i);
    Mask active = nu == nu;
    Mask accepted = nu < nu;
    V size;
    V kappa;
    for (int correction = 0; correction < most; ++correction) {
      linearize(x, nu_squared);
      extended_residual(x, nu);
      invert();
      size = abs(step_[0]);
      for (std::size_t k = 1; k < 4; ++k) size = larger(abs(step_[k]), size);
      V largest = abs(g_[0]);
      for (std::size_t k = 1; k < 4; ++k) largest = larger(abs(g_[k]), largest);
      kappa = rows({V(1.0), V(1.0), V(1.0), V(1.0)});
      // As refine(): no correction is that large, no matrix that singular.
      active = active & (size <= V(0.5)) & (largest <= 64.0 * size);
      accepted = active & (kappa * size * (size + 0x1p-50) <= V(0x1p-86)) &
                 (kappa * extended <= V(0x1p-60));
      if (!any(active & ~accepted)) break;
      for (std::size_t k = 0; k < 4; ++k)
        x[k] = select(accepted, x[k], moved_little(x[k], -step_[k]));
    }
    const V linear = rows(perturbation(x, nu_squared)) + kappa * size * (size + 0x1p-50) + 0x1p-53;
    const V rest = 1.0 - 4.0 * kappa * linear;
    const Mask simple = V(0.0) < rest;
    const V bound = select(simple, 2.0 * linear / (1.0 + sqrt(select(simple, rest, V(1.0)))),
                           0.5 / kappa + sqrt(linear / kappa));
    select(bound < linear, linear, bound).store(points.error_bound.data() + i);
    select(accepted, V(1.0), V(0.0)).store(points.accepted.data() + i);
    select(V(0.0) < determinant_, V(1.0), V(0.0)).store(points.positive.data() + i);
    std::array<Pair<V>, 4> wide;
    for (std::size_t k = 0; k < 4; ++k) {
      wide[k] = two_sum(x[k], -(x[k] * step_[k]));
      moved_little(x[k], -step_[k]).store(points.x[k].data() + i);
    }
    V alpha(0.0);
    if constexpr (sheared) {
      const V exact = V(oriented_stretch(wide[0], wide[1], wide[2], wide[3]).q.alpha);
      // Below the rounding of extended precision it is none.
      alpha = select(0x1p-80 * sqrt(x[0] * x[1]) < abs(exact), exact, alpha);
    }
    alpha.store(points.alpha.data() + i);
  }

 private:
  static constexpr int most = 4;
  /// Error of a residual in pairs, of its terms.
  static constexpr double extended = 0x1p-68;

  template <class S, class X>
  [[gnu::always_inline]] static OrientedStretch<S> stretch(const std::array<X, 4>& x) {
    if constexpr (sheared) {
      return oriented_stretch(S(x[0]), S(x[1]), S(x[2]), S(x[3]));
    } else {
      using std::sqrt;
      return {{S(0.0), S(x[0]), S(x[1]), S(x[2])}, sqrt(S(S(x[0]) * x[1])), S(0.0), S(1.0)};
    }
  }

  /// J and the rows' sizes, as OrientedSystem::linearize().
  [[gnu::always_inline]] void linearize(const std::array<V, 4>& x, const V& nu_squared) {
    const OrientedStretch<V> at = stretch<V>(x);
    const SpinProducts<V> spin = axis_products(lane_.branch, nu_squared);
    const auto b = oriented_balance<2>(plain_.J, plain_.template evaluate<2>(at), at, spin);
    const auto pull = inertial_part<V>(plain_.J, std::nullopt, at, spin, nullptr);
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t row = place[k];
      V magnitude = abs(b.g[row]) + 2.0 * abs(pull[row]);
      for (std::size_t j = 0; j < n; ++j) magnitude = magnitude + abs(b.slope[row][place[j]]);
      scale_[k] = 1.0 / magnitude;
      for (std::size_t j = 0; j < n; ++j) J_[k][j] = b.slope[row][place[j]] * scale_[k];
    }
    using oriented::w;
    scale_[3] = 1.0 / (abs(b.g[w]) + 2.0 * abs(pull[w]) + abs(b.slope[w][w]));
    axial_ = b.slope[w][w] * scale_[3];
  }

  [[gnu::always_inline]] void extended_residual(const std::array<V, 4>& x, const V& nu) {
    const OrientedStretch<Pair<V>> at = stretch<Pair<V>>(x);
    const auto b = oriented_balance<1>(wide_.J, wide_.template evaluate<1>(at), at,
                                       axis_products(lane_.branch, two_product(nu, nu)));
    for (std::size_t k = 0; k < n; ++k) g_[k] = V(b.g[place[k]]) * scale_[k];
    if constexpr (!sheared) g_[2] = V(0.0);
    g_[3] = V(b.g[oriented::w]) * scale_[3];
  }

  /// By cofactors; the step in the order of x: the plane's, rho's in place 2, a's in place 3.
  [[gnu::always_inline]] void invert() {
    if constexpr (sheared) {
      const auto& A = J_;
      const auto minor = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        return A[i][k] * A[j][l] - A[i][l] * A[j][k];
      };
      inverse_[0] = {minor(1, 2, 1, 2), -minor(0, 2, 1, 2), minor(0, 1, 1, 2)};
      inverse_[1] = {-minor(1, 2, 0, 2), minor(0, 2, 0, 2), -minor(0, 1, 0, 2)};
      inverse_[2] = {minor(1, 2, 0, 1), -minor(0, 2, 0, 1), minor(0, 1, 0, 1)};
      determinant_ = A[0][0] * inverse_[0][0] + A[0][1] * inverse_[1][0] + A[0][2] * inverse_[2][0];
    } else {
      inverse_[0] = {J_[1][1], -J_[0][1], V(0.0)};
      inverse_[1] = {-J_[1][0], J_[0][0], V(0.0)};
      inverse_[2] = {V(0.0), V(0.0), V(0.0)};
      determinant_ = J_[0][0] * J_[1][1] - J_[0][1] * J_[1][0];
    }
    const V per_determinant = 1.0 / determinant_;
    for (auto& row : inverse_)
      for (V& entry : row) entry = entry * per_determinant;
    determinant_ = determinant_ * axial_;
    std::array<V, 3> by_row;
    for (std::size_t k = 0; k < 3; ++k)
      by_row[k] = inverse_[k][0] * g_[0] + inverse_[k][1] * g_[1] + inverse_[k][2] * g_[2];
    step_ = {by_row[0], by_row[1], g_[3] / axial_, by_row[2]};
  }

  /// The largest row of |J^-1| p, p in the order of the rows: the plane's and rho's.
  [[gnu::always_inline]] V rows(const std::array<V, 4>& p) const {
    V out = p[3] / abs(axial_);
    for (std::size_t k = 0; k < n; ++k) {
      V sum = abs(inverse_[k][0]) * p[0] + abs(inverse_[k][1]) * p[1];
      if constexpr (sheared) sum = sum + abs(inverse_[k][2]) * p[2];
      out = larger(sum, out);
    }
    return out;
  }

  /// 2^-53 of what the inputs do to each row, as OrientedSystem::input_sensitivity(), and what the
  /// residual's rounding does.
  [[gnu::always_inline]] std::array<V, 4> perturbation(const std::array<V, 4>& x,
                                                       const V& nu_squared) const {
    using T = Dual<V, 2>;
    OrientedBalance<V, 1> sum;
    const auto add = [&](const OrientedBalance<T, 1>& slopes) {
      for (std::size_t k = 0; k < 4; ++k)
        for (const V& slope : slopes.g[k].slope) sum.g[k] = sum.g[k] + abs(slope);
    };
    const auto seeded = [](double c, std::size_t k) { return T::along(V(c), V(c), k); };
    const OrientedStretch<V> plain = stretch<V>(x);
    const OrientedStretch<T> at{
        {T(plain.q.alpha), T(x[0]), T(x[1]), T(x[2])}, T(plain.root), T(plain.tanh), T(plain.sech)};
    const T none(0.0);
    {
      const Plane<T> plane{seeded(lane_.plane[0], 0), seeded(lane_.plane[1], 1)};
      OrientedBalance<T, 1> out;
      add_in_logarithms<1>(at,
                           CoupledDerivatives<T>{plane.template evaluate<1>(at.invariants()), none,
                                                 none, none, none},
                           out);
      add(out);
    }
    const T c0 = seeded(lane_.thickness[0], 0);
    const T c1 = seeded(lane_.thickness[1], 1);
    const T axial = lane_.harmonic
                        ? Harmonic<T>{c0, c1}.template evaluate<1>(at.q.rho).v_r
                        : ReciprocalQuadratic<T>{c0, c1}.template evaluate<1>(at.q.rho).v_r;
    for (const V& slope : axial.slope) sum.g[oriented::w] += abs(slope);
    for (std::size_t k = 0; k < lane_.fibres; ++k) {
      const auto& fibre = lane_.fibre[k];
      const FibreTerm<T> term{seeded(fibre.k, 0),
                              {T::along(V(fibre.along.cosine), V(fibre.turned.cosine), 1),
                               T::along(V(fibre.along.sine), V(fibre.turned.sine), 1)}};
      PotentialDerivatives<T> directed{none, Vector4<T>::Constant(none),
                                       Matrix4<T>::Constant(none)};
      term.template add<1>(at.q, directed);
      OrientedBalance<T, 1> out;
      add_in_logarithms<1>(at, directed.gradient, directed.hessian, out);
      add(out);
    }
    const SpinProducts<V> spin = axis_products(lane_.branch, nu_squared);
    add_inertial_sensitivity<V>(plain_.J, std::nullopt, plain, spin, nullptr, sum.g);
    std::array<V, 4> out;
    for (std::size_t k = 0; k < n; ++k) out[k] = 0x1p-53 * (sum.g[place[k]] * scale_[k]) + extended;
    if constexpr (!sheared) out[2] = V(0.0);
    out[3] = 0x1p-53 * (sum.g[oriented::w] * scale_[3]) + extended;
    return out;
  }

  const OrientedLane& lane_;
  LanePotential<V, Plane> plain_;
  LanePotential<Pair<V>, Plane> wide_;
  std::array<std::array<V, 3>, 3> J_;
  std::array<std::array<V, 3>, 3> inverse_;
  V axial_;
  V determinant_;
  std::array<V, 4> scale_;  ///< of rows: the plane's, and rho's last
  std::array<V, 4> g_;      ///< likewise
  std::array<V, 4> step_;   ///< in the order of x
};

template <class V, template <class> class Plane, bool sheared>
void correct_oriented(const OrientedLane& lane, OrientedPoints& points) {
  OrientedCorrection<V, Plane, sheared> correction(lane);
  for (std::size_t i = 0; i < OrientedPoints::size; i += V::lanes) correction.run(points, i);
}

/// Nothing of hencky, whose series are as long as the state asks for.
template <class V, template <class> class Plane, bool sheared>
constexpr OrientedKernels::Kernel oriented_kernel() {
  if constexpr (std::is_same_v<Plane<double>, Hencky<double>>) {
    return nullptr;
  } else {
    return &correct_oriented<V, Plane, sheared>;
  }
}

template <class V, template <class> class... Plane>
constexpr OrientedKernels oriented_kernels_of(const std::variant<Plane<double>...>*) {
  return {{oriented_kernel<V, Plane, true>()...}, {oriented_kernel<V, Plane, false>()...}};
}
template <class V>
const OrientedKernels& oriented_kernels() {
  static constexpr OrientedKernels kernels = oriented_kernels_of<V>(models<PlanarPotential>);
  return kernels;
}

}  // namespace stationary
