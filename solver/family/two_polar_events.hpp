// Where the events of a two-polar family lie: the balance (lib/balance/two_polar.hpp) and what
// vanishes at the event, equations in (lambda, mu, rho, p), on the circle lambda = mu once, in any
// number type.
#pragma once

#include <tuple>

#include "solver/motion/event.hpp"
#include "solver/motion/event_equations.hpp"
#include "solver/motion/event_functions.hpp"
#include "solver/motion/two_polar_motion.hpp"
#include "solver/motion/varied_balance.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {

enum class TwoPolarVanishing {
  fold,           ///< the stiffness at what is held and varied
  momentum_fold,  ///< the stiffness at the momenta of the rates
  ellipse,        ///< the circle's stiffness along (1, -1), at the rates
  shear,          ///< the circle's K_alpha,alpha as a motion of (iii)
  leaves_mu,      ///< omega - s3/I_1
  leaves_lambda,  ///< omega - s3/I_2
  leaves_circle,  ///< the circle's I_1 - I_3
  momentum        ///< s3
};

template <template <class> class Motion, bool circle>
class TwoPolarEventSystem {
 public:
  static constexpr std::size_t stretches = circle ? 2 : 3;
  static constexpr int dimension = circle ? 3 : 4;
  using BoxNumber = BoxDual<dimension>;
  using Kind = FamilyParameter::Kind;

  TwoPolarEventSystem(const Body& body, const Potential& potential, const Motion<double>& motion,
                      const FamilyParameter& parameter, TwoPolarVanishing what)
      : body_(body),
        motion_(motion),
        parameter_(parameter),
        what_(what),
        potential_(potential),
        elastic_parameter_{parameter.kind == Kind::nu ? Kind::inertia : parameter.kind,
                           parameter.index},
        elastic_(potential, elastic_parameter_) {}

  std::size_t inputs() const { return 4 + elastic_.inputs(); }
  bool has_decimals() const { return elastic_.has_decimals(); }

  ExtendedVector<dimension> values(const ExtendedVector<dimension>& y,
                                   const InputChange& change) const {
    return equations<DoubleDouble>(
        y, [&](double x, std::size_t k) { return change(x, k); },
        [&](const auto&... x) { return elastic_.at(x..., change.from(4)); });
  }
  /// In intervals: of a proof (enclosed_event.hpp).
  std::array<BoxNumber, static_cast<std::size_t>(dimension)> over_boxes(
      const std::array<BoxNumber, static_cast<std::size_t>(dimension)>& y, Inputs inputs) const {
    using T = BoxNumber;
    return equations<T>(
        y, [&](double x, std::size_t) { return T(as_input(x, inputs)); },
        [&](const T& lambda, const T& mu, const T& rho, const T& p) {
          return elastic_over<dimension>(potential_, elastic_parameter_, {lambda, mu, rho}, p,
                                         inputs);
        });
  }
  std::array<Conditioned, static_cast<std::size_t>(dimension)> conditioned(
      const std::array<Conditioned, static_cast<std::size_t>(dimension)>& y, bool exact) const {
    return equations<Conditioned>(
        y, [&](double x, std::size_t) { return exact ? Conditioned(x) : Conditioned::input(x); },
        [&](const auto&... x) { return elastic_.at(x..., exact); });
  }

 private:
  template <class T, class Number, class Elastic>
  std::array<T, static_cast<std::size_t>(dimension)> equations(
      const std::array<T, static_cast<std::size_t>(dimension)>& y, const Number& number,
      const Elastic& elastic_at) const {
    const T& lambda = y[0];
    const T& mu = circle ? lambda : y[1];
    const T& rho = y[stretches - 1];
    const T& p = y[stretches];
    const T J = number(body_.J1, 0);
    const bool varies_motion = parameter_.kind == Kind::nu;
    const T J3 = parameter_.kind == Kind::inertia ? p : number(body_.J3, 1);
    const auto& [first, second] = motion_;
    const Motion<T> motion{varies_motion && parameter_.index == 0 ? p : number(first, 2),
                           varies_motion && parameter_.index == 1 ? p : number(second, 3)};
    const LogBalance<T> elastic = elastic_at(lambda, mu, rho, p);
    const TwoPolarPull<T> pull = two_polar_pull(J, lambda, mu, motion);
    std::array<T, static_cast<std::size_t>(dimension)> out;
    out[0] = elastic.g_xi - pull.lambda;
    if constexpr (!circle) out[1] = elastic.g_zeta - pull.mu;
    out[stretches - 1] = elastic.g_rho;
    out[stretches] = vanishing(J, J3, motion, lambda, mu, rho, elastic, pull);
    return out;
  }

