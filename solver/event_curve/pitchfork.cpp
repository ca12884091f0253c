#include "solver/event_curve/pitchfork.hpp"

#include <array>
#include <cmath>

#include "solver/motion/varied_balance.hpp"

namespace stationary {
namespace {

using Gradient = std::array<DoubleDouble, 3>;

/// G at ln q + s v.
class AcrossTheCircle {
 public:
  AcrossTheCircle(const Problem& problem, double nu, const Stretch& q)
      : elastic_(problem.potential(), {}),
        rates_(problem.rates(two_product(nu, nu))),
        r_(q.xi),
        rho_(q.rho) {}

  LogBalance<DoubleDouble> at(double s) const {
    const DoubleDouble grown = exp(DoubleDouble(s));
    const DoubleDouble xi = r_ * grown;
    const DoubleDouble zeta = r_ / grown;
    LogBalance<DoubleDouble> out = elastic_.at(xi, zeta, rho_, DoubleDouble(0.0), {});
    const DoubleDouble pull_xi = rates_.xi * xi * xi;
    const DoubleDouble pull_zeta = rates_.zeta * zeta * zeta;
    const DoubleDouble pull_rho = rates_.rho * rho_ * rho_;
    out.g_xi -= pull_xi;
    out.g_zeta -= pull_zeta;
    out.g_rho -= pull_rho;
    out.uu -= 2.0 * pull_xi;
    out.vv -= 2.0 * pull_zeta;
    out.ww -= 2.0 * pull_rho;
    return out;
  }

 private:
  VariedElastic elastic_;
  CentrifugalRates<DoubleDouble> rates_;
  DoubleDouble r_;
  DoubleDouble rho_;
};

}  // namespace

double pitchfork_coefficient(const Problem& problem, double nu, const Stretch& q) {
  const AcrossTheCircle across(problem, nu, q);
  // Differences of order h^4: their error, and that of pairs of doubles over h^3, are below 1e-14.
  constexpr double h = 0x1p-13;
  const auto here = across.at(0.0);
  const auto one = across.at(h);
  const auto two = across.at(2.0 * h);
  const auto three = across.at(3.0 * h);
  // v.G is odd in s, the rest even: a reflection exchanges xi and zeta.
  const auto odd = [](const auto& b) { return b.g_xi - b.g_zeta; };
  const double vvvv = double(8.0 * odd(two) - 13.0 * odd(one) - odd(three)) / (4.0 * h * h * h);
  const auto second = [&](const auto& part) {
    return double(32.0 * part(one) - 2.0 * part(two) - 30.0 * part(here)) / (12.0 * h * h);
  };
  const double b_s = second([](const auto& b) { return b.g_xi + b.g_zeta; });
  const double b_rho = second([](const auto& b) { return b.g_rho; });
  const double K_ss = double(here.uu + 2.0 * here.uv + here.vv);
  const double K_sr = double(here.uw + here.vw);
  const double K_rr = double(here.ww);
  const double determinant = K_ss * K_rr - K_sr * K_sr;
  const double bKb =
      (b_s * b_s * K_rr - 2.0 * b_s * b_rho * K_sr + b_rho * b_rho * K_ss) / determinant;
  return (vvvv - 3.0 * bKb) / (std::abs(vvvv) + 3.0 * std::abs(bKb));
}

}  // namespace stationary
