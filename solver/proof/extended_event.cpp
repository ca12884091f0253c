#include "solver/proof/extended_event.hpp"

#include <algorithm>
#include <cmath>

#include "lib/number/elementary.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {
namespace {

constexpr int all = 5;
using Equations = HeldEventEquations<all>;
constexpr auto p_place = static_cast<std::size_t>(Equations::parameter);

template <bool circle, bool spectral>
class EquationsOf final : public Equations {
 public:
  EquationsOf(const EventSetting& setting, const EventFunction& function)
      : setting_(setting), system_(setting_, function) {}

  void hold(double value) override { setting_.held->value = value; }

  ExtendedVector<all> values(const ExtendedVector<all>& y) const override {
    return in_places_.values(y);
  }
  std::optional<ExtendedRoot<all>> root(const ExtendedVector<all>& y) const override {
    return in_places_.root(y);
  }
  Errors conditions(const ExtendedVector<all>& y) const override {
    return in_places_.conditions(y);
  }

 private:
  using System = ExtendedEventSystem<circle, spectral>;
  using InPlaces = EventSystemInPlaces<all, System>;
  static constexpr typename InPlaces::Places places = [] {
    typename InPlaces::Places out{};
    std::size_t k = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(all); ++i)
      if (!(circle && i == 1) && (spectral || i != static_cast<std::size_t>(lambda))) out[k++] = i;
    return out;
  }();

  EventSetting setting_;
  System system_;
  InPlaces in_places_{system_, places, circle};
};

/// Whether an event found is the one located, and not another of its kind.
bool is_near(const ExtendedRoot<all>& found, const Member& located) {
  constexpr double near = 1e-3;
  const double x[3] = {located.q.xi, located.q.zeta, located.q.rho};
  for (std::size_t i = 0; i < 3; ++i)
    if (!(std::abs(log(double(found.y[i]) / x[i])) < near)) return false;
  return true;
}

}  // namespace

std::unique_ptr<Equations> extended_event_equations(const EventSetting& setting,
                                                    const EventFunction& function) {
  if (function.spectral()) {
    if (setting.circle == Circle::xi_zeta)
      return std::make_unique<EquationsOf<true, true>>(setting, function);
    return std::make_unique<EquationsOf<false, true>>(setting, function);
  }
  if (setting.circle == Circle::xi_zeta)
    return std::make_unique<EquationsOf<true, false>>(setting, function);
  return std::make_unique<EquationsOf<false, false>>(setting, function);
}

ExtendedVector<all> event_unknowns(const Member& member, const SoughtEvent& what) {
  ExtendedVector<all> y = event_unknowns(member, unknowns<3>(member.q));
  if (what.function.spectral()) y[Equations::lambda] = DoubleDouble(what.lambda);
  return y;
}

std::optional<ExtendedEvent<3>> extended_event(const Problem& problem,
                                               const FamilyParameter& parameter, Circle circle,
                                               EventType type, const Member& member) {
  if (member.parameter == 0.0) return std::nullopt;
  const EventSetting setting{problem.body(), problem.potential(), problem.branch(),
                             member.nu,      parameter,           circle,
                             Inputs::doubles};
  for (const SoughtEvent& what : sought_events(type, problem.branch(), member)) {
    const auto found =
        extended_event_equations(setting, what.function)->root(event_unknowns(member, what));
    if (!found || !is_near(*found, member)) continue;
    return ExtendedEvent<3>{{found->y[0], found->y[1], found->y[2]},
                            found->y[p_place],
                            *std::max_element(found->error.begin(), found->error.begin() + p_place),
                            found->error[p_place]};
  }
  return std::nullopt;
}

}  // namespace stationary