  template <class T>
  T vanishing(const T& J, const T& J3, const Motion<T>& motion, const T& lambda, const T& mu,
              const T& rho, const LogBalance<T>& elastic, const TwoPolarPull<T>& pull) const {
    const T first = J * square(lambda);
    const T second = J * square(mu);
    const T third = J3 * square(rho);
    const T across = (elastic.uu - elastic.uv) - (pull.ll - pull.lm);
    const auto rates = rates_of(J, lambda, mu, motion);
    switch (what_) {
      case TwoPolarVanishing::fold:
        return singular(elastic, pull);
      case TwoPolarVanishing::momentum_fold:
        return singular(elastic, two_polar_pull(J, lambda, mu,
                                                momenta_of(first, second, J, lambda, mu, rates)));
      case TwoPolarVanishing::ellipse:
        return across;
      case TwoPolarVanishing::shear:
        return (elastic.uu - elastic.uv) - elastic.g_xi -
               first * square(rates.omega + rates.theta_dot);
      case TwoPolarVanishing::leaves_circle:
        return first - third;
      case TwoPolarVanishing::leaves_mu:
      case TwoPolarVanishing::leaves_lambda:
      case TwoPolarVanishing::momentum:
        break;
    }
    const T s3 = momenta_of(first, second, J, lambda, mu, rates).s3;
    if (what_ == TwoPolarVanishing::momentum) return s3;
    const T inertia = (what_ == TwoPolarVanishing::leaves_mu ? second : first) + third;
    return rates.omega * inertia - s3;
  }

  template <class T>
  static T singular(const LogBalance<T>& elastic, const TwoPolarPull<T>& pull) {
    const T ll = elastic.uu - pull.ll;
    const T lm = elastic.uv - pull.lm;
    if constexpr (circle) {
      return determinant(
          SquareArray<T, 2>{{{ll + lm, elastic.uw}, {2.0 * elastic.uw, elastic.ww}}});
    } else {
      return determinant(SquareArray<T, 3>{{{ll, lm, elastic.uw},
                                            {lm, elastic.vv - pull.mm, elastic.vw},
                                            {elastic.uw, elastic.vw, elastic.ww}}});
    }
  }

  template <class T>
  static TwoPolarRates<T> rates_of(const T&, const T&, const T&, const TwoPolarRates<T>& rates) {
    return rates;
  }
  template <class T>
  static TwoPolarRates<T> rates_of(const T& J, const T& lambda, const T& mu,
                                   const TwoPolarMomenta<T>& momenta) {
    return two_polar_rates(J, Vector3<T>{lambda, mu, lambda}, momenta);
  }
  template <class T>
  static TwoPolarMomenta<T> momenta_of(const T& first, const T& second, const T& J, const T& lambda,
                                       const T& mu, const TwoPolarRates<T>& rates) {
    const T product = 2.0 * (J * (lambda * mu));
    const T squares = first + second;
    return {squares * rates.omega + product * rates.theta_dot,
            squares * rates.theta_dot + product * rates.omega};
  }

  Body body_;
  Motion<double> motion_;
  FamilyParameter parameter_;
  TwoPolarVanishing what_;
  Potential potential_;
  FamilyParameter elastic_parameter_;
  VariedElastic elastic_;
};

/// The test functions of a two-polar family.
KindEvents two_polar_events();

/// What vanishes at an event of this type near a located member, of two candidates the one nearer to
/// zero; nothing where there are no equations for it.
std::optional<TwoPolarVanishing> vanishing_at(EventType type, bool circle, const Member& near);

}  // namespace stationary
