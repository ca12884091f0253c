// Whether a curve stays where its potential is defined (lib/expression/domain.hpp): every condition
// x > 0 holds, and what must not be 0 keeps its sign, for a pole parts the domain even where the
// balance has numbers on both sides of it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "solver/continuation/curve.hpp"

namespace stationary {

template <int N>
class DomainGuard {
 public:
  /// The conditions at x, p.
  using Conditions = std::function<std::vector<ConditionValue>(const ReducedVector<N>&, double)>;

  /// scale: of p in y.
  DomainGuard(Conditions conditions, double scale)
      : conditions_(std::move(conditions)), scale_(scale) {}
  explicit DomainGuard(const Curve<N>& curve)
      : DomainGuard([&family = curve.family()](const ReducedVector<N>& x,
                                               double p) { return family.conditions(x, p); },
                    curve.corrector().scale()) {}

  /// To be called at every point of the curve, before what is asked of the next step.
  void enter(const ReducedVector<N>& x, double p) {
    if (entered_ && !watches()) return;
    entered_ = true;
    x_ = x;
    p_ = p;
    here_ = conditions_(x, p);
  }
  void enter(const ArcPoint<N>& at) { enter(at.x, at.p); }
  /// Built-in potentials are defined everywhere.
  bool watches() const { return !here_.empty(); }

  /// The first condition found broken on an arc from the point entered, at its end or where it dips
  /// in between; nullptr: none.
  const expression::TapeCondition* broken_on(const Arc<N>& arc) const {
    if (!watches()) return nullptr;
    constexpr std::array samples{0.25, 0.5, 0.75, 1.0};
    std::array<std::vector<ConditionValue>, samples.size()> values;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      values[i] = at(arc.at(samples[i]));
      if (const auto* broken = broken_at(values[i])) return broken;
    }
    for (std::size_t k = 0; k < here_.size(); ++k) {
      // The vertex of the parabola through three neighbours, where it lies between them.
      for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
        const double a = i == 0 ? here_[k].value : values[i - 1][k].value;
        const double b = values[i][k].value;
        const double c = values[i + 1][k].value;
        const double curvature = a - 2.0 * b + c;
        const double shift = 0.5 * (a - c) / curvature;
        if (curvature * b <= 0.0 || !(std::abs(shift) <= 1.0)) continue;
        if (const auto* broken = broken_at(at(arc.at(samples[i] + 0.25 * shift)))) return broken;
      }
    }
    return nullptr;
  }

  /// Whether a point near the one entered lies in the same part of the domain, and would where each
  /// of its coordinates, and so what rounding does to a condition, were some units off.
  bool has(const ArcPoint<N>& point) const {
    constexpr double some_units = 0x1p-48;
    if (broken_at(conditions_(point.x, point.p)) != nullptr) return false;
    for (int k = 0; k < 2 * N; ++k) {
      ReducedVector<N> step = ReducedVector<N>::Zero();
      step[k / 2] = k % 2 == 0 ? some_units : -some_units;
      if (broken_at(conditions_(moved<N>(point.x, step), point.p)) != nullptr) return false;
    }
    return true;
  }

  /// What is broken at a distance along a direction.
  const expression::TapeCondition* broken_along(const ArcVector<N>& direction,
                                                double distance) const {
    return watches() ? broken_at(at(distance * direction)) : nullptr;
  }

 private:
  std::vector<ConditionValue> at(const ArcVector<N>& y) const {
    return conditions_(moved<N>(x_, ReducedVector<N>(y.template head<N>())), p_ + scale_ * y[N]);
  }

  /// values: none where there is no such potential at all.
  const expression::TapeCondition* broken_at(const std::vector<ConditionValue>& values) const {
    for (std::size_t k = 0; k < here_.size(); ++k)
      if (k >= values.size() || !values[k].holds() ||
          (values[k].value < 0.0) != (here_[k].value < 0.0))
        return here_[k].condition;
    return nullptr;
  }

  Conditions conditions_;
  double scale_;
  ReducedVector<N> x_;
  double p_ = 0.0;
  std::vector<ConditionValue> here_;
  bool entered_ = false;
};

}  // namespace stationary
