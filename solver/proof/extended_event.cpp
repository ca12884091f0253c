#include "solver/proof/extended_event.hpp"

#include <algorithm>
#include <cmath>

#include "lib/number/elementary.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {
namespace {

constexpr int all = ExtendedEventEquations::dimension;
constexpr auto p_place = static_cast<std::size_t>(ExtendedEventEquations::parameter);
constexpr auto lambda_place = static_cast<std::size_t>(ExtendedEventEquations::lambda);

template <bool circle, bool spectral>
class EquationsOf final : public ExtendedEventEquations {
 public:
  EquationsOf(const EventSetting& setting, const EventFunction& function)
      : setting_(setting), system_(setting_, function) {}

  void hold(double value) override { setting_.held->value = value; }

  ExtendedVector<all> values(const ExtendedVector<all>& y) const override {
    return with_the_rest(system_.values(own(y), {}), y);
  }
  std::optional<ExtendedRoot<all>> root(const ExtendedVector<all>& y) const override {
    const auto found = extended_root(system_, own(y));
    if (!found) return std::nullopt;
    ExtendedRoot<all> out{y, {}};
    for (std::size_t k = 0; k < places.size(); ++k) {
      out.y[places[k]] = found->y[k];
      out.error[places[k]] = found->error[k];
    }
    if constexpr (circle) {
      out.y[1] = out.y[0];
      out.error[1] = out.error[0];
    }
    if constexpr (!spectral) out.y[lambda_place] = DoubleDouble(1.0);
    return out;
  }
  std::array<double, all> conditions(const ExtendedVector<all>& y) const override {
    std::array<Conditioned, places.size()> rounded;
    for (std::size_t k = 0; k < places.size(); ++k)
      rounded[k] = Conditioned::input(double(y[places[k]]));
    const auto at = system_.conditioned(rounded, false);
    std::array<double, all> out{};
    for (std::size_t k = 0; k < places.size(); ++k) out[places[k]] = at[k].condition;
    return out;
  }

 private:
  using System = ExtendedEventSystem<circle, spectral>;
  /// Of the system's unknowns and equations, among all.
  static constexpr auto places = [] {
    std::array<std::size_t, static_cast<std::size_t>(System::dimension)> out{};
    std::size_t k = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(all); ++i)
      if (!(circle && i == 1) && (spectral || i != lambda_place)) out[k++] = i;
    return out;
  }();

  static ExtendedVector<System::dimension> own(const ExtendedVector<all>& y) {
    ExtendedVector<System::dimension> out;
    for (std::size_t k = 0; k < places.size(); ++k) out[k] = y[places[k]];
    return out;
  }
  static ExtendedVector<all> with_the_rest(const ExtendedVector<System::dimension>& values,
                                           const ExtendedVector<all>& y) {
    ExtendedVector<all> out;
    for (std::size_t k = 0; k < places.size(); ++k) out[places[k]] = values[k];
    if constexpr (circle) out[1] = y[1] - y[0];
    if constexpr (!spectral) out[lambda_place] = y[lambda_place] - DoubleDouble(1.0);
    return out;
  }

  EventSetting setting_;
  System system_;
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

std::unique_ptr<ExtendedEventEquations> extended_event_equations(const EventSetting& setting,
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
  const double lambda = what.function.spectral() ? what.lambda : 1.0;
  return {DoubleDouble(member.q.xi), DoubleDouble(member.q.zeta), DoubleDouble(member.q.rho),
          DoubleDouble(member.parameter), DoubleDouble(lambda)};
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
