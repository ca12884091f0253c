#include "solver/event_curve/event_curve_family.hpp"

#include <algorithm>
#include <cmath>

#include "lib/number/elementary.hpp"
#include "solver/event_curve/oriented_event_equations.hpp"
#include "solver/family/coefficient_slope.hpp"
#include "solver/family/oriented_events.hpp"

namespace stationary {
namespace {

constexpr double h = 0x1p-27;

EventCurveFamily::X difference(const ExtendedVector<EventCurveFamily::N>& a,
                               const ExtendedVector<EventCurveFamily::N>& b) {
  EventCurveFamily::X out;
  for (std::size_t i = 0; i < a.size(); ++i)
    out[static_cast<Eigen::Index>(i)] = double(a[i] - b[i]);
  return out;
}

bool is_coefficient(const FamilyParameter& parameter) {
  using Kind = FamilyParameter::Kind;
  return parameter.kind == Kind::plane || parameter.kind == Kind::thickness ||
         parameter.kind == Kind::shared;
}

}  // namespace

EventCurveFamily::EventCurveFamily(const EventSetting& setting, const SoughtEvent& what,
                                   const Member& start)
    : branch_(setting.branch),
      potential_(setting.potential),
      first_parameter_(setting.parameter),
      second_parameter_(setting.held->number),
      equations_(potential_.is_isotropic() ? extended_event_equations(setting, what.function)
                                           : oriented_event_equations(setting, what.function)) {
  const ExtendedVector<N> y = event_unknowns(start, what);
  for (int i = 0; i < N; ++i) {
    const double value = double(y[static_cast<std::size_t>(i)]);
    start_[i] = std::abs(value);
    sign_[i] = value < 0.0 ? -1.0 : 1.0;
  }
}

KindEvents EventCurveFamily::events() const {
  KindEvents out = axis_events();
  out.set = [](const Member&, const TestContext&, TestValues&) {};
  return out;
}

EventCurveFamily::X EventCurveFamily::coordinates(const Stretch&, double) const { return start_; }

std::vector<ConditionValue> EventCurveFamily::conditions(const X& x, double p) const {
  if (!potential_.is_isotropic()) {
    AnisotropicPotential V = potential_.anisotropic();
    if (const int k = coefficient_place(V, first_parameter_); k >= 0)
      V = V.with_coefficient(k, first_parameter(x));
    if (const int k = coefficient_place(V, second_parameter_); k >= 0) V = V.with_coefficient(k, p);
    return V.conditions_at({0.0, x[0], x[1], x[2]});
  }
  return potential_.visit_parts([&](auto model) {
    if (is_coefficient(first_parameter_))
      model = at_coefficient(model, first_parameter_, first_parameter(x));
    if (is_coefficient(second_parameter_)) model = at_coefficient(model, second_parameter_, p);
    return model_conditions(model, {0.0, x[0], x[1], x[2]});
  });
}

ExtendedVector<EventCurveFamily::N> EventCurveFamily::unknowns(const X& x) const {
  ExtendedVector<N> y;
  for (int i = 0; i < N; ++i) y[static_cast<std::size_t>(i)] = DoubleDouble(sign_[i] * x[i]);
  return y;
}

EventCurveFamily::Slopes EventCurveFamily::slopes(const ExtendedVector<N>& y, double p) const {
  Slopes out;
  equations_->hold(p);
  for (std::size_t k = 0; k < y.size(); ++k) {
    ExtendedVector<N> ahead = y;
    ExtendedVector<N> behind = y;
    ahead[k] = y[k] + h * y[k];
    behind[k] = y[k] - h * y[k];
    out.jacobian.col(static_cast<Eigen::Index>(k)) =
        difference(equations_->values(ahead), equations_->values(behind)) / (2.0 * h);
  }
  out.scale = out.jacobian.cwiseAbs().rowwise().sum().cwiseInverse();
  return out;
}

FamilyLinearization<EventCurveFamily::N> EventCurveFamily::linearize(const X& x, double p) const {
  ++evaluations_.jacobians;
  const ExtendedVector<N> y = unknowns(x);
  const Slopes at = slopes(y, p);
  const ExtendedVector<N> here = equations_->values(y);
  // Of a p2 near zero a step that is no smaller than those of numbers of order one.
  const double step = h * std::max(std::abs(p), 0x1p-10);
  equations_->hold(p + step);
  const ExtendedVector<N> ahead = equations_->values(y);
  equations_->hold(p - step);
  const ExtendedVector<N> behind = equations_->values(y);
  FamilyLinearization<N> out;
  out.slope = difference(ahead, behind) / ((p + step) - (p - step));
  out.slope = out.slope.cwiseProduct(at.scale).eval();
  out.nu_slope = out.slope;
  out.jacobian = at.scale.asDiagonal() * at.jacobian;
  for (int i = 0; i < N; ++i) out.g[i] = at.scale[i] * double(here[static_cast<std::size_t>(i)]);
  return out;
}

Refined EventCurveFamily::refine_at(X& x, X& tail, double p) const {
  ++evaluations_.extended_residuals;
  Refined out;
  equations_->hold(p);
  const auto root = equations_->root(unknowns(x));
  if (!root) return out;
  out.converged = true;
  out.first_correction = 0.0;
  out.error_bound = 0.0;
  for (int i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const DoubleDouble exact = sign_[i] * root->y[k];
    const double rounded = double(exact);
    if (!(rounded > 0.0)) return Refined{};  // another root, across a zero
    out.first_correction = std::max(out.first_correction, std::abs(log(rounded / x[i])));
    if (i < first) out.error_bound = std::max(out.error_bound, root->error[k]);
    x[i] = rounded;
    tail[i] = double(exact - DoubleDouble(rounded));
  }
  out.error_bound += 0x1p-53;
  return out;
}

EventCurveFamily::X EventCurveFamily::extended_residual(const X& x, double p) const {
  ++evaluations_.extended_residuals;
  const ExtendedVector<N> y = unknowns(x);
  const X rows = slopes(y, p).scale;
  const ExtendedVector<N> at = equations_->values(y);
  X out;
  for (int i = 0; i < N; ++i) out[i] = rows[i] * double(at[static_cast<std::size_t>(i)]);
  return out;
}

EventCurveFamily::X EventCurveFamily::input_perturbation(const X& x, double p) const {
  ++evaluations_.sensitivities;
  const ExtendedVector<N> y = unknowns(x);
  const X rows = slopes(y, p).scale;
  const auto conditions = equations_->conditions(y);
  X out;
  for (int i = 0; i < N; ++i) out[i] = 0x1p-53 * rows[i] * conditions[static_cast<std::size_t>(i)];
  return out;
}

Member EventCurveFamily::member(const X& x, const X&, double p, double error_bound) const {
  Member out;
  out.parameter = p;
  out.q = {0.0, x[0], x[1], x[2]};
  out.error_bound = error_bound;
  return out;
}

}  // namespace stationary
