// The thickness of a separable potential as curves in ln rho: V_rho' = c_rho rho, and what other
// curves share with it.
#pragma once

#include <memory>
#include <utility>

#include "lib/balance/balance.hpp"
#include "solver/proof/box_balance.hpp"
#include "solver/tube/curve_equations.hpp"
#include "solver/tube/curve_terms.hpp"

namespace stationary {

/// J_i nu_end^2 where nu_i turns about another axis than i: the rates are q times this.
inline CentrifugalRates<Interval> rates_at_end(const Body& body, Branch branch, double nu_end,
                                               Inputs inputs) {
  return axis_rates(inertia_intervals(body, inputs), branch, square(Interval(nu_end)));
}

template <class Thickness>
class ThicknessCurves final : public CurveEquations<1> {
 public:
  ThicknessCurves(const Thickness& model, const CentrifugalRates<Interval>& rates, Inputs inputs)
      : model_(interval_model(model, inputs)),
        rate_(rates.rho),
        terms_(model_terms<1>(model, inputs)) {}

  CurveLinearized<1> linearize(const CurveBox<1>& y) const override {
    const Interval rho = exp(y[0]);
    const auto b = model_.log_balance(rho, y[1] * rate_);
    CurveLinearized<1> out;
    out.g = {b.g_rho};
    out.slope[0] = {b.ww, -(rate_ * square(rho))};
    return out;
  }
  bool excludes(const CurveBox<1>& y) const override { return defined_nowhere(model_, exp(y[0])); }
  bool contract(CurveBox<1>& y) const override {
    std::array<Interval, 1> x{y[0]};
    const bool left = terms_.contract({y[1] * rate_}, x);
    y[0] = x[0];
    return left;
  }
  void place(const CurveCoordinates<1>& y, PlacedMotions& motions) const override {
    motions.rho = exp(y[0]);
  }

 private:
  decltype(interval_model(std::declval<Thickness>(), Inputs())) model_;
  Interval rate_;
  CurveTerms<1> terms_;
};

}  // namespace stationary
