// The two-polar balance (lib/balance/two_polar.hpp) as a reduced system in ln (lambda, mu[, rho]):
// the elastic part of a PlanarSystem or CoupledSystem without its centrifugal rates, minus the pull
// of the motion at fixed rates or at fixed momenta. x = (lambda, mu[, rho]).
#pragma once

#include <type_traits>

#include "lib/balance/two_polar.hpp"
#include "solver/newton/reduced_system.hpp"
#include "solver/newton/thickness_balance.hpp"

namespace stationary {

/// A motion's numbers as those of another type.
template <class S, class Convert>
auto with_numbers(const TwoPolarRates<S>& m, const Convert& convert) {
  return TwoPolarRates<decltype(convert(m.omega))>{convert(m.omega), convert(m.theta_dot)};
}
template <class S, class Convert>
auto with_numbers(const TwoPolarMomenta<S>& m, const Convert& convert) {
  return TwoPolarMomenta<decltype(convert(m.s3))>{convert(m.s3), convert(m.p_theta)};
}
template <class S, class Convert>
auto with_numbers(const TwoPolarEqualMomenta<S>& m, const Convert& convert) {
  return TwoPolarEqualMomenta<decltype(convert(m.s3))>{convert(m.s3)};
}

/// The elastic part of a model's two-polar balance, N = 2 or 3.
template <class Model>
auto elastic_system(const Model& model) {
  if constexpr (requires { model.plane; }) {
    return PlanarSystem<std::decay_t<decltype(model.plane)>>{model.plane, {}};
  } else {
    return CoupledSystem<Model>{model, {}};
  }
}

/// The same for following a motion; with_rho: where rho may be one of several it is among the
/// unknowns, N = 3.
template <bool with_rho, class Model>
auto followed_elastic_system(const Model& model) {
  if constexpr (with_rho) {
    return CoupledSystem<Model>{model, {}};
  } else {
    return elastic_system(model);
  }
}

/// By what factor a derivative of the pull in ln x may exceed the one before.
template <class S>
double steepness(const TwoPolarMomenta<S>&, double lambda, double mu) {
  return 4.0 * (lambda + mu) / std::abs(lambda - mu);  // powers of 1/(lambda - mu)
}
template <class Motion>
double steepness(const Motion&, double, double) {
  return 1.0;
}

/// Relative change of the pull for one of its motion's numbers.
inline double amplification(const TwoPolarMomenta<double>& m) {
  return (std::abs(m.s3) + std::abs(m.p_theta)) / std::abs(m.s3 - m.p_theta);
}
template <class Motion>
double amplification(const Motion&) {
  return 1.0;
}

/// Motion: TwoPolarRates, TwoPolarMomenta or TwoPolarEqualMomenta.
template <class Elastic, template <class> class Motion>
struct TwoPolarSystem {
  static constexpr int dimension = Elastic::dimension;
  static constexpr int N = dimension;
  Elastic elastic;  ///< with zero rates
  double J;
  Motion<double> motion;

