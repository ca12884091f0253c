#include "solver/tube/axis_curves.hpp"

#include "solver/tube/circle_curves.hpp"
#include "solver/tube/curve_terms.hpp"
#include "solver/tube/held_curves.hpp"
#include "solver/tube/thickness_curves.hpp"

namespace stationary {
namespace {

template <class Plane>
class PlaneCurves final : public CurveEquations<2> {
 public:
  PlaneCurves(const Plane& model, const CentrifugalRates<Interval>& rates, Inputs inputs)
      : model_(interval_model(model, inputs)),
        rates_(rates),
        terms_(model_terms<2>(model, inputs)) {}

  CurveLinearized<2> linearize(const CurveBox<2>& y) const override {
    const Interval xi = exp(y[0]);
    const Interval zeta = exp(y[1]);
    const auto b = model_.log_balance(xi, zeta, y[2] * rates_.xi, y[2] * rates_.zeta);
    CurveLinearized<2> out;
    out.g = {b.g_xi, b.g_zeta};
    out.slope[0] = {b.uu, b.uv, -(rates_.xi * square(xi))};
    out.slope[1] = {b.uv, b.vv, -(rates_.zeta * square(zeta))};
    return out;
  }
  bool excludes(const CurveBox<2>& y) const override {
    return defined_nowhere(model_, exp(y[0]), exp(y[1]));
  }
  bool contract(CurveBox<2>& y) const override {
    std::array<Interval, 2> x{y[0], y[1]};
    const bool left = terms_.contract({y[2] * rates_.xi, y[2] * rates_.zeta}, x);
    y = {x[0], x[1], y[2]};
    return left;
  }
  void place(const CurveCoordinates<2>& y, PlacedMotions& motions) const override {
    motions.xi = exp(y[0]);
    motions.zeta = exp(y[1]);
  }

 private:
  decltype(interval_model(std::declval<Plane>(), Inputs())) model_;
  CentrifugalRates<Interval> rates_;
  CurveTerms<2> terms_;
};

template <class Coupled>
class CoupledCurves final : public CurveEquations<3> {
 public:
  CoupledCurves(const Coupled& model, const CentrifugalRates<Interval>& rates, Inputs inputs)
      : model_(interval_model(model, inputs)),
        rates_(rates),
        terms_(model_terms<3>(model, inputs)) {}

  CurveLinearized<3> linearize(const CurveBox<3>& y) const override {
    const auto [b, by_q] = at<2>(y);
    return {
        {b.g_xi, b.g_zeta, b.g_rho},
        {{{b.uu, b.uv, b.uw, by_q[0]}, {b.uv, b.vv, b.vw, by_q[1]}, {b.uw, b.vw, b.ww, by_q[2]}}}};
  }
  CurveForces<3> forces(const CurveBox<3>& y) const override {
    const auto [b, by_q] = at<1>(y);
    return {{b.g_xi, b.g_zeta, b.g_rho}, by_q};
  }
  bool excludes(const CurveBox<3>& y) const override {
    return defined_nowhere(model_, exp(y[0]), exp(y[1]), exp(y[2]));
  }
  bool contract(CurveBox<3>& y) const override {
    std::array<Interval, 3> x{y[0], y[1], y[2]};
    const bool left = terms_.contract({y[3] * rates_.xi, y[3] * rates_.zeta, y[3] * rates_.rho}, x);
    y = {x[0], x[1], x[2], y[3]};
    return left;
  }
  void place(const CurveCoordinates<3>& y, PlacedMotions& motions) const override {
    motions.xi = exp(y[0]);
    motions.zeta = exp(y[1]);
    motions.rho = exp(y[2]);
  }

 private:
  struct Balance {
    LogBalance<Interval> rows;
    Box<3> by_q;
  };
  template <int order>
  Balance at(const CurveBox<3>& y) const {
    const Interval xi = exp(y[0]);
    const Interval zeta = exp(y[1]);
    const Interval rho = exp(y[2]);
    return {
        balance_of<order>(model_, xi, zeta, rho, y[3] * rates_.xi, y[3] * rates_.zeta,
                          y[3] * rates_.rho),
        {-(rates_.xi * square(xi)), -(rates_.zeta * square(zeta)), -(rates_.rho * square(rho))}};
  }

  decltype(interval_model(std::declval<Coupled>(), Inputs())) model_;
  CentrifugalRates<Interval> rates_;
  CurveTerms<3> terms_;
};

class AxisCurves {
 public:
  AxisCurves(const Problem& problem, double from, double to, const SearchOptions& options)
      : problem_(problem),
        rates_(rates_at_end(problem.body(), problem.branch(), to, options.inputs)),
        q_(curve_range(from, to)),
        inputs_(options.inputs),
        round_(problem.branch() == Branch::iii && problem.body().symmetric()) {
    for (std::size_t k = 0; k < 3; ++k) stretch_[k] = log_range(options.range(k));
  }

