#include "solver/event_curve/oriented_event_equations.hpp"

#include <array>

#include "solver/event_curve/event_curve_system.hpp"
#include "solver/family/oriented_events.hpp"

namespace stationary {
namespace {

constexpr int all = 5;
constexpr auto p_place = static_cast<std::size_t>(ExtendedEventEquations<all>::parameter);
constexpr auto lambda_place = static_cast<std::size_t>(ExtendedEventEquations<all>::lambda);

/// Of xi, zeta, rho, p and Lambda: the balance, and two modes that meet.
class MeetingSystem : public SpinSystem<MeetingSystem, all> {
 public:
  MeetingSystem(const VariedSpin& spin, const SpinBlocks& blocks, const MeetingModes& modes)
      : SpinSystem(spin), blocks_(blocks), modes_(modes) {}

  template <class T, class Number>
  std::array<T, all> equations(const std::array<T, all>& y, const Number& number) const {
    const auto [J, nu, model] = spin_.at(y[p_place], number);
    const std::array<T, 5> x{y[0], y[1], y[2], T(1.0), T(1.0)};
    const auto balance = balance_at<StraightLayout, 1>(J, model, blocks_.branch, square(nu), x);
    StraightState<T> state = straight_state(J, model, {T(0.0), y[0], y[1], y[2]}, nu);
    if (blocks_.volume_held && blocks_.branch != Branch::iii)
      state = with_thickness_pull(state, T(J.J3 * square(nu)));
    const auto meeting = meeting_equations<false>(modes_, blocks_, state, y[lambda_place]);
    std::array<T, all> out;
    for (std::size_t i = 0; i < StraightLayout::places.size(); ++i)
      out[i] = balance.g[StraightLayout::places[i]];
    out[p_place] = meeting[0];
    out[lambda_place] = meeting[1];
    return out;
  }

 private:
  SpinBlocks blocks_;
  MeetingModes modes_;
};

class OrientedEventEquations final : public HeldEventEquations<all> {
  /// answer(the event's own equations): where no Lambda is an unknown, one fewer.
  template <class Answer>
  auto with_system(const Answer& answer) const {
    const VariedSpin spin(potential_, body_, nu_, parameter_,
                          coefficient_place(potential_, parameter_));
    if (!function_.spectral())
      return answer(OrientedEventSystem<StraightLayout>(spin, branch_, *test_function(function_)));
    const SpinBlocks blocks{branch_, !potential_.is_separable(),
                            potential_.body().volume.has_value()};
    return answer(MeetingSystem(spin, blocks, function_.meeting()));
  }

 public:
  OrientedEventEquations(const EventSetting& setting, const EventFunction& function)
      : potential_(setting.potential.anisotropic()),
        body_(setting.body),
        branch_(setting.branch),
        nu_(setting.nu),
        parameter_(setting.parameter),
        held_(setting.held->number),
        function_(function) {
    hold(setting.held->value);
  }

  void hold(double value) override {
    switch (held_.kind) {
      case FamilyParameter::Kind::nu:
        nu_ = value;
        break;
      case FamilyParameter::Kind::inertia:
        inertia_of(body_, held_.index) = value;
        break;
      default:
        break;
    }
    if (const int place = coefficient_place(potential_, held_); place >= 0)
      potential_ = potential_.with_coefficient(place, value);
  }

  ExtendedVector<all> values(const ExtendedVector<all>& y) const override {
    return with_system([&](const auto& system) { return in_places(system).values(y); });
  }
  std::optional<ExtendedRoot<all>> root(const ExtendedVector<all>& y) const override {
    return with_system([&](const auto& system) { return in_places(system).root(y); });
  }
  Errors conditions(const ExtendedVector<all>& y) const override {
    return with_system([&](const auto& system) { return in_places(system).conditions(y); });
  }

 private:
  /// The system's unknowns are the first of all.
  template <class System>
  static EventSystemInPlaces<all, System> in_places(const System& system) {
    using InPlaces = EventSystemInPlaces<all, System>;
    static constexpr typename InPlaces::Places places = [] {
      typename InPlaces::Places out{};
      for (std::size_t k = 0; k < out.size(); ++k) out[k] = k;
      return out;
    }();
    return {system, places};
  }

  AnisotropicPotential potential_;
  Body body_;
  Branch branch_;
  double nu_;
  FamilyParameter parameter_;
  FamilyParameter held_;
  EventFunction function_;
};

}  // namespace

std::unique_ptr<HeldEventEquations<5>> oriented_event_equations(const EventSetting& setting,
                                                                const EventFunction& function) {
  return std::make_unique<OrientedEventEquations>(setting, function);
}

}  // namespace stationary
