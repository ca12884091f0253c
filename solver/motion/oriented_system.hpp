// The balance of a potential that need not be isotropic (anisotropic_balance.hpp) as reduced
// systems, by what is unknown beside xi and zeta:
//
//   rho      always, but where a separable V leaves it to itself, or a held volume follows from the
//            others, and a search takes it apart
//   alpha    in (iii) and oblique; 0 in (i), (ii) and where an even V is followed in (iii)
//   axis     oblique
//
// x holds xi, zeta[, rho][, e^a][, x_phi]. Each row is divided by the magnitude of its own terms:
// magnitude is 1, and rows of any stiffness, or of a slow spin, weigh the same.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "lib/balance/anisotropic_balance.hpp"
#include "lib/matrix/small_matrix.hpp"
#include "lib/number/dual.hpp"
#include "solver/newton/reduced_system.hpp"

namespace stationary {

template <bool thickness_unknown, bool alpha_unknown, bool axis_unknown>
struct OrientedLayout {
  static constexpr bool thickness = thickness_unknown;
  static constexpr bool alpha = alpha_unknown;
  static constexpr bool axis = axis_unknown;
  static constexpr int dimension = 2 + int(thickness) + int(alpha) + int(axis);
  /// Of each unknown, in oriented::.
  static constexpr std::array<std::size_t, static_cast<std::size_t>(dimension)> places = [] {
    std::array<std::size_t, static_cast<std::size_t>(dimension)> out{oriented::u, oriented::v};
    std::size_t k = 2;
    if (thickness) out[k++] = oriented::w;
    if (alpha) out[k++] = oriented::a;
    if (axis) out[k++] = oriented::phi;
    return out;
  }();
  /// Place of an unknown in x.
  static constexpr int thickness_place = 2;
  static constexpr int alpha_place = 2 + int(thickness);
  static constexpr int axis_place = alpha_place + 1;
  /// Of alpha over sqrt(xi zeta), tanh a, and of the axis' angle, against the bound of ln x.
  static constexpr double bound_factor = axis ? 2.0 : alpha ? 1.25 : 1.0;
};

using StraightLayout = OrientedLayout<true, false, false>;
using ShearedLayout = OrientedLayout<true, true, false>;
using ObliqueLayout = OrientedLayout<true, true, true>;

/// All five coordinates from x, those that are no unknowns at their values.
template <class Layout, class S, class X>
std::array<S, 5> all_coordinates(const X& x, const S& rho) {
  std::array<S, 5> out{S(1.0), S(1.0), rho, S(1.0), S(1.0)};
  for (std::size_t k = 0; k < Layout::places.size(); ++k) {
    if constexpr (requires { x.rows(); }) {
      out[Layout::places[k]] = S(x[static_cast<Eigen::Index>(k)]);
    } else {
      out[Layout::places[k]] = x[k];
    }
  }
  return out;
}

/// Of the coordinates, the balance of the motion they are. nu_squared: of |nu|.
template <class Layout, int order, class S>
OrientedBalance<S, order> balance_at(const Inertia3<S>& J, const AnisotropicModel<S>& model,
                                     Branch branch, const S& nu_squared,
                                     const std::array<S, 5>& y) {
  const OrientedStretch<S> at = oriented_stretch(y[0], y[1], y[2], y[3]);
  const auto balance = [&](const SpinProducts<S>& n) {
    if constexpr (Layout::thickness) {
      return oriented_balance<order>(J, model, at, n);
    } else {
      return eliminated_balance<order>(J, model, at, n);
    }
  };
  if constexpr (Layout::axis) {
    const AxisAngle<S> axis = axis_angle(y[4]);
    auto out = balance(in_plane_products(nu_squared, axis.cosine, axis.sine));
    add_axis<order>(J, at, nu_squared, axis, out);
    return out;
  } else {
    return balance(axis_products(branch, nu_squared));
  }
}

/// |p dG/dp| or dG/dp of coefficients in y, two at a time; G of (u, v, w, a).
struct CoefficientDuals {
  int first;      ///< place of the one in direction 0
  bool relative;  ///< slopes to relative changes
  mutable int next = 0;

  Dual2 operator()(double c) const { return seeded(c, relative ? c : 1.0); }
  Direction<Dual2> direction(double degrees) const;

