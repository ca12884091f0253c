#include <algorithm>
#include <memory>
#include <utility>

#include "solver/proof/tilted_enclosure.hpp"
#include "solver/search/tilted_search.hpp"
#include "solver/tube/axis_curves.hpp"

namespace stationary {
namespace {

/// In (ln xi, ln zeta), rho tied to the stretch along the plane's own axis. What q takes from the row of
/// that axis may be taken from its own part or from rho's, J1 xi^2 being J3 rho^2: from each as much as
/// nu^2 has along axis 3 and along its own where the place's middle is a motion, both parts are near 0
/// by themselves. On its way to an escape a curve has nearly one q, and terms as large as rho^2 cancel.
template <class System>
class TiltedCurves final : public CurveEquations<2> {
 public:
  /// system: at nu_end.
  template <class Model>
  TiltedCurves(System system, const Model& model, const LogRange& rho, Inputs inputs)
      : system_(std::move(system)), rho_(rho), terms_(model, inputs) {}

  CurveLinearized<2> linearize(const CurveBox<2>& y) const override {
    const Box<2> x = stretches(y);
    const Interval rho = system_.thickness(x);
    const CentrifugalRates<Interval> end = holds_volume() ? system_.rates : shared_rates(y);
    const CentrifugalRates<Interval> here{y[2] * end.xi, y[2] * end.zeta, y[2] * end.rho};
    const auto b = tilted_balance(system_.model, system_.plane, x[0], x[1], rho, here);
    const auto pull = tilted_pull(system_.model, system_.plane, x[0], x[1], rho, end);
    const Interval of_rho = end.rho * square(rho);
    const bool first = system_.plane == TiltPlane::one_three;
    return {{b.g_xi, b.g_zeta},
            {{{b.uu, b.uv, -(first ? pull[0] + of_rho : pull[0])},
              {b.uv, b.vv, -(first ? pull[1] : pull[1] + of_rho)}}}};
  }
  /// That nu is tilted at a solution; rho's own sides of the box.
  std::vector<Interval> conditions(const CurveBox<2>& y) const override {
    System here = system_;
    here.square_nu = y[2] * system_.square_nu;
    const Box<2> x = stretches(y);
    const TiltSquares<Interval> squares = here.squares(x);
    const Interval log_rho = log(system_.thickness(x));
    return {squares.in_plane, squares.normal, log_rho - rho_.lower, rho_.upper - log_rho};
  }
  std::size_t ends() const override { return 2; }
  bool contract(CurveBox<2>& y) const override {
    if (!terms_.any()) return true;
    System here = system_;
    here.square_nu = y[2] * system_.square_nu;
    Box<2> x = stretches(y);
    if (!narrow_tilted(here, terms_, x)) return false;
    for (std::size_t k = 0; k < 2; ++k) {
      const Interval narrowed = log(x[k]);
      if (narrowed.bounded() && !narrowed.apart_from(y[k])) y[k] = common(y[k], narrowed);
    }
    return true;
  }
  bool excludes(const CurveBox<2>& y) const override {
    const Box<2> x = stretches(y);
    return defined_nowhere(system_.model, x[0], x[1], system_.thickness(x));
  }
  void place(const CurveCoordinates<2>& y, PlacedMotions& motions) const override {
    motions.xi = exp(y[0]);
    motions.zeta = exp(y[1]);
    motions.rho = tilted_thickness(system_.J, system_.plane, motions.xi, motions.zeta);
  }

 private:
  bool holds_volume() const {
    if constexpr (may_hold_volume<decltype(System::model)>) return system_.model.volume.has_value();
    return false;
  }
  /// At nu_end, with rho's share.
  CentrifugalRates<Interval> shared_rates(const CurveBox<2>& y) const {
    const Box<2> middle{exp(Interval(y[0].mid())), exp(Interval(y[1].mid()))};
    const double along = system_.squares(middle).in_plane.mid();
    const double all = y[2].mid() * system_.square_nu.mid();
    const Interval share(along > 0.0 ? std::min(along / all, 1.0) : 0.0);
    CentrifugalRates<Interval> out = system_.rates;
    out.rho = share * system_.J.J3 * system_.square_nu;
    Interval& own = system_.plane == TiltPlane::one_three ? out.xi : out.zeta;
    own *= Interval(1.0) - share;
    return out;
  }
  static Box<2> stretches(const CurveBox<2>& y) { return {exp(y[0]), exp(y[1])}; }

  System system_;
  LogRange rho_;
  StretchTerms terms_;
};

}  // namespace

std::vector<CurveFactor> tilted_curves(const Body& body, const Potential& potential,
                                       TiltPlane plane, double from, double to,
                                       const SearchOptions& options) {
  const std::vector<LogRange> ranges{log_range(options.range(0)), log_range(options.range(1))};
  std::vector<CurveFactor> out(1);
  potential.visit_parts([&](const auto& model) {
    auto system = tilted_box_system(body, model, plane, to, options.inputs);
    system.square_nu = square(Interval(to));  // the end of the range is no input
    system.rates = axis_rates(system.J, Branch::iii, system.square_nu);
    auto curves = std::make_unique<TiltedCurves<decltype(system)>>(
        std::move(system), model, log_range(options.range(2)), options.inputs);
    out[0].sets.push_back(curve_set<2>(std::move(curves), ranges, curve_range(from, to)));
  });
  return out;
}

}  // namespace stationary
