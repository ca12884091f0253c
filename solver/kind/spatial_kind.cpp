#include "solver/kind/spatial_kind.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "lib/number/elementary.hpp"
#include "solver/kind/spatial_boxes.hpp"
#include "solver/kind/spatial_certificate.hpp"
#include "solver/search/search_run.hpp"
#include "solver/solve/family_solve.hpp"

namespace stationary {
namespace {

/// Where a box holds no motion, as branch and prune asks.
struct SearchedBoxes : StatedBoxes<SpatialEquations> {
  static constexpr bool split_by_slopes = true;
  Interval rho_range;

  bool excludes(const Box<3>& x) const {
    const SpatialBoxes boxes(equations, p, inputs);
    if (boxes.stretch(x).rho.apart_from(rho_range)) return true;
    const auto squares = boxes.squares(x);
    return squares.in_plane.hi <= 0.0 || squares.normal.hi <= 0.0;
  }
};

class SpatialSearch {
 public:
  SpatialSearch(const SpatialEquations& equations, double nu, const SearchOptions& options)
      : equations_(equations),
        family_(equations),
        nu_(nu),
        options_(options),
        boxes_(equations, nu, options.inputs),
        search_(options) {}

  SearchResult run() {
    const StatedSystem<SpatialEquations> system{equations_, nu_};
    const SearchedBoxes boxes{{equations_, nu_, options_.inputs}, options_.range(2)};
    constexpr long box_factor = 20;
    search_.each_of(
        search_.prune(system, boxes, Mirror::none, everything(), box_factor),
        [this](const Box<3>& x) { return boxes_.stretch(x); },
        [this](const ProvenSolution<3>& each) { add(each); });
    return search_.finish(
        [](const Equilibrium& each) { return std::tuple(each.q.xi, each.q.zeta, each.q.alpha); },
        "a fold, a bifurcation, solutions that are not isolated, or an axis within rounding of a "
        "material plane");
  }

 private:
  /// alpha > 0: the others are mirror images.
  Box<3> everything() const {
    return {options_.range(0), options_.range(1), Interval(1.0, options_.most_shear())};
  }

  void add(const ProvenSolution<3>& each) {
    ReducedVector<3> tail;
    tail.setConstant(std::numeric_limits<double>::quiet_NaN());
    const Member member = family_.member(each.x, tail, nu_, each.proof.error_bound);
    const bool proven = each.proof.proven;
    // What decides a box need not be in it.
    if (proven && boxes_.stretch(each.proof.solution).rho.apart_from(options_.range(2))) return;
    if (member.beyond_end() || (proven && !boxes_.axis(each.proof.solution))) {
      if (proven) search_.leave_undecided(boxes_.stretch(each.proof.solution));
      return;
    }
    Equilibrium motion = equilibrium_of_search(member.q, member.error_bound, proven);
    if (proven) {
      const Interval rho = boxes_.stretch(each.proof.solution).rho;
      motion.error_bound =
          std::max(motion.error_bound, (Interval(member.q.rho) / rho - Interval(1.0)).magnitude());
    }
    motion.nu = member.angular_velocity;
    motion.residual = member.residual;
    motion.compatibility = member.compatibility;
    search_.add(motion, proven);
  }

  const SpatialEquations& equations_;
  StatedFamily<SpatialEquations> family_;
  double nu_;
  const SearchOptions& options_;
  SpatialBoxes boxes_;
  SearchRun search_;
};

class SpatialSolve : FamilySolve {
 public:
  SpatialSolve(const SpatialEquations& equations, double nu, const SolveOptions& options)
      : FamilySolve(equations.body, equations.potential, options), equations_(equations), nu_(nu) {}

