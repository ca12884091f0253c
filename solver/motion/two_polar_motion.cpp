#include "solver/motion/two_polar_motion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "solver/newton/separable_parts.hpp"

namespace stationary {

std::optional<RatesVerdict> rates_verdict(double J, const Potential& potential,
                                          const TwoPolarRates<double>& rates) {
  const auto verdict = [](const char* condition, double left, double right) {
    return RatesVerdict{condition, std::abs(left - right) <= 8 * 0x1p-53 * right};
  };
  const double squares = J * (rates.omega * rates.omega + rates.theta_dot * rates.theta_dot);
  const double slip = rates.omega - rates.theta_dot;
  const auto plane = [&](const auto& m) -> std::optional<RatesVerdict> {
    using Model = std::decay_t<decltype(m)>;
    if constexpr (std::is_same_v<Model, ReciprocalDeterminant<>>)
      return verdict("J (omega^2 + theta_dot^2) = k", squares, m.k);
    if constexpr (std::is_same_v<Model, NeoHookean<>> || std::is_same_v<Model, NeoHookean3d<>>)
      return verdict("J (omega^2 + theta_dot^2) = mu", squares, m.mu);
    if constexpr (std::is_same_v<Model, Biot<>>)
      return verdict("J (omega - theta_dot)^2 = 2 mu", J * slip * slip, 2.0 * m.mu);
    return std::nullopt;
  };
  if (const auto parts = separable_parts(potential)) return parts->plane.visit(plane);
  return potential.visit(plane);
}

std::string RatesVerdict::line_message() const {
  return "at these rates, " + condition +
         ", the ellipses lambda != mu of this potential form a line: prescribe s3 and p_theta "
         "instead";
}

void set_motion(const Body& body, const TwoPolarMotion& motion, TwoPolarEquilibrium& at) {
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&motion)) {
    at.rates = *rates;
    at.momenta = two_polar_momenta(body.J1, at.x, rates->omega, rates->theta_dot);
    return;
  }
  at.momenta = std::get<TwoPolarMomenta<double>>(motion);
  at.rates = at.circle
                 ? TwoPolarRates<double>{at.momenta.s3 / (2.0 * body.J1 * at.x[0] * at.x[0]), 0.0}
                 : two_polar_rates(body.J1, at.x, at.momenta);
}

void require_two_polar(const Body& body, const TwoPolarMotion& motion) {
  if (!body.symmetric()) throw std::invalid_argument("J1 = J2 in the two-polar family");
  std::visit(
      [](const auto& m) {
        const auto& [first, second] = m;
        if (!std::isfinite(first) || !std::isfinite(second))
          throw std::invalid_argument("a finite motion");
      },
      motion);
}

double two_polar_residual_check(const Body& body, const PotentialDerivatives<double>& v,
                                const TwoPolarEquilibrium& at) {
  const Vector3<double> gradient = v.gradient.tail<3>();
  const auto pull = two_polar_pull(body.J1, at.x[0], at.x[1], at.rates);
  const Vector3<double> force{pull.lambda / at.x[0], pull.mu / at.x[1], 0.0};
  const double largest = std::max(
      {gradient.cwiseAbs().maxCoeff(), std::abs(pull.ll / at.x[0]), std::abs(pull.mm / at.x[1]),
       (v.hessian.bottomRightCorner<3, 3>() * at.x.asDiagonal()).cwiseAbs().maxCoeff()});
  return (gradient - force).cwiseAbs().maxCoeff() / largest;
}

}  // namespace stationary
