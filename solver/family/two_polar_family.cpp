#include "solver/family/two_polar_family.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <type_traits>

#include "lib/material/elastic_energy.hpp"
#include "solver/family/coefficient_slope.hpp"
#include "solver/family/two_polar_events.hpp"
#include "solver/motion/model_stability.hpp"
#include "solver/motion/two_polar_stability.hpp"
#include "solver/motion/two_polar_system.hpp"
#include "solver/newton/newton.hpp"
#include "solver/newton/thickness_balance.hpp"

namespace stationary {
namespace {

template <class Model, bool with_rho>
using FollowedElastic = decltype(followed_elastic_system<with_rho>(std::declval<Model>()));

template <class Model, bool with_rho, template <class> class Motion>
class TwoPolarFamily final : public Family<FollowedElastic<Model, with_rho>::dimension> {
 public:
  using Elastic = FollowedElastic<Model, with_rho>;
  static constexpr int N = Elastic::dimension;

  TwoPolarFamily(const Body& body, const Potential& potential, const Model& model,
                 const Motion<double>& motion, const TwoPolarFamilyOptions& options)
      : parameter_(options.parameter),
        spectrum_(options.spectrum),
        base_{body, model, motion},
        potential_(potential) {}

  Branch branch() const override { return Branch::iii; }
  KindEvents events() const override { return two_polar_events(); }
  bool along_nu() const override { return false; }
  bool material_symmetry() const override { return true; }

  std::vector<ConditionValue> conditions(const ReducedVector<N>& x, double p) const override {
    const Model model = setting(p).model;
    if constexpr (N == 3) {
      return model_conditions(model, {0.0, x[0], x[1], x[2]});
    } else {  // rho is the same all along
      return model_conditions(model.plane, {0.0, x[0], x[1], 1.0});
    }
  }

  FamilyLinearization<N> linearize(const ReducedVector<N>& x, double p) const override {
    const Setting at = setting(p);
    ++this->evaluations_.jacobians;
    const Linearized<N> all = system(at).linearize(x);
    const double scale = 1.0 / all.magnitude;
    FamilyLinearization<N> out;
    out.g = scale * all.g;
    out.jacobian = scale * all.jacobian.matrix();
    out.slope = scale * slope(at, x);
    out.nu_slope = out.slope;
    return out;
  }

  Refined refine_at(ReducedVector<N>& x, ReducedVector<N>& tail, double p) const override {
    const Refined out = refine(system(setting(p)), x, most_corrections, &tail);
    this->evaluations_.extended_residuals += out.steps;
    this->evaluations_.jacobians += out.steps;
    this->evaluations_.sensitivities += out.converged;
    return out;
  }

  ReducedVector<N> extended_residual(const ReducedVector<N>& x, double p) const override {
    const auto at = system(setting(p));
    ++this->evaluations_.extended_residuals;
    ++this->evaluations_.jacobians;
    return at.extended_residual(x) / at.linearize(x).magnitude;
  }

  ReducedVector<N> input_perturbation(const ReducedVector<N>& x, double p) const override {
    const auto at = system(setting(p));
    ++this->evaluations_.sensitivities;
    ++this->evaluations_.jacobians;
    return 0x1p-53 * at.input_sensitivity(x) / at.linearize(x).magnitude;
  }

  std::optional<Member> circle_point(const ReducedVector<N>& near) const override {
    if constexpr (by_momenta) {
      if (parameter_.kind != Kind::nu) return std::nullopt;
      const auto& [s3, p_theta] = base_.motion;
      const double equal = parameter_.index == 0 ? p_theta : s3;
      ReducedVector<N> x = near;
      x[0] = x[1] = std::sqrt(near[0] * near[1]);
      const TwoPolarSystem<Elastic, TwoPolarEqualMomenta> system{
          followed_elastic_system<with_rho>(base_.model), base_.body.J1, {equal}};
      if (!newton(system, x).converged) return std::nullopt;
      ReducedVector<N> tail;
      const Refined refined = refine(system, x, most_corrections, &tail);
      if (!refined.converged || std::abs(x[0] - x[1]) > refined.error_bound * x[0])
        return std::nullopt;
      x[1] = x[0];
      tail[1] = tail[0];
      return member(x, tail, equal, refined.error_bound);
    } else {
      return std::nullopt;
    }
  }

