#include "solver/search/anisotropic_search.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <tuple>

#include "solver/proof/oriented_boxes.hpp"
#include "solver/search/oriented_box.hpp"
#include "solver/search/search_run.hpp"

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
        boxes_(body, models_.potential, branch, nu, options.inputs),
        search_(potential, options) {
    boxes_.rho_range = options.range(2);
  }

  SearchResult run() {
    if constexpr (Layout::thickness) {
      search_.each_of(
          plane(), [this](const Box<N>& box) { return stretch_box(box); },
          [this](const Found& each) {
            constexpr auto place = Layout::thickness_place;
            add(each, {each.x[place], each.proof.solution[index(place)], 0.0, true});
          });
    } else if (const auto& volume = boxes_.model.body.volume) {
      search_.each_of(
          plane(), [this](const Box<N>& box) { return stretch_box(box); },
          [&](const Found& each) { add(each, thickness_at(each, *volume)); });
    } else {
      run_separate();
    }
    SearchResult out = search_.finish([](const Equilibrium& each) {
      return std::tuple(each.q.xi, each.q.zeta, each.q.rho, each.q.alpha, each.nu[1]);
    });
    if (nearest_ < std::numeric_limits<double>::infinity()) {
      std::ostringstream text;
      text.precision(2);
      text << "; alpha = 0, which compatibility asks for about this axis, leaves a force V_alpha: "
              "the nearest residual is "
           << std::scientific << nearest_ << " of the largest term";
      out.message += text.str();
    }
    return out;
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  /// The thickness is a problem of its own.
  void run_separate() {
    const auto& model =
        *std::get<AnisotropicModel<double>::Separate>(models_.potential.model().base).thickness;
    const Branch about = Layout::axis ? Branch::i : branch_;
    const auto extended = axis_rates(body_, about, two_product(system_.nu, system_.nu)).rho;
    const Interval rate = about == Branch::iii ? Interval(0.0) : boxes_.J.J3 * boxes_.nu_squared;
    const auto interval =
        with_coefficients(model, [this](double c) { return as_input(c, options_.inputs); });
    const auto axial =
        search_.prune(ThicknessSystem<AnyThickness<>>{model, extended},
                      ThicknessBoxSystem<AnyThickness<Interval>>{interval, rate}, Mirror::none, 2);
    if (search_.ends_with(axial)) return;
    search_.combine(
        plane(), axial, [this](const Box<N>& box) { return stretch_box(box); },
        [this](const Found& each, const FoundThickness& rho) { add(each, rho); });
  }

  /// What the held volume leaves.
  FoundThickness thickness_at(const Found& each, const Interval& volume) const {
    const auto y = all_coordinates<Layout>(each.x, 1.0);
    const OrientedStretch<double> at = oriented_stretch(y[0], y[1], y[2], y[3]);
    const double rho = at_volume(*models_.potential.body().volume, at).q.rho;
    if (!each.proof.proven) return {rho, Interval(rho), each.proof.error_bound, true};
    const auto box = boxes_.at(each.proof.solution);
    const Interval solution = at_volume(volume, box).q.rho;
    return {rho, solution, (Interval(rho) / solution - Interval(1.0)).magnitude(), true};
  }

  PruneResult<N> plane() {
    auto out =
        search_.prune(system_, boxes_, Mirror::none, oriented_box<Layout>(options_), box_factor);
    // One axis is found twice where it is at both ends of the half turn searched.
    std::vector<Found> kept;
    for (auto* list : {&out.solutions, &out.unproven})
      std::erase_if(*list, [&](const Found& each) {
        if (on_material_axis(each) || again(each, kept)) return true;
        kept.push_back(each);
        return false;
      });
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
  /// Of an even V: about a material axis with alpha = 0, and none of an oblique axis. One that is not
  /// proven is told by its numbers.
  bool on_material_axis(const Found& each) const {
    if constexpr (!Layout::axis) {
      return false;
    } else {
      if (own_mirror(each, false) || own_mirror(each, true)) return true;
      if (each.proof.proven || !models_.potential.even_in_alpha()) return false;
      constexpr double same = 1e-9;
      const AxisAngle<double> axis = axis_angle(each.x[Layout::axis_place]);
      return std::abs(hyperbolic(each.x[Layout::alpha_place]).tanh) < same &&
             std::min(std::abs(axis.cosine), std::abs(axis.sine)) < same;
    }
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

  void add(const Found& each, const FoundThickness& rho) {
    const bool proven = each.proof.proven && rho.proven;
    // Of a held volume rho is no unknown, and what decides a box need not be in it.
    if (proven && rho.solution.apart_from(options_.range(2))) return;
    constexpr double factor = Layout::axis ? 2.0 : Layout::alpha ? 1.25 : 1.0;
    auto y = all_coordinates<Layout>(each.x, rho.rho);
    y[oriented::w] = rho.rho;
    if (Layout::alpha && !Layout::axis && own_mirror(each, false)) y[oriented::a] = 1.0;
    Equilibrium found =
        equilibrium_of_search(oriented_stretch(y[0], y[1], y[2], y[3]).q,
                              std::max(factor * each.proof.error_bound, rho.error_bound), proven);
    found.nu = angular_velocity(branch_, system_.nu);
    if constexpr (Layout::axis) {
      const AxisAngle<double> axis = axis_angle(y[4]);
      found.nu = {system_.nu * axis.cosine, system_.nu * axis.sine, 0.0};
    }
    recompute_residual(body_, potential_, found);
    if (!Layout::alpha && !models_.potential.shear_free()) {
      nearest_ = std::min(nearest_, found.residual);
      if (!proven || !boxes_.shear_force(each.proof.solution).may_be(0.0)) return;
      StretchBox at = stretch_box(each.proof.solution);
      at.rho = rho.solution;
      search_.leave_undecided(at);
      return;
    }
    search_.add(found, proven);
  }

  const Body& body_;
  const Potential& potential_;
  OrientedModels models_;
  Branch branch_;
  const SearchOptions& options_;
  OrientedSystem<Layout> system_;
  OrientedBoxSystem<Layout> boxes_;
  double nearest_ = std::numeric_limits<double>::infinity();  ///< residual of what is no motion
  SearchRun search_;
};

template <bool alpha, bool axis>
SearchResult run(const Body& body, const Potential& potential, Branch branch, double nu,
                 const SearchOptions& options) {
  if (potential.is_separable() || potential.holds_volume())
    return OrientedSearch<OrientedLayout<false, alpha, axis>>(body, potential, branch, nu, options)
        .run();
  return OrientedSearch<OrientedLayout<true, alpha, axis>>(body, potential, branch, nu, options)
      .run();
}

}  // namespace

SearchResult search_anisotropic(const Problem& problem, double nu, const SearchOptions& options) {
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
  return run<true, true>(body, potential, Branch::i, motion.nu, options);
}

}  // namespace stationary
