#include "solver/family/sheared_family.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lib/material/elastic_energy.hpp"
#include "lib/material/material_coordinates.hpp"
#include "lib/stability/general_spectrum.hpp"
#include "solver/family/oriented_events.hpp"
#include "solver/family/tilted_family.hpp"
#include "solver/motion/oriented_stability.hpp"
#include "solver/newton/newton.hpp"

namespace stationary {
namespace {

/// The motion at alpha = 0 and its |nu|, which the equations have as unknowns then.
template <int N>
struct MirrorEquations {
  static constexpr int dimension = N;
  static constexpr auto place = static_cast<std::size_t>(ShearedEquations<N>::shear_place);
  const ShearedEquations<N>& family;

  template <class T, class Number>
  auto balance(std::array<T, static_cast<std::size_t>(N)> x, const T&, const Number& number) const {
    const T nu = x[place];
    x[place] = T(1.0);
    return family.balance(x, nu, number);
  }
};

template <int N>
Spectrum spectrum_at(const ShearedEquations<N>& of, const BasicStretch<DoubleDouble>& q,
                     const Vector3<DoubleDouble>& nu, double bound) {
  const LeafParts parts{.about_third = of.axis == ShearedAxis::third,
                        .coupled = !of.potential.is_separable(),
                        .volume_held = of.potential.holds_volume()};
  if (!parts.divided()) return general_spectrum(of.body, of.potential, q, nu, bound);
  return spectrum_by_parts(motion_leaf(of.body, of.potential, q, nu), parts, bound);
}

}  // namespace

template <int N>
ShearedEquations<N>::ShearedEquations(const Body& of, const Potential& with, ShearedAxis about,
                                      bool with_spectrum)
    : body(of), potential(with), model(), axis(about), spectrum(with_spectrum) {
  if (const auto reason = no_sheared_motion(of, with, about)) throw std::invalid_argument(*reason);
  if (with.holds_volume() != (N == 3))
    throw std::invalid_argument("three unknowns of a held volume, four of another body");
  model = with.as_body();
}

template <int N>
auto ShearedEquations<N>::unknowns(const Stretch& q) const -> X {
  if constexpr (N == 3) {
    return {q.xi, q.zeta, shear_coordinate(q)};
  } else {
    return {q.xi, q.zeta, q.rho, shear_coordinate(q)};
  }
}

template <int N>
Stretch ShearedEquations<N>::stretch(const X& x) const {
  double rho = 1.0;
  if constexpr (N == 4) rho = x[rho_place];
  const OrientedStretch<double> at = oriented_stretch(x[0], x[1], rho, x[shear_place]);
  return model.volume ? at_volume(*model.volume, at).q : at.q;
}

template <int N>
KindEvents ShearedEquations<N>::events() const {
  if (axis == ShearedAxis::third) return oriented_events<ShearedLayout>();
  if (axis == ShearedAxis::oblique) return oriented_events<ObliqueLayout>();
  KindEvents out = axis_events();
  out.set = [](const Member&, const TestContext&, TestValues&) {};
  out.may_collide = [](Block, const TestContext&) { return true; };
  out.mirror = EventType::shear;
  out.mirror_reason = "alpha has come to 0, the axis to a plane; beyond are mirror images";
  out.end = EventType::tilt;
  out.end_reason = [](const Member& at) -> std::string_view {
    return at.tilt_in_plane < at.tilt_normal ? "the axis has come to axis 3, alpha != 0"
                                             : "the axis has come to the plane of axes 1 and 2";
  };
  return out;
}

template <int N>
std::optional<Member> ShearedEquations<N>::mirror_point(const X& x, double p) const {
  const MirrorEquations<N> equations{*this};
  const StatedSystem<MirrorEquations<N>> system{equations, 0.0};
  X y = x;
  y[shear_place] = std::abs(p);
  if (!newton(system, y).converged) return std::nullopt;
  X tail;
  const Refined refined = refine(system, y, most_corrections, &tail);
  if (!refined.converged) return std::nullopt;
  const double nu = std::copysign(y[shear_place], p);
  y[shear_place] = 1.0;
  tail[shear_place] = 0.0;
  return member(y, tail, nu, refined.error_bound);
}

template <int N>
Member ShearedEquations<N>::member(const X& x, const X& tail, double p, double error_bound) const {
  using T = DoubleDouble;
  std::array<T, size> wide;
  for (std::size_t i = 0; i < wide.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    wide[i] = tail.allFinite() ? T(x[k], tail[k]) : T(x[k]);
  }
  const ShearedPoint<T> at = state(wide, T(p), [](double c) { return T(c); });
  const BasicStretch<T>& q = at.at.q;
  const ShearedSquares<T> squares = sheared_squares<T>(axis, at, two_product(p, p));
  Member out;
  out.parameter = out.nu = p;
  out.body = body;
  const double alpha = double(q.alpha);
  out.error_bound = bound_factor * error_bound;
  // Where the volume is held ln rho = ln C - ln xi - ln zeta + 2 ln cosh a.
  if constexpr (N == 3) out.error_bound *= 1.0 + std::abs(alpha) / std::sqrt(x[0] * x[1]);
  // An alpha below the rounding of extended precision is none.
  const bool sheared = std::abs(alpha) > 0x1p-80 * std::sqrt(x[0] * x[1]);
  out.q = {sheared ? alpha : 0.0, x[0], x[1], double(q.rho)};
  if (axis == ShearedAxis::in_no_plane) {
    out.tilt_in_plane = tilt_share(double(squares.in_plane), p, error_bound);
    out.tilt_normal = tilt_share(double(squares.normal), p, error_bound);
  }
  if (out.beyond_end()) return out;
  Vector3<T> nu{T(0.0), T(0.0), T(p)};
  // A share that is none is exactly none.
  if (axis != ShearedAxis::third && out.tilt_in_plane != 0.0) {
    const auto n = sheared_direction<T>({T(body.J1), T(body.J2), T(body.J3)}, at);
    const T along = sqrt(squares.in_plane / (square(n[0]) + square(n[1])));
    nu = {
        along * n[0], along * n[1],
        axis == ShearedAxis::oblique || out.tilt_normal == 0.0 ? T(0.0) : T(sqrt(squares.normal))};
  }
  if (double(nu[0]) == 0.0 && double(nu[1]) < 0.0) nu[1] = -nu[1];
  out.angular_velocity = {double(nu[0]), double(nu[1]), double(nu[2])};
  const BalanceCheck check = check_balance(body, potential, out.q, out.angular_velocity);
  out.residual = check.residual;
  out.compatibility = check.compatibility;
  if (N == 3) out.pressure = pressure(body, potential, out.q, out.angular_velocity);
  out.energy = energy(body, potential, out.q, out.angular_velocity);
  if (spectrum) out.spectrum = spectrum_at(*this, q, nu, stretch_uncertainty(out.error_bound));
  return out;
}

template struct ShearedEquations<3>;
template struct ShearedEquations<4>;

std::optional<Branch> left_at(ShearedAxis axis, EventType event, const Member& member) {
  const bool oblique = axis == ShearedAxis::oblique;
  if (axis == ShearedAxis::in_no_plane || member.q.alpha != 0.0 ||
      event != (oblique ? EventType::oblique : EventType::shear))
    return std::nullopt;
  const Vector3<double>& nu = member.angular_velocity;
  return !oblique ? Branch::iii : std::abs(nu[1]) > std::abs(nu[0]) ? Branch::ii : Branch::i;
}

std::optional<std::string> no_sheared_motion(const Body& body, const Potential& potential,
                                             ShearedAxis axis) {
  if (!potential.is_isotropic()) return "its equations are an isotropic potential's";
  if (body.symmetric())
    return axis == ShearedAxis::in_no_plane
               ? "J1 = J2 and an isotropic potential: the plane of the axis is taken for one of "
                 "material axes (plane \"13\")"
               : "J1 = J2 and an isotropic potential: material axes are taken such that alpha = 0";
  if (is_fluid(potential))
    return "a fluid: J is a choice of material coordinates, and there are such in which alpha = 0";
  const BodyModel<> whole = potential.as_body();
  if (axis != ShearedAxis::in_no_plane && !whole.gravitates)
    return "an isotropic potential without gravity: alpha = 0, and the axis is a material one or "
           "out "
           "of their plane";
  if (whole.elastic.rises_with_trace())
    return "alpha != 0 asks for W_t = 0, and this potential rises with t = xi + zeta everywhere";
  return std::nullopt;
}

}  // namespace stationary
