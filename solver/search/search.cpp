#include "solver/search/search.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "solver/proof/axis_boxes.hpp"
#include "solver/search/anisotropic_search.hpp"
#include "solver/search/branch_and_prune.hpp"
#include "solver/search/search_message.hpp"

namespace stationary {
namespace {

/// Of a model that is an expression with a normal form.
template <int D, class Model>
std::shared_ptr<const TermBounds<D>> term_bounds(const Model& model,
                                                 const std::array<Interval, D>& rates,
                                                 Inputs inputs) {
  if constexpr (requires { model.is_expression(); }) {
    return model.visit([&](const auto& own) { return term_bounds<D>(own, rates, inputs); });
  } else if constexpr (requires { model.tape(); }) {
    constexpr std::array coordinates{0, 1, 2};
    std::vector<Interval> parameters;
    for (const double c : model.coefficients()) parameters.push_back(as_input(c, inputs));
    const auto table = expression::term_table(
        *model.tape()->source,
        D == 1 ? std::span(coordinates).last(1) : std::span(coordinates).first(std::size_t(D)),
        parameters);
    return table ? std::make_shared<const TermBounds<D>>(table, rates) : nullptr;
  } else {
    return nullptr;
  }
}

class Search {
 public:
  Search(const Problem& problem, double nu, const SearchOptions& options)
      : problem_(problem),
        nu_(nu),
        options_(options),
        rates_(problem.rates(two_product(nu, nu))),
        mirror_(mirror_symmetric(problem, nu) && alike(options.range(0), options.range(1))
                    ? Mirror::both
                    : Mirror::none) {}

  SearchResult run() {
    problem_.potential().visit_parts([this](const auto& model) { run_model(model); });
    for (auto* list : {&out_.solutions, &out_.unproven})
      std::ranges::sort(*list, {}, [](const Equilibrium& each) {
        return std::tuple(each.q.xi, each.q.zeta, each.q.rho);
      });
    if (out_.status != SearchStatus::interrupted) {
      out_.status = out_.undecided.empty() ? SearchStatus::complete : SearchStatus::undecided;
    }
    out_.message = search_message(options_, out_.status, out_.solutions.size(), out_.undecided) +
                   unproven_text(out_.unproven.size());
    return std::move(out_);
  }

 private:
  static bool alike(const Interval& a, const Interval& b) { return a.lo == b.lo && a.hi == b.hi; }

  /// first: the stretch that is the system's first unknown.
  template <class System, class BoxSystem>
  PruneResult<BoxSystem::dimension> prune(const System& system, const BoxSystem& boxes,
                                          std::size_t first = 0) {
    const PruneOptions options{
        .min_width = options_.min_width, .max_boxes = options_.max_boxes, .stop = options_.stop};
    Box<BoxSystem::dimension> everything;
    for (std::size_t k = 0; k < everything.size(); ++k) everything[k] = options_.range(first + k);
    auto found = BranchAndPrune<System, BoxSystem>(system, boxes, mirror_, options).run(everything);
    out_.boxes += found.boxes;
    if (found.interrupted) out_.status = SearchStatus::interrupted;
    return found;
  }

  template <class Plane, class Thickness>
  void run_model(const Separable<Plane, Thickness>& model) {
    BoxSystems<Separable<Plane, Thickness>> boxes(problem_, model, nu_, options_.inputs);
    const CentrifugalRates<Interval>& rates = boxes.plane.rates;
    boxes.thickness.terms = term_bounds<1>(model.thickness, {rates.rho}, options_.inputs);
    boxes.plane.terms = term_bounds<2>(model.plane, {rates.xi, rates.zeta}, options_.inputs);
    const auto axial =
        prune(ThicknessSystem<Thickness>{model.thickness, rates_.rho}, boxes.thickness, 2);
    if (out_.status == SearchStatus::interrupted) return;
    // No thickness, no ellipsoid: whatever the plane does.
    if (axial.solutions.empty() && axial.undecided.empty()) return;
    const auto planar = prune(PlanarSystem<Plane>{model.plane, rates_}, boxes.plane);
    for (const auto* planes : {&planar.solutions, &planar.unproven})
      for (const auto& plane : *planes)
        for (const auto* thicknesses : {&axial.solutions, &axial.unproven})
          for (const auto& rho : *thicknesses)
            add({0.0, plane.x[0], plane.x[1], rho.x[0]},
                std::max(plane.proof.error_bound, rho.proof.error_bound),
                plane.proof.proven && rho.proof.proven);
    for (const auto& plane : planar.solutions) {
      for (const auto& rho : axial.undecided)
        out_.undecided.push_back({plane.proof.solution[0], plane.proof.solution[1], rho[0]});
    }
    for (const auto& plane : planar.undecided) {
      for (const auto& rho : axial.solutions)
        out_.undecided.push_back({plane[0], plane[1], rho.proof.solution[0]});
      for (const auto& rho : axial.undecided)
        out_.undecided.push_back({plane[0], plane[1], rho[0]});
    }
  }

  template <class Coupled>
  void run_model(const Coupled& model) {
    BoxSystems<Coupled> boxes(problem_, model, nu_, options_.inputs);
    const CentrifugalRates<Interval>& rates = boxes.coupled.rates;
    boxes.coupled.terms = term_bounds<3>(model, {rates.xi, rates.zeta, rates.rho}, options_.inputs);
    const auto found = prune(CoupledSystem<Coupled>{model, rates_}, boxes.coupled);
    for (const auto* list : {&found.solutions, &found.unproven})
      for (const auto& each : *list)
        add({0.0, each.x[0], each.x[1], each.x[2]}, each.proof.error_bound, each.proof.proven);
    for (const auto& box : found.undecided) out_.undecided.push_back({box[0], box[1], box[2]});
  }

  void add(const Stretch& q, double error_bound, bool proven) {
    Equilibrium found;
    found.status = SolveStatus::solved;
    found.message = found_by_search(proven);
    found.q = q;
    found.nu = angular_velocity(problem_.branch(), nu_);
    found.error_bound = error_bound;
    const BalanceCheck check =
        check_balance(problem_.body(), problem_.potential(), found.q, found.nu);
    found.residual = check.residual;
    found.compatibility = check.compatibility;
    if (proven) {
      out_.solutions.push_back(found);
    } else if (found.residual <= acceptable_residual) {
      out_.unproven.push_back(found);
    }
  }

  const Problem& problem_;
  double nu_;
  const SearchOptions& options_;
  CentrifugalRates<DoubleDouble> rates_;
  Mirror mirror_;
  SearchResult out_;
};

}  // namespace

SearchResult search(const Problem& problem, double nu, const SearchOptions& options) {
  if (!std::isfinite(nu)) throw std::invalid_argument("nu finite");
  if (!problem.potential().is_isotropic()) return search_anisotropic(problem, nu, options);
  require_box(options);
  return Search(problem, nu, options).run();
}

}  // namespace stationary
