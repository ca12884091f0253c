#include "solver/family/two_polar_family.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <type_traits>

#include "lib/material/elastic_energy.hpp"
#include "solver/family/coefficient_slope.hpp"
#include "solver/motion/event.hpp"
#include "solver/motion/event_functions.hpp"
#include "solver/motion/extended_root.hpp"
#include "solver/motion/model_stability.hpp"
#include "solver/motion/two_polar_stability.hpp"
#include "solver/motion/two_polar_system.hpp"
#include "solver/newton/newton.hpp"
#include "solver/newton/thickness_balance.hpp"

namespace stationary {
namespace {

/// The events of a two-polar family in (lambda, mu, rho, p), on the circle lambda = mu once, in any
/// number type (extended_root.hpp).
enum class TwoPolarVanishing {
  fold,           ///< the stiffness at what is held and varied
  momentum_fold,  ///< the stiffness at the momenta of the rates
  ellipse,        ///< the circle's stiffness along (1, -1), at the rates
  shear,          ///< the circle's K_alpha,alpha as a motion of (iii)
  leaves_mu,      ///< omega - s3/I_1
  leaves_lambda,  ///< omega - s3/I_2
  leaves_circle   ///< the circle's I_1 - I_3
};

template <template <class> class Motion, bool circle>
class TwoPolarEventSystem {
 public:
  static constexpr std::size_t stretches = circle ? 2 : 3;
  static constexpr int dimension = circle ? 3 : 4;
  using Kind = FamilyParameter::Kind;

  TwoPolarEventSystem(const Body& body, const Potential& potential, const Motion<double>& motion,
                      const FamilyParameter& parameter, TwoPolarVanishing what)
      : body_(body),
        motion_(motion),
        parameter_(parameter),
        what_(what),
        elastic_(potential,
                 {parameter.kind == Kind::nu ? Kind::inertia : parameter.kind, parameter.index}) {}

  std::size_t inputs() const { return 4 + elastic_.inputs(); }
  bool has_decimals() const { return elastic_.has_decimals(); }

  ExtendedVector<dimension> values(const ExtendedVector<dimension>& y,
                                   const InputChange& change) const {
    return equations<DoubleDouble>(
        y, [&](double x, std::size_t k) { return change(x, k); },
        [&](const auto&... x) { return elastic_.at(x..., change.from(4)); });
  }
  std::array<Conditioned, static_cast<std::size_t>(dimension)> conditioned(
      const std::array<Conditioned, static_cast<std::size_t>(dimension)>& y, bool exact) const {
    return equations<Conditioned>(
        y, [&](double x, std::size_t) { return exact ? Conditioned(x) : Conditioned::input(x); },
        [&](const auto&... x) { return elastic_.at(x..., exact); });
  }

 private:
  template <class T, class Number, class Elastic>
  std::array<T, static_cast<std::size_t>(dimension)> equations(
      const std::array<T, static_cast<std::size_t>(dimension)>& y, const Number& number,
      const Elastic& elastic_at) const {
    const T& lambda = y[0];
    const T& mu = circle ? lambda : y[1];
    const T& rho = y[stretches - 1];
    const T& p = y[stretches];
    const T J = number(body_.J1, 0);
    const bool varies_motion = parameter_.kind == Kind::nu;
    const T J3 = parameter_.kind == Kind::inertia ? p : number(body_.J3, 1);
    const auto& [first, second] = motion_;
    const Motion<T> motion{varies_motion && parameter_.index == 0 ? p : number(first, 2),
                           varies_motion && parameter_.index == 1 ? p : number(second, 3)};
    const LogBalance<T> elastic = elastic_at(lambda, mu, rho, p);
    const TwoPolarPull<T> pull = two_polar_pull(J, lambda, mu, motion);
    std::array<T, static_cast<std::size_t>(dimension)> out;
    out[0] = elastic.g_xi - pull.lambda;
    if constexpr (!circle) out[1] = elastic.g_zeta - pull.mu;
    out[stretches - 1] = elastic.g_rho;
    out[stretches] = vanishing(J, J3, motion, lambda, mu, rho, elastic, pull);
    return out;
  }

