#include "solver/event_curve/pitchfork.hpp"

#include <array>
#include <cmath>

#include "solver/motion/varied_balance.hpp"

namespace stationary {
namespace {

/// G at ln q + s v.
class AcrossTheCircle {
 public:
  AcrossTheCircle(const Problem& problem, double nu, const Stretch& q, const CirclePlaces& at)
      : problem_(problem), rates_(problem.rates(two_product(nu, nu))), at_(at) {
    q_ = {q.xi, q.zeta, q.rho};
  }

  LogBalance<DoubleDouble> at(double s) const {
    const DoubleDouble grown = exp(DoubleDouble(s));
    std::array<DoubleDouble, 3> x = q_;
    x[std::size_t(at_.first)] *= grown;
    x[std::size_t(at_.second)] = x[std::size_t(at_.second)] / grown;
    const auto number = [](double value, FamilyParameter::Kind, int) {
      return DoubleDouble(value);
    };
    return varied_balance(problem_.potential(), x[0], x[1], x[2], rates_, number);
  }

 private:
  const Problem& problem_;
  CentrifugalRates<DoubleDouble> rates_;
  CirclePlaces at_;
  std::array<DoubleDouble, 3> q_;
};

using Weights = std::array<double, 3>;

DoubleDouble along(const Weights& v, const LogBalance<DoubleDouble>& b) {
  return v[0] * b.g_xi + v[1] * b.g_zeta + v[2] * b.g_rho;
}
double stiffness(const Weights& v, const Weights& w, const LogBalance<DoubleDouble>& b) {
  const DoubleDouble of_w[3] = {w[0] * b.uu + w[1] * b.uv + w[2] * b.uw,
                                w[0] * b.uv + w[1] * b.vv + w[2] * b.vw,
                                w[0] * b.uw + w[1] * b.vw + w[2] * b.ww};
  return double(v[0] * of_w[0] + v[1] * of_w[1] + v[2] * of_w[2]);
}

}  // namespace

double pitchfork_coefficient(const Problem& problem, double nu, const Stretch& q, Circle circle) {
  const CirclePlaces places_of = places(circle);
  const AcrossTheCircle across(problem, nu, q, places_of);
  Weights v{};
  Weights both{};
  Weights third{};
  v[std::size_t(places_of.first)] = both[std::size_t(places_of.first)] = 1.0;
  v[std::size_t(places_of.second)] = -1.0;
  both[std::size_t(places_of.second)] = 1.0;
  third[std::size_t(places_of.other)] = 1.0;
  // Differences of order h^4: their error, and that of pairs of doubles over h^3, are below 1e-14.
  constexpr double h = 0x1p-13;
  const auto here = across.at(0.0);
  const auto one = across.at(h);
  const auto two = across.at(2.0 * h);
  const auto three = across.at(3.0 * h);
  // v.G is odd in s, the rest even: a reflection exchanges the two stretches.
  const double vvvv =
      double(8.0 * along(v, two) - 13.0 * along(v, one) - along(v, three)) / (4.0 * h * h * h);
  const auto second = [&](const Weights& w) {
    return double(32.0 * along(w, one) - 2.0 * along(w, two) - 30.0 * along(w, here)) /
           (12.0 * h * h);
  };
  double bKb = 0.0;
  double scale = 0.0;
  double det_K = 0.0;
  if (problem.potential().holds_volume()) {
    // Only along the volume: off it what is left of V is symmetric in no pair with rho.
    Weights along_volume = both;
    along_volume[std::size_t(places_of.other)] = -2.0;
    const double b = second(along_volume);
    scale = det_K = stiffness(along_volume, along_volume, here);
    bKb = b * b / scale;
  } else {
    const double b_s = second(both);
    const double b_t = second(third);
    const double K_ss = stiffness(both, both, here);
    const double K_st = stiffness(both, third, here);
    const double K_tt = stiffness(third, third, here);
    scale = std::abs(K_ss) + std::abs(K_tt);
    det_K = K_ss * K_tt - K_st * K_st;
    bKb = (b_s * b_s * K_tt - 2.0 * b_s * b_t * K_st + b_t * b_t * K_ss) / det_K;
  }
  const double size = std::abs(vvvv) + 3.0 * std::abs(bKb);
  const double out = vvvv - 3.0 * bKb;
  // The point is known to doubles, and so is its stiffness along v, which is in out.
  constexpr double rounding = 1e-11;
  if (!(std::abs(out) > rounding * (size + std::abs(scale)))) return 0.0;
  return (det_K < 0.0 ? -out : out) / size;
}

}  // namespace stationary
