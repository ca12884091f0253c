// The normal form (normal_form.hpp) of events of an anisotropic body. F is the reduced energy
// V - |nu|^2 n.I n/2, or V + |pi|^2/(2 n.I n) at given |pi|, in ln (xi, zeta, rho), in a, alpha =
// sqrt(xi zeta) tanh a, and in phi, the angle of the axis n in the plane of axes 1 and 2. Where n is a
// material axis and V even in alpha, a and phi break the symmetry of alpha = 0; at the event F_vv = 0
// for
//
//   shear    v along a: s = a
//   oblique  v = (a, phi) with F_aa a + F_aphi phi = 0, phi = 1: s = phi
//   tilt     v the angle from n to the other axis v of the locked inertia: F_vv = |nu|^2 (n.I n - v.I v)
#include "solver/normal_form/oriented_normal_form.hpp"

#include <algorithm>
#include <cmath>

#include "lib/balance/anisotropic_balance.hpp"
#include "lib/number/interval_functions.hpp"
#include "solver/family/oriented_events.hpp"
#include "solver/motion/varied_balance.hpp"
#include "solver/normal_form/reduction.hpp"

namespace stationary {
namespace {

using T = AlongLine;
using oriented::a;
using oriented::phi;
using oriented::u;
using oriented::v;
using oriented::w;

constexpr std::size_t dimension = 5;

/// A vector of unit length.
using Axis = std::array<Interval, 3>;

/// Where motions of a kind lie near an event.
class NearOrientedEvent {
 public:
  /// axis: nu's own. momentum: |pi| is what is varied.
  NearOrientedEvent(const Body& body, const AnisotropicPotential& potential,
                    const FamilyParameter& parameter, const Axis& axis, bool in_plane,
                    bool momentum, const Stretch& q, const Member& member)
      : body_(body),
        potential_(potential),
        parameter_(parameter),
        axis_(axis),
        in_plane_(in_plane),
        momentum_(momentum),
        nu_(member.nu),
        x_{about(q.xi, member), about(q.zeta, member), about(q.rho, member),
           q.alpha == 0.0 ? Interval(1.0) : about(shear_coordinate(q), member)},
        p_(member) {}

  std::vector<T> gradient(const IntervalVector& d, double c) const {
    const State at = state(d, c);
    const std::array<T, 3>& n = at.axis;
    const SpinProducts<T> products{at.nu_squared * square(n[0]), at.nu_squared * square(n[1]),
                                   in_plane_ ? T(0.0) : at.nu_squared,
                                   at.nu_squared * (n[0] * n[1])};
    auto out = oriented_balance<1>(at.J, model(c), at.stretch, products);
    if (in_plane_) {
      add_axis<1>(at.J, at.stretch, at.nu_squared, {n[0], n[1], T(1.0)}, out);
      out.g[phi] = at.nu_squared * out.g[phi];
    }
    return {out.g.begin(), out.g.end()};
  }
  /// |nu|^2 (n.I n - v.I v).
  T turning(const Axis& to, const IntervalVector& d, double c) const {
    const State at = state(d, c);
    const std::array<T, 3> other{T(to[0]), T(to[1]), T(to[2])};
    return at.nu_squared * (moment(at, at.axis) - moment(at, other));
  }
  /// The axis of the inertia's to which it tilts.
  std::optional<Axis> tilts_to() const {
    if (in_plane_) return Axis{0.0, 0.0, 1.0};
    const Matrix3<T> I = locked_inertia(state(IntervalVector(dimension), 0.0));
    const Interval third = I(2, 2).value;
    const auto parts = null_vector(
        {{I(0, 0).value - third, I(0, 1).value}, {I(0, 1).value, I(1, 1).value - third}});
    if (!parts) return std::nullopt;
    return Axis{(*parts)[0], (*parts)[1], 0.0};
  }

  GradientAlong gradient() const {
    return [this](const IntervalVector& d, double c) { return gradient(d, c); };
  }

 private:
  using Kind = FamilyParameter::Kind;

  struct State {
    Inertia3<T> J;
    OrientedStretch<T> stretch;
    std::array<T, 3> axis;
    T nu_squared;
    T rho;  ///< of the inertia: that of a held volume follows the others
  };

  T along_parameter(double c) const { return p_.along(momentum_ ? 0.0 : c); }
  T number(double value, Kind kind, int index, double c) const {
    return varies(parameter_, kind, index) ? along_parameter(c) : T(Interval(value));
  }
  AnisotropicModel<T> model(double c) const {
    return potential_.model(
        Coefficients{coefficient_place(potential_, parameter_), along_parameter(c)});
  }
  State state(const IntervalVector& d, double c) const {
    State out;
    const auto moved = [&](std::size_t k) { return T(x_[k]) * exp(T::along(Interval(0.0), d[k])); };
    out.stretch = oriented_stretch<T>(moved(u), moved(v), moved(w), moved(a));
    out.J = {number(body_.J1, Kind::inertia, 0, c), number(body_.J2, Kind::inertia, 1, c),
             number(body_.J3, Kind::inertia, 2, c)};
    const T angle = T::along(Interval(0.0), d[phi]);
    out.axis = {axis_[0] * cos(angle) - axis_[1] * sin(angle),
                axis_[1] * cos(angle) + axis_[0] * sin(angle), T(axis_[2])};
    const auto volume = model(c).body.volume;
    out.rho = volume ? at_volume<T>(*volume, out.stretch).q.rho : out.stretch.q.rho;
    const T nu = number(nu_, Kind::nu, 0, c);
    out.nu_squared = square(nu);
    if (momentum_) {
      const T inertia = moment(out, out.axis);
      const Interval whole = absolute(nu.value) * inertia.value;
      out.nu_squared = square(T::along(whole, whole * c) / inertia);
    }
    return out;
  }
  static Matrix3<T> locked_inertia(const State& at) {
    BasicStretch<T> q = at.stretch.q;
    q.rho = at.rho;
    return stationary::locked_inertia(at.J, q);
  }
  static T moment(const State& at, const std::array<T, 3>& n) {
    const Matrix3<T> I = locked_inertia(at);
    return square(n[0]) * I(0, 0) + square(n[1]) * I(1, 1) + square(n[2]) * I(2, 2) +
           2.0 * (n[0] * n[1] * I(0, 1));
  }

