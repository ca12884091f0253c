#include "solver/kind/spatial_family.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lib/material/elastic_energy.hpp"
#include "lib/material/material_coordinates.hpp"
#include "lib/stability/general_spectrum.hpp"
#include "solver/motion/event.hpp"
#include "solver/motion/event_functions.hpp"

namespace stationary {
namespace {

/// The motion at alpha = 0 and its |nu|, which the three equations have as unknowns then.
struct MirrorEquations {
  static constexpr int dimension = 3;
  const SpatialEquations& family;

  template <class T, class Number>
  std::array<T, 3> balance(const std::array<T, 3>& x, const T&, const Number& number) const {
    return spatial_balance<T>(family.state(std::array<T, 3>{x[0], x[1], T(1.0)}, number),
                              square(x[2]));
  }
};

}  // namespace

SpatialEquations::SpatialEquations(const Body& of, const Potential& with, bool with_spectrum)
    : body(of), potential(with), spectrum(with_spectrum) {
  if (const auto reason = no_spatial_motion(of, with)) throw std::invalid_argument(*reason);
}

KindEvents SpatialEquations::events() const {
  KindEvents out = axis_events();
  out.set = [](const Member&, const TestContext&, TestValues&) {};
  out.may_collide = [](Block, const TestContext&) { return true; };
  out.mirror = EventType::shear;
  out.mirror_reason = "alpha has come to 0, the axis to a plane; beyond are mirror images";
  return out;
}

std::vector<ConditionValue> SpatialEquations::conditions(const X& x) const {
  return potential.conditions_at(oriented_stretch(x[0], x[1], 1.0, x[2]).q);
}

std::optional<Member> SpatialEquations::mirror_point(const X& x, double p) const {
  const MirrorEquations equations{*this};
  const StatedSystem<MirrorEquations> system{equations, 0.0};
  X y(x[0], x[1], std::abs(p));
  if (!newton(system, y).converged) return std::nullopt;
  X tail;
  const Refined refined = refine(system, y, 8, &tail);
  if (!refined.converged) return std::nullopt;
  const X at(y[0], y[1], 1.0);
  return member(at, X(tail[0], tail[1], 0.0), y[2], refined.error_bound);
}

Member SpatialEquations::member(const X& x, const X& tail, double p, double error_bound) const {
  using T = DoubleDouble;
  std::array<T, 3> wide;
  for (std::size_t i = 0; i < wide.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    wide[i] = tail.allFinite() ? T(x[k], tail[k]) : T(x[k]);
  }
  const SpatialState<T> at = state(wide, [](double c) { return T(c); });
  const BasicStretch<T>& q = at.at.q;
  const SpatialSquares<T> squares = spatial_squares(at, two_product(p, p));
  Member out;
  out.parameter = out.nu = p;
  out.body = body;
  out.error_bound = bound_factor * error_bound;
  // An alpha below the rounding of extended precision is none.
  const double alpha = double(q.alpha);
  const bool sheared = std::abs(alpha) > 0x1p-80 * std::sqrt(x[0] * x[1]);
  out.q = {sheared ? alpha : 0.0, x[0], x[1], double(q.rho)};
  const double share[2] = {double(squares.in_plane) / (p * p), double(squares.normal) / (p * p)};
  out.tilt_in_plane = share[0];
  out.tilt_normal = share[1];
  if (out.beyond_end()) return out;
  const auto n = spatial_direction<T>({T(body.J1), T(body.J2), T(body.J3)}, at);
  const T along = sqrt(squares.in_plane / (square(n[0]) + square(n[1])));
  const Vector3<T> nu{along * n[0], along * n[1], sqrt(squares.normal)};
  out.angular_velocity = {double(nu[0]), double(nu[1]), double(nu[2])};
  const BalanceCheck check = check_balance(body, potential, out.q, out.angular_velocity);
  out.residual = check.residual;
  out.compatibility = check.compatibility;
  out.pressure = pressure(body, potential, out.q, out.angular_velocity);
  out.energy = energy(body, potential, out.q, out.angular_velocity);
  if (spectrum) {
    const double bound = std::isnan(error_bound) ? 1e-15 : std::max(out.error_bound, 0x1p-53);
    out.spectrum = general_spectrum(body, potential, q, nu, bound);
  }
  return out;
}

std::optional<std::string> no_spatial_motion(const Body& body, const Potential& potential) {
  if (!potential.is_isotropic()) return "its equations are an isotropic potential's";
  if (!potential.holds_volume())
    return "axes in no material plane are those of a body whose det S is held";
  if (body.symmetric())
    return "J1 = J2 and an isotropic potential: the plane of the axis is taken for one of material "
           "axes (plane \"13\")";
  if (is_fluid(potential))
    return "a fluid: J is a choice of material coordinates, and there are such in which alpha = 0";
  return std::nullopt;
}

std::unique_ptr<Family<3>> spatial_family(const Body& body, const Potential& potential,
                                          bool spectrum) {
  return std::make_unique<StatedFamily<SpatialEquations>>(
      SpatialEquations(body, potential, spectrum));
}

}  // namespace stationary
