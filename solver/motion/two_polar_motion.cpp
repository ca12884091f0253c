#include "solver/motion/two_polar_motion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "solver/newton/separable_parts.hpp"

namespace stationary {

std::optional<RatesVerdict> rates_verdict(double J, const Potential& potential,
                                          const TwoPolarRates<double>& rates) {
  // half_unit: what half a unit of the rates makes of `left`, beside its own rounding.
  const auto verdict = [](const char* condition, double left, double right,
                          double half_unit = 0.0) {
    return RatesVerdict{condition, std::abs(left - right) <= 8 * 0x1p-53 * right + half_unit};
  };
  const double squares = J * (rates.omega * rates.omega + rates.theta_dot * rates.theta_dot);
  const double slip = rates.omega - rates.theta_dot;
  // Of V = k t^2/2 + g(d, rho) t is free where the condition holds, a held volume or not.
  const auto of_trace = [&](const auto& m) -> std::optional<RatesVerdict> {
    using Model = std::decay_t<decltype(m)>;
    if constexpr (std::is_same_v<Model, ReciprocalDeterminant<>>)
      return verdict("J (omega^2 + theta_dot^2) = k", squares, m.k);
    if constexpr (std::is_same_v<Model, NeoHookean<>> || std::is_same_v<Model, NeoHookean3d<>>)
      return verdict("J (omega^2 + theta_dot^2) = mu", squares, m.mu);
    return std::nullopt;
  };
  if (const BodyModel<>* body = potential.body_model()) {
    if (body->gravitates) return std::nullopt;
    if (body->elastic.plane) return body->elastic.plane->visit(of_trace);
    return std::visit(of_trace, body->elastic.coupled);
  }
  const auto plane = [&](const auto& m) -> std::optional<RatesVerdict> {
    if constexpr (std::is_same_v<std::decay_t<decltype(m)>, Biot<>>)
      return verdict(
          "J (omega - theta_dot)^2 = 2 mu", J * slip * slip, 2.0 * m.mu,
          4.0 * 0x1p-53 * J * std::abs(slip) * (std::abs(rates.omega) + std::abs(rates.theta_dot)));
    return of_trace(m);
  };
  if (const auto parts = separable_parts(potential)) return parts->plane.visit(plane);
  return potential.visit(plane);
}

std::string RatesVerdict::line_message() const {
  return "at these rates, " + condition +
         ", two of an ellipse's equations are one: ellipses lambda != mu of this potential form a "
         "line, if there are any: prescribe s3 and p_theta instead";
}

void set_motion(const Body& body, const TwoPolarMotion& motion, Equilibrium& at) {
  const Vector3<double> x = diagonal(at.q);
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&motion)) {
    at.two_polar = {*rates, two_polar_momenta(body.J1, x, rates->omega, rates->theta_dot), false};
  } else {
    const auto& momenta = std::get<TwoPolarMomenta<double>>(motion);
    at.two_polar = {at.circle
                        ? TwoPolarRates<double>{momenta.s3 / (2.0 * body.J1 * x[0] * x[0]), 0.0}
                        : two_polar_rates(body.J1, x, momenta),
                    momenta, true};
  }
  const TwoPolarRates<double>& rates = at.two_polar->rates;
  at.nu = {0.0, 0.0, rates.omega + rates.theta_dot};
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
                                const Stretch& q, const TwoPolarRates<double>& rates) {
  const Vector3<double> x = diagonal(q);
  const Vector3<double> gradient = v.gradient.tail<3>();
  const auto pull = two_polar_pull(body.J1, x[0], x[1], rates);
  const Vector3<double> force{pull.lambda / x[0], pull.mu / x[1], 0.0};
  const double largest =
      std::max({gradient.cwiseAbs().maxCoeff(), std::abs(pull.ll / x[0]), std::abs(pull.mm / x[1]),
                (v.hessian.bottomRightCorner<3, 3>() * x.asDiagonal()).cwiseAbs().maxCoeff()});
  return (gradient - force).cwiseAbs().maxCoeff() / largest;
}

void check_motion(const Body& body, const Potential& potential, Equilibrium& at) {
  at.residual =
      two_polar_residual_check(body, potential.derivatives(at.q), at.q, at.two_polar->rates);
  at.compatibility = 0.0;
}

}  // namespace stationary
