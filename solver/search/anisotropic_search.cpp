#include "solver/search/anisotropic_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "solver/proof/oriented_boxes.hpp"
#include "solver/search/branch_and_prune.hpp"
#include "solver/search/search_message.hpp"

namespace stationary {
namespace {

/// More unknowns than the others' have, and coordinates that are not the balance's own: two million
/// boxes, ten seconds, where a valley of V is nearly as steep as the centrifugal force.
constexpr long box_factor = 200;

template <class Layout>
class OrientedSearch {
 public:
  static constexpr int N = Layout::dimension;
  using Found = ProvenSolution<N>;

  OrientedSearch(const Body& body, const Potential& potential, Branch branch, double nu,
                 const SearchOptions& options)
      : body_(body),
        potential_(potential),
        models_(potential.anisotropic()),
        branch_(branch),
        options_(options),
        system_{&models_, body, branch, nu},
        boxes_(body, models_.potential, branch, nu, options.inputs) {}

  SearchResult run() {
    if constexpr (Layout::thickness) {
      run_plane(nullptr);
    } else {
      const auto& parts =
          std::get<AnisotropicModel<double>::Separate>(models_.potential.model().base);
      run_thickness(parts.thickness);
    }
    for (auto* list : {&out_.solutions, &out_.unproven})
      std::ranges::sort(*list, {}, [](const Equilibrium& each) {
        return std::tuple(each.q.xi, each.q.zeta, each.q.rho, each.q.alpha, each.nu[1]);
      });
    if (out_.status != SearchStatus::interrupted)
      out_.status = out_.undecided.empty() ? SearchStatus::complete : SearchStatus::undecided;
    out_.message = search_message(options_, out_.status, out_.solutions.size(), out_.undecided) +
                   unproven_text(out_.unproven.size());
    if (nearest_ < std::numeric_limits<double>::infinity()) {
      std::ostringstream text;
      text.precision(2);
      text << "; alpha = 0, which compatibility asks for about this axis, leaves a force V_alpha: "
              "the nearest residual is "
           << std::scientific << nearest_ << " of the largest term";
      out_.message += text.str();
    }
    return std::move(out_);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  template <class System, class BoxSystem>
  PruneResult<BoxSystem::dimension> prune(const System& system, const BoxSystem& boxes,
                                          const Box<BoxSystem::dimension>& everything,
                                          long max_boxes) {
    const PruneOptions how{
        .min_width = options_.min_width, .max_boxes = max_boxes, .stop = options_.stop};
    auto found =
        BranchAndPrune<System, BoxSystem>(system, boxes, Mirror::none, how).run(everything);
    out_.boxes += found.boxes;
    if (found.interrupted) out_.status = SearchStatus::interrupted;
    return found;
  }

  void run_thickness(const AnyThickness<>& model) {
    const Branch about = Layout::axis ? Branch::i : branch_;
    const auto extended = axis_rates(body_, about, two_product(system_.nu, system_.nu)).rho;
    const Interval rate = about == Branch::iii ? Interval(0.0) : boxes_.J.J3 * boxes_.nu_squared;
    const auto interval =
        with_coefficients(model, [this](double c) { return as_input(c, options_.inputs); });
    const auto axial = prune(ThicknessSystem<AnyThickness<>>{model, extended},
                             ThicknessBoxSystem<AnyThickness<Interval>>{interval, rate},
                             Box<1>{options_.range(2)}, options_.max_boxes);
    if (out_.status == SearchStatus::interrupted) return;
    // No thickness, no ellipsoid: whatever the plane does.
    if (axial.solutions.empty() && axial.undecided.empty()) return;
    run_plane(&axial);
  }

  void run_plane(const PruneResult<1>* axial) {
    const auto plane = prune(system_, boxes_, everything(), box_factor * options_.max_boxes);
    // One axis is found twice where it is at both ends of the half turn searched.
    std::vector<Found> kept;
    for (const auto* list : {&plane.solutions, &plane.unproven})
      for (const Found& each : *list)
        if (!on_material_axis(each) && !again(each, kept)) kept.push_back(each);
    for (const Found& each : kept) with_thickness(each, axial);
    for (const Box<N>& box : plane.undecided) {
      StretchBox at = stretch_box(box);
      if (axial == nullptr) {
        out_.undecided.push_back(at);
        continue;
      }
      for (const auto& rho : axial->solutions) {
        at.rho = rho.proof.solution[0];
        out_.undecided.push_back(at);
      }
      for (const Box<1>& rho : axial->undecided) {
        at.rho = rho[0];
        out_.undecided.push_back(at);
      }
    }
  }

  Box<N> everything() const {
    Box<N> out;
    out[0] = options_.range(0);
    out[1] = options_.range(1);
    if constexpr (Layout::thickness) out[index(Layout::thickness_place)] = options_.range(2);
    if constexpr (Layout::alpha) {
      const double most = std::sqrt(options_.max_stretch / options_.min_stretch);
      out[index(Layout::alpha_place)] = {1.0 / most, most};
    }
    // Half a turn, whose ends are no material axis.
    if constexpr (Layout::axis)
      out[index(Layout::axis_place)] = {axis_coordinate(-0.25 * std::numbers::pi) * (1.0 - 1e-12),
                                        axis_coordinate(0.75 * std::numbers::pi) * (1.0 + 1e-12)};
    return out;
  }

  StretchBox stretch_box(const Box<N>& box) const {
    const auto q = boxes_.stretch(box);
    return {q.xi, q.zeta, q.rho, q.alpha};
  }

  /// By an even V: a solution whose mirror image it must be itself.
  bool own_mirror(const Found& each, bool about_second) const {
    if (!models_.potential.even_in_alpha()) return false;
    Box<N> image = each.proof.solution;
    if constexpr (Layout::alpha) {
      Interval& a = image[index(Layout::alpha_place)];
      a = Interval(1.0) / a;
    }
    if constexpr (Layout::axis) {
      // phi -> -phi, or pi - phi: sin of half of it becomes the cosine.
      Interval& x = image[index(Layout::axis_place)];
      if (about_second) {
        const Hyperbolic<Interval> half = hyperbolic(x);
        x = sqrt((Interval(1.0) + half.sech) / (Interval(1.0) - half.sech));
      } else {
        x = Interval(1.0) / x;
      }
    }
    for (int i = 0; i < N; ++i)
      if (!image[index(i)].within(each.proof.unique[index(i)])) return false;
    return true;
  }
  bool on_material_axis(const Found& each) const {
    return Layout::axis && (own_mirror(each, false) || own_mirror(each, true));
  }

  bool again(const Found& each, const std::vector<Found>& kept) const {
    if constexpr (!Layout::axis) {
      return false;
    } else {
      return std::ranges::any_of(kept, [&](const Found& other) {
        for (int i = 0; i < Layout::axis_place; ++i)
          if (each.proof.solution[index(i)].apart_from(other.proof.solution[index(i)]))
            return false;
        const AxisAngle<double> a = axis_angle(each.x[Layout::axis_place]);
        const AxisAngle<double> b = axis_angle(other.x[Layout::axis_place]);
        return std::abs(a.cosine * b.sine - a.sine * b.cosine) < 1e-11;
      });
    }
  }

  void with_thickness(const Found& each, const PruneResult<1>* axial) {
    if (axial == nullptr) {
      if constexpr (Layout::thickness)
        add(each, each.x[Layout::thickness_place], each.proof.solution[Layout::thickness_place],
            0.0, true);
      return;
    }
    for (const auto* thicknesses : {&axial->solutions, &axial->unproven})
      for (const auto& rho : *thicknesses)
        add(each, rho.x[0], rho.proof.solution[0], rho.proof.error_bound, rho.proof.proven);
    if (!each.proof.proven) return;
    for (const Box<1>& rho : axial->undecided) {
      StretchBox at = stretch_box(each.proof.solution);
      at.rho = rho[0];
      out_.undecided.push_back(at);
    }
  }

  void add(const Found& each, double rho, const Interval& proven_rho, double rho_bound,
           bool proven_thickness) {
    const bool proven = each.proof.proven && proven_thickness;
    constexpr double factor = Layout::axis ? 2.0 : Layout::alpha ? 1.25 : 1.0;
    auto y = all_coordinates<Layout>(each.x, rho);
    y[oriented::w] = rho;
    if (Layout::alpha && !Layout::axis && own_mirror(each, false)) y[oriented::a] = 1.0;
    Equilibrium found;
    found.status = SolveStatus::solved;
    found.message = found_by_search(proven);
    found.q = oriented_stretch(y[0], y[1], y[2], y[3]).q;
    found.error_bound = std::max(factor * each.proof.error_bound, rho_bound);
    found.nu = angular_velocity(branch_, system_.nu);
    if constexpr (Layout::axis) {
      const AxisAngle<double> axis = axis_angle(y[4]);
      found.nu = {system_.nu * axis.cosine, system_.nu * axis.sine, 0.0};
    }
    const BalanceCheck check = check_balance(body_, potential_, found.q, found.nu);
    found.residual = check.residual;
    found.compatibility = check.compatibility;
    if (!Layout::alpha && !models_.potential.shear_free()) {
      nearest_ = std::min(nearest_, check.residual);
      if (!proven || !boxes_.shear_force(each.proof.solution).may_be(0.0)) return;
      StretchBox at = stretch_box(each.proof.solution);
      at.rho = proven_rho;
      out_.undecided.push_back(at);
      return;
    }
    if (proven) {
      out_.solutions.push_back(found);
    } else if (found.residual <= acceptable_residual) {
      out_.unproven.push_back(found);
    }
  }

  const Body& body_;
  const Potential& potential_;
  OrientedModels models_;
  Branch branch_;
  const SearchOptions& options_;
  OrientedSystem<Layout> system_;
  OrientedBoxSystem<Layout> boxes_;
  double nearest_ = std::numeric_limits<double>::infinity();  ///< residual of what is no motion
  SearchResult out_;
};

template <bool alpha, bool axis>
SearchResult run(const Body& body, const Potential& potential, Branch branch, double nu,
                 const SearchOptions& options) {
  if (potential.is_separable())
    return OrientedSearch<OrientedLayout<false, alpha, axis>>(body, potential, branch, nu, options)
        .run();
  return OrientedSearch<OrientedLayout<true, alpha, axis>>(body, potential, branch, nu, options)
      .run();
}

}  // namespace

SearchResult search_anisotropic(const Problem& problem, double nu, const SearchOptions& options) {
  require_box(options);
  const Branch branch = problem.branch();
  // At rest no axis is asked for.
  if (branch == Branch::iii || nu == 0.0)
    return run<true, false>(problem.body(), problem.potential(), Branch::iii, nu, options);
  return run<false, false>(problem.body(), problem.potential(), branch, nu, options);
}

SearchResult search_oblique(const Body& body, const Potential& potential,
                            const ObliqueRotation& motion, const SearchOptions& options) {
  if (potential.is_isotropic())
    throw std::invalid_argument("an anisotropic potential, for an oblique axis");
  if (!(motion.nu > 0.0 && std::isfinite(motion.nu)))
    throw std::invalid_argument("|nu| finite and > 0");
  require_box(options);
  return run<true, true>(body, potential, Branch::i, motion.nu, options);
}

}  // namespace stationary
