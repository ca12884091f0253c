// A family of steady rotations about a material axis (axis_family.hpp) of a model known by its
// type: a Separable of a planar and a thickness model, or a coupled one. All formulas are lib's;
// this gathers them for continuation and lets one number of them vary.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <type_traits>
#include <utility>

#include "lib/balance/symmetry_stiffness.hpp"
#include "lib/body/inertia.hpp"
#include "lib/material/elastic_energy.hpp"
#include "solver/family/axis_family.hpp"
#include "solver/family/coefficient_slope.hpp"
#include "solver/motion/body_circle.hpp"
#include "solver/motion/model_stability.hpp"
#include "solver/newton/thickness_balance.hpp"
#include "solver/proof/event_enclosure.hpp"

namespace stationary {

template <class Model, int N>
class ModelFamily final : public Family<N> {
 public:
  /// problem: the same body, model and branch, for the events' own equations; none without it.
  ModelFamily(const Body& body, Branch branch, const Model& model, const AxisFamilyOptions& options,
              std::optional<Problem> problem = std::nullopt)
      : branch_(branch),
        options_(options),
        base_{body, model, options.nu},
        problem_(std::move(problem)),
        circle_(problem_ ? circle_of(*problem_, options.parameter) : Circle::none) {
    if constexpr (is_body_model<Model>)
      may_leave_ = model.gravitates && !model.elastic.rises_with_trace();
    if constexpr (constant_thickness) {
      const ThicknessBalance thickness = balanced_thickness(model.thickness, DoubleDouble(0.0));
      rho_ = thickness.rho;
      extended_rho_ = extended_solution(
          ThicknessSystem<std::decay_t<decltype(model.thickness)>>{model.thickness,
                                                                   DoubleDouble(0.0)},
          ReducedVector<1>(rho_))[0];
      rho_bound_ = thickness.refined.error_bound;
    }
  }

  Branch branch() const override { return branch_; }
  bool along_nu() const override { return options_.parameter.kind == Kind::nu; }
  bool material_symmetry() const override {
    const bool breaks = options_.parameter.kind == Kind::inertia && options_.parameter.index < 2;
    return base_.body.symmetric() && !breaks;
  }
  Circle circle() const override { return branch_ == Branch::iii ? Family<N>::circle() : circle_; }

  bool volume_row() const override {
    if constexpr (is_body_model<Model>) return base_.model.volume.has_value();
    return false;
  }

  std::vector<ConditionValue> conditions(const ReducedVector<N>& x, double p) const override {
    return model_conditions(setting(p).model, {0.0, x[0], x[1], rho_of(x)});
  }

  FamilyLinearization<N> linearize(const ReducedVector<N>& x, double p) const override {
    const Setting at = setting(p);
    const auto rates = extended_rates(at);
    this->evaluations_.jacobians += systems;
    Linearizations parts;
    FamilyLinearization<N> out;
    if constexpr (separable) {
      parts.plane = planar_system(at, rates).linearize({x[0], x[1]});
      out.g[0] = parts.plane.g[0];
      out.g[1] = parts.plane.g[1];
      if constexpr (N == 3) {
        parts.thickness = thickness_system(at, rates).linearize(ReducedVector<1>(x[2]));
        out.g[2] = parts.thickness.g[0];
      }
    } else {
      parts.all = CoupledSystem<Model>{at.model, rates}.linearize(x);
      out.g = parts.all.g;
    }
    const ReducedVector<N> scale = row_scales(parts);
    static_cast<FamilySlopes<N>&>(out) = slopes_of(at, rates, x, parts, scale);
    for (int i = 0; i < N; ++i) out.g[i] *= scale[i];
    return out;
  }

  Refined refine_at(ReducedVector<N>& x, ReducedVector<N>& tail, double p) const override {
    const Setting at = setting(p);
    return refined(at, extended_rates(at), x, tail, nullptr);
  }
  Refined refine_with_slopes(ReducedVector<N>& x, ReducedVector<N>& tail, double p,
                             std::optional<FamilySlopes<N>>& slopes) const override {
    const Setting at = setting(p);
    const auto rates = extended_rates(at);
    Linearizations parts;
    const Refined out = refined(at, rates, x, tail, &parts);
    slopes.reset();
    if (out.converged && out.last_change <= Family<N>::slopes_agree)
      slopes = slopes_of(at, rates, x, parts, row_scales(parts));
    return out;
  }

