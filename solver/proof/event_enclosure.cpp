#include "solver/proof/event_enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "solver/proof/enclosed_event.hpp"
#include "solver/proof/event_system.hpp"
#include "solver/proof/sought_event.hpp"

namespace stationary {
namespace {

template <bool circle, bool spectral>
EventEnclosure enclose(const EventSetting& setting, const SoughtEvent& what, const Member& member) {
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

}  // namespace

bool has_enclosure(EventType type) {
  return type != EventType::none && type != EventType::unexplained && !is_end(type);
}

EventEnclosure enclose_event(const Problem& problem, const FamilyParameter& parameter,
                             Circle circle, EventType type, const Member& member, Inputs inputs) {
  EventEnclosure out;
  if (!problem.potential().is_isotropic()) {
    out.reason = "the equations of events are an isotropic potential's";
    return out;
  }
  out.reason = "it has no equations to prove, or no spectrum was computed";
  const EventSetting setting{
      problem.body(), problem.potential(), problem.branch(), member.nu, parameter, circle, inputs};
  const bool once = circle == Circle::xi_zeta;
  for (const SoughtEvent& what : sought_events(type, problem.branch(), member)) {
    if (what.function.spectral()) {
      out = once ? enclose<true, true>(setting, what, member)
                 : enclose<false, true>(setting, what, member);
    } else {
      out = once ? enclose<true, false>(setting, what, member)
                 : enclose<false, false>(setting, what, member);
    }
    if (out.proven) break;
  }
  return out;
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
