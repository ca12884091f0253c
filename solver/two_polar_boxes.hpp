// The two-polar balance (two_polar_system.hpp) over a box of stretches, in interval arithmetic,
// with J, coefficients and the motion as intervals. At fixed rates their own part of the pull is
// gathered with the elastic force, as a centrifugal rate of both stretches.
//
// At fixed momenta the pull has no bound where lambda = mu. What excludes boxes there is the same
// balance without its poles, t = lambda + mu, delta = lambda - mu:
//   J t^3 (V_lambda + V_mu) = (s3 + p_theta)^2,    -J W_d delta^4 = (s3 - p_theta)^2.
#pragma once

#include <algorithm>
#include <type_traits>

#include "solver/interval_system.hpp"
#include "solver/two_polar_equilibrium.hpp"
#include "solver/two_polar_system.hpp"

namespace stationary {

/// x = (lambda, mu[, rho]); Elastic: a planar model in intervals, or a coupled one. Motion: as
/// TwoPolarSystem's.
template <class Elastic, int dimensions, template <class> class Motion>
struct TwoPolarBoxSystem {
  static constexpr int dimension = dimensions;
  static constexpr int N = dimensions;
  static constexpr bool by_rates = std::is_same_v<Motion<double>, TwoPolarRates<double>>;
  Elastic model;
  Interval J;
  Motion<Interval> motion;

  BoxLinearized<N> linearize(const Box<N>& x) const {
    LogBalance<Interval> b;
    TwoPolarPull<Interval> pull;
    if constexpr (by_rates) {
      const TwoPolarPullRates<Interval> rates = two_polar_pull_rates(J, motion);
      b = elastic(x, rates.own);
      const Interval mixed = rates.product * (x[0] * x[1]);
      pull = {mixed, mixed, mixed, mixed, mixed};
    } else {
      b = elastic(x, 0.0);
      pull = two_polar_pull(J, x[0], x[1], motion);
    }
    b.g_xi -= pull.lambda;
    b.g_zeta -= pull.mu;
    b.uu -= pull.ll;
    b.uv -= pull.lm;
    b.vv -= pull.mm;
    if constexpr (N == 2) {
      return {{b.g_xi, b.g_zeta}, {b.uu, b.uv, b.vv}};
    } else {
      return {{b.g_xi, b.g_zeta, b.g_rho}, {b.uu, b.uv, b.uw, b.vv, b.vw, b.ww}};
    }
  }

  /// No solution with lambda >= mu in x, by the balance without its poles.
  bool excludes(
      const Box<N>& x) const requires std::is_same_v<Motion<double>, TwoPolarMomenta<double>> {
    const auto b = elastic(x, 0.0);
    const Interval t = x[0] + x[1];
    const Interval plus = square(motion.s3 + motion.p_theta);
    const Interval sum = J * (t * square(t)) * (b.g_xi / x[0] + b.g_zeta / x[1]) - plus;
    if (!sum.may_be(0.0)) return true;
    const Interval minus = square(motion.s3 - motion.p_theta);
    const Interval apart = x[0] - x[1];
    const Interval delta(std::max(apart.lo, 0.0), std::max(apart.hi, 0.0));
    const Interval difference =
        J * (determinant_force(x) / (x[0] * x[1])) * square(square(delta)) + minus;
    return !difference.may_be(0.0);
  }

 private:
  LogBalance<Interval> elastic(const Box<N>& x, const Interval& rate) const {
    if constexpr (N == 2) {
      return model.log_balance(x[0], x[1], rate, rate);
    } else {
      return model.log_balance(x[0], x[1], x[2], rate, rate, Interval(0.0));
    }
  }
  /// W_l.
  Interval determinant_force(const Box<N>& x) const {
    const auto invariants = planar_invariants(x[0], x[1]);
    if constexpr (N == 2) {
      return model.template evaluate<1>(invariants).w_l;
    } else {
      return model.template evaluate<1>(invariants, x[2]).plane.w_l;
    }
  }
};

/// Of a model (planar or coupled) and a motion in doubles.
template <class Model, template <class> class Motion>
auto two_polar_box_system(double J, const Model& model, const Motion<double>& motion,
                          Inputs inputs) {
  const auto input = [inputs](double c) { return as_input(c, inputs); };
  constexpr int N = decltype(elastic_system(model))::dimension;
  if constexpr (requires { model.plane; }) {
    const auto plane = interval_model(model.plane, inputs);
    return TwoPolarBoxSystem<std::remove_cv_t<decltype(plane)>, N, Motion>{
        plane, input(J), with_numbers(motion, input)};
  } else {
    const auto coupled = interval_model(model, inputs);
    return TwoPolarBoxSystem<std::remove_cv_t<decltype(coupled)>, N, Motion>{
        coupled, input(J), with_numbers(motion, input)};
  }
}

/// f(motion in its own type): rates, momenta, or equal momenta where s3 = p_theta.
template <class F>
void visit_motion(const TwoPolarMotion& motion, const F& f) {
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&motion)) return f(*rates);
  const auto& momenta = std::get<TwoPolarMomenta<double>>(motion);
  if (momenta.s3 == momenta.p_theta) return f(TwoPolarEqualMomenta<double>{momenta.s3});
  f(momenta);
}

}  // namespace stationary
