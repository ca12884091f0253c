// The two-polar balance (two_polar_system.hpp) over a box of stretches, in interval arithmetic,
// with J, coefficients and the motion as intervals. At fixed rates their own part of the pull is
// gathered with the elastic force, as a centrifugal rate of both stretches.
//
// Sum and difference of the balance, t = lambda + mu, delta = lambda - mu, exclude more boxes: in
//   V_lambda + V_mu = J t (omega + theta')^2
// the rates' parts do not cancel where they are nearly opposite, and at fixed momenta, whose pull
// has no bound where lambda = mu, omega + theta' = (s3 + p_theta)/(J t^2) and
//   -J W_d delta^4 = (s3 - p_theta)^2   are regular there.
#pragma once

#include <algorithm>
#include <optional>
#include <type_traits>

#include "lib/number/dual.hpp"
#include "solver/motion/two_polar_motion.hpp"
#include "solver/motion/two_polar_system.hpp"
#include "solver/proof/box_balance.hpp"
#include "solver/proof/krawczyk.hpp"

namespace stationary {

/// The first or the second number of a motion.
template <template <class> class Motion, class S>
S& number_of(Motion<S>& motion, int number) {
  if constexpr (std::is_same_v<Motion<S>, TwoPolarEqualMomenta<S>>) {
    return motion.s3;
  } else {
    auto& [first, second] = motion;
    return number == 0 ? first : second;
  }
}

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
  /// That is an interval for many motions (VariedResidual), if one is.
  std::optional<int> varied_number = {};

  BoxLinearized<N> linearize(const Box<N>& x) const { return linearize_at(motion, x); }

  bool varies() const { return varied_number.has_value(); }
  VariedResidual<N> varied(const Box<N>& x) const {
    using T = Dual<Interval, 1>;
    Motion<Interval> middle = motion;
    Interval& number = number_of(middle, *varied_number);
    const Interval whole = number;
    number = Interval(whole.mid());
    VariedResidual<N> out{linearize_at(middle, x).g, {}, whole - number};
    auto moved = with_numbers(motion, [](const Interval& each) { return T(each); });
    number_of(moved, *varied_number).slope[0] = 1.0;
    const TwoPolarPull<T> pull = two_polar_pull(J, T(x[0]), T(x[1]), moved);
    out.slope[0] = -pull.lambda.slope[0];
    out.slope[1] = -pull.mu.slope[0];
    return out;
  }

  /// No solution with lambda >= mu in x, by the sum of the balance, in which nothing cancels, and
  /// by its difference where that has a pole.
  bool excludes(const Box<N>& x) const {
    if constexpr (N == 2) {
      if (defined_nowhere(model, x[0], x[1])) return true;
    } else {
      if (defined_nowhere(model, x[0], x[1], x[2])) return true;
    }
    const auto b = elastic(x, 0.0);
    const Interval t = x[0] + x[1];
    if (!(b.g_xi / x[0] + b.g_zeta / x[1] - sum_pull(t)).may_be(0.0)) return true;
    if constexpr (std::is_same_v<Motion<double>, TwoPolarMomenta<double>>) {
      const Interval minus = square(motion.s3 - motion.p_theta);
      const Interval apart = x[0] - x[1];
      const Interval delta(std::max(apart.lo, 0.0), std::max(apart.hi, 0.0));
      return !(J * (determinant_force(x) / (x[0] * x[1])) * square(square(delta)) + minus)
                  .may_be(0.0);
    }
    return false;
  }

 private:
  BoxLinearized<N> linearize_at(const Motion<Interval>& at, const Box<N>& x) const {
    LogBalance<Interval> b;
    TwoPolarPull<Interval> pull;
    if constexpr (by_rates) {
      const TwoPolarPullRates<Interval> rates = two_polar_pull_rates(J, at);
      b = elastic(x, rates.own);
      const Interval mixed = rates.product * (x[0] * x[1]);
      pull = {mixed, mixed, mixed, mixed, mixed};
    } else {
      b = elastic(x, 0.0);
      pull = two_polar_pull(J, x[0], x[1], at);
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
  LogBalance<Interval> elastic(const Box<N>& x, const Interval& rate) const {
    if constexpr (N == 2) {
      return model.log_balance(x[0], x[1], rate, rate);
    } else {
      return model.log_balance(x[0], x[1], x[2], rate, rate, Interval(0.0));
    }
  }
  /// J t (omega + theta')^2.
  Interval sum_pull(const Interval& t) const {
    if constexpr (by_rates) {
      return J * t * square(motion.omega + motion.theta_dot);
    } else if constexpr (requires { motion.p_theta; }) {
      return square(motion.s3 + motion.p_theta) / (J * (t * square(t)));
    } else {
      return square(2.0 * motion.s3) / (J * (t * square(t)));
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
