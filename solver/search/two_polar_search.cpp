#include "solver/search/two_polar_search.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

#include "solver/proof/two_polar_boxes.hpp"
#include "solver/search/round_search.hpp"
#include "solver/search/search_run.hpp"

namespace stationary {
namespace {

/// The equations of a motion in doubles and over boxes, and the search of them.
template <class Model, template <class> class Motion>
class Equations {
 public:
  using Elastic = decltype(elastic_system(std::declval<const Model&>()));
  static constexpr int N = Elastic::dimension;
  using System = TwoPolarSystem<Elastic, Motion>;
  using Boxes = decltype(two_polar_box_system(
      0.0, std::declval<const Model&>(), std::declval<const Motion<double>&>(), Inputs::decimals));
  /// Circles are there at given rates; their ellipses near them are sought by other equations.
  static constexpr bool in_parts =
      std::is_same_v<Motion<double>, TwoPolarRates<double>> && !is_body_model<Model>;

  Equations(double J, const Model& model, const Motion<double>& motion, Inputs inputs)
      : system_{elastic_system(model), J, motion},
        boxes_(two_polar_box_system(J, model, motion, inputs)) {}

  /// Of other numbers, one of which may be many.
  void set(const Motion<double>& motion, const Motion<Interval>& inputs,
           const std::optional<int>& varied) {
    system_.motion = motion;
    boxes_.motion = inputs;
    boxes_.varied_number = varied;
  }

  /// f(search): it refers to these equations.
  template <class F>
  auto with_search(const Box<N>& everything, const F& f) const {
    if constexpr (in_parts) {
      const auto invariants = invariant_system<N>(system_.elastic.model, system_.J, system_.motion);
      const EllipseBoxSystem<decltype(boxes_.model), N> ellipses{
          boxes_.model, boxes_.J, boxes_.motion, boxes_.varied_number};
      return f(RoundSearch(system_, boxes_, invariants, ellipses, Mirror::one, everything));
    } else {
      return f(WholeSearch(system_, boxes_, Mirror::one, everything));
    }
  }

 private:
  System system_;
  Boxes boxes_;
};

class TwoPolarSearch {
 public:
  TwoPolarSearch(const Body& body, const Potential& potential, const TwoPolarMotion& motion,
                 const SearchOptions& options)
      : body_(body),
        potential_(potential),
        motion_(motion),
        options_(options),
        search_(potential, options) {}

  SearchResult run() {
    potential_.visit_parts([this](const auto& model) {
      visit_motion(motion_, [&](const auto& motion) { run_model(model, motion); });
    });
    return finish();
  }

  /// Of a separable potential the solutions of its thickness.
  template <class Model>
  PruneResult<1> thicknesses(const Model& model) {
    const auto thickness = interval_model(model.thickness, options_.inputs);
    return search_.prune(
        ThicknessSystem<std::decay_t<decltype(model.thickness)>>{model.thickness,
                                                                 DoubleDouble(0.0)},
        ThicknessBoxSystem<std::remove_cv_t<decltype(thickness)>>{thickness, 0.0}, Mirror::none, 2);
  }

  /// Of the plane's solutions with those of the thickness.
  SearchResult of(const PruneResult<2>& plane, const PruneResult<1>& axial) {
    take(plane, axial);
    return finish();
  }
  /// Of the solutions of all unknowns.
  SearchResult of(const PruneResult<3>& all, const PruneResult<1>&) {
    take(all);
    return finish();
  }

 private:
  SearchResult finish() {
    return search_.finish(
        [](const Equilibrium& each) {
          return std::tuple(-each.q.xi / each.q.zeta, each.q.xi, each.q.rho);
        },
        "a fold, the circle turning into ellipses, or solutions that are not isolated",
        {"lambda", "mu", "rho"});
  }

  template <class Model, template <class> class Motion>
  void run_model(const Model& model, const Motion<double>& motion) {
    using Own = Equations<Model, Motion>;
    Box<Own::N> everything;
    for (std::size_t k = 0; k < everything.size(); ++k) everything[k] = options_.range(k);
    const Own equations(body_.J1, model, motion, options_.inputs);
    const auto all = [&] {
      return equations.with_search(everything,
                                   [&](const auto& search) { return search_.prune(search); });
    };
    if constexpr (requires { model.plane; }) {
      const auto axial = thicknesses(model);
      if (!search_.ends_with(axial)) take(all(), axial);
    } else {
      take(all());
    }
  }