  template <class T>
  T vanishing(const T& J, const T& J3, const Motion<T>& motion, const T& lambda, const T& mu,
              const T& rho, const LogBalance<T>& elastic, const TwoPolarPull<T>& pull) const {
    const T first = J * square(lambda);
    const T second = J * square(mu);
    const T third = J3 * square(rho);
    const T across = (elastic.uu - elastic.uv) - (pull.ll - pull.lm);
    const auto rates = rates_of(J, lambda, mu, motion);
    switch (what_) {
      case TwoPolarVanishing::fold:
        return singular(elastic, pull);
      case TwoPolarVanishing::momentum_fold:
        return singular(elastic, two_polar_pull(J, lambda, mu,
                                                momenta_of(first, second, J, lambda, mu, rates)));
      case TwoPolarVanishing::ellipse:
        return across;
      case TwoPolarVanishing::shear:
        return (elastic.uu - elastic.uv) - elastic.g_xi -
               first * square(rates.omega + rates.theta_dot);
      case TwoPolarVanishing::leaves_circle:
        return first - third;
      case TwoPolarVanishing::leaves_mu:
      case TwoPolarVanishing::leaves_lambda:
        break;
    }
    const T s3 = momenta_of(first, second, J, lambda, mu, rates).s3;
    const T inertia = (what_ == TwoPolarVanishing::leaves_mu ? second : first) + third;
    return rates.omega * inertia - s3;
  }

  template <class T>
  static T singular(const LogBalance<T>& elastic, const TwoPolarPull<T>& pull) {
    const T ll = elastic.uu - pull.ll;
    const T lm = elastic.uv - pull.lm;
    if constexpr (circle) {
      return determinant(
          SquareArray<T, 2>{{{ll + lm, elastic.uw}, {2.0 * elastic.uw, elastic.ww}}});
    } else {
      return determinant(SquareArray<T, 3>{{{ll, lm, elastic.uw},
                                            {lm, elastic.vv - pull.mm, elastic.vw},
                                            {elastic.uw, elastic.vw, elastic.ww}}});
    }
  }

  template <class T>
  static TwoPolarRates<T> rates_of(const T&, const T&, const T&, const TwoPolarRates<T>& rates) {
    return rates;
  }
  template <class T>
  static TwoPolarRates<T> rates_of(const T& J, const T& lambda, const T& mu,
                                   const TwoPolarMomenta<T>& momenta) {
    return two_polar_rates(J, Vector3<T>{lambda, mu, lambda}, momenta);
  }
  template <class T>
  static TwoPolarMomenta<T> momenta_of(const T& first, const T& second, const T& J, const T& lambda,
                                       const T& mu, const TwoPolarRates<T>& rates) {
    const T product = 2.0 * (J * (lambda * mu));
    const T squares = first + second;
    return {squares * rates.omega + product * rates.theta_dot,
            squares * rates.theta_dot + product * rates.omega};
  }

