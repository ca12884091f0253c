#include "solver/family/normal_form.hpp"

#include <cmath>
#include <vector>

#include "lib/number/interval.hpp"
#include "lib/number/interval_functions.hpp"
#include "lib/number/taylor.hpp"
#include "solver/family/normal_form_reduction.hpp"
#include "solver/motion/varied_balance.hpp"

namespace stationary {
namespace {

using T = Taylor<Interval, 3>;
/// Of ln (xi, zeta, rho).
using Direction = std::array<Interval, 3>;

Interval dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Direction of_order(const std::array<T, 3>& g, int k) {
  return {g[0].derivative(k), g[1].derivative(k), g[2].derivative(k)};
}

/// What is varied as p: the family's parameter, or |pi|, nu = |pi|/I following it.
enum class Varied { parameter, momentum };

/// The balance near the event.
class NearEvent {
 public:
  NearEvent(const Problem& problem, const FamilyParameter& parameter, Circle circle,
            const Member& member, Varied varied = Varied::parameter)
      : problem_(problem), parameter_(parameter), member_(member), varied_(varied) {
    const Interval around(1.0 - 2.0 * member.error_bound, 1.0 + 2.0 * member.error_bound);
    double x[3] = {member.q.xi, member.q.zeta, member.q.rho};
    if (circle != Circle::none) {
      const auto [a, b, other] = places(circle);
      x[a] = x[b] = std::sqrt(x[a] * x[b]);
    }
    x_ = {around * x[0], around * x[1], around * x[2]};
    p_ = around * member.parameter;
    scale_ = member.parameter != 0.0 ? std::abs(member.parameter) : 1.0;
  }

  /// The numbers of the problem at p + c scale s.
  struct Numbers {
    const Potential& potential;
    FamilyParameter parameter;
    T p;

    T operator()(double value, FamilyParameter::Kind kind, int index) const {
      const InputPlace at = input_place(potential, kind, index);
      return varies(parameter, at.kind, at.index) ? p : T(Interval(value));
    }
  };
  Numbers numbers(double c) const {
    const double rate = varied_ == Varied::parameter ? c * scale_ : 0.0;
    return {problem_.potential(), parameter_, T::along(p_, Interval(rate))};
  }
  bool volume_held() const { return problem_.potential().holds_volume(); }

  struct State {
    std::array<T, 3> x;
    T nu;
    Inertia3<T> J;
  };
  /// At x e^(v s), p + c scale s.
  State state(const Direction& v, double c) const {
    using Kind = FamilyParameter::Kind;
    State out;
    for (std::size_t i = 0; i < 3; ++i) out.x[i] = T(x_[i]) * exp(T::along(Interval(0.0), v[i]));
    const Numbers number = numbers(c);
    const Body& body = problem_.body();
    out.nu = number(member_.nu, Kind::nu, 0);
    out.J = {number(body.J1, Kind::inertia, 0), number(body.J2, Kind::inertia, 1),
             number(body.J3, Kind::inertia, 2)};
    if (varied_ == Varied::momentum) {
      const auto part = axis_rates(out.J, problem_.branch(), T(1.0));
      const T inertia =
          part.xi * square(out.x[0]) + part.zeta * square(out.x[1]) + part.rho * square(out.x[2]);
      const Interval momentum = absolute(out.nu.value) * inertia.value;
      out.nu = T::along(momentum, momentum * c) / inertia;
    }
    return out;
  }
  LogBalance<T> balance(const Direction& v, double c) const {
    const State s = state(v, c);
    const auto rates = axis_rates(s.J, problem_.branch(), s.nu * s.nu);
    return varied_balance(problem_.potential(), s.x[0], s.x[1], s.x[2], rates, numbers(c));
  }
  std::array<T, 3> gradient(const Direction& v, double c) const {
    const LogBalance<T> b = balance(v, c);
    return {b.g_xi, b.g_zeta, b.g_rho};
  }
  /// dG/dp, over the scale of p.
  Direction slope() const { return of_order(gradient({}, 1.0), 1); }
  /// v d^2G/dp dx likewise.
  Direction mixed(const Direction& v) const {
    const Direction up = of_order(gradient(v, 1.0), 2);
    const Direction down = of_order(gradient(v, -1.0), 2);
    Direction out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = 0.25 * (up[i] - down[i]);
    return out;
  }
  /// dG/dx in a basis.
  IntervalMatrix stiffness(const std::vector<Direction>& basis) const {
    const LogBalance<T> b = balance({}, 0.0);
    const std::array<Direction, 3> rows{Direction{b.uu.value, b.uv.value, b.uw.value},
                                        Direction{b.uv.value, b.vv.value, b.vw.value},
                                        Direction{b.uw.value, b.vw.value, b.ww.value}};
    IntervalMatrix out;
    for (const Direction& a : basis) {
      Direction image;
      for (std::size_t i = 0; i < 3; ++i) image[i] = dot(rows[i], a);
      // nu follows the stretches.
      if (varied_ == Varied::momentum) image = of_order(gradient(a, 0.0), 1);
      IntervalVector& row = out.emplace_back();
      for (const Direction& each : basis) row.push_back(dot(each, image));
    }
    return out;
  }

