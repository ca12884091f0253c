#include "solver/search/two_polar_search.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "solver/proof/two_polar_boxes.hpp"
#include "solver/search/branch_and_prune.hpp"
#include "solver/search/search_message.hpp"

namespace stationary {
namespace {

class TwoPolarSearch {
 public:
  TwoPolarSearch(const Body& body, const Potential& potential, const TwoPolarMotion& motion,
                 const SearchOptions& options)
      : body_(body), potential_(potential), motion_(motion), options_(options) {}

  SearchResult run() {
    potential_.visit_parts([this](const auto& model) {
      visit_motion(motion_, [&](const auto& motion) { run_model(model, motion); });
    });
    for (auto* list : {&out_.solutions, &out_.unproven})
      std::ranges::sort(*list, {}, [](const Equilibrium& each) {
        return std::tuple(-each.q.xi / each.q.zeta, each.q.xi, each.q.rho);
      });
    if (out_.status != SearchStatus::interrupted)
      out_.status = out_.undecided.empty() ? SearchStatus::complete : SearchStatus::undecided;
    out_.message =
        search_message(options_, out_.status, out_.solutions.size(), out_.undecided,
                       "a fold, the circle turning into ellipses, or solutions that are not "
                       "isolated",
                       {"lambda", "mu", "rho"}) +
        unproven_text(out_.unproven.size());
    return std::move(out_);
  }

 private:
  template <class System, class BoxSystem>
  PruneResult<BoxSystem::dimension> prune(const System& system, const BoxSystem& boxes,
                                          Mirror mirror, std::size_t first = 0) {
    Box<BoxSystem::dimension> everything;
    for (std::size_t k = 0; k < everything.size(); ++k) everything[k] = options_.range(first + k);
    auto found = BranchAndPrune<System, BoxSystem>(system, boxes, mirror,
                                                   {.min_width = options_.min_width,
                                                    .max_boxes = options_.max_boxes,
                                                    .stop = options_.stop})
                     .run(everything);
    out_.boxes += found.boxes;
    if (found.interrupted) out_.status = SearchStatus::interrupted;
    return found;
  }

  template <class Model, template <class> class Motion>
  void run_model(const Model& model, const Motion<double>& motion) {
    const TwoPolarSystem<decltype(elastic_system(model)), Motion> system{elastic_system(model),
                                                                         body_.J1, motion};
    const auto boxes = two_polar_box_system(body_.J1, model, motion, options_.inputs);
    if constexpr (requires { model.plane; }) {
      const auto thickness = interval_model(model.thickness, options_.inputs);
      const auto axial =
          prune(ThicknessSystem<std::decay_t<decltype(model.thickness)>>{model.thickness,
                                                                         DoubleDouble(0.0)},
                ThicknessBoxSystem<std::remove_cv_t<decltype(thickness)>>{thickness, 0.0},
                Mirror::none, 2);
      // No thickness, no ellipsoid: whatever the plane does.
      if (axial.solutions.empty() && axial.undecided.empty()) return;
      if (out_.status == SearchStatus::interrupted) return;
      const auto planar = prune(system, boxes, Mirror::one);
      for (const auto* planes : {&planar.solutions, &planar.unproven})
        for (const auto& plane : *planes)
          for (const auto* thicknesses : {&axial.solutions, &axial.unproven})
            for (const auto& rho : *thicknesses)
              add(plane.x[0], plane.x[1], rho.x[0], plane.proof, rho.proof.solution[0],
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
    } else {
      const auto found = prune(system, boxes, Mirror::one);
      for (const auto* list : {&found.solutions, &found.unproven})
        for (const auto& each : *list)
          add(each.x[0], each.x[1], each.x[2], each.proof, each.proof.solution[2],
              each.proof.error_bound, each.proof.proven);
      for (const auto& box : found.undecided) out_.undecided.push_back({box[0], box[1], box[2]});
    }
  }

  template <int N>
  void add(double lambda, double mu, double rho, const Proof<N>& proof, const Interval& rho_box,
           double error_bound, bool proven) {
    const auto& [l, m] = std::tie(proof.solution[0], proof.solution[1]);
    // Its mirror image is a solution too; within `unique` it is the solution itself.
    const bool circle = l.within(proof.unique[1]) && m.within(proof.unique[0]);
    // The mirror image of one of the box may lie outside.
    if (l.apart_from(options_.range(0)) || m.apart_from(options_.range(1))) return;
    if (!circle && !(l.lo > m.hi)) {
      if (proven) out_.undecided.push_back({l, m, rho_box});
      return;
    }
    Equilibrium found;
    found.status = SolveStatus::solved;
    found.message = found_by_search(proven);
    found.circle = circle;
    if (circle)
      found.message += "; the circle lambda = mu, which depends on omega + theta_dot only";
    found.q = {0.0, lambda, circle ? lambda : mu, rho};
    found.error_bound = error_bound;
    set_motion(body_, motion_, found);
    check_motion(body_, potential_, found);
    if (proven) {
      out_.solutions.push_back(found);
    } else if (found.residual <= acceptable_residual) {
      out_.unproven.push_back(found);
    }
  }

  const Body& body_;
  const Potential& potential_;
  const TwoPolarMotion& motion_;
  const SearchOptions& options_;
  SearchResult out_;
};

}  // namespace

SearchResult search_two_polar(const Body& body, const Potential& potential,
                              const TwoPolarMotion& motion, const SearchOptions& options) {
  require_two_polar(body, motion);
  require_box(options);
  if (const auto* rates = std::get_if<TwoPolarRates<double>>(&motion)) {
    const auto verdict = rates_verdict(body.J1, potential, *rates);
    if (verdict && verdict->on_line) {
      SearchResult out;
      out.status = SearchStatus::undecided;
      out.on_line = true;
      out.message = verdict->line_message();
      return out;
    }
  }
  return TwoPolarSearch(body, potential, motion, options).run();
}

}  // namespace stationary
