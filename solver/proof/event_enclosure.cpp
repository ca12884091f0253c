#include "solver/proof/event_enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "lib/body/inertia.hpp"
#include "solver/proof/enclosed_event.hpp"
#include "solver/proof/event_system.hpp"

namespace stationary {
namespace {

/// The equations' function, and where Lambda is among the unknowns, about where.
struct Sought {
  EventFunction function;
  double lambda = std::numeric_limits<double>::quiet_NaN();
};

double relative_gap(double a, double b) { return std::abs(a - b) / (std::abs(a) + std::abs(b)); }

/// The pair of modes that meets at the event: of one block and of one sign, or of two blocks,
/// imaginary and of opposite signature; whichever are nearest to each other.
std::optional<Sought> meeting_modes(const Spectrum& spectrum, EventType type) {
  const bool within = type != EventType::krein_pass;
  const bool imaginary = type != EventType::real_collision;
  std::optional<Sought> out;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](double gap, double lambda, Block first, Block second) {
    if (!(gap < least) || (lambda < 0.0) != imaginary) return;
    least = gap;
    const auto kind = within ? EventFunction::Kind::collision : EventFunction::Kind::crossing;
    out = Sought{{kind, 0, 0, first, second}, lambda};
  };
  for (int i = 0; i < spectrum.modes; ++i) {
    const Mode& a = spectrum.mode[static_cast<std::size_t>(i)];
    if (a.forced_zero) continue;
    if (within && a.lambda_im > 0.0)
      offer(a.lambda_im / std::hypot(a.lambda_re, a.lambda_im), a.lambda_re, a.block, a.block);
    for (int k = 0; k < i; ++k) {
      const Mode& b = spectrum.mode[static_cast<std::size_t>(k)];
      if (b.forced_zero || a.lambda_im > 0.0 || b.lambda_im > 0.0) continue;
      if ((a.block == b.block) != within || (!within && a.krein * b.krein > 0)) continue;
      offer(relative_gap(a.lambda_re, b.lambda_re), 0.5 * (a.lambda_re + b.lambda_re), a.block,
            b.block);
    }
  }
  return out;
}

/// The pairs of inertias whose equality is an event of the type, as moments of the stretches; the
/// nearest to equal first.
std::vector<Sought> equal_inertias(EventType type, Branch branch, const Member& member) {
  const Vector3<double> moment = second_moments(member.body, member.q);
  std::vector<Sought> out;
  struct Pair {
    int a;
    int b;
  };
  for (const Pair each : {Pair{0, 2}, Pair{1, 2}, Pair{0, 1}}) {
    // A tilt's, unless the spin is about the axis left over.
    const bool tilts = each.b == 2 && !(branch == Branch::i && each.a == 1) &&
                       !(branch == Branch::ii && each.a == 0);
    if (tilts == (type == EventType::tilt))
      out.push_back({{.kind = EventFunction::Kind::inertia, .a = each.a, .b = each.b}});
  }
  std::ranges::sort(out, {}, [&](const Sought& each) {
    return relative_gap(moment[each.function.a], moment[each.function.b]);
  });
  return out;
}

/// What may vanish at a located event of the type, the likeliest first.
std::vector<Sought> sought(EventType type, Branch branch, const Member& member) {
  const auto plain = [](EventFunction::Kind kind) {
    return std::vector{Sought{EventFunction{.kind = kind}}};
  };
  switch (type) {
    case EventType::fold_nu:
      return plain(EventFunction::Kind::fold);
    case EventType::fold_momentum:
      return plain(EventFunction::Kind::momentum);
    case EventType::ellipse:
      return plain(EventFunction::Kind::ellipse);
    case EventType::oblique:
    case EventType::shear:
      return plain(EventFunction::Kind::turn);
    case EventType::tilt:
    case EventType::inertia_exchange:
      return equal_inertias(type, branch, member);
    case EventType::hamiltonian_hopf:
    case EventType::real_collision:
    case EventType::krein_pass:
      if (member.spectrum)
        if (const auto meeting = meeting_modes(*member.spectrum, type)) return {*meeting};
      return {};
    default:
      return {};
  }
}

template <bool circle, bool spectral>
EventEnclosure enclose(const EventSetting& setting, const Sought& what, const Member& member) {
  using System = EventSystem<circle, spectral>;
  const System system(setting, what.function);
  ReducedVector<System::dimension> y;
  constexpr int p = System::stretches;
  y[0] = member.q.xi;
  if constexpr (!circle) y[1] = member.q.zeta;
  y[p - 1] = member.q.rho;
  y[p] = member.parameter;
  if constexpr (spectral) y[p + 1] = what.lambda;
  return enclosed_event(system, y, p, member, [](const Box<System::dimension>& found) {
    return StretchBox{found[0], found[circle ? 0 : 1], found[p - 1]};
  });
}

template <bool circle, bool spectral>
std::optional<ExtendedEvent<3>> extended(const EventSetting& setting, const Sought& what,
                                         const Member& member) {
  using System = ExtendedEventSystem<circle, spectral>;
  constexpr auto p = static_cast<std::size_t>(System::stretches);
  ExtendedVector<System::dimension> y;
  y[0] = member.q.xi;
  if constexpr (!circle) y[1] = member.q.zeta;
  y[p - 1] = member.q.rho;
  y[p] = member.parameter;
  if constexpr (spectral) y[p + 1] = what.lambda;
  const System system(setting, what.function);
  const auto root = extended_root(system, y);
  if (!root) return std::nullopt;
  return ExtendedEvent<3>{{root->y[0], root->y[circle ? 0 : 1], root->y[p - 1]},
                          root->y[p],
                          *std::max_element(root->error.begin(), root->error.begin() + p),
                          root->error[p]};
}

/// Whether an event found is the one located, and not another of its kind.
bool is_near(const ExtendedEvent<3>& found, const Member& located) {
  constexpr double near = 1e-3;
  const double x[3] = {located.q.xi, located.q.zeta, located.q.rho};
  for (std::size_t i = 0; i < 3; ++i)
    if (!(std::abs(std::log(double(found.x[i]) / x[i])) < near)) return false;
  return true;
}

}  // namespace