  std::unique_ptr<ExtendedEventEquations<5>> event_equations(EventType type, Circle section,
                                                             const Member& near) const override {
    const bool circle = section != Circle::none;
    const auto what = vanishing_at(type, circle, near);
    if (!what) return nullptr;
    const auto equations =
        [&]<bool round>(const auto& places) -> std::unique_ptr<ExtendedEventEquations<5>> {
      using System = TwoPolarEventSystem<Motion, round>;
      return std::make_unique<SystemEventEquations<5, System>>(
          System(base_.body, potential_, base_.motion, parameter_, *what), places, round);
    };
    if (circle) return equations.template operator()<true>(std::array<std::size_t, 3>{0, 2, 3});
    return equations.template operator()<false>(std::array<std::size_t, 4>{0, 1, 2, 3});
  }

  Member member(const ReducedVector<N>& x, const ReducedVector<N>& tail, double p,
                double error_bound) const override {
    const Setting at = setting(p);
    const Body& body = at.body;
    double rho_bound = 0.0;
    const DoubleDouble rho = thickness(at.model, x, tail, rho_bound);
    Member out;
    out.parameter = p;
    out.body = body;
    out.q = {0.0, x[0], x[1], double(rho)};
    out.error_bound = std::max(error_bound, rho_bound);
    Equilibrium found;
    found.q = out.q;
    found.circle = x[0] == x[1];
    set_motion(body, TwoPolarMotion(at.motion), found);
    const TwoPolarRates<double>& rates = found.two_polar->rates;
    out.two_polar = found.two_polar;
    out.nu = found.nu[2];
    out.angular_velocity = found.nu;
    ++this->evaluations_.second_derivatives;
    ++this->evaluations_.jacobians;  // the shear stiffness below
    const auto v = potential_derivatives<2>(at.model, out.q);
    out.residual = two_polar_residual_check(body, v, out.q, rates);
    out.compatibility = 0.0;  // both vectors lie along axis 3
    out.energy =
        two_polar_kinetic_energy(body.J1, diagonal(out.q), rates) + elastic_energy(at.model, out.q);
    if constexpr (is_body_model<Model>)
      if (at.model.volume) out.pressure = at.model.pressure(x[0], x[1], 0.0);
    const Linearized<N> all = system(at).linearize(x);
    const double across = all.jacobian(0, 0) - all.jacobian(0, 1);
    out.shear_stiffness = across / (x[0] * x[1]);
    if (found.circle) {
      // Half K_alpha,alpha of the same motion in (iii), from the elastic part of the above.
      const auto pull = two_polar_pull(body.J1, x[0], x[1], rates);
      const double own = body.J1 * out.nu * out.nu;
      out.turn = (across + (pull.ll - pull.lm) - pull.lambda) / (x[0] * x[1]) - own;
      const double terms = system(at).elastic.linearize(x).magnitude + std::abs(pull.ll) +
                           std::abs(pull.lm) + std::abs(pull.lambda);
      out.turn_condition = terms / (x[0] * x[1]) + own;
    }
    if (spectrum_) out.spectrum = spectrum(at, found, with_tails(x, tail, rho), out.error_bound);
    return out;
  }

 private:
  using Kind = FamilyParameter::Kind;
  static constexpr bool by_momenta = std::is_same_v<Motion<double>, TwoPolarMomenta<double>>;

  /// The problem at one value of the parameter.
  struct Setting {
    Body body;
    Model model;
    Motion<double> motion;
  };

  Setting setting(double p) const {
    Setting out = base_;
    if (parameter_.kind == Kind::nu) {
      auto& [first, second] = out.motion;
      (parameter_.index == 0 ? first : second) = p;
    } else if (parameter_.kind == Kind::inertia) {
      out.body.J3 = p;
      if constexpr (is_body_model<Model>) out.model.J.J3 = p;
    } else {
      out.model = at_coefficient(out.model, parameter_, p);
    }
    return out;
  }

