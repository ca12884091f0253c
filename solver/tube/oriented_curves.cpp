#include "solver/tube/oriented_curves.hpp"

#include <memory>
#include <utility>

#include "solver/proof/oriented_boxes.hpp"
#include "solver/search/oriented_box.hpp"
#include "solver/tube/thickness_curves.hpp"

namespace stationary {
namespace {

template <class Layout>
class OrientedCurves final : public CurveEquations<Layout::dimension> {
 public:
  static constexpr int N = Layout::dimension;

  /// boxes: at nu_end. rho: where a held volume is to leave it.
  OrientedCurves(OrientedBoxSystem<Layout> boxes, const LogRange& rho)
      : boxes_(std::move(boxes)), rho_(rho) {}

  CurveLinearized<N> linearize(const CurveBox<N>& y) const override {
    const Box<N> x = coordinates(y);
    const auto b = boxes_.linearize(x, y[last] * boxes_.nu_squared);
    const Box<N> pull = by_q(x);
    CurveLinearized<N> out;
    for (std::size_t i = 0; i < std::size_t(N); ++i) {
      out.g[i] = b.g[i];
      for (std::size_t j = 0; j < std::size_t(N); ++j) out.slope[i][j] = b.slope[i][j];
      out.slope[i][last] = pull[i];
    }
    return out;
  }
  CurveForces<N> forces(const CurveBox<N>& y) const override {
    const Box<N> x = coordinates(y);
    return {boxes_.residual(x, y[last] * boxes_.nu_squared), by_q(x)};
  }
  std::vector<Interval> conditions(const CurveBox<N>& y) const override {
    if (Layout::thickness || !boxes_.model.body.volume) return {};
    const Interval log_rho = log(boxes_.at(coordinates(y)).q.rho);
    return {log_rho - rho_.lower, rho_.upper - log_rho};
  }
  bool excludes(const CurveBox<N>& y) const override {
    return boxes_.excludes(coordinates(y), y[last] * boxes_.nu_squared);
  }
  void place(const CurveCoordinates<N>& y, PlacedMotions& motions) const override {
    motions.has_slopes = false;
    Box<N> x;
    for (std::size_t i = 0; i < last; ++i) x[i] = exp(y[i].value);
    const BasicStretch<Interval> q = boxes_.stretch(x);
    motions.xi = q.xi;
    motions.zeta = q.zeta;
    if (Layout::alpha) motions.alpha = q.alpha;
    if (Layout::thickness || boxes_.model.body.volume) motions.rho = q.rho;
    if constexpr (Layout::axis) {
      const AxisAngle<Interval> axis = axis_angle(x[static_cast<std::size_t>(Layout::axis_place)]);
      motions.axis = {axis.cosine, axis.sine};
    }
  }

 private:
  static constexpr auto last = static_cast<std::size_t>(N);

  /// phi's own equation has no nu in it.
  Box<N> by_q(const Box<N>& x) const {
    const auto all = all_coordinates<Layout>(x, boxes_.rho);
    const auto at = oriented_stretch(all[0], all[1], all[2], all[3]);
    const AxisAngle<Interval> axis = axis_angle(all[4]);
    const auto pull =
        inertial_part(boxes_.J, Layout::thickness ? std::nullopt : boxes_.model.body.volume, at,
                      Layout::axis ? in_plane_products(boxes_.nu_squared, axis.cosine, axis.sine)
                                   : axis_products(boxes_.branch, boxes_.nu_squared),
                      static_cast<const AxisAngle<Interval>*>(nullptr));
    Box<N> out;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = pull[Layout::places[i]];
    return out;
  }
  static Box<N> coordinates(const CurveBox<N>& y) {
    Box<N> out;
    for (std::size_t i = 0; i < last; ++i) out[i] = exp(y[i]);
    return out;
  }

  OrientedBoxSystem<Layout> boxes_;
  LogRange rho_;
};

class OrientedFactors {
 public:
  OrientedFactors(const Body& body, const AnisotropicPotential& potential, Branch branch,
                  double from, double to, const SearchOptions& options)
      : body_(body),
        potential_(potential),
        branch_(branch),
        to_(to),
        options_(options),
        q_(curve_range(from, to)) {}

  template <bool alpha, bool axis>
  std::vector<CurveFactor> all() const {
    const auto model = potential_.model();
    using Separate = AnisotropicModel<double>::Separate;
    const auto* const parts = std::get_if<Separate>(&model.base);
    const bool separate = potential_.is_separable() && parts != nullptr && parts->thickness;
    if (!separate && !potential_.body().volume) return with<OrientedLayout<true, alpha, axis>>();
    auto out = with<OrientedLayout<false, alpha, axis>>();
    if (!potential_.body().volume) {
      const Branch about = axis ? Branch::i : branch_;
      auto thickness = std::make_unique<ThicknessCurves<AnyThickness<>>>(
          *parts->thickness, rates_at_end(body_, about, to_, options_.inputs), options_.inputs);
      out.emplace_back().sets.push_back(
          curve_set<1>(std::move(thickness), {log_range(options_.range(2))}, q_));
    }
    return out;
  }

 private:
  template <class Layout>
  std::vector<CurveFactor> with() const {
    constexpr int N = Layout::dimension;
    std::vector<CurveFactor> out;
    if constexpr (N <= 4) {
      std::vector<LogRange> ranges;
      for (const Interval& side : oriented_box<Layout>(options_)) ranges.push_back(log_range(side));
      OrientedBoxSystem<Layout> boxes(body_, potential_, branch_, to_, options_.inputs);
      boxes.nu_squared = square(Interval(to_));  // the end of the range is no input
      boxes.rho_range = options_.range(2);
      out.emplace_back().sets.push_back(curve_set<N>(
          std::make_unique<OrientedCurves<Layout>>(std::move(boxes), log_range(options_.range(2))),
          ranges, q_));
    }
    return out;
  }

  const Body& body_;
  const AnisotropicPotential& potential_;
  Branch branch_;
  double to_;
  const SearchOptions& options_;
  Interval q_;
};

}  // namespace

std::vector<CurveFactor> oriented_curves(const Body& body, const AnisotropicPotential& potential,
                                         Branch branch, bool oblique, double from, double to,
                                         const SearchOptions& options) {
  const OrientedFactors factors(body, potential, branch, from, to, options);
  if (oblique) return factors.all<true, true>();
  return branch == Branch::iii ? factors.all<true, false>() : factors.all<false, false>();
}

}  // namespace stationary
