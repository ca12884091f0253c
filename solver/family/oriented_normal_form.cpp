// The normal form (normal_form.hpp) of an anisotropic body where motions leave a spin about a
// material axis, V even in alpha. F is the reduced energy V - |nu|^2 n.I n/2 in ln (xi, zeta, rho)
// and two that break the symmetry: a, alpha = sqrt(xi zeta) tanh a, and phi, the angle of the axis
// n from its own in the plane of axes 1 and 2. At the event F_vv = 0 for
//
//   shear    v along a: s = a
//   oblique  v = (a, phi) with F_aa a + F_aphi phi = 0, phi = 1: s = phi
//
// and `fold-nu` as of isotropic bodies, alpha being 0.
#include <cmath>

#include "lib/balance/anisotropic_balance.hpp"
#include "lib/number/interval_functions.hpp"
#include "lib/number/taylor.hpp"
#include "solver/family/normal_form_reduction.hpp"
#include "solver/family/oriented_events.hpp"
#include "solver/motion/varied_balance.hpp"

namespace stationary {
namespace {

using T = Taylor<Interval, 3>;
using oriented::a;
using oriented::phi;
using oriented::u;
using oriented::v;
using oriented::w;
/// In (u, v, w, a, phi).
using Displacement = std::array<Interval, 5>;

constexpr std::array kept{u, v, w};  ///< directions that keep the symmetry

Displacement along(std::size_t k) {
  Displacement out{};
  out[k] = 1.0;
  return out;
}

class NearOrientedEvent {
 public:
  using Gradient = std::array<T, 5>;

  NearOrientedEvent(const Problem& problem, const FamilyParameter& parameter, const Member& member)
      : problem_(problem), parameter_(parameter), member_(member) {
    const Interval around(1.0 - 2.0 * member.error_bound, 1.0 + 2.0 * member.error_bound);
    x_ = {around * member.q.xi, around * member.q.zeta, around * member.q.rho};
    p_ = around * member.parameter;
    scale_ = member.parameter != 0.0 ? std::abs(member.parameter) : 1.0;
  }

  /// At the event and s times the direction away from it, p + c scale s.
  Gradient gradient(const Displacement& d, double c) const {
    using Kind = FamilyParameter::Kind;
    const Coefficients coefficients{
        coefficient_place(problem_.potential().anisotropic(), parameter_),
        T::along(p_, Interval(c * scale_))};
    const auto number = [&](double value, Kind kind, int index) {
      return varies(parameter_, kind, index) ? coefficients.p : T(Interval(value));
    };
    const Body& body = problem_.body();
    const Inertia3<T> J{number(body.J1, Kind::inertia, 0), number(body.J2, Kind::inertia, 1),
                        number(body.J3, Kind::inertia, 2)};
    const T nu2 = square(number(member_.nu, Kind::nu, 0));
    const auto moved = [&](std::size_t k) { return exp(T::along(Interval(0.0), d[k])); };
    const auto at = oriented_stretch<T>(T(x_[0]) * moved(u), T(x_[1]) * moved(v),
                                        T(x_[2]) * moved(w), moved(a));
    const auto model = problem_.potential().anisotropic().model(coefficients);
    if (problem_.branch() == Branch::iii)
      return oriented_balance<1>(J, model, at, axis_products(Branch::iii, nu2)).g;
    const T angle = T::along(Interval(0.0), d[phi]);
    const bool first = problem_.branch() == Branch::i;
    const AxisAngle<T> axis{first ? cos(angle) : -sin(angle), first ? sin(angle) : cos(angle),
                            T(1.0)};
    auto out = oriented_balance<1>(J, model, at, in_plane_products(nu2, axis.cosine, axis.sine));
    add_axis<1>(J, at, nu2, axis, out);
    out.g[phi] = nu2 * out.g[phi];
    return out.g;
  }

  /// Of order k along the direction, in those that keep the symmetry.
  static IntervalVector kept_part(const Gradient& g, int k) {
    IntervalVector out;
    for (const std::size_t i : kept) out.push_back(g[i].derivative(k));
    return out;
  }
  IntervalVector slope() const { return kept_part(gradient({}, 1.0), 1); }
  template <std::size_t n>
  IntervalMatrix stiffness(const std::array<std::size_t, n>& places) const {
    IntervalMatrix out;
    for (const std::size_t j : places) {
      const Gradient g = gradient(along(j), 0.0);
      IntervalVector& row = out.emplace_back();
      for (const std::size_t i : places) row.push_back(g[i].derivative(1));
    }
    return out;
  }

  std::optional<NormalForm> fold() const {
    const auto parts = null_vector(stiffness(kept));
    if (!parts) return std::nullopt;
    Displacement d{};
    for (std::size_t k = 0; k < kept.size(); ++k) d[kept[k]] = (*parts)[k];
    const IntervalVector curved = kept_part(gradient(d, 0.0), 2);
    const IntervalVector pull = slope();
    Interval F_vvv;
    Interval F_vp;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      F_vvv += (*parts)[k] * curved[k];
      F_vp += (*parts)[k] * pull[k];
    }
    return fold_form(F_vvv, F_vp);
  }
  /// d: of a and phi alone.
  std::optional<NormalForm> breaking(const Displacement& d) const {
    const auto broken = [&](const Gradient& g, int k) {
      return d[a] * g[a].derivative(k) + d[phi] * g[phi].derivative(k);
    };
    const Gradient g = gradient(d, 0.0);
    const Interval vvp = 0.25 * (broken(gradient(d, 1.0), 2) - broken(gradient(d, -1.0), 2));
    return breaking_form({broken(g, 3), kept_part(g, 2), vvp}, stiffness(kept), slope());
  }
  std::optional<NormalForm> oblique() const {
    const auto parts = null_vector(stiffness(std::array{a, phi}));
    if (!parts || (*parts)[1].may_be(0.0)) return std::nullopt;
    Displacement d{};
    d[a] = (*parts)[0] / (*parts)[1];
    d[phi] = 1.0;
    return breaking(d);
  }

 private:
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

  const Problem& problem_;
  FamilyParameter parameter_;
  const Member& member_;
  std::array<Interval, 3> x_;
  Interval p_;
  double scale_;
};

}  // namespace

std::optional<NormalForm> oriented_normal_form(const Problem& problem,
                                               const FamilyParameter& parameter, EventType type,
                                               const Member& member) {
  using Kind = FamilyParameter::Kind;
  const AnisotropicPotential& V = problem.potential().anisotropic();
  const bool angle = parameter.kind == Kind::fibre && parameter.index % 2 != 0;
  if (!V.even_in_alpha() || member.q.alpha != 0.0 || angle || parameter.kind == Kind::shared)
    return std::nullopt;
  const NearOrientedEvent event(problem, parameter, member);
  const bool normal = problem.branch() == Branch::iii;
  if (type == EventType::fold_nu) return event.fold();
  if (type == EventType::shear && normal) return event.breaking(along(a));
  if (type == EventType::oblique && !normal) return event.oblique();
  return std::nullopt;
}

}  // namespace stationary
