#include "solver/search/tilted_search.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "solver/family/tilted_family.hpp"
#include "solver/motion/tilted_system.hpp"
#include "solver/proof/tilted_boxes.hpp"
#include "solver/search/branch_and_prune.hpp"
#include "solver/search/search_message.hpp"

namespace stationary {
namespace {

class TiltedSearch {
 public:
  TiltedSearch(const Body& body, const Potential& potential, const TiltedRotation& motion,
               const SearchOptions& options)
      : body_(body),
        potential_(potential),
        motion_(motion),
        options_(options),
        family_(tilted_family(body, potential, motion.plane, false)) {}

  SearchResult run() {
    potential_.visit_parts([this](const auto& model) { run_model(model); });
    for (auto* list : {&out_.solutions, &out_.unproven})
      std::ranges::sort(*list, {},
                        [](const Equilibrium& each) { return std::tuple(each.q.xi, each.q.zeta); });
    if (out_.status != SearchStatus::interrupted)
      out_.status = out_.undecided.empty() ? SearchStatus::complete : SearchStatus::undecided;
    out_.message = search_message(options_, out_.status, out_.solutions.size(), out_.undecided,
                                  "a fold, a bifurcation, solutions that are not isolated, or an "
                                  "axis within rounding of a material one") +
                   unproven_text(out_.unproven.size());
    return std::move(out_);
  }

 private:
  template <class Model>
  void run_model(const Model& model) {
    const TiltedSystem<Model> system{
        model, body_, motion_.plane,
        axis_rates(body_, Branch::iii, two_product(motion_.nu, motion_.nu))};
    const auto boxes = tilted_box_system(body_, model, motion_.plane, motion_.nu, options_.inputs);
    using BoxSystem = std::remove_const_t<decltype(boxes)>;
    Box<2> everything{options_.range(0), options_.range(1)};
    // rho in the box too.
    Interval& tied = everything[motion_.plane == TiltPlane::one_three ? 0 : 1];
    const Interval of_rho =
        options_.range(2) / tilted_slenderness<Interval>(boxes.J, motion_.plane);
    if (of_rho.apart_from(tied)) return;
    tied = common(tied, of_rho);
    const PruneOptions prune{
        .min_width = options_.min_width, .max_boxes = options_.max_boxes, .stop = options_.stop};
    const auto found =
        BranchAndPrune<TiltedSystem<Model>, BoxSystem>(system, boxes, Mirror::none, prune)
            .run(everything);
    out_.boxes = found.boxes;
    if (found.interrupted) out_.status = SearchStatus::interrupted;
    for (const auto& each : found.solutions) add(boxes, each);
    for (const auto& each : found.unproven) add(boxes, each);
    for (const auto& box : found.undecided) leave_undecided(boxes, box);
  }

  template <class BoxSystem>
  void leave_undecided(const BoxSystem& boxes, const Box<2>& box) {
    out_.undecided.push_back({box[0], box[1], boxes.thickness(box)});
  }

  template <class BoxSystem>
  void add(const BoxSystem& boxes, const ProvenSolution<2>& each) {
    if (boxes.excludes(each.proof.solution)) return;
    const auto square = boxes.squares(each.proof.solution);
    const Interval rho = boxes.thickness(each.proof.solution);
    ReducedVector<2> tail;
    tail.setConstant(std::numeric_limits<double>::quiet_NaN());
    const Member member = family_->member(each.x, tail, motion_.nu, each.proof.error_bound);
    if (!square.in_plane.positive() || !square.normal.positive() ||
        !(member.tilt_in_plane > 0.0 && member.tilt_normal > 0.0)) {
      if (each.proof.proven) leave_undecided(boxes, each.proof.solution);
      return;
    }
    Equilibrium motion;
    motion.status = SolveStatus::solved;
    motion.message = found_by_search(each.proof.proven);
    motion.q = member.q;
    motion.nu = member.angular_velocity;
    motion.residual = member.residual;
    motion.compatibility = member.compatibility;
    motion.error_bound = std::max(each.proof.error_bound,
                                  (Interval(member.q.rho) / rho - Interval(1.0)).magnitude());
    if (each.proof.proven) {
      out_.solutions.push_back(motion);
    } else if (motion.residual <= acceptable_residual) {
      out_.unproven.push_back(motion);
    }
  }

  const Body& body_;
  const Potential& potential_;
  const TiltedRotation& motion_;
  const SearchOptions& options_;
  std::unique_ptr<Family<2>> family_;
  SearchResult out_;
};

}  // namespace

SearchResult search_tilted(const Body& body, const Potential& potential,
                           const TiltedRotation& motion, const SearchOptions& options) {
  if (!(motion.nu > 0.0 && std::isfinite(motion.nu)))
    throw std::invalid_argument("|nu| finite and > 0");
  require_box(options);
  return TiltedSearch(body, potential, motion, options).run();
}

}  // namespace stationary