  ReducedVector<N> extended_residual(const ReducedVector<N>& x, double p) const override {
    const Setting at = setting(p);
    const auto rates = extended_rates(at);
    this->evaluations_.extended_residuals += systems;
    this->evaluations_.jacobians += systems;
    return by_rows(at, rates, x,
                   [](const auto& system, const auto& y) { return system.extended_residual(y); });
  }

  ReducedVector<N> input_perturbation(const ReducedVector<N>& x, double p) const override {
    const Setting at = setting(p);
    const auto rates = extended_rates(at);
    this->evaluations_.sensitivities += systems;
    this->evaluations_.jacobians += systems;
    ReducedVector<N> out = by_rows(at, rates, x, [](const auto& system, const auto& y) {
      return system.input_sensitivity(y);
    });
    return 0x1p-53 * out;
  }

  std::optional<ExtendedEvent<N>> event_at(EventType type, Circle circle,
                                           const Member& near) const override {
    if (!problem_) return std::nullopt;
    // The body and nu are this family's, whichever member is near.
    const Setting at = setting(near.parameter);
    Member beside = near;
    beside.body = at.body;
    beside.nu = at.nu;
    const auto found = extended_event(*problem_, options_.parameter, circle, type, beside);
    if (!found) return std::nullopt;
    ExtendedEvent<N> out{{}, found->parameter, found->error_bound, found->parameter_bound};
    for (std::size_t i = 0; i < out.x.size(); ++i) out.x[i] = found->x[i];
    return out;
  }

  Member member(const ReducedVector<N>& x, const ReducedVector<N>& tail, double p,
                double error_bound) const override {
    const Setting at = setting(p);
    Member out;
    out.parameter = p;
    out.body = at.body;
    out.nu = at.nu;
    out.q = {0.0, x[0], x[1], rho_of(x)};
    out.error_bound = error_bound;
    const Vector3<double> nu = angular_velocity(branch_, at.nu);
    out.angular_velocity = nu;
    add_elastic(at, out);
    if constexpr (is_body_model<Model>) {
      const CentrifugalRates<double> c = axis_rates(at.body, branch_, at.nu * at.nu);
      if (at.model.volume) out.pressure = at.model.pressure(out.q.xi, out.q.zeta, c.rho);
    }
    if (options_.spectrum) {
      ++this->evaluations_.spectra;
      const std::array<DoubleDouble, 3> q =
          tail.allFinite() ? with_tails(x, tail)
                           : extended_q(at.body, branch_, at.model, out.q, at.nu);
      out.spectrum = model_stability(at.body, branch_, at.model, q, at.nu, error_bound);
    }
    return out;
  }

 private:
  using Kind = FamilyParameter::Kind;
  static constexpr bool separable = requires(const Model& m) { m.plane; };
  static constexpr bool constant_thickness = separable && N == 2;

  /// Of the systems that are solved at one place: separable V's two, or the coupled one.
  struct Linearizations {
    Linearized<2> plane;
    Linearized<1> thickness;  ///< N = 3
    Linearized<3> all;
  };

  /// Planar and thickness balances that are unknowns' own.
  static constexpr int systems = separable ? N - 1 : 1;

  Refined counted(const Refined& refined) const {
    this->evaluations_.extended_residuals += refined.steps;
    this->evaluations_.jacobians += refined.steps;
    this->evaluations_.sensitivities += refined.converged;
    return refined;
  }

  /// The problem at one value of the parameter.
  struct Setting {
    Body body;
    Model model;
    double nu;
  };

  Setting setting(double p) const {
    Setting out = base_;
    const int k = options_.parameter.index;
    switch (options_.parameter.kind) {
      case Kind::nu:
        out.nu = p;
        break;
      case Kind::inertia:
        inertia_of(out.body, k) = p;
        if constexpr (is_body_model<Model>) inertia_of(out.model.J, k) = p;
        break;
      case Kind::plane:
      case Kind::thickness:
      case Kind::shared:
        out.model = at_coefficient(out.model, options_.parameter, p);
        break;
      case Kind::fibre:
        break;  // none of an isotropic potential's
    }
    return out;
  }

