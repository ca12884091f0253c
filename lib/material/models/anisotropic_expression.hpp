// A potential V(alpha, xi, zeta, rho) written by its user that is no function of t, d and rho alone
// (expression.hpp has those that are): its derivatives are taken in q = (alpha, xi, zeta, rho)
// itself. OrientedExpression takes the terms that are such a function as they are written apart
// (expression::oriented_tape), as what an anisotropic potential is made of:
//
//   V = W(t, l, r) + directed terms in q.
#pragma once

#include <optional>

#include "lib/material/models/expression.hpp"
#include "lib/material/models/potential_derivatives.hpp"

namespace stationary {

template <class C = double>
class AnisotropicExpression : public TapeModel<C> {
 public:
  using TapeModel<C>::TapeModel;

  std::vector<ConditionValue> conditions_at(
      const Stretch& q) const requires std::is_same_v<C, double> {
    return this->conditions(q.alpha, q.xi, q.zeta, q.rho);
  }
  /// Whether it is defined nowhere in a box.
  bool outside_box(const BasicStretch<Interval>& q) const requires std::is_same_v<C, Interval> {
    return this->outside(this->programs().evaluate[0], q.alpha, q.xi, q.zeta, q.rho);
  }

  /// order 0, 1, 2 as in evaluate() of the other models; what was not asked for is NaN.
  template <int order, class S>
  PotentialDerivatives<Product<C, S>> derivatives(const BasicStretch<S>& q) const {
    using R = Product<C, S>;
    PotentialDerivatives<R> out{poison<R>(), Vector4<R>::Constant(poison<R>()),
                                Matrix4<R>::Constant(poison<R>())};
    this->template run<R>(
        this->programs().evaluate[order],
        [&](const auto& result) {
          std::size_t k = 0;
          out.value = result(k++);
          if constexpr (order >= 1)
            for (int i = 0; i < 4; ++i) out.gradient[i] = result(k++);
          if constexpr (order >= 2)
            for (int i = 0; i < 4; ++i)
              for (int j = i; j < 4; ++j) out.hessian(i, j) = out.hessian(j, i) = result(k++);
        },
        q.alpha, q.xi, q.zeta, q.rho);
    return out;
  }
};

template <class C = double>
class OrientedExpression : public AnisotropicExpression<C> {
 public:
  /// tape: of oriented_tape().
  OrientedExpression(const std::shared_ptr<const expression::Tape>& tape,
                     const CoefficientList<C>& coefficients, const DomainPart& part = {})
      : AnisotropicExpression<C>(tape, coefficients, part) {
    if (tape->isotropic_terms) isotropic_.emplace(tape->isotropic_terms, coefficients);
  }

  /// Restricted to the part of its domain that q lies in.
  OrientedExpression on_part_of(const Stretch& q) const requires std::is_same_v<C, double> {
    return {this->tape(), this->coefficients(), this->part_of(q.alpha, q.xi, q.zeta, q.rho)};
  }

  /// Where it is known to be so: V_alpha = 0 at alpha = 0; not so; V(-alpha) = V(alpha).
  bool shear_free() const { return this->tape()->shear_free; }
  bool sheared() const { return this->tape()->sheared; }
  bool even() const { return this->tape()->even; }

  /// W; order 0, 1, 2 as in evaluate() of the other models.
  template <int order>
  CoupledDerivatives<C> isotropic(const PlanarInvariants<C>& x, const C& rho) const {
    if (isotropic_) return isotropic_->template evaluate<order>(x, rho);
    const C none(0.0);
    return {{none, none, none, none, none, none}, none, none, none, none};
  }
  /// Adds the directed terms and their derivatives to `out`.
  template <int order>
  void add(const BasicStretch<C>& q, PotentialDerivatives<C>& out) const {
    const PotentialDerivatives<C> own = this->template derivatives<order>(q);
    out.value += own.value;
    if constexpr (order >= 1) out.gradient += own.gradient;
    if constexpr (order >= 2) out.hessian += own.hessian;
  }

  /// alpha V_alpha + xi V_xi + zeta V_zeta of the directed terms, as one expression; none where the
  /// tape has not got it.
  std::optional<C> plane_pull(const BasicStretch<C>& q) const {
    const expression::Program& program = this->programs().plane_pull;
    if (program.results.empty()) return std::nullopt;
    std::optional<C> out;
    this->template run_anywhere<C>(
        program, [&](const auto& result) { out = result(0); }, q.alpha, q.xi, q.zeta, q.rho);
    return out;
  }

 private:
  std::optional<CoupledExpression<C>> isotropic_;
};

}  // namespace stationary