  /// One after the other, as AnisotropicPotential::model() asks for them.
  struct Coefficients {
    int place;
    T p;
    mutable int next = 0;

    T operator()(double value) const { return next++ == place ? p : T(Interval(value)); }
    Direction<T> direction(double degrees) const {
      ++next;
      const auto exact = direction_interval(degrees, 0.0);
      return {T(exact.cosine), T(exact.sine)};
    }
  };

  const Body& body_;
  const AnisotropicPotential& potential_;
  FamilyParameter parameter_;
  Axis axis_;
  bool in_plane_;
  bool momentum_;
  double nu_;
  std::array<Interval, 4> x_;  ///< in the places of oriented::
  NearParameter p_;
};

/// A family in an angle is not told of: its coefficients are of no Taylor number's type.
bool can_vary(const FamilyParameter& parameter) {
  using Kind = FamilyParameter::Kind;
  const bool angle = parameter.kind == Kind::fibre && parameter.index % 2 != 0;
  return !angle && parameter.kind != Kind::shared;
}

std::optional<NormalForm> tilt(const NearOrientedEvent& event,
                               const std::vector<std::size_t>& kept) {
  const auto to = event.tilts_to();
  if (!to) return std::nullopt;
  return turning_form(
      event.gradient(), [&](const IntervalVector& d, double c) { return event.turning(*to, d, c); },
      along_coordinates(kept, dimension));
}

std::optional<NormalForm> oblique(const NearOrientedEvent& event,
                                  const std::vector<IntervalVector>& kept) {
  const auto parts =
      null_vector(stiffness(event.gradient(), along_coordinates({a, phi}, dimension)));
  if (!parts || (*parts)[1].may_be(0.0)) return std::nullopt;
  IntervalVector d(dimension);
  d[a] = (*parts)[0] / (*parts)[1];
  d[phi] = 1.0;
  return breaking_form(event.gradient(), d, kept);
}

}  // namespace

std::optional<NormalForm> oriented_normal_form(const Problem& problem,
                                               const FamilyParameter& parameter, EventType type,
                                               const Member& member) {
  if (!can_vary(parameter)) return std::nullopt;
  const AnisotropicPotential& V = problem.potential().anisotropic();
  const bool normal = problem.branch() == Branch::iii;
  // What begins at a shear has alpha = 0 there, whichever sheet the member is of.
  Stretch q = member.q;
  if (type == EventType::shear) q.alpha = 0.0;
  const bool straight = q.alpha == 0.0 && V.even_in_alpha();
  if (!straight && !normal) return std::nullopt;
  Axis axis{};
  axis[static_cast<std::size_t>(stationary::axis(problem.branch()))] = 1.0;
  const NearOrientedEvent event(problem.body(), V, parameter, axis, !normal,
                                type == EventType::fold_momentum, q, member);
  std::vector<std::size_t> kept{u, v, w};
  if (!straight) kept.push_back(a);
  switch (type) {
    case EventType::fold_nu:
    case EventType::fold_parameter:
    case EventType::fold_momentum:
      return fold_form(event.gradient(), along_coordinates(kept, dimension));
    case EventType::tilt:
      return tilt(event, kept);
    case EventType::shear:
      if (!straight || !normal) return std::nullopt;
      return breaking_form(event.gradient(), along_coordinates({a}, dimension).front(),
                           along_coordinates(kept, dimension));
    case EventType::oblique:
      if (normal) return std::nullopt;
      return oblique(event, along_coordinates(kept, dimension));
    default:
      return std::nullopt;
  }
}

std::optional<NormalForm> oblique_normal_form(const Body& body, const Potential& potential,
                                              const FamilyParameter& parameter, EventType type,
                                              const Member& member) {
  if (!is_known(member) || !can_vary(parameter)) return std::nullopt;
  const AnisotropicPotential& V = potential.anisotropic();
  const Vector3<double> along = member.angular_velocity.normalized();
  if (type == EventType::oblique) {  // where it leaves the spin about a material axis
    const Branch branch = std::abs(along[0]) > std::abs(along[1]) ? Branch::i : Branch::ii;
    Member left = member;
    left.q.alpha = 0.0;
    return oriented_normal_form(Problem(body, potential, branch), parameter, type, left);
  }
  // Of a coordinate x of the axis as of the stretches, dphi = sech(ln x) dx/x.
  const Interval error(-4.0 * member.error_bound - 0x1p-50, 4.0 * member.error_bound + 0x1p-50);
  const Axis axis{along[0] + error, along[1] + error, 0.0};
  const NearOrientedEvent event(body, V, parameter, axis, true, type == EventType::fold_momentum,
                                member.q, member);
  const std::vector<std::size_t> kept{u, v, w, a, phi};
  switch (type) {
    case EventType::fold_nu:
    case EventType::fold_parameter:
    case EventType::fold_momentum:
      return fold_form(event.gradient(), along_coordinates(kept, dimension));
    case EventType::tilt:
      return tilt(event, kept);
    default:
      return std::nullopt;
  }
}

}  // namespace stationary