  /// Corrects x; parts: linearizations before the last correction, if they are asked for.
  Refined refined(const Setting& at, const CentrifugalRates<DoubleDouble>& rates,
                  ReducedVector<N>& x, ReducedVector<N>& tail, Linearizations* parts) const {
    if constexpr (separable) {
      ReducedVector<2> plane(x[0], x[1]);
      ReducedVector<2> planar_tail;
      Refined out = counted(refine(planar_system(at, rates), plane, most_corrections, &planar_tail,
                                   parts ? &parts->plane : nullptr));
      x.template head<2>() = plane;
      tail.template head<2>() = planar_tail;
      if constexpr (N == 3) {
        ReducedVector<1> rho(x[2]);
        ReducedVector<1> rho_tail;
        const Refined axial = counted(refine(thickness_system(at, rates), rho, most_corrections,
                                             &rho_tail, parts ? &parts->thickness : nullptr));
        x[2] = rho[0];
        tail[2] = rho_tail[0];
        out.converged = out.converged && axial.converged;
        out.error_bound = std::max(out.error_bound, axial.error_bound);
        out.first_correction = std::max(out.first_correction, axial.first_correction);
        out.last_change = std::max(out.last_change, axial.last_change);
      } else {
        out.error_bound = std::max(out.error_bound, rho_bound_);
      }
      return out;
    } else {
      return counted(refine(CoupledSystem<Model>{at.model, rates}, x, most_corrections, &tail,
                            parts ? &parts->all : nullptr));
    }
  }

  /// What the rows of G are multiplied by.
  static ReducedVector<N> row_scales(const Linearizations& parts) {
    ReducedVector<N> out;
    if constexpr (separable) {
      out[0] = out[1] = 1.0 / parts.plane.magnitude;
      if constexpr (N == 3) out[2] = 1.0 / parts.thickness.magnitude;
    } else {
      out.setConstant(1.0 / parts.all.magnitude);
    }
    return out;
  }
  FamilySlopes<N> slopes_of(const Setting& at, const CentrifugalRates<DoubleDouble>& rates,
                            const ReducedVector<N>& x, const Linearizations& parts,
                            const ReducedVector<N>& scale) const {
    FamilySlopes<N> out;
    if constexpr (separable) {
      out.jacobian.setZero();
      out.jacobian.template topLeftCorner<2, 2>() = parts.plane.jacobian.matrix();
      if constexpr (N == 3) out.jacobian(2, 2) = parts.thickness.jacobian(0, 0);
    } else {
      out.jacobian = parts.all.jacobian.matrix();
    }
    out.nu_slope = minus_pull<N>(at.model, axis_rates(at.body, branch_, 2.0 * at.nu), x);
    out.slope = along_nu() ? out.nu_slope
                           : parameter_slope<N>(at.model, at.body, rates, options_.parameter, x);
    for (int i = 0; i < N; ++i) {
      out.slope[i] *= scale[i];
      out.nu_slope[i] *= scale[i];
      out.jacobian.row(i) *= scale[i];
    }
    return out;
  }

  BalanceCheck checked(const Setting& at, const Stretch& q, const Vector3<double>& nu) const {
    if constexpr (is_body_model<Model>) {
      return check_balance(at.body, potential_derivatives<2>(at.model, q), q, nu,
                           holds_volume(at.model));
    } else {
      return check_straight_balance(axis_rates(at.body, branch_, at.nu * at.nu),
                                    potential_derivatives<2, 1>(at.model, q), q);
    }
  }