  Body body_;
  Motion<double> motion_;
  FamilyParameter parameter_;
  TwoPolarVanishing what_;
  VariedElastic elastic_;
};

/// Of two candidates the one that is nearer to zero.
std::optional<TwoPolarVanishing> vanishing_at(EventType type, bool circle, const Member& near) {
  const auto& rates = near.two_polar->rates;
  const Vector3<double> m = second_moments(near.body, near.q);
  const auto gap = [](double a, double b) { return std::abs(a - b) / (std::abs(a) + std::abs(b)); };
  const double s3 = near.two_polar->momenta.s3;
  switch (type) {
    case EventType::fold_nu:
      return TwoPolarVanishing::fold;
    case EventType::fold_momentum:
      return near.two_polar->by_momenta ? TwoPolarVanishing::fold
                                        : TwoPolarVanishing::momentum_fold;
    case EventType::ellipse:
      if (!circle) return std::nullopt;
      return std::abs(near.shear_stiffness) < std::abs(near.turn) ? TwoPolarVanishing::ellipse
                                                                  : TwoPolarVanishing::shear;
    case EventType::tilt:
      if (circle) return TwoPolarVanishing::leaves_circle;
      return gap(rates.omega, s3 / (m[1] + m[2])) < gap(rates.omega, s3 / (m[0] + m[2]))
                 ? TwoPolarVanishing::leaves_mu
                 : TwoPolarVanishing::leaves_lambda;
    default:
      return std::nullopt;
  }
}

template <class Model, template <class> class Motion>
class TwoPolarFamily final
    : public Family<decltype(elastic_system(std::declval<Model>()))::dimension> {
 public:
  using Elastic = decltype(elastic_system(std::declval<Model>()));
  static constexpr int N = Elastic::dimension;

  TwoPolarFamily(const Body& body, const Potential& potential, const Model& model,
                 const Motion<double>& motion, const TwoPolarFamilyOptions& options)
      : parameter_(options.parameter),
        spectrum_(options.spectrum),
        base_{body, model, motion},
        potential_(potential) {}

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

  std::optional<Member> circle_point(const ReducedVector<N>& near) const override {
    if constexpr (by_momenta) {
      if (parameter_.kind != Kind::nu) return std::nullopt;
      const auto& [s3, p_theta] = base_.motion;
      const double equal = parameter_.index == 0 ? p_theta : s3;
      ReducedVector<N> x = near;
      x[0] = x[1] = std::sqrt(near[0] * near[1]);
      const TwoPolarSystem<Elastic, TwoPolarEqualMomenta> system{
          elastic_system(base_.model), base_.body.J1, {equal}};
      if (!newton(system, x).converged) return std::nullopt;
      ReducedVector<N> tail;
      const Refined refined = refine(system, x, 8, &tail);
      if (!refined.converged || std::abs(x[0] - x[1]) > refined.error_bound * x[0])
        return std::nullopt;
      x[1] = x[0];
      tail[1] = tail[0];
      return member(x, tail, equal, refined.error_bound);
    } else {
      return std::nullopt;
    }
  }

  std::optional<ExtendedEvent<N>> event_at(EventType type, bool circle,
                                           const Member& near) const override {
    const auto what = vanishing_at(type, circle, near);
    if (!what || near.parameter == 0.0) return std::nullopt;
    const auto& [xi, zeta, rho] = std::tie(near.q.xi, near.q.zeta, near.q.rho);
    ExtendedEvent<N> out;
    const auto take = [&](const auto& root, const std::array<std::size_t, 3>& places) {
      if (!root) return false;
      for (std::size_t i = 0; i < out.x.size(); ++i) out.x[i] = root->y[places[i]];
      const std::size_t p = places[2] + 1;
      out.parameter = root->y[p];
      out.error_bound = *std::max_element(root->error.begin(), root->error.begin() + places[2] + 1);
      out.parameter_bound = root->error[p];
      return true;
    };
    const bool found =
        circle ? take(extended_root(TwoPolarEventSystem<Motion, true>(
                                        base_.body, potential_, base_.motion, parameter_, *what),
                                    {xi, rho, near.parameter}),
                      {0, 0, 1})
               : take(extended_root(TwoPolarEventSystem<Motion, false>(
                                        base_.body, potential_, base_.motion, parameter_, *what),
                                    {xi, zeta, rho, near.parameter}),
                      {0, 1, 2});
    return found ? std::optional(out) : std::nullopt;
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
    const double across = all.jacobian(0, 0) - all.jacobian(0, 1);
    out.shear_stiffness = across / (x[0] * x[1]);
    if (found.circle) {
      // Half K_alpha,alpha of the same motion in (iii), from the elastic part of the above.
      const auto pull = two_polar_pull(body.J1, x[0], x[1], found.rates);
      const double own = body.J1 * out.nu * out.nu;
      out.turn = (across + (pull.ll - pull.lm) - pull.lambda) / (x[0] * x[1]) - own;
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
  Potential potential_;
};

template <class Model>
AnyFamily family_of(const Body& body, const Potential& potential, const Model& model,
                    const TwoPolarFamilyOptions& options) {
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&options.motion))
    return std::make_unique<TwoPolarFamily<Model, TwoPolarRates>>(body, potential, model, *rates,
                                                                  options);
  const auto& momenta = std::get<TwoPolarMomenta<double>>(options.motion);
  return std::make_unique<TwoPolarFamily<Model, TwoPolarMomenta>>(body, potential, model, momenta,
                                                                  options);
}

}  // namespace

AnyFamily two_polar_family(const Body& body, const Potential& potential,
                           const TwoPolarFamilyOptions& options) {
  require_two_polar(body, options.motion);
  if (options.parameter.kind == FamilyParameter::Kind::inertia && options.parameter.index != 2)
    throw std::invalid_argument("J1 = J2 is kept: J3 is the inertia that may vary");
  return potential.visit_parts(
      [&](const auto& model) { return family_of(body, potential, model, options); });
}

}  // namespace stationary
