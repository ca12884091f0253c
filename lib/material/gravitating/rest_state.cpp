#include "lib/material/gravitating/rest_state.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/number/elementary.hpp"
#include "lib/number/number.hpp"

namespace stationary {
namespace {

using Point = std::array<double, 3>;  ///< logarithms of xi, zeta, rho

constexpr double farthest = 6.9;  // of 1e3

double sphere(const BodyModel<>& model) { return model.volume ? log(*model.volume) / 3.0 : 0.0; }

double distance(const Point& a, double centre) {
  double out = 0.0;
  for (const double x : a) out = hypotenuse(out, x - centre);
  return out;
}

LogBalance<double> balance_at(const BodyModel<>& model, const Point& at) {
  return model.log_balance(exp(at[0]), exp(at[1]), exp(at[2]), 0.0, 0.0, 0.0);
}

/// The shift of the diagonal that makes a symmetric matrix positive definite, 0 where it is.
std::optional<Eigen::LLT<Eigen::Matrix3d>> convex(Eigen::Matrix3d H, double size, bool& shifted) {
  shifted = false;
  for (double shift = 1e-3; shift < 1e3; shift *= 4.0) {
    const Eigen::LLT<Eigen::Matrix3d> factors(H);
    if (factors.info() == Eigen::Success) return factors;
    shifted = true;
    H.diagonal().array() += shift * size;
  }
  return {};
}

/// The minimum that a descent by Newton's steps comes to.
std::optional<Point> minimum_from(const BodyModel<>& model, Point at, double centre) {
  const bool circle = model.isotropic();
  for (int k = 0; k < 200; ++k) {
    const LogBalance<double> b = balance_at(model, at);
    Eigen::Matrix3d H;
    H << b.uu, b.uv, b.uw, b.uv, b.vv, b.vw, b.uw, b.vw, b.ww;
    const Eigen::Vector3d g(b.g_xi, b.g_zeta, b.g_rho);
    if (!H.allFinite() || !g.allFinite()) return {};
    bool shifted = false;
    // Along (1, -1) a circle's energy is not asked: it may be a saddle there and is at rest.
    if (circle) {
      const double across = std::abs(H(0, 0)) + std::abs(H(0, 1));
      H(0, 0) += across;
      H(1, 1) += across;
      H(0, 1) -= across;
      H(1, 0) -= across;
    }
    const auto factors = convex(H, H.cwiseAbs().maxCoeff(), shifted);
    if (!factors) return {};
    Eigen::Vector3d step = -factors->solve(g);
    if (circle) step[0] = step[1] = 0.5 * (step[0] + step[1]);
    const double size = step.cwiseAbs().maxCoeff();
    if (!(size < 1e6)) return {};
    const double damping = size > 0.25 ? 0.25 / size : 1.0;
    for (int i = 0; i < 3; ++i) at[static_cast<std::size_t>(i)] += damping * step[i];
    if (distance(at, centre) > farthest) return {};
    if (size <= 0x1p-46 && !shifted) return at;
  }
  return {};
}

}  // namespace

std::array<double, 3> rest_state(const BodyModel<>& model) {
  const double centre = sphere(model);
  std::optional<Point> nearest;
  for (const double spread : {0.0, 0.5, -0.5, 1.0, -1.0, 2.0, -2.0}) {
    const double away = std::abs(spread) * std::sqrt(1.5);
    if (nearest && away > 2.0 * distance(*nearest, centre)) break;
    const Point start{centre + 0.5 * spread, centre + 0.5 * spread, centre - spread};
    const auto found = minimum_from(model, start, centre);
    if (found && (!nearest || distance(*found, centre) < distance(*nearest, centre) - 1e-9))
      nearest = found;
  }
  if (!nearest) return {poison<double>(), poison<double>(), poison<double>()};
  std::array<double, 3> out;
  for (std::size_t i = 0; i < 3; ++i) out[i] = exp((*nearest)[i]);
  if (model.isotropic()) out[1] = out[0];
  return out;
}

double volume_stiffness(const BodyModel<>& model) {
  const double s = exp(sphere(model));
  const LogBalance<double> b = model.whole<2>(s, s, s, 0.0, 0.0, 0.0);
  double out = 0.0;
  for (const double each : {b.uu, b.vv, b.ww, b.uv, b.uw, b.vw, b.g_xi, b.g_rho})
    out = std::fmax(out, std::abs(each));
  return out > 0.0 && std::isfinite(out) ? out : 1.0;
}

}  // namespace stationary
