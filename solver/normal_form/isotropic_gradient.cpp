#include "solver/normal_form/isotropic_gradient.hpp"

#include <cmath>

#include "lib/number/interval_functions.hpp"

namespace stationary {

NearAxis NearAxis::along(Branch branch) {
  const auto own = static_cast<std::size_t>(axis(branch));
  return {own, own == 2 ? 0U : 2U};
}

NearAxis NearAxis::tilted(const Body& body, const Potential& potential, TiltPlane plane,
                          const Member& member) {
  const Inertia3<Interval> J{Interval(body.J1), Interval(body.J2), Interval(body.J3)};
  const Interval square_nu = square(about(member.nu, member));
  const auto at = varied_tilted<Interval>(
      potential, plane, J, about(member.q.xi, member), about(member.q.zeta, member), square_nu,
      [](double value, FamilyParameter::Kind, int) { return Interval(value); });
  return {static_cast<std::size_t>(axis(in_plane_branch(plane))), 2,
          sqrt(at.squares.in_plane / square_nu), sqrt(at.squares.normal / square_nu), true};
}

IsotropicGradient::IsotropicGradient(const Body& body, const Potential& potential,
                                     const FamilyParameter& parameter, const NearAxis& axis,
                                     Circle circle, const Member& member, Varied varied)
    : body_(body),
      potential_(potential),
      parameter_(parameter),
      axis_(axis),
      varied_(varied),
      nu_(member.nu),
      p_(member) {
  double x[3] = {member.q.xi, member.q.zeta, member.q.rho};
  if (circle != Circle::none) {
    const auto [a, b, other] = places(circle);
    x[a] = x[b] = std::sqrt(x[a] * x[b]);
  }
  for (std::size_t k = 0; k < x_.size(); ++k) x_[k] = about(x[k], member);
}

IsotropicGradient::Numbers IsotropicGradient::numbers(double c) const {
  return {potential_, parameter_, p_.along(varied_ == Varied::parameter ? c : 0.0)};
}

IsotropicGradient::State IsotropicGradient::state(const IntervalVector& d, double c) const {
  using Kind = FamilyParameter::Kind;
  State out;
  for (std::size_t k = 0; k < 3; ++k)
    out.x[k] = AlongLine(x_[k]) * exp(AlongLine::along(Interval(0.0), d[k]));
  const Numbers number = numbers(c);
  out.J = {number(body_.J1, Kind::inertia, 0), number(body_.J2, Kind::inertia, 1),
           number(body_.J3, Kind::inertia, 2)};
  out.cosine = AlongLine(axis_.cosine);
  out.sine = AlongLine(axis_.sine);
  if (axis_.turns) {
    const AlongLine s = AlongLine::along(Interval(0.0), d[3]);
    const AlongLine cosine = cos(s);
    const AlongLine sine = sin(s);
    out.cosine = axis_.cosine * cosine - axis_.sine * sine;
    out.sine = axis_.sine * cosine + axis_.cosine * sine;
  }
  AlongLine rho = out.x[2];
  if (potential_.holds_volume()) {
    const double volume = *potential_.body_model()->volume;
    rho = number(volume, Kind::plane, static_cast<int>(BodyModel<>::volume_place)) /
          (out.x[0] * out.x[1]);
  }
  out.moments = {out.J.J1 * square(out.x[0]), out.J.J2 * square(out.x[1]), out.J.J3 * square(rho)};
  const AlongLine nu = number(nu_, Kind::nu, 0);
  out.nu_squared = square(nu);
  if (varied_ == Varied::momentum) {
    const AlongLine& third = out.moments[3 - axis_.own - axis_.other];
    const AlongLine inertia = third + square(out.cosine) * out.moments[axis_.other] +
                              square(out.sine) * out.moments[axis_.own];
    const Interval momentum = absolute(nu.value) * inertia.value;
    out.nu_squared = square(AlongLine::along(momentum, momentum * c) / inertia);
  }
  return out;
}

std::vector<AlongLine> IsotropicGradient::operator()(const IntervalVector& d, double c) const {
  const State at = state(d, c);
  std::array<AlongLine, 3> squares{};  // of nu's components
  squares[axis_.own] = at.nu_squared * square(at.cosine);
  squares[axis_.other] = at.nu_squared * square(at.sine);
  const auto rates = centrifugal_rates(at.J, squares[0], squares[1], squares[2]);
  const LogBalance<AlongLine> b =
      varied_balance(potential_, at.x[0], at.x[1], at.x[2], rates, numbers(c));
  std::vector<AlongLine> out{b.g_xi, b.g_zeta, b.g_rho};
  if (axis_.turns)
    out.push_back(at.nu_squared * (at.sine * at.cosine) *
                  (at.moments[axis_.other] - at.moments[axis_.own]));
  return out;
}

AlongLine IsotropicGradient::turning(const IntervalVector& d, double c) const {
  const State at = state(d, c);
  return at.nu_squared * (at.moments[axis_.other] - at.moments[axis_.own]);
}

}  // namespace stationary