 private:
  const Problem& problem_;
  FamilyParameter parameter_;
  const Member& member_;
  Varied varied_;
  Direction x_;
  Interval p_;
  double scale_;
};

/// Of the sheets that keep the circle. A held volume is kept by it too where rho is one of the two:
/// off it what is left of V (held_volume.hpp) is not symmetric in rho and another stretch.
std::vector<Direction> symmetric_basis(Circle circle, bool volume_held) {
  if (circle == Circle::none) return {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const CirclePlaces at = places(circle);
  const auto a = static_cast<std::size_t>(at.first);
  const auto b = static_cast<std::size_t>(at.second);
  const auto other = static_cast<std::size_t>(at.other);
  Direction along{};
  Direction third{};
  if (volume_held && circle != Circle::xi_zeta) {
    along[a] = along[b] = -sqrt(Interval(1.0) / 6.0);
    along[other] = sqrt(Interval(2.0) / 3.0);
    return {along};
  }
  along[a] = along[b] = sqrt(Interval(0.5));
  third[other] = 1.0;
  return {along, third};
}

std::optional<NormalForm> at_fold(const NearEvent& event, Circle circle) {
  // One direction alone is singular by itself; all three are so too.
  if (event.volume_held() && circle != Circle::xi_zeta) circle = Circle::none;
  const std::vector<Direction> basis = symmetric_basis(circle, event.volume_held());
  const auto parts = null_vector(event.stiffness(basis));
  if (!parts) return std::nullopt;
  Direction v{};
  for (std::size_t k = 0; k < basis.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) v[i] += basis[k][i] * (*parts)[k];
  return fold_form(dot(v, of_order(event.gradient(v, 0.0), 2)), dot(v, event.slope()));
}

/// F_vvvv, the gradient of F_vv across v, and its derivative in p at fixed x.
std::optional<NormalForm> at_breaking(const NearEvent& event, const Interval& vvvv,
                                      const Direction& vv_slope, const Interval& vv_parameter,
                                      const std::vector<Direction>& basis) {
  const Direction slope = event.slope();
  Breaking F{vvvv, {}, vv_parameter};
  IntervalVector along;
  for (const Direction& each : basis) {
    F.vv_slope.push_back(dot(each, vv_slope));
    along.push_back(dot(each, slope));
  }
  return breaking_form(F, event.stiffness(basis), along);
}

std::optional<NormalForm> at_ellipse(const NearEvent& event, Circle circle) {
  const CirclePlaces at = places(circle);
  Direction v{};
  v[static_cast<std::size_t>(at.first)] = 1.0;
  v[static_cast<std::size_t>(at.second)] = -1.0;
  const std::array<T, 3> g = event.gradient(v, 0.0);
  return at_breaking(event, dot(v, of_order(g, 3)), of_order(g, 2), dot(v, event.mixed(v)),
                     symmetric_basis(circle, event.volume_held()));
}

std::optional<NormalForm> at_tilt(const NearEvent& event, Branch branch, const Member& member) {
  const auto own = static_cast<std::size_t>(axis(branch));
  const Vector3<double> m = second_moments(member.body, member.q);
  std::size_t other = own == 2 ? 0 : 2;
  if (own == 2 && std::abs(m[1] - m[2]) < std::abs(m[0] - m[2])) other = 1;
  // I_b - I_a = m_a - m_b.
  const auto stiffness = [&](double c) {
    const NearEvent::State s = event.state({}, c);
    const std::array<T, 3> J{s.J.J1, s.J.J2, s.J.J3};
    const auto moment = [&](std::size_t k) { return J[k] * square(s.x[k]); };
    const T nu2 = square(s.nu);
    return std::array{nu2 * moment(own), nu2 * moment(other)};
  };
  const auto [m_own, m_other] = stiffness(1.0);
  Direction slope{};
  slope[own] = -2.0 * m_own.value;
  slope[other] = 2.0 * m_other.value;
  // Along a held volume rho follows xi and zeta.
  if (event.volume_held()) slope = {slope[0] - slope[2], slope[1] - slope[2], Interval(0.0)};
  return at_breaking(event, Interval(0.0), slope, m_other[1] - m_own[1],
                     symmetric_basis(Circle::none, event.volume_held()));
}

}  // namespace

std::optional<NormalForm> normal_form(const Problem& problem, const FamilyParameter& parameter,
                                      Circle circle, EventType type, const Member& member) {
  constexpr double least_known = 1e-6;
  if (!(member.error_bound < least_known) || !std::isfinite(member.parameter) || member.nu == 0.0)
    return std::nullopt;
  if (!problem.potential().is_isotropic())
    return oriented_normal_form(problem, parameter, type, member);
  // rho itself follows a volume that is varied: not worked out.
  const bool volume_varies = varies(parameter, FamilyParameter::Kind::plane,
                                    static_cast<int>(BodyModel<>::volume_place)) &&
                             problem.potential().holds_volume();
  switch (type) {
    case EventType::fold_nu:
    case EventType::fold_parameter:
      return at_fold({problem, parameter, circle, member}, circle);
    case EventType::fold_momentum:
      if (problem.potential().holds_volume()) return std::nullopt;  // not worked out
      return at_fold({problem, parameter, circle, member, Varied::momentum}, circle);
    case EventType::ellipse:
      return at_ellipse({problem, parameter, Circle::xi_zeta, member}, Circle::xi_zeta);
    case EventType::ellipse_23:
    case EventType::ellipse_13:
      if (volume_varies) return std::nullopt;
      return at_ellipse({problem, parameter, broken_circle(type), member}, broken_circle(type));
    case EventType::tilt:
      if (volume_varies) return std::nullopt;
      return at_tilt({problem, parameter, circle, member}, problem.branch(), member);
    default:
      return std::nullopt;
  }
}

}  // namespace stationary