  void take(const PruneResult<2>& plane, const PruneResult<1>& axial) {
    search_.combine(
        plane, axial,
        [](const Box<2>& x) {
          return StretchBox{x[0], x[1], {}};
        },
        [this](const ProvenSolution<2>& each, const FoundThickness& rho) {
          add(each, rho.rho, rho.solution, std::max(each.proof.error_bound, rho.error_bound),
              each.proof.proven && rho.proven);
        });
  }
  void take(const PruneResult<3>& all) {
    search_.each_of(
        all,
        [](const Box<3>& x) {
          return StretchBox{x[0], x[1], x[2]};
        },
        [this](const ProvenSolution<3>& each) {
          add(each, each.x[2], each.proof.solution[2], each.proof.error_bound, each.proof.proven);
        });
  }

  template <int N>
  void add(const ProvenSolution<N>& each, double rho, const Interval& rho_box, double error_bound,
           bool proven) {
    const Interval& lambda = each.proof.solution[0];
    const Interval& mu = each.proof.solution[1];
    // Its mirror image is a solution too; within `unique` it is the solution itself.
    const bool circle = lambda.within(each.proof.unique[1]) && mu.within(each.proof.unique[0]);
    // The mirror image of one of the box may lie outside, and one that others of its block have inside.
    if (lambda.apart_from(options_.range(0)) || mu.apart_from(options_.range(1)) ||
        rho_box.apart_from(options_.range(2)))
      return;
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

class TwoPolarSearches::Blocks {
 public:
  virtual ~Blocks() = default;
  /// Nothing where the motion is to be searched by itself.
  /// boxes: added to.
  virtual std::optional<SearchResult> at(const TwoPolarMotion& motion, std::size_t place,
                                         long& boxes) = 0;
};

namespace {

template <class Model, template <class> class Motion>
class BlocksOf final : public TwoPolarSearches::Blocks {
 public:
  using Own = Equations<Model, Motion>;
  static constexpr int N = Own::N;

  BlocksOf(const Body& body, const Potential& potential, const Model& model,
           const TwoPolarMotion& motion, const NumberRange& range, const SearchOptions& options)
      : body_(body),
        potential_(potential),
        range_(range),
        options_(options),
        equations_(body.J1, model, std::get<Motion<double>>(motion), options.inputs) {
    for (std::size_t k = 0; k < everything_.size(); ++k) everything_[k] = options.range(k);
    if constexpr (N == 2) {
      axial_ = TwoPolarSearch(body, potential, motion, options).thicknesses(model);
      possible_ = axial_.undecided.empty() && !axial_.interrupted;
    }
  }

  std::optional<SearchResult> at(const TwoPolarMotion& motion, std::size_t place,
                                 long& boxes) override {
    if (!possible_) return std::nullopt;
    const auto& numbers = std::get<Motion<double>>(motion);
    const Parts* before = around(numbers, place, boxes);
    if (before == nullptr) return std::nullopt;
    equations_.set(numbers, as_inputs(numbers), std::nullopt);
    const auto found = equations_.with_search(everything_, [&](const auto& search) {
      return search.finished(prune_options(options_.min_width, options_.max_boxes), before);
    });
    if (!found) return std::nullopt;
    boxes += found->boxes;
    if (found->interrupted || !found->undecided.empty()) return std::nullopt;
    SearchResult out = TwoPolarSearch(body_, potential_, motion, options_).of(*found, axial_);
    out.boxes = found->boxes;
    return out.status == SearchStatus::complete ? std::optional(std::move(out)) : std::nullopt;
  }

 private:
  using Parts = FoundInParts<N>;

  /// Values of a block, and the width in ln x to which its search goes.
  struct Level {
    std::size_t size;
    double min_width;
  };
  static constexpr std::array<Level, 2> levels{{{64, 0x1p-3}, {16, 0x1p-5}}};
  static constexpr long most_boxes = 1000;

  struct Block {
    std::size_t place = std::numeric_limits<std::size_t>::max();
    Parts left;
  };

  PruneOptions prune_options(double min_width, long max_boxes) const {
    return {.min_width = min_width, .max_boxes = max_boxes, .stop = options_.stop};
  }
  Motion<Interval> as_inputs(const Motion<double>& numbers) const {
    return with_numbers(numbers, [this](double c) { return as_input(c, options_.inputs); });
  }

  /// What the search of the smallest block of the value has left; null where it was stopped.
  const Parts* around(const Motion<double>& motion, std::size_t place, long& boxes) {
    const Parts* out = nullptr;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      Block& block = blocks_[k];
      const std::size_t own = place / levels[k].size;
      if (block.place != own) {
        block = {own, left_of(motion, own * levels[k].size, levels[k], out)};
        boxes += block.left.boxes();
        // A block within another begins anew.
        for (std::size_t j = k + 1; j < levels.size(); ++j) blocks_[j] = Block();
      }
      if (block.left.interrupted()) return nullptr;
      out = &block.left;
    }
    return out;
  }

  Parts left_of(Motion<double> motion, std::size_t first, const Level& level, const Parts* before) {
    const auto values = range_.values.subspan(first);
    const double from = values.front();
    const double to = values[std::min(level.size, values.size()) - 1];
    Motion<Interval> inputs = as_inputs(motion);
    number_of(inputs, range_.number) =
        hull(as_input(from, options_.inputs), as_input(to, options_.inputs));
    number_of(motion, range_.number) = std::midpoint(from, to);
    equations_.set(motion, inputs, range_.number);
    PruneOptions how = prune_options(level.min_width, most_boxes);
    how.to_go_on = true;
    return equations_.with_search(everything_,
                                  [&](const auto& search) { return search.begun(how, before); });
  }

  const Body& body_;
  const Potential& potential_;
  NumberRange range_;
  const SearchOptions& options_;
  Own equations_;
  Box<N> everything_;
  PruneResult<1> axial_;
  bool possible_ = true;
  std::array<Block, levels.size()> blocks_;
};

}  // namespace

TwoPolarSearches::TwoPolarSearches(const Body& body, const Potential& potential,
                                   const TwoPolarMotion& motion, const NumberRange& range,
                                   const SearchOptions& options)
    : body_(body), potential_(potential), motion_(motion), range_(range), options_(options) {
  require_two_polar(body, motion);
  require_box(options);
  potential.visit_parts([&]<class Model>(const Model& model) {
    std::visit(
        [&]<template <class> class Motion>(const Motion<double>&) {
          blocks_ = std::make_unique<BlocksOf<Model, Motion>>(body, potential, model, motion, range,
                                                              options_);
        },
        motion);
  });
}

TwoPolarSearches::~TwoPolarSearches() = default;

TwoPolarMotion TwoPolarSearches::motion_at(double value) const {
  TwoPolarMotion out = motion_;
  std::visit([&](auto& motion) { number_of(motion, range_.number) = value; }, out);
  return out;
}

SearchResult TwoPolarSearches::at(double value) {
  const TwoPolarMotion motion = motion_at(value);
  require_two_polar(body_, motion);
  const auto* rates = std::get_if<TwoPolarRates<double>>(&motion);
  const auto* momenta = std::get_if<TwoPolarMomenta<double>>(&motion);
  const auto place = std::ranges::lower_bound(range_.values, value);
  // Lines of solutions, and equal momenta, have equations of their own.
  const bool of_block = place != range_.values.end() && *place == value &&
                        !(rates && rates_verdict(body_.J1, potential_, *rates)) &&
                        !(momenta && momenta->s3 == momenta->p_theta);
  if (of_block) {
    auto out = blocks_->at(motion, static_cast<std::size_t>(place - range_.values.begin()), boxes_);
    if (out) {
      ++shared_;
      return std::move(*out);
    }
  }
  SearchResult out = search_two_polar(body_, potential_, motion, options_);
  boxes_ += out.boxes;
  return out;
}

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