bool has_enclosure(EventType type) {
  return type != EventType::none && type != EventType::unexplained && !is_end(type);
}

EventEnclosure enclose_event(const Problem& problem, const FamilyParameter& parameter, bool circle,
                             EventType type, const Member& member, Inputs inputs) {
  EventEnclosure out;
  if (!problem.potential().is_isotropic()) {
    out.reason = "the equations of events are an isotropic potential's";
    return out;
  }
  out.reason = "it has no equations to prove, or no spectrum was computed";
  const EventSetting setting{
      problem.body(), problem.potential(), problem.branch(), member.nu, parameter, circle, inputs};
  for (const Sought& what : sought(type, problem.branch(), member)) {
    if (what.function.spectral()) {
      out = circle ? enclose<true, true>(setting, what, member)
                   : enclose<false, true>(setting, what, member);
    } else {
      out = circle ? enclose<true, false>(setting, what, member)
                   : enclose<false, false>(setting, what, member);
    }
    if (out.proven) break;
  }
  return out;
}

std::optional<ExtendedEvent<3>> extended_event(const Problem& problem,
                                               const FamilyParameter& parameter, bool circle,
                                               EventType type, const Member& member) {
  if (member.parameter == 0.0) return std::nullopt;
  const EventSetting setting{problem.body(), problem.potential(), problem.branch(),
                             member.nu,      parameter,           circle,
                             Inputs::doubles};
  for (const Sought& what : sought(type, problem.branch(), member)) {
    const auto found = what.function.spectral()
                           ? (circle ? extended<true, true>(setting, what, member)
                                     : extended<false, true>(setting, what, member))
                           : (circle ? extended<true, false>(setting, what, member)
                                     : extended<false, false>(setting, what, member));
    if (found && is_near(*found, member)) return found;
  }
  return std::nullopt;
}

template <int N>
LogBalance<BoxDual<N>> elastic_over(const Potential& potential, const FamilyParameter& parameter,
                                    const std::array<BoxDual<N>, 3>& x, const BoxDual<N>& p,
                                    Inputs inputs) {
  using T = BoxDual<N>;
  const CentrifugalRates<T> at_rest{T(0.0), T(0.0), T(0.0)};
  return varied_balance(potential, x[0], x[1], x[2], at_rest,
                        [&](double value, FamilyParameter::Kind kind, int index) {
                          return varies(parameter, kind, index) ? p : T(as_input(value, inputs));
                        });
}
template LogBalance<BoxDual<3>> elastic_over<3>(const Potential&, const FamilyParameter&,
                                                const std::array<BoxDual<3>, 3>&, const BoxDual<3>&,
                                                Inputs);
template LogBalance<BoxDual<4>> elastic_over<4>(const Potential&, const FamilyParameter&,
                                                const std::array<BoxDual<4>, 3>&, const BoxDual<4>&,
                                                Inputs);

}  // namespace stationary
