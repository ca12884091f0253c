#include "solver/kind/two_polar_event_enclosure.hpp"

#include <variant>

#include "solver/family/two_polar_events.hpp"
#include "solver/proof/enclosed_event.hpp"

namespace stationary {
namespace {

template <bool circle, template <class> class Motion>
EventEnclosure enclose_with(const Body& body, const Potential& potential,
                            const Motion<double>& motion, const FamilyParameter& parameter,
                            TwoPolarVanishing what, const Member& member, Inputs inputs) {
  const TwoPolarEventSystem<Motion, circle> equations(body, potential, motion, parameter, what);
  constexpr int N = TwoPolarEventSystem<Motion, circle>::dimension;
  ReducedVector<N> y;
  y[0] = member.q.xi;
  if constexpr (!circle) y[1] = member.q.zeta;
  y[N - 2] = member.q.rho;
  y[N - 1] = member.parameter;
  return enclosed_event(EventBoxes(equations, inputs), y, N - 1, member, [](const Box<N>& found) {
    return StretchBox{found[0], found[circle ? 0 : 1], found[N - 2]};
  });
}

}  // namespace

std::optional<EventEnclosure> enclose_two_polar_event(const Body& body, const Potential& potential,
                                                      const TwoPolarMotion& motion,
                                                      const FamilyParameter& parameter,
                                                      EventType type, const Member& member,
                                                      Inputs inputs) {
  const bool circle = member.q.xi == member.q.zeta;
  const auto what = vanishing_at(type, circle, member);
  if (!what) return std::nullopt;
  return std::visit(
      [&](const auto& own) {
        return circle ? enclose_with<true>(body, potential, own, parameter, *what, member, inputs)
                      : enclose_with<false>(body, potential, own, parameter, *what, member, inputs);
      },
      motion);
}

}  // namespace stationary
