#include "solver/search/two_polar_search.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "solver/proof/two_polar_boxes.hpp"
#include "solver/search/search_run.hpp"

namespace stationary {
namespace {

class TwoPolarSearch {
 public:
  TwoPolarSearch(const Body& body, const Potential& potential, const TwoPolarMotion& motion,
                 const SearchOptions& options)
      : body_(body), potential_(potential), motion_(motion), options_(options), search_(options) {}

  SearchResult run() {
    potential_.visit_parts([this](const auto& model) {
      visit_motion(motion_, [&](const auto& motion) { run_model(model, motion); });
    });
    return search_.finish(
        [](const Equilibrium& each) {
          return std::tuple(-each.q.xi / each.q.zeta, each.q.xi, each.q.rho);
        },
        "a fold, the circle turning into ellipses, or solutions that are not isolated",
        {"lambda", "mu", "rho"});
  }

 private:
  template <class Model, template <class> class Motion>
  void run_model(const Model& model, const Motion<double>& motion) {
    const TwoPolarSystem<decltype(elastic_system(model)), Motion> system{elastic_system(model),
                                                                         body_.J1, motion};
    const auto boxes = two_polar_box_system(body_.J1, model, motion, options_.inputs);
    if constexpr (requires { model.plane; }) {
      const auto thickness = interval_model(model.thickness, options_.inputs);
      const auto axial =
          search_.prune(ThicknessSystem<std::decay_t<decltype(model.thickness)>>{model.thickness,
                                                                                 DoubleDouble(0.0)},
                        ThicknessBoxSystem<std::remove_cv_t<decltype(thickness)>>{thickness, 0.0},
                        Mirror::none, 2);
      if (search_.ends_with(axial)) return;
      search_.combine(
          search_.prune(system, boxes, Mirror::one), axial,
          [](const Box<2>& x) {
            return StretchBox{x[0], x[1], {}};
          },
          [this](const ProvenSolution<2>& each, const FoundThickness& rho) {
            add(each, rho.rho, rho.solution, std::max(each.proof.error_bound, rho.error_bound),
                each.proof.proven && rho.proven);
          });
    } else {
      search_.each_of(
          search_.prune(system, boxes, Mirror::one),
          [](const Box<3>& x) {
            return StretchBox{x[0], x[1], x[2]};
          },
          [this](const ProvenSolution<3>& each) {
            add(each, each.x[2], each.proof.solution[2], each.proof.error_bound, each.proof.proven);
          });
    }
  }

  template <int N>
  void add(const ProvenSolution<N>& each, double rho, const Interval& rho_box, double error_bound,
           bool proven) {
    const Interval& lambda = each.proof.solution[0];
    const Interval& mu = each.proof.solution[1];
    // Its mirror image is a solution too; within `unique` it is the solution itself.
    const bool circle = lambda.within(each.proof.unique[1]) && mu.within(each.proof.unique[0]);
    // The mirror image of one of the box may lie outside.
    if (lambda.apart_from(options_.range(0)) || mu.apart_from(options_.range(1))) return;
    if (!circle && !(lambda.lo > mu.hi)) {
      if (proven) search_.leave_undecided({lambda, mu, rho_box});
      return;
    }
    Equilibrium found = equilibrium_of_search({0.0, each.x[0], circle ? each.x[0] : each.x[1], rho},
                                              error_bound, proven);
    found.circle = circle;
    if (circle)
      found.message += "; the circle lambda = mu, which depends on omega + theta_dot only";
    set_motion(body_, motion_, found);
    check_motion(body_, potential_, found);
    search_.add(found, proven);
  }

  const Body& body_;
  const Potential& potential_;
  const TwoPolarMotion& motion_;
  const SearchOptions& options_;
  SearchRun search_;
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