  Equilibrium run() {
    if (options_.start) {
      const StatedFamily<SpatialEquations> family(equations_);
      Stretch start = *options_.start;
      start.alpha = std::abs(start.alpha);
      by_newton(family, equations_.unknowns(start), nu_, Connection::given_start,
                "Newton from the given start");
      return out_;
    }
    const SearchResult all = SpatialSearch(equations_, nu_, {.stop = options_.stop}).run();
    out_.status = SolveStatus::not_found;
    out_.message = "exhaustive search: " + all.message;
    if (all.status == SearchStatus::interrupted) {
      out_.status = SolveStatus::interrupted;
      return out_;
    }
    if (all.solutions.empty()) return out_;
    const double unit = cube_root(*potential_.volume());
    const auto far = [unit](const Equilibrium& at) {
      return std::max({std::abs(log(at.q.xi / unit)), std::abs(log(at.q.zeta / unit)),
                       std::abs(log(at.q.rho / unit))});
    };
    const Counts counts = out_.counts;
    out_ = *std::ranges::min_element(all.solutions, {}, far);
    out_.counts = counts;
    out_.connection = Connection::unknown;
    return out_;
  }

 private:
  const SpatialEquations& equations_;
  double nu_;
};

class SpatialKind final : public Kind {
 public:
  SpatialKind(const Body& body, const Potential& potential, const SpatialRotation& motion)
      : Kind(body, potential), motion_(motion), none_(no_spatial_motion(body, potential)) {
    if (!none_) equations_.emplace(body, potential, true);
  }

  Motion motion() const override { return motion_; }
  std::optional<std::string> nonexistence() const override {
    return by_convention() ? none_ : std::nullopt;
  }
  Equilibrium solve(const SolveOptions& options) const override {
    if (motion_.nu == 0.0) return at_rest();
    if (none_) {
      Equilibrium out;
      out.status = by_convention() ? SolveStatus::none_exists : SolveStatus::not_found;
      out.message = *none_;
      return out;
    }
    return SpatialSolve(*equations_, motion_.nu, options).run();
  }
  SearchResult search(const SearchOptions& options) const override {
    if (!none_) return SpatialSearch(*equations_, motion_.nu, options).run();
    SearchResult out;
    out.status = by_convention() ? SearchStatus::complete : SearchStatus::undecided;
    out.message = *none_;
    return out;
  }

  std::optional<Spectrum> spectrum(const Equilibrium& solved) const override {
    const StatedFamily<SpatialEquations> family(*equations_);
    return family_spectrum(family, solved, motion_.nu);
  }

  Certificate certify(const Equilibrium& equilibrium) const override {
    if (!none_) return certify_spatial(*equations_, motion_.nu, equilibrium);
    Certificate out;
    out.reason = *none_;
    return out;
  }
  SpectrumEnclosure enclose(const Equilibrium&, const Certificate& certificate,
                            const Spectrum& spectrum) const override {
    return enclose_spatial_spectrum(*equations_, motion_.nu, certificate, spectrum);
  }

  std::vector<PlanItem> unknowns() const override {
    return {{"alpha", "an unknown, > 0", "alpha -> -alpha, nu2 -> -nu2 is a mirror image"},
            {"rho", "volume/d", "det S is held"},
            {"xi, zeta", "3 equations with alpha",
             "W_t = 0, compatibility, and the balance less the pressure"},
            {"nu", "closed form", "the eigenvector of S J S with J3 rho^2"}};
  }
  PlanItem spectrum_plan() const override {
    return {"spectrum", "4 modes from the whole problem, by a structure-preserving method",
            "no reflection makes blocks of the dynamics, on the 8-dimensional leaf of fixed |pi|"};
  }
  std::string_view default_start() const override { return "the nearest of an exhaustive search"; }

  AnyFamily family(const FamilyParameter&, const FamilyOutputs& outputs,
                   const Stretch&) const override {
    return spatial_family(body(), potential(), outputs.spectrum);
  }
  std::optional<std::string> no_family(const FamilyParameter&) const override { return none_; }
  std::optional<EventEnclosure> enclose_event(const FamilyParameter&, EventType event,
                                              const Member& member) const override {
    return enclose_spatial_event(*equations_, event, member);
  }

 private:
  /// Whether there are none because axes are chosen such that these motions are of another kind; else
  /// they are only not sought.
  bool by_convention() const {
    return none_ && potential().is_isotropic() && potential().holds_volume();
  }

  SpatialRotation motion_;
  std::optional<std::string> none_;
  std::optional<SpatialEquations> equations_;
};

}  // namespace

std::unique_ptr<Kind> spatial_kind(const Body& body, const Potential& potential,
                                   const SpatialRotation& motion) {
  return std::make_unique<SpatialKind>(body, potential, motion);
}

}  // namespace stationary
