#include "solver/two_polar_family.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "lib/elastic_energy.hpp"
#include "solver/model_stability.hpp"
#include "solver/thickness_balance.hpp"
#include "solver/two_polar_stability.hpp"
#include "solver/two_polar_system.hpp"
#include "solver/varied_model.hpp"

namespace stationary {
namespace {

template <class Model, template <class> class Motion>
class TwoPolarFamily final
    : public Family<decltype(elastic_system(std::declval<Model>()))::dimension> {
 public:
  using Elastic = decltype(elastic_system(std::declval<Model>()));
  static constexpr int N = Elastic::dimension;

  TwoPolarFamily(const Body& body, const Model& model, const Motion<double>& motion,
                 const TwoPolarFamilyOptions& options)
      : parameter_(options.parameter), spectrum_(options.spectrum), base_{body, model, motion} {}

  Branch branch() const override { return Branch::iii; }
  bool two_polar() const override { return true; }
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
    constexpr int max_corrections = 8;
    const Refined out = refine(system(setting(p)), x, max_corrections, &tail);
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
    TwoPolarEquilibrium found;
    found.x = {x[0], x[1], out.q.rho};
    found.circle = x[0] == x[1];
    set_motion(body, TwoPolarMotion(at.motion), found);
    out.two_polar = TwoPolarMember{found.rates, found.momenta, by_momenta};
    out.nu = found.rates.omega + found.rates.theta_dot;
    out.angular_velocity = {0.0, 0.0, out.nu};
    ++this->evaluations_.second_derivatives;
    ++this->evaluations_.jacobians;  // the shear stiffness below
    const auto v = potential_derivatives<2>(at.model, out.q);
    out.residual = two_polar_residual_check(body, v, found);
    out.compatibility = 0.0;  // both vectors lie along axis 3
    out.energy =
        two_polar_kinetic_energy(body.J1, found.x, found.rates) + elastic_energy(at.model, out.q);
    const Linearized<N> all = system(at).linearize(x);
    out.shear_stiffness = (all.jacobian(0, 0) - all.jacobian(0, 1)) / (x[0] * x[1]);
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
    } else {
      out.model = at_coefficient(out.model, parameter_, p);
    }
    return out;
  }

  static TwoPolarSystem<Elastic, Motion> system(const Setting& at) {
    return {elastic_system(at.model), at.body.J1, at.motion};
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

  Spectrum spectrum(const Setting& at, const TwoPolarEquilibrium& found,
                    const std::array<DoubleDouble, 3>& x, double error_bound) const {
    ++this->evaluations_.spectra;
    if (found.circle) {
      return model_stability(at.body, Branch::iii, at.model, x,
                             found.rates.omega + found.rates.theta_dot, error_bound);
    }
    const double bound = std::isnan(error_bound) ? 1e-15 : std::max(error_bound, 0x1p-53);
    return two_polar_stability(at.body, at.model, x, found.rates, found.momenta.s3, bound);
  }

  FamilyParameter parameter_;
  bool spectrum_;
  Setting base_;
};

template <class Model>
AnyFamily family_of(const Body& body, const Model& model, const TwoPolarFamilyOptions& options) {
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&options.motion))
    return std::make_unique<TwoPolarFamily<Model, TwoPolarRates>>(body, model, *rates, options);
  const auto& momenta = std::get<TwoPolarMomenta<double>>(options.motion);
  return std::make_unique<TwoPolarFamily<Model, TwoPolarMomenta>>(body, model, momenta, options);
}

}  // namespace

AnyFamily two_polar_family(const Body& body, const Potential& potential,
                           const TwoPolarFamilyOptions& options) {
  require_two_polar(body, options.motion);
  if (options.parameter.kind == FamilyParameter::Kind::inertia && options.parameter.index != 2)
    throw std::invalid_argument("J1 = J2 is kept: J3 is the inertia that may vary");
  return potential.visit([&](const auto& model) { return family_of(body, model, options); });
}

}  // namespace stationary