 private:
  Dual2 seeded(double value, double slope) const {
    Dual2 out(value);
    const int k = next++ - first;
    if (k == 0 || k == 1) out.slope[static_cast<std::size_t>(k)] = slope;
    return out;
  }
};

/// Made once of a potential.
struct OrientedModels {
  AnisotropicPotential potential;
  AnisotropicModel<double> plain;
  AnisotropicModel<DoubleDouble> extended;
  AnisotropicModel<Conditioned> conditioned;      ///< coefficients as inputs
  std::vector<AnisotropicModel<Dual2>> relative;  ///< CoefficientDuals{2 k, true}

  explicit OrientedModels(const AnisotropicPotential& from);
};

/// Of the balance of a spin, by a model that such duals made.
std::array<Dual2, 4> coefficient_slopes(const AnisotropicModel<Dual2>& model,
                                        const Inertia3<double>& J,
                                        const OrientedStretch<double>& at,
                                        const SpinProducts<double>& n);

/// Of the same four numbers the conditions with regard to the decimals of a formula.
std::array<double, 4> decimal_conditions(const AnisotropicPotential& potential,
                                         const OrientedStretch<double>& at);

/// The centrifugal part, -C(nu) q in the coordinates, along the volume where one is held, and phi's
/// own equation: linear in J.
template <class S>
std::array<S, 5> inertial_part(const Inertia3<S>& J, const std::optional<S>& volume,
                               const OrientedStretch<S>& at, const SpinProducts<S>& n,
                               const AxisAngle<S>* axis) {
  const OrientedStretch<S> whole = volume ? at_volume(*volume, at) : at;
  OrientedBalance<S, 1> out;
  const Vector4<S> force = -(centrifugal_matrix(J, n) * whole.q.vector());
  const Matrix4<S> none = Matrix4<S>::Zero();
  add_in_logarithms<1>(whole, force, none, out);
  if (volume) out = held<1>(out, whole);
  if (axis != nullptr) add_axis<1>(J, at, S(0.0), *axis, out);
  return out.g;
}

/// Adds the sum over J1, J2, J3 and, twice, nu of |p dG/dp|, G the inertial part.
template <class S>
void add_inertial_sensitivity(const Inertia3<S>& J, const std::optional<S>& volume,
                              const OrientedStretch<S>& at, const SpinProducts<S>& n,
                              const AxisAngle<S>* axis, std::array<S, 5>& sum) {
  using std::abs;
  const S none(0.0);
  for (const Inertia3<S>& one : {Inertia3<S>{J.J1, none, none}, Inertia3<S>{none, J.J2, none},
                                 Inertia3<S>{none, none, J.J3}}) {
    const auto part = inertial_part(one, volume, at, n, axis);
    for (std::size_t i = 0; i < 5; ++i) sum[i] += abs(part[i]);
  }
  const auto all = inertial_part(J, volume, at, n, axis);
  for (std::size_t i = 0; i < 4; ++i) sum[i] += 2.0 * abs(all[i]);
}

/// Of the shear's equation at alpha = 0 the coefficient that turns it, without J1 or J2 times nu^2
/// and the like: V_alpha,alpha, less what the spin pulls rho by along a held volume. V_aa along it.
template <class S>
S shear_stiffness(const S& V_aa, bool volume_held, Branch branch, const S& J3, const S& nu_squared,
                  const BasicStretch<S>& q) {
  if (!volume_held || branch == Branch::iii) return V_aa;
  return V_aa - 2.0 * (J3 * nu_squared * square(q.rho) / (q.xi * q.zeta));
}

/// Residual and Jacobian, rows divided by `scale`.
template <int N>
struct OrientedLinearized {
  ReducedVector<N> g;
  SmallMatrix<N> jacobian;
  ReducedVector<N> scale;
  double magnitude = 1.0;
};

template <class Layout>
struct OrientedSystem {
  static constexpr int dimension = Layout::dimension;
  static constexpr int N = dimension;

  const OrientedModels* models;
  Body body;
  Branch branch;  ///< where the axis is no unknown
  double nu;
  double rho = 1.0;  ///< where that is no unknown