  std::vector<CurveFactor> all() {
    problem_.potential().visit_parts([this](const auto& model) { add(model); });
    return std::move(out_);
  }

 private:
  template <class Plane, class Thickness>
  void add(const Separable<Plane, Thickness>& model) {
    factor(set<1>(std::make_unique<ThicknessCurves<Thickness>>(model.thickness, rates_, inputs_),
                  {stretch_[2]}));
    if (round_) {
      factor(circles_and_ellipses<1>(model.plane, {}));
    } else {
      factor(set<2>(std::make_unique<PlaneCurves<Plane>>(model.plane, rates_, inputs_),
                    {stretch_[0], stretch_[1]}));
    }
  }
  template <class Coupled>
  void add(const Coupled& model) {
    if constexpr (is_body_model<Coupled>) {
      if (model.volume) return add_held({model});
    }
    if (round_) {
      factor(circles_and_ellipses<2>(model, {stretch_[2]}));
    } else {
      factor(set<3>(std::make_unique<CoupledCurves<Coupled>>(model, rates_, inputs_),
                    {stretch_[0], stretch_[1], stretch_[2]}));
    }
  }

  void add_held(const HeldPlane<>& model) {
    const HeldThickness thickness{log(as_input(*model.body.volume, inputs_)), stretch_[2]};
    if (round_) {
      factor(circles_and_ellipses<1>(model, {}, thickness));
    } else {
      factor(set<2>(std::make_unique<HeldCurves>(model, rates_, thickness, inputs_),
                    {stretch_[0], stretch_[1]}));
    }
  }

  /// N unknowns of a circle, one more of an ellipse; thickness: the last, where it is one. Of an
  /// ellipse and the same turned by a right angle that with xi > zeta; where the box is not the same in the
  /// two, those of which either lies in it.
  template <int N, class Model>
  std::vector<AnyCurveSet> circles_and_ellipses(const Model& model,
                                                const std::vector<LogRange>& thickness,
                                                const HeldThickness& held = {}) const {
    const LogRange& xi = stretch_[0];
    const LogRange& zeta = stretch_[1];
    std::vector<AnyCurveSet> out;
    const auto with_thickness = [&](std::vector<LogRange> plane) {
      plane.insert(plane.end(), thickness.begin(), thickness.end());
      return plane;
    };
    const LogRange circle = overlap(xi, zeta);
    if (circle.lower.lo < circle.upper.hi)
      out.push_back(set<N>(std::make_unique<CircleCurves<Model, N>>(model, rates_, held, inputs_),
                           with_thickness({circle})));
    const auto add_ellipses = [&](const LogRange& longer, const LogRange& shorter) {
      const LogRange half{Interval(0.0), 0.5 * (longer.upper - shorter.lower)};
      if (!(half.upper.hi > 0.0)) return;
      const LogRange mean{0.5 * (longer.lower + shorter.lower),
                          0.5 * (longer.upper + shorter.upper)};
      auto ellipses = std::make_unique<EllipseCurves<Model, N + 1>>(model, rates_, longer, shorter,
                                                                    held, inputs_);
      out.push_back(set<N + 1>(std::move(ellipses), with_thickness({mean, half})));
      std::get<CurveSet<N + 1>>(out.back()).region.mirror = 1;
    };
    add_ellipses(xi, zeta);
    if (!same(xi, zeta)) add_ellipses(zeta, xi);
    return out;
  }
  static bool same(const LogRange& a, const LogRange& b) {
    return a.lower.lo == b.lower.lo && a.upper.hi == b.upper.hi;
  }
  static LogRange overlap(const LogRange& a, const LogRange& b) {
    return {a.lower.lo > b.lower.lo ? a.lower : b.lower,
            a.upper.hi < b.upper.hi ? a.upper : b.upper};
  }

  template <int N>
  AnyCurveSet set(std::unique_ptr<CurveEquations<N>> equations,
                  const std::vector<LogRange>& ranges) const {
    return curve_set<N>(std::move(equations), ranges, q_);
  }
  void factor(AnyCurveSet only) { out_.emplace_back().sets.push_back(std::move(only)); }
  void factor(std::vector<AnyCurveSet> sets) { out_.push_back({std::move(sets)}); }

  const Problem& problem_;
  CentrifugalRates<Interval> rates_;
  Interval q_;
  Inputs inputs_;
  bool round_;  ///< circles and ellipses
  std::array<LogRange, 3> stretch_;
  std::vector<CurveFactor> out_;
};

}  // namespace

LogRange log_range(const Interval& stretch) {
  return {log(Interval(stretch.lo)), log(Interval(stretch.hi))};
}

Interval curve_range(double from, double to) {
  const Interval lowest = square(Interval(from) / Interval(to));
  return {lowest.lo, 1.0};
}

std::vector<CurveFactor> axis_curves(const Problem& problem, double from, double to,
                                     const SearchOptions& options) {
  return AxisCurves(problem, from, to, options).all();
}

}  // namespace stationary