  /// Of V at the member's q, as far as it is asked for.
  void add_elastic(const Setting& at, Member& out) const {
    const Vector3<double>& nu = out.angular_velocity;
    if (options_.errors) {
      ++this->evaluations_.second_derivatives;
      const BalanceCheck check = checked(at, out.q, nu);
      out.residual = check.residual;
      out.compatibility = check.compatibility;
    }
    if (options_.energy) {
      this->evaluations_.potentials += !options_.errors;
      out.energy = energy(at.body, elastic_energy(at.model, out.q), out.q, nu);
    }
    if (branch_ != Branch::iii && is_on(circle_, out.q)) {
      ++this->evaluations_.second_derivatives;
      out.round_stiffness = stiffness_across_circle(at.model, branch_, at.body, out.q, at.nu);
    }
    const bool varied = options_.parameter.kind == Kind::inertia;
    if constexpr (is_body_model<Model>) {
      // As J1 passes J2 in (iii) the stiffness below, which has no factor J1 - J2 on a circle.
      if (may_leave_ && !at.body.symmetric() && !(varied && branch_ == Branch::iii)) {
        ++this->evaluations_.potentials;
        const TurningStiffness turn = turning_stiffness(at.model, branch_, at.body, out.q, at.nu);
        out.turn = turn.value;
        out.turn_condition = turn.condition;
      }
    }
    // What turns an ellipse or makes one; elsewhere it keeps its sign.
    const bool may_turn = at.body.symmetric() || varied;
    if (branch_ != Branch::iii || !may_turn) return;
    ++this->evaluations_.potentials;
    if constexpr (is_body_model<Model>) {
      out.shear_stiffness = potential_derivatives<2>(at.model, out.q).hessian(0, 0) -
                            centrifugal_matrix(at.body, nu)(0, 0);
    } else {
      const auto x = planar_invariants(out.q.xi, out.q.zeta);
      const auto w = at.model.template evaluate<1>(x, out.q.rho);
      out.shear_stiffness = -2.0 * w.plane.w_l / x.d - centrifugal_matrix(at.body, nu)(0, 0);
    }
  }

  CentrifugalRates<DoubleDouble> extended_rates(const Setting& at) const {
    return axis_rates(at.body, branch_, two_product(at.nu, at.nu));
  }
  static auto planar_system(const Setting& at, const CentrifugalRates<DoubleDouble>& rates) {
    return PlanarSystem<std::decay_t<decltype(at.model.plane)>>{at.model.plane, rates};
  }
  static auto thickness_system(const Setting& at, const CentrifugalRates<DoubleDouble>& rates) {
    return ThicknessSystem<std::decay_t<decltype(at.model.thickness)>>{at.model.thickness,
                                                                       rates.rho};
  }

  double rho_of(const ReducedVector<N>& x) const {
    if constexpr (N == 3) {
      return x[2];
    } else {
      return rho_;
    }
  }

  std::array<DoubleDouble, 3> with_tails(const ReducedVector<N>& x,
                                         const ReducedVector<N>& tail) const {
    std::array<DoubleDouble, 3> out{DoubleDouble(x[0], tail[0]), DoubleDouble(x[1], tail[1]),
                                    extended_rho_};
    if constexpr (N == 3) out[2] = DoubleDouble(x[2], tail[2]);
    return out;
  }

  /// part(system, unknowns) of each uncoupled system, rows divided by its magnitude.
  template <class Part>
  static ReducedVector<N> by_rows(const Setting& at, const CentrifugalRates<DoubleDouble>& rates,
                                  const ReducedVector<N>& x, const Part& part) {
    if constexpr (separable) {
      ReducedVector<N> out;
      const auto planar = planar_system(at, rates);
      const ReducedVector<2> plane(x[0], x[1]);
      out.template head<2>() = part(planar, plane) / planar.linearize(plane).magnitude;
      if constexpr (N == 3) {
        const auto axial = thickness_system(at, rates);
        const ReducedVector<1> rho(x[2]);
        out[2] = part(axial, rho)[0] / axial.linearize(rho).magnitude;
      }
      return out;
    } else {
      const CoupledSystem<Model> system{at.model, rates};
      return part(system, x) / system.linearize(x).magnitude;
    }
  }

  Branch branch_;
  AxisFamilyOptions options_;
  Setting base_;
  std::optional<Problem> problem_;
  Circle circle_;           ///< about axis 1 or 2
  bool may_leave_ = false;  ///< alpha = 0, where J1 != J2
  double rho_ = std::numeric_limits<double>::quiet_NaN();
  DoubleDouble extended_rho_;
  double rho_bound_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace stationary
