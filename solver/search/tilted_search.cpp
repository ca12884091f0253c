#include "solver/search/tilted_search.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "solver/family/tilted_family.hpp"
#include "solver/motion/tilted_system.hpp"
#include "solver/proof/tilted_enclosure.hpp"
#include "solver/search/model_terms.hpp"
#include "solver/search/search_run.hpp"

namespace stationary {
namespace {

template <class System>
struct NarrowedBoxes : System {
  std::shared_ptr<const StretchTerms> terms;

  bool contract(Box<2>& x) const { return narrow_tilted<System>(*this, *terms, x); }
};

class TiltedSearch {
 public:
  TiltedSearch(const Body& body, const Potential& potential, const TiltedRotation& motion,
               const SearchOptions& options)
      : body_(body),
        potential_(potential),
        motion_(motion),
        options_(options),
        family_(tilted_family(body, potential, motion.plane, false)),
        search_(potential, options) {}

  SearchResult run() {
    potential_.visit_parts([this](const auto& model) { run_model(model); });
    return search_.finish(
        [](const Equilibrium& each) { return std::tuple(each.q.xi, each.q.zeta); },
        "a fold, a bifurcation, solutions that are not isolated, or an axis within rounding of a "
        "material one");
  }

 private:
  template <class Model>
  void run_model(const Model& model) {
    const TiltedSystem<Model> system{
        model, body_, motion_.plane,
        axis_rates(body_, Branch::iii, two_product(motion_.nu, motion_.nu))};
    auto plain = tilted_box_system(body_, model, motion_.plane, motion_.nu, options_.inputs);
    const NarrowedBoxes<decltype(plain)> boxes{
        std::move(plain), std::make_shared<StretchTerms>(model, options_.inputs)};
    Box<2> everything{options_.range(0), options_.range(1)};
    // rho in the box too.
    Interval& tied = everything[motion_.plane == TiltPlane::one_three ? 0 : 1];
    const Interval of_rho =
        options_.range(2) / tilted_slenderness<Interval>(boxes.J, motion_.plane);
    if (of_rho.apart_from(tied)) return;
    tied = common(tied, of_rho);
    const auto at = [&boxes](const Box<2>& x) {
      return StretchBox{x[0], x[1], boxes.thickness(x)};
    };
    search_.each_of(search_.prune(system, boxes, Mirror::none, everything), at,
                    [&](const ProvenSolution<2>& each) { add(boxes, at, each); });
  }

  template <class BoxSystem, class At>
  void add(const BoxSystem& boxes, const At& at, const ProvenSolution<2>& each) {
    const Box<2>& solution = each.proof.solution;
    if (boxes.excludes(solution)) return;
    const auto square = boxes.squares(solution);
    ReducedVector<2> tail;
    tail.setConstant(std::numeric_limits<double>::quiet_NaN());
    const Member member = family_->member(each.x, tail, motion_.nu, each.proof.error_bound);
    if (!square.in_plane.positive() || !square.normal.positive() ||
        !(member.tilt_in_plane > 0.0 && member.tilt_normal > 0.0)) {
      if (each.proof.proven) search_.leave_undecided(at(solution));
      return;
    }
    const Interval off = Interval(member.q.rho) / boxes.thickness(solution) - Interval(1.0);
    Equilibrium motion = equilibrium_of_search(
        member.q, std::max(each.proof.error_bound, off.magnitude()), each.proof.proven);
    motion.nu = member.angular_velocity;
    motion.residual = member.residual;
    motion.compatibility = member.compatibility;
    search_.add(motion, each.proof.proven);
  }

  const Body& body_;
  const Potential& potential_;
  const TiltedRotation& motion_;
  const SearchOptions& options_;
  std::unique_ptr<Family<2>> family_;
  SearchRun search_;
};

}  // namespace

SearchResult search_tilted(const Body& body, const Potential& potential,
                           const TiltedRotation& motion, const SearchOptions& options) {
  if (!(motion.nu > 0.0 && std::isfinite(motion.nu)))
    throw std::invalid_argument("|nu| finite and > 0");
  return TiltedSearch(body, potential, motion, options).run();
}

}  // namespace stationary
