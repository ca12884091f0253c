#include "solver/kind/spatial_kind.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "lib/stability/leaf_enclosure.hpp"
#include "solver/family/spatial_family.hpp"
#include "solver/proof/certificate.hpp"
#include "solver/search/search_run.hpp"
#include "solver/solve/family_solve.hpp"

namespace stationary {
namespace {

constexpr int shear = SpatialEquations::shear_place;

/// What a box of the unknowns holds of a motion.
class SpatialBoxes {
 public:
  SpatialBoxes(const SpatialEquations& equations, double nu, Inputs inputs)
      : equations_(equations), nu_(nu), inputs_(inputs) {}

  StretchBox stretch(const Box<3>& x) const {
    const auto q = state(x).at.q;
    return {q.xi, q.zeta, q.rho, q.alpha};
  }
  SpatialSquares<Interval> squares(const Box<3>& x) const {
    return spatial_squares(state(x), square(as_input(nu_, inputs_)));
  }
  /// Directions that nu/|nu| may have; nothing where that is not known.
  std::optional<Vector3<Interval>> axis(const Box<3>& x) const {
    const SpatialState<Interval> at = state(x);
    const auto square_of = squares(x);
    if (!square_of.in_plane.positive() || !square_of.normal.positive()) return std::nullopt;
    const auto n = spatial_direction<Interval>(J(), at);
    const Interval length = sqrt(square(n[0]) + square(n[1]));
    if (!length.positive()) return std::nullopt;
    const Interval speed = sqrt(square_of.in_plane + square_of.normal);
    const Interval in_plane = sqrt(square_of.in_plane) / speed;
    return Vector3<Interval>{in_plane * n[0] / length, in_plane * n[1] / length,
                             sqrt(square_of.normal) / speed};
  }
  Inertia3<Interval> J() const { return inertia_intervals(equations_.body, inputs_); }

 private:
  SpatialState<Interval> state(const Box<3>& x) const {
    return equations_.state(x, [this](double c) { return as_input(c, inputs_); });
  }

  const SpatialEquations& equations_;
  double nu_;
  Inputs inputs_;
};

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
    const double most = std::sqrt(options_.max_stretch / options_.min_stretch);
    return {options_.range(0), options_.range(1), Interval(1.0, most)};
  }

  void add(const ProvenSolution<3>& each) {
    ReducedVector<3> tail;
    tail.setConstant(std::numeric_limits<double>::quiet_NaN());
    const Member member = family_.member(each.x, tail, nu_, each.proof.error_bound);
    const bool proven = each.proof.proven;
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
    if (all.status == SearchStatus::interrupted) out_.status = SolveStatus::interrupted;
    if (all.solutions.empty()) return out_;
    const double unit = std::cbrt(*potential_.volume());
    const auto far = [unit](const Equilibrium& at) {
      return std::max({std::abs(std::log(at.q.xi / unit)), std::abs(std::log(at.q.zeta / unit)),
                       std::abs(std::log(at.q.rho / unit))});
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
  std::optional<std::string> nonexistence() const override { return none_; }

  Equilibrium solve(const SolveOptions& options) const override {
    if (motion_.nu == 0.0) return at_rest();
    if (none_) {
      Equilibrium out;
      out.status = SolveStatus::none_exists;
      out.message = *none_;
      return out;
    }
    return SpatialSolve(*equations_, motion_.nu, options).run();
  }
  SearchResult search(const SearchOptions& options) const override {
    if (!none_) return SpatialSearch(*equations_, motion_.nu, options).run();
    SearchResult out;
    out.status = SearchStatus::complete;
    out.message = *none_;
    return out;
  }

  std::optional<Spectrum> spectrum(const Equilibrium& solved) const override {
    const StatedFamily<SpatialEquations> family(*equations_);
    return family_spectrum(family, solved, motion_.nu);
  }

  Certificate certify(const Equilibrium& equilibrium) const override {
    Certificate out = begun(potential(), equilibrium.q);
    if (!out.reason.empty()) return out;
    if (none_) {
      out.reason = *none_;
      return out;
    }
    const StatedBoxes<SpatialEquations> boxes{*equations_, motion_.nu};
    const SpatialBoxes stated(*equations_, motion_.nu, Inputs::decimals);
    const ReducedVector<3> x = equations_->unknowns(equilibrium.q);
    const Krawczyk test(boxes, x);
    const auto proof = prove_solution(test, x, "xi, zeta, alpha", out);
    if (!proof.proven) return out;
    const StretchBox solution = stated.stretch(proof.solution);
    const auto axis = stated.axis(proof.solution);
    if (!axis) {
      out.reason = "the squares of nu's components are not proven to be positive there";
      return out;
    }
    double bound = (Interval(equilibrium.q.rho) / solution.rho - Interval(1.0)).magnitude();
    bound = std::max(bound, SpatialEquations::bound_factor * proof.error_bound);
    for (int k = 0; k < 3; ++k) {
      const Interval off =
          Interval(equilibrium.nu[k]) / (*axis)[k] / as_input(motion_.nu, Inputs::decimals);
      if (off.apart_from(Interval(1.0 - allowed_error, 1.0 + allowed_error))) {
        out.reason = "proven not to be a solution: its nu has other components";
        return out;
      }
    }
    std::optional<StretchBox> unique;
    const double t = equilibrium.q.alpha / std::sqrt(equilibrium.q.xi * equilibrium.q.zeta);
    const double spread = std::max(2.5 * bound / (1.0 - t * t), proof.error_bound);
    if (const auto box = test.unique_within(spread)) unique = stated.stretch(*box);
    conclude(unique, solution, bound, out);
    require_assumptions(potential(), Inputs::decimals, out);
    return out;
  }
  SpectrumEnclosure enclose(const Equilibrium& equilibrium, const Certificate& certificate,
                            const Spectrum& spectrum) const override {
    if (!certificate.proven) throw std::invalid_argument("a spectrum needs a proven equilibrium");
    const SpatialBoxes stated(*equations_, motion_.nu, Inputs::decimals);
    const StretchBox& at = certificate.solution;
    const BasicStretch<Interval> q{at.alpha, at.xi, at.zeta, at.rho};
    const Box<3> x{at.xi, at.zeta, stretch_coordinate(at.alpha / sqrt(at.xi * at.zeta))};
    const auto axis = stated.axis(x);
    if (!axis) throw std::invalid_argument("a spectrum needs a proven axis");
    const auto model = with_indexed_coefficients(
        *potential().body_model(),
        [](double c, std::size_t) { return as_input(c, Inputs::decimals); });
    (void)equilibrium;
    return enclose_leaf_spectrum({stated.J(), q, as_input(motion_.nu, Inputs::decimals), *axis,
                                  potential_derivatives<2>(model, q).hessian, true, true, false},
                                 spectrum);
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
  std::optional<std::string> no_family() const override { return none_; }

 private:
  /// x of an interval of tanh a = tanh ln x, within (-1, 1).
  static Interval stretch_coordinate(const Interval& t) {
    return sqrt((Interval(1.0) + t) / (Interval(1.0) - t));
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