  static TwoPolarSystem<Elastic, Motion> system(const Setting& at) {
    return {followed_elastic_system<with_rho>(at.model), at.body.J1, at.motion};
  }

  /// dG/dp; J3 is in no equation of these.
  ReducedVector<N> slope(const Setting& at, const ReducedVector<N>& x) const {
    ReducedVector<N> out = ReducedVector<N>::Zero();
    if (parameter_.kind == Kind::nu) {
      const auto& [first, second] = at.motion;
      const Motion<Dual2> numbers{Dual2(first, {1.0, 0.0}), Dual2(second, {0.0, 1.0})};
      const auto pull = two_polar_pull(at.body.J1, Dual2(x[0]), Dual2(x[1]), numbers);
      const auto k = static_cast<std::size_t>(parameter_.index);
      out[0] = -pull.lambda.slope[k];
      out[1] = -pull.mu.slope[k];
    } else if (parameter_.kind != Kind::inertia) {
      out = coefficient_slope<N>(at.model, parameter_, x);
    } else if constexpr (is_body_model<Model>) {
      out = body_slope(at.model, Model::inertia_place + 2, x);
    }
    return out;
  }

  static DoubleDouble thickness(const Model& model, const ReducedVector<N>& x,
                                const ReducedVector<N>& tail, double& bound) {
    if constexpr (N == 3) {
      return tail.allFinite() ? DoubleDouble(x[2], tail[2]) : DoubleDouble(x[2]);
    } else {
      const DoubleDouble at_rest(0.0);
      const ThicknessBalance balance = balanced_thickness(model.thickness, at_rest);
      bound = balance.refined.error_bound;
      using Thickness = std::decay_t<decltype(model.thickness)>;
      return extended_solution(ThicknessSystem<Thickness>{model.thickness, at_rest},
                               ReducedVector<1>(balance.rho))[0];
    }
  }

  static std::array<DoubleDouble, 3> with_tails(const ReducedVector<N>& x,
                                                const ReducedVector<N>& tail,
                                                const DoubleDouble& rho) {
    if (!tail.allFinite()) return {DoubleDouble(x[0]), DoubleDouble(x[1]), rho};
    return {DoubleDouble(x[0], tail[0]), DoubleDouble(x[1], tail[1]), rho};
  }

  Spectrum spectrum(const Setting& at, const Equilibrium& found,
                    const std::array<DoubleDouble, 3>& x, double error_bound) const {
    ++this->evaluations_.spectra;
    if (found.circle) {
      return model_stability(at.body, Branch::iii, at.model, x, found.nu[2], error_bound);
    }
    return two_polar_stability(at.body, at.model, x, *found.two_polar,
                               stretch_uncertainty(error_bound));
  }

  FamilyParameter parameter_;
  bool spectrum_;
  Setting base_;
  Potential potential_;
};

template <bool with_rho, class Model>
AnyFamily family_of(const Body& body, const Potential& potential, const Model& model,
                    const TwoPolarFamilyOptions& options) {
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&options.motion))
    return std::make_unique<TwoPolarFamily<Model, with_rho, TwoPolarRates>>(body, potential, model,
                                                                            *rates, options);
  const auto& momenta = std::get<TwoPolarMomenta<double>>(options.motion);
  return std::make_unique<TwoPolarFamily<Model, with_rho, TwoPolarMomenta>>(body, potential, model,
                                                                            momenta, options);
}

}  // namespace

AnyFamily two_polar_family(const Body& body, const Potential& potential,
                           const TwoPolarFamilyOptions& options) {
  require_two_polar(body, options.motion);
  if (options.parameter.kind == FamilyParameter::Kind::inertia && options.parameter.index != 2)
    throw std::invalid_argument("J1 = J2 is kept: J3 is the inertia that may vary");
  return potential.visit_parts([&](const auto& model) {
    // As of a spin (axis_family.cpp).
    constexpr bool with_rho = several_thicknesses<std::decay_t<decltype(model)>>;
    if constexpr (few_types && with_rho)
      if (potential.is_built_in()) return family_of<false>(body, potential, model, options);
    return family_of<with_rho>(body, potential, model, options);
  });
}

}  // namespace stationary
