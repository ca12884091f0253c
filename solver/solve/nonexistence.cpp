#include "solver/solve/nonexistence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <variant>

namespace stationary {
namespace {

using Rates = CentrifugalRates<DoubleDouble>;

template <class... Parts>
std::string text(const Parts&... parts) {
  std::ostringstream out;
  out.precision(10);
  (out << ... << parts);
  return out.str();
}

/// Sign of `stiffness - rate`, the difference in extended precision.
int sign_left(double stiffness, const DoubleDouble& rate) {
  const double left = double(stiffness - rate);
  return (left > 0.0) - (left < 0.0);
}

struct PlanarReason {
  const Problem& problem;
  const Rates& c;

  std::optional<std::string> operator()(const ReciprocalDeterminant<>& m) const {
    if (sign_left(m.k, c.xi) <= 0) {
      return text("(k - J1 nu^2) xi^2 = c/d has no solution: J1 nu^2 = ", double(c.xi),
                  " >= k = ", m.k);
    }
    if (sign_left(m.k, c.zeta) <= 0) {
      return text("(k - J2 nu^2) zeta^2 = c/d has no solution: J2 nu^2 = ", double(c.zeta),
                  " >= k = ", m.k);
    }
    return std::nullopt;
  }

  std::optional<std::string> operator()(const NeoHookean<>& m) const {
    const int xi = sign_left(m.mu, c.xi);
    const int zeta = sign_left(m.mu, c.zeta);
    if (xi == zeta) return std::nullopt;
    return text(
        "(mu - c_xi) xi^2 = (mu - c_zeta) zeta^2 has no solution: the centrifugal rates c_xi = ",
        double(c.xi), ", c_zeta = ", double(c.zeta), " lie on different sides of mu = ", m.mu);
  }

  std::optional<std::string> operator()(const Biot<>& m) const {
    const DoubleDouble xi_left = 2.0 * m.mu - c.zeta;
    const DoubleDouble zeta_left = 2.0 * m.mu - c.xi;
    const DoubleDouble det = zeta_left * xi_left + m.lambda * (xi_left + zeta_left);
    // An overflow proves nothing, nor does an underflow.
    const double size =
        std::max({std::abs(double(xi_left)), std::abs(double(zeta_left)), std::abs(m.lambda)});
    if (!std::isfinite(double(det)) || !(size > 0x1p-450)) return std::nullopt;
    const bool positive = (double(det) > 0.0 && double(xi_left) > 0.0 && double(zeta_left) > 0.0) ||
                          (double(det) < 0.0 && double(xi_left) < 0.0 && double(zeta_left) < 0.0);
    if (positive) return std::nullopt;
    if (double(det) == 0.0 && double(xi_left) == 0.0 && double(zeta_left) == 0.0)
      return std::nullopt;
    if (double(det) == 0.0) return "the balance is linear in (xi, zeta) and singular at this nu";
    const DoubleDouble force = 2.0 * (DoubleDouble(m.mu) + m.lambda);
    return text("the balance is linear in (xi, zeta) and its one solution is xi = ",
                double(force * xi_left / det), ", zeta = ", double(force * zeta_left / det),
                ": not both positive");
  }

  std::optional<std::string> operator()(const Hencky<>& m) const {
    if (problem.branch() == Branch::iii) return std::nullopt;
    // The unpulled stretch follows; 2 kappa ln x = c x^2 remains, and ln x / x^2 <= 1/(2 e).
    const double kappa = 2.0 * m.mu * ((m.mu + m.lambda) / (2.0 * m.mu + m.lambda));
    const double rate = problem.branch() == Branch::i ? double(c.zeta) : double(c.xi);
    const double largest = kappa / std::numbers::e;
    if (rate <= largest * (1.0 + 1e-14)) return std::nullopt;
    const char* stretch = problem.branch() == Branch::i ? "zeta" : "xi";
    return text("the pulled stretch obeys 2 kappa ln ", stretch, " = c ", stretch,
                "^2, which has no solution beyond the fold c = kappa/e: here c = J nu^2 = ", rate,
                " > ", largest, ", kappa = 2 mu (mu + lambda)/(2 mu + lambda)");
  }

  template <class Other>
  std::optional<std::string> operator()(const Other&) const {
    return std::nullopt;
  }
};

/// A built-in one.
std::optional<std::string> thickness_reason(const ThicknessPotential& thickness, const Rates& c) {
  return std::visit(
      [&](const auto& model) -> std::optional<std::string> {
        if (!std::isnan(model.balanced(c.rho))) return std::nullopt;
        return text("V_rho'(rho) = J3 nu^2 rho has no solution: it needs ", model.existence,
                    ", and J3 nu^2 = ", double(c.rho));
      },
      thickness);
}

std::optional<std::string> coupled_reason(const NeoHookean3d<>& m, const Rates& c) {
  const int xi = sign_left(m.mu, c.xi);
  if (sign_left(m.mu, c.zeta) == xi && sign_left(m.mu, c.rho) == xi) return std::nullopt;
  return text("(mu - c_i) x_i^2 must be one number for xi, zeta, rho: the centrifugal rates ",
              double(c.xi), ", ", double(c.zeta), ", ", double(c.rho),
              " lie on different sides of mu = ", m.mu);
}

/// Of the built-in part beside a written-out one.
std::optional<std::string> reason_beside_expression(const Problem& problem, const Rates& c) {
  if (!problem.potential().is_separable()) return std::nullopt;
  return problem.potential().visit([&](const auto& model) -> std::optional<std::string> {
    if constexpr (requires { model.plane.is_expression(); }) {
      if (const auto* thickness = std::get_if<ThicknessPotential>(&model.thickness.model))
        return thickness_reason(*thickness, c);
      if (const auto* plane = std::get_if<PlanarPotential>(&model.plane.model))
        return std::visit(PlanarReason{problem, c}, *plane);
    }
    return std::nullopt;
  });
}

}  // namespace

std::optional<std::string> nonexistence_reason(const Problem& problem, double nu) {
  const Rates c = problem.rates(two_product(nu, nu));
  // What overflows, or is not a number, proves nothing.
  if (!std::isfinite(double(c.xi)) || !std::isfinite(double(c.zeta)) ||
      !std::isfinite(double(c.rho)))
    return std::nullopt;
  if (!problem.potential().is_isotropic()) {
    using Separate = AnisotropicPotential::Model::Separate;
    const auto* separate = std::get_if<Separate>(&problem.potential().anisotropic().model().base);
    if (separate == nullptr || problem.potential().anisotropic().body().any()) return std::nullopt;
    const auto* thickness = std::get_if<ThicknessPotential>(&separate->thickness->model);
    return thickness == nullptr ? std::nullopt : thickness_reason(*thickness, c);
  }
  if (!problem.potential().is_built_in()) return reason_beside_expression(problem, c);
  if (!problem.potential().is_separable()) {
    return std::visit([&](const auto& model) { return coupled_reason(model, c); },
                      problem.potential().coupled());
  }
  if (auto reason = thickness_reason(problem.potential().thickness(), c)) return reason;
  return std::visit(PlanarReason{problem, c}, problem.potential().plane());
}

}  // namespace stationary