  Linearized<N> linearize(const ReducedVector<N>& x) const {
    Linearized<N> out = elastic.linearize(x);
    const TwoPolarPull<double> pull = two_polar_pull(J, x[0], x[1], motion);
    out.g[0] -= pull.lambda;
    out.g[1] -= pull.mu;
    using Jacobian = SmallSymmetric<N>;
    out.jacobian.entries[Jacobian::index(0, 0)] -= pull.ll;
    out.jacobian.entries[Jacobian::index(0, 1)] -= pull.lm;
    out.jacobian.entries[Jacobian::index(1, 1)] -= pull.mm;
    out.magnitude += 2.0 * steepness(motion, x[0], x[1]) *
                         (std::abs(pull.ll) + std::abs(pull.lm) + std::abs(pull.mm)) +
                     std::abs(pull.lambda) + std::abs(pull.mu);
    return out;
  }
  ReducedVector<N> extended_residual(const ReducedVector<N>& x) const {
    const auto b = elastic.extended_balance(x);
    const auto wide = with_numbers(motion, [](double number) { return DoubleDouble(number); });
    const auto pull = two_polar_pull(J, DoubleDouble(x[0]), DoubleDouble(x[1]), wide);
    ReducedVector<N> out;
    out[0] = double(b.g_xi - pull.lambda);
    out[1] = double(b.g_zeta - pull.mu);
    if constexpr (N == 3) out[2] = double(b.g_rho);
    return out;
  }
  /// J once and the motion's two numbers twice each, s3 - p_theta as they cancel; the terms of a
  /// pull may cancel, hence pull.ll.
  ReducedVector<N> input_sensitivity(const ReducedVector<N>& x) const {
    ReducedVector<N> out = elastic.input_sensitivity(x);
    const TwoPolarPull<double> pull = two_polar_pull(J, x[0], x[1], motion);
    const double size = std::abs(pull.lambda) + std::abs(pull.mu) + std::abs(pull.ll) +
                        std::abs(pull.lm) + std::abs(pull.mm);
    const double share = 5.0 * amplification(motion);
    out[0] += share * size;
    out[1] += share * size;
    return out;
  }
};

/// The same at fixed rates in the invariants, ln (t, d[, rho]), where lambda != mu:
///   t W_t - J t^2 (omega^2 + theta'^2) = 0,   W_l + J d (omega - theta')^2 = 0[,   W_r = 0].
/// The circle is no solution of these, so a search does not fall into it; symmetric Jacobian.
template <class Model, int dimensions>
struct TwoPolarInvariantSystem {
  static constexpr int dimension = dimensions;
  static constexpr int N = dimensions;
  Model model;     ///< planar (N = 2) or coupled (N = 3)
  double squares;  ///< J (omega^2 + theta'^2)
  double slip;     ///< J (omega - theta')^2

  Linearized<N> linearize(const ReducedVector<N>& x) const {
    const double t = x[0];
    const double d = x[1];
    const PlanarInvariants<double> invariants{t, d, t * t - 4.0 * d};
    Linearized<N> out;
    const auto planar = [&](const PlanarDerivatives<double>& w) {
      const double pull = squares * t * t;
      const double push = slip * d;
      out.g[0] = t * w.w_t - pull;
      out.g[1] = w.w_l + push;
      out.jacobian.entries[SmallSymmetric<N>::index(0, 0)] = t * (w.w_t + t * w.w_tt) - 2.0 * pull;
      out.jacobian.entries[SmallSymmetric<N>::index(0, 1)] = t * w.w_tl;
      out.jacobian.entries[SmallSymmetric<N>::index(1, 1)] = w.w_ll + push;
      out.magnitude = t * (std::abs(w.w_t) + t * std::abs(w.w_tt) + std::abs(w.w_tl)) +
                      std::abs(w.w_l) + std::abs(w.w_ll) + 2.0 * pull + push;
    };
    if constexpr (N == 2) {
      planar(model.template evaluate<2>(invariants));
    } else {
      const auto w = model.template evaluate<2>(invariants, x[2]);
      planar(w.plane);
      out.g[2] = w.w_r;
      out.jacobian.entries[SmallSymmetric<N>::index(0, 2)] = t * w.w_tr;
      out.jacobian.entries[SmallSymmetric<N>::index(1, 2)] = w.w_lr;
      out.jacobian.entries[SmallSymmetric<N>::index(2, 2)] = w.w_rr;
      out.magnitude += std::abs(w.w_r) + std::abs(w.w_rr);
    }
    return out;
  }
};

/// Of rates; a spin nu about axis 3 is omega = nu, theta' = 0.
template <int dimensions, class Model>
TwoPolarInvariantSystem<Model, dimensions> invariant_system(const Model& model, double J,
                                                            const TwoPolarRates<double>& rates) {
  const double slip = rates.omega - rates.theta_dot;
  return {model, J * (rates.omega * rates.omega + rates.theta_dot * rates.theta_dot),
          J * slip * slip};
}

}  // namespace stationary
