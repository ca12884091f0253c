#include "solver/event_curve/event_curve_family.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

constexpr double h = 0x1p-27;

template <std::size_t M>
auto difference(const std::array<DoubleDouble, M>& a, const std::array<DoubleDouble, M>& b) {
  ReducedVector<static_cast<int>(M)> out;
  for (std::size_t i = 0; i < M; ++i) out[static_cast<Eigen::Index>(i)] = double(a[i] - b[i]);
  return out;
}

}  // namespace

template <int N>
EventCurveFamily<N>::EventCurveFamily(EventCurveSystem<N> system, double scale)
    : system_(std::move(system)), scale_(scale) {
  for (int i = 0; i < N; ++i) {
    const double value = double(system_.start[static_cast<std::size_t>(i)]);
    start_[i] = std::abs(value);
    sign_[i] = value < 0.0 ? -1.0 : 1.0;
  }
}

template <int N>
KindEvents EventCurveFamily<N>::events() const {
  KindEvents out = axis_events();
  out.set = [](const Member&, const TestContext&, TestValues&) {};
  return out;
}

template <int N>
typename EventCurveFamily<N>::X EventCurveFamily<N>::coordinates(const Stretch&, double) const {
  return start_;
}

template <int N>
std::vector<ConditionValue> EventCurveFamily<N>::conditions(const X& x, double p) const {
  return system_.conditions(signed_unknowns(x), p);
}

template <int N>
ExtendedVector<N> EventCurveFamily<N>::unknowns(const X& x) const {
  ExtendedVector<N> y;
  for (int i = 0; i < N; ++i) y[static_cast<std::size_t>(i)] = DoubleDouble(sign_[i] * x[i]);
  return y;
}

template <int N>
typename EventCurveFamily<N>::Slopes EventCurveFamily<N>::slopes(const ExtendedVector<N>& y,
                                                                 double p) const {
  Slopes out;
  system_.equations->hold(p);
  for (std::size_t k = 0; k < y.size(); ++k) {
    ExtendedVector<N> ahead = y;
    ExtendedVector<N> behind = y;
    ahead[k] = y[k] + h * y[k];
    behind[k] = y[k] - h * y[k];
    out.jacobian.col(static_cast<Eigen::Index>(k)) =
        difference(system_.equations->values(ahead), system_.equations->values(behind)) / (2.0 * h);
  }
  out.scale = out.jacobian.cwiseAbs().rowwise().sum().cwiseInverse();
  return out;
}

template <int N>
FamilyLinearization<N> EventCurveFamily<N>::linearize(const X& x, double p) const {
  ++this->evaluations_.jacobians;
  const ExtendedVector<N> y = unknowns(x);
  const Slopes at = slopes(y, p);
  const ExtendedVector<N> here = system_.equations->values(y);
  // Of a p2 near zero a step that is no smaller than that of other numbers of its range.
  const double step = h * std::max(std::abs(p), 0x1p-10 * scale_);
  system_.equations->hold(p + step);
  const ExtendedVector<N> ahead = system_.equations->values(y);
  system_.equations->hold(p - step);
  const ExtendedVector<N> behind = system_.equations->values(y);
  FamilyLinearization<N> out;
  out.slope = difference(ahead, behind) / ((p + step) - (p - step));
  out.slope = out.slope.cwiseProduct(at.scale).eval();
  out.nu_slope = out.slope;
  out.jacobian = at.scale.asDiagonal() * at.jacobian;
  for (int i = 0; i < N; ++i) out.g[i] = at.scale[i] * double(here[static_cast<std::size_t>(i)]);
  return out;
}

template <int N>
Refined EventCurveFamily<N>::refine_at(X& x, X& tail, double p) const {
  ++this->evaluations_.extended_residuals;
  Refined out;
  system_.equations->hold(p);
  const auto root = system_.equations->root(unknowns(x));
  if (!root) return out;
  out.converged = true;
  out.first_correction = 0.0;
  for (int i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const DoubleDouble exact = sign_[i] * root->y[k];
    const double rounded = double(exact);
    if (!(rounded > 0.0)) return Refined{};  // another root, across a zero
    out.first_correction = std::max(out.first_correction, std::abs(log(rounded / x[i])));
    x[i] = rounded;
    tail[i] = double(exact - DoubleDouble(rounded));
  }
  out.error_bound = system_.equations->stretch_error(root->error) + 0x1p-53;
  return out;
}

template <int N>
typename EventCurveFamily<N>::X EventCurveFamily<N>::extended_residual(const X& x, double p) const {
  ++this->evaluations_.extended_residuals;
  const ExtendedVector<N> y = unknowns(x);
  const X rows = slopes(y, p).scale;
  const ExtendedVector<N> at = system_.equations->values(y);
  X out;
  for (int i = 0; i < N; ++i) out[i] = rows[i] * double(at[static_cast<std::size_t>(i)]);
  return out;
}

template <int N>
typename EventCurveFamily<N>::X EventCurveFamily<N>::input_perturbation(const X& x,
                                                                        double p) const {
  ++this->evaluations_.sensitivities;
  const ExtendedVector<N> y = unknowns(x);
  const X rows = slopes(y, p).scale;
  const auto conditions = system_.equations->conditions(y);
  X out;
  for (int i = 0; i < N; ++i) out[i] = 0x1p-53 * rows[i] * conditions[static_cast<std::size_t>(i)];
  return out;
}

template <int N>
Member EventCurveFamily<N>::member(const X& x, const X&, double p, double error_bound) const {
  Member out;
  out.parameter = p;
  out.q = {0.0, x[0], x[1], x[2]};
  out.error_bound = error_bound;
  return out;
}

template class EventCurveFamily<5>;
template class EventCurveFamily<6>;

}  // namespace stationary