  OrientedStretch<double> stretch(const std::array<double, 5>& y) const {
    return oriented_stretch(y[0], y[1], y[2], y[3]);
  }
  std::array<double, 5> coordinates(const ReducedVector<N>& x) const {
    return all_coordinates<Layout>(x, rho);
  }
  SpinProducts<double> spin(const std::array<double, 5>& y, double nu_squared) const {
    if constexpr (Layout::axis) {
      const AxisAngle<double> axis = axis_angle(y[4]);
      return in_plane_products(nu_squared, axis.cosine, axis.sine);
    } else {
      return axis_products(branch, nu_squared);
    }
  }
  /// inertial_part() with other J.
  std::array<double, 5> inertial(const Inertia3<double>& J, const std::array<double, 5>& y,
                                 double nu_squared) const {
    const AxisAngle<double> axis = axis_angle(y[4]);
    return inertial_part(J, models->plain.body.volume, stretch(y), spin(y, nu_squared),
                         Layout::axis ? &axis : nullptr);
  }

  OrientedLinearized<N> linearize(const ReducedVector<N>& x) const {
    const auto y = coordinates(x);
    const Inertia3<double> J{body.J1, body.J2, body.J3};
    const auto b = balance_at<Layout, 2>(J, models->plain, branch, nu * nu, y);
    const auto pull = inertial(J, y, nu * nu);
    OrientedLinearized<N> out;
    for (int i = 0; i < N; ++i) {
      const std::size_t row = place(i);
      double magnitude = 0.0;
      for (int j = 0; j < N; ++j) magnitude += std::abs(b.slope[row][place(j)]);
      magnitude += row == oriented::phi ? in_plane_inertia(J, stretch(y).q).sum
                                        : std::abs(b.g[row]) + 2.0 * std::abs(pull[row]);
      out.scale[i] = 1.0 / magnitude;
      out.g[i] = b.g[row] * out.scale[i];
      for (int j = 0; j < N; ++j)
        out.jacobian.entries(i, j) = b.slope[row][place(j)] * out.scale[i];
    }
    return out;
  }
  ReducedVector<N> extended_residual(const ReducedVector<N>& x) const {
    return extended_residual(x, linearize(x).scale);
  }
  ReducedVector<N> extended_residual(const ReducedVector<N>& x,
                                     const ReducedVector<N>& scale) const {
    const Inertia3<DoubleDouble> J{body.J1, body.J2, body.J3};
    const auto b = balance_at<Layout, 1>(J, models->extended, branch, two_product(nu, nu),
                                         all_coordinates<Layout>(x, DoubleDouble(rho)));
    ReducedVector<N> out;
    for (int i = 0; i < N; ++i) out[i] = double(b.g[place(i)]) * scale[i];
    return out;
  }
  /// Sum over the inputs p of |p dG/dp|: a coefficient once, J once, nu twice (as nu^2).
  ReducedVector<N> input_sensitivity(const ReducedVector<N>& x) const {
    return input_sensitivity(x, linearize(x).scale);
  }
  ReducedVector<N> input_sensitivity(const ReducedVector<N>& x,
                                     const ReducedVector<N>& scale) const {
    const auto y = coordinates(x);
    std::array<double, 5> sum{};
    for (const AnisotropicModel<Dual2>& model : models->relative) {
      const auto slopes =
          coefficient_slopes(model, {body.J1, body.J2, body.J3}, stretch(y), spin(y, nu * nu));
      for (std::size_t i = 0; i < slopes.size(); ++i) sum[i] += sensitivity(slopes[i]);
    }
    if (models->plain.has_decimals()) {
      const std::array<double, 4> decimals = decimal_conditions(models->potential, stretch(y));
      for (std::size_t i = 0; i < decimals.size(); ++i) sum[i] += decimals[i];
    }
    const AxisAngle<double> axis = axis_angle(y[4]);
    add_inertial_sensitivity({body.J1, body.J2, body.J3}, models->plain.body.volume, stretch(y),
                             spin(y, nu * nu), Layout::axis ? &axis : nullptr, sum);
    ReducedVector<N> out;
    for (int i = 0; i < N; ++i) out[i] = sum[place(i)] * scale[i];
    return out;
  }

  static constexpr std::size_t place(int i) { return Layout::places[static_cast<std::size_t>(i)]; }
};

}  // namespace stationary
