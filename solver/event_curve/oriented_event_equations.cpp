#include "solver/event_curve/oriented_event_equations.hpp"

#include <algorithm>
#include <array>

#include "solver/event_curve/event_sides.hpp"
#include "solver/family/oriented_events.hpp"

namespace stationary {
namespace {

constexpr int all = ExtendedEventEquations::dimension;
constexpr auto lambda_place = static_cast<std::size_t>(ExtendedEventEquations::lambda);

class OrientedEventEquations final : public ExtendedEventEquations {
 public:
  OrientedEventEquations(const EventSetting& setting, std::size_t function)
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
        (held_.index == 0 ? body_.J1 : held_.index == 1 ? body_.J2 : body_.J3) = value;
        break;
      default:
        break;
    }
    if (const int place = coefficient_place(potential_, held_); place >= 0)
      potential_ = potential_.with_coefficient(place, value);
  }

  ExtendedVector<all> values(const ExtendedVector<all>& y) const override {
    const auto at = system().values(own(y), {});
    ExtendedVector<all> out;
    std::copy(at.begin(), at.end(), out.begin());
    out[lambda_place] = y[lambda_place] - DoubleDouble(1.0);
    return out;
  }
  std::optional<ExtendedRoot<all>> root(const ExtendedVector<all>& y) const override {
    const auto found = extended_root(system(), own(y));
    if (!found) return std::nullopt;
    ExtendedRoot<all> out{y, {}};
    std::copy(found->y.begin(), found->y.end(), out.y.begin());
    std::copy(found->error.begin(), found->error.end(), out.error.begin());
    out.y[lambda_place] = DoubleDouble(1.0);
    return out;
  }
  std::array<double, all> conditions(const ExtendedVector<all>& y) const override {
    std::array<Conditioned, System::dimension> rounded;
    for (std::size_t k = 0; k < rounded.size(); ++k) rounded[k] = Conditioned::input(double(y[k]));
    const auto at = system().conditioned(rounded, false);
    std::array<double, all> out{};
    for (std::size_t k = 0; k < at.size(); ++k) out[k] = at[k].condition;
    return out;
  }

 private:
  /// Of xi, zeta, rho and p.
  using System = OrientedEventSystem<StraightLayout>;

  System system() const {
    return {potential_, body_, branch_, nu_, parameter_, coefficient_place(potential_, parameter_),
            function_};
  }
  static ExtendedVector<System::dimension> own(const ExtendedVector<all>& y) {
    ExtendedVector<System::dimension> out;
    std::copy_n(y.begin(), out.size(), out.begin());
    return out;
  }

  AnisotropicPotential potential_;
  Body body_;
  Branch branch_;
  double nu_;
  FamilyParameter parameter_;
  FamilyParameter held_;
  std::size_t function_;
};

}  // namespace

std::unique_ptr<ExtendedEventEquations> oriented_event_equations(const EventSetting& setting,
                                                                 const EventFunction& function) {
  const auto own_one = own_function(function);
  if (function.spectral() || !own_one) return nullptr;
  return std::make_unique<OrientedEventEquations>(setting, *own_one);
}

}  // namespace stationary
