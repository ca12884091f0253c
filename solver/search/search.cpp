#include "solver/search/search.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <type_traits>

#include "solver/proof/axis_boxes.hpp"
#include "solver/search/anisotropic_search.hpp"
#include "solver/search/model_terms.hpp"
#include "solver/search/round_search.hpp"
#include "solver/search/search_run.hpp"

namespace stationary {
namespace {

/// Of a model that is an expression with a normal form.
template <int D, class Model>
std::shared_ptr<const TermBounds<D>> term_bounds(const Model& model,
                                                 const std::array<Interval, D>& rates,
                                                 Inputs inputs) {
  const auto table = model_terms<D>(model, inputs);
  return table ? std::make_shared<const TermBounds<D>>(table, rates) : nullptr;
}

class AxisSearch {
 public:
  AxisSearch(const Problem& problem, double nu, const SearchOptions& options)
      : problem_(problem),
        nu_(nu),
        options_(options),
        rates_(problem.rates(two_product(nu, nu))),
        mirror_(mirror_symmetric(problem, nu) && alike(options.range(0), options.range(1))
                    ? Mirror::both
                    : Mirror::none),
        search_(problem.potential(), options) {}

  SearchResult run() {
    problem_.potential().visit_parts([this](const auto& model) { run_model(model); });
    return search_.finish(
        [](const Equilibrium& each) { return std::tuple(each.q.xi, each.q.zeta, each.q.rho); });
  }

 private:
  static bool alike(const Interval& a, const Interval& b) { return a.lo == b.lo && a.hi == b.hi; }

  template <class Plane, class Thickness>
  void run_model(const Separable<Plane, Thickness>& model) {
    BoxSystems<Separable<Plane, Thickness>> boxes(problem_, model, nu_, options_.inputs);
    const CentrifugalRates<Interval>& rates = boxes.plane.rates;
    boxes.thickness.terms = term_bounds<1>(model.thickness, {rates.rho}, options_.inputs);
    boxes.plane.terms = term_bounds<2>(model.plane, {rates.xi, rates.zeta}, options_.inputs);
    const auto axial = search_.prune(ThicknessSystem<Thickness>{model.thickness, rates_.rho},
                                     boxes.thickness, Mirror::none, 2);
    if (search_.ends_with(axial)) return;
    const PlanarSystem<Plane> system{model.plane, rates_};
    const auto planar = mirror_ == Mirror::both
                            ? in_parts(system, boxes.plane, {options_.range(0), options_.range(1)})
                            : search_.prune(system, boxes.plane, mirror_);
    search_.combine(
        planar, axial,
        [](const Box<2>& x) {
          return StretchBox{x[0], x[1], {}};
        },
        [this](const ProvenSolution<2>& each, const FoundThickness& rho) {
          add({0.0, each.x[0], each.x[1], rho.rho},
              std::max(each.proof.error_bound, rho.error_bound), each.proof.proven && rho.proven);
        });
  }

  template <class Coupled>
  void run_model(const Coupled& model) {
    BoxSystems<Coupled> boxes(problem_, model, nu_, options_.inputs);
    const CentrifugalRates<Interval>& rates = boxes.coupled.rates;
    boxes.coupled.terms = term_bounds<3>(model, {rates.xi, rates.zeta, rates.rho}, options_.inputs);
    // Gravity and elastic force nearly cancel over wide boxes.
    constexpr long patience = is_body_model<Coupled> ? 20 : 1;
    const Box<3> everything{options_.range(0), options_.range(1), options_.range(2)};
    const CoupledSystem<Coupled> system{model, rates_};
    const auto all = [&] {
      if constexpr (!is_body_model<Coupled>) {
        if (mirror_ == Mirror::both) return in_parts(system, boxes.coupled, everything);
      }
      return search_.prune(system, boxes.coupled, mirror_, everything, patience);
    };
    search_.each_of(
        all(),
        [](const Box<3>& x) {
          return StretchBox{x[0], x[1], x[2]};
        },
        [this](const ProvenSolution<3>& each) {
          add({0.0, each.x[0], each.x[1], each.x[2]}, each.proof.error_bound, each.proof.proven);
        });
  }

  /// Where J1 = J2, or nothing spins: that is a spin of a body with J1 = J2 too.
  template <class System, class Boxes>
  PruneResult<Boxes::dimension> in_parts(const System& system, const Boxes& boxes,
                                         const Box<Boxes::dimension>& everything) {
    constexpr int N = Boxes::dimension;
    const double J = problem_.body().J1;
    const auto invariants = invariant_system<N>(system.model, J, {nu_, 0.0});
    const EllipseBoxSystem<std::decay_t<decltype(boxes.model)>, N> ellipses{
        boxes.model, as_input(J, options_.inputs), {as_input(nu_, options_.inputs), Interval(0.0)}};
    return search_.prune(RoundSearch(system, boxes, invariants, ellipses, mirror_, everything));
  }

  void add(const Stretch& q, double error_bound, bool proven) {
    Equilibrium found = equilibrium_of_search(q, error_bound, proven);
    found.nu = angular_velocity(problem_.branch(), nu_);
    recompute_residual(problem_.body(), problem_.potential(), found);
    search_.add(found, proven);
  }

  const Problem& problem_;
  double nu_;
  const SearchOptions& options_;
  CentrifugalRates<DoubleDouble> rates_;
  Mirror mirror_;
  SearchRun search_;
};

}  // namespace

SearchResult search(const Problem& problem, double nu, const SearchOptions& options) {
  if (!std::isfinite(nu)) throw std::invalid_argument("nu finite");
  if (!problem.potential().is_isotropic()) return search_anisotropic(problem, nu, options);
  SearchResult out = AxisSearch(problem, nu, options).run();
  if (problem.branch() == Branch::iii && problem.potential().may_shear())
    out.message += ", of alpha = 0";
  return out;
}

}  // namespace stationary
