#include "solver/kind/sheared_kind.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "lib/number/elementary.hpp"
#include "solver/family/branch_switch.hpp"
#include "solver/kind/sheared_certificate.hpp"
#include "solver/search/sheared_search.hpp"
#include "solver/solve/family_solve.hpp"

namespace stationary {
namespace {

template <int N>
class ShearedSolve : FamilySolve {
 public:
  ShearedSolve(const ShearedEquations<N>& equations, double nu, const SolveOptions& options)
      : FamilySolve(equations.body, equations.potential, options), equations_(equations), nu_(nu) {}

  Equilibrium run() {
    if (options_.start) {
      const StatedFamily<ShearedEquations<N>> family(equations_);
      Stretch start = *options_.start;
      start.alpha = std::abs(start.alpha);
      by_newton(family, equations_.unknowns(start), nu_, Connection::given_start,
                "Newton from the given start");
      return out_;
    }
    const SearchResult all = search_sheared(equations_, nu_, {.stop = options_.stop});
    out_.status = SolveStatus::not_found;
    out_.message = "exhaustive search: " + all.message;
    if (all.status == SearchStatus::interrupted) {
      out_.status = SolveStatus::interrupted;
      return out_;
    }
    if (all.solutions.empty()) return out_;
    const double unit = cube_root(potential_.volume().value_or(1.0));
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
  const ShearedEquations<N>& equations_;
  double nu_;
};

template <int N>
class ShearedKind final : public Kind {
 public:
  ShearedKind(const Body& body, const Potential& potential, ShearedAxis axis, const Motion& motion,
              double nu)
      : Kind(body, potential),
        motion_(motion),
        nu_(nu),
        axis_(axis),
        none_(no_sheared_motion(body, potential, axis)) {
    if (!none_) equations_.emplace(body, potential, axis, true);
  }

  Motion motion() const override { return motion_; }
  std::optional<std::string> nonexistence() const override {
    return none_is_known() ? none_ : std::nullopt;
  }
  Equilibrium solve(const SolveOptions& options) const override {
    if (nu_ == 0.0) return at_rest();
    if (none_) {
      Equilibrium out;
      out.status = none_is_known() ? SolveStatus::none_exists : SolveStatus::not_found;
      out.message = *none_;
      return out;
    }
    return ShearedSolve<N>(*equations_, nu_, options).run();
  }
  SearchResult search(const SearchOptions& options) const override {
    if (!none_) return search_sheared(*equations_, nu_, options);
    SearchResult out;
    out.status = none_is_known() ? SearchStatus::complete : SearchStatus::undecided;
    out.message = *none_;
    return out;
  }

  std::optional<Spectrum> spectrum(const Equilibrium& solved) const override {
    const StatedFamily<ShearedEquations<N>> family(*equations_);
    return family_spectrum(family, solved, nu_);
  }

  Certificate certify(const Equilibrium& equilibrium) const override {
    if (!none_) return certify_sheared(*equations_, nu_, equilibrium);
    Certificate out;
    out.reason = *none_;
    return out;
  }
  SpectrumEnclosure enclose(const Equilibrium&, const Certificate& certificate,
                            const Spectrum& spectrum) const override {
    return enclose_sheared_spectrum(*equations_, nu_, certificate, spectrum);
  }

  std::vector<PlanItem> unknowns() const override {
    const bool spatial = axis_ == ShearedAxis::in_no_plane;
    std::vector<PlanItem> out{{"alpha", "an unknown, > 0",
                               axis_ == ShearedAxis::third
                                   ? "alpha -> -alpha is a mirror image"
                                   : "alpha -> -alpha, nu2 -> -nu2 is a mirror image"}};
    out.push_back(N == 3 ? PlanItem{"rho", "volume/d", "det S is held"}
                         : PlanItem{"rho", "an unknown", "its balance has the others in it"});
    out.push_back({"xi, zeta", N == 3 ? "3 equations with alpha" : "4 equations with alpha and rho",
                   spatial && N == 3 ? "W_t = 0, compatibility, and the balance less the pressure"
                   : spatial         ? "W_t = 0, compatibility, and the balance"
                   : N == 3          ? "W_t = 0, the axis, and the balance less the pressure"
                                     : "W_t = 0, the axis, and the balance"});
    if (spatial)
      out.push_back({"nu", "closed form", "the eigenvector of S J S with J3 rho^2"});
    else if (axis_ == ShearedAxis::oblique)
      out.push_back({"nu", "closed form", "the eigenvector of S J S with the smaller eigenvalue"});
    return out;
  }
  PlanItem spectrum_plan() const override {
    const std::string modes = std::to_string(N + 1) + " modes from ";
    if (axis_ == ShearedAxis::third)
      return {"spectrum", modes + "the parts that the plane's reflection leaves",
              "nu along axis 3: pi1, pi2 by themselves"};
    return {"spectrum", modes + "the whole problem, by a structure-preserving method",
            "no reflection makes blocks of the dynamics, on the " + std::to_string(2 * N + 2) +
                "-dimensional leaf of fixed |pi|"};
  }
  std::string_view default_start() const override { return "the nearest of an exhaustive search"; }

  AnyFamily family(const FamilyParameter&, const FamilyOutputs& outputs,
                   const Stretch&) const override {
    return std::make_unique<StatedFamily<ShearedEquations<N>>>(
        ShearedEquations<N>(body(), potential(), axis_, outputs.spectrum));
  }
  std::optional<std::string> no_family(const FamilyParameter& parameter,
                                       const Stretch&) const override {
    if (none_ || parameter.kind == FamilyParameter::Kind::nu) return none_;
    return "motions with alpha != 0 of an isotropic body are followed in nu alone";
  }
  std::optional<Beginning> beginning(EventType event, const Member& at,
                                     std::optional<Branch> branch, const Interval&) const override {
    if (axis_ != ShearedAxis::oblique || none_ || event != EventType::oblique || !branch)
      return std::nullopt;
    const auto start = leave_straight(family({}, {.spectrum = false}, at.q), at, *branch);
    if (!start) return std::nullopt;
    return Beginning{ObliqueRotation{start->parameter}, start->q};
  }
  std::optional<NormalForm> normal_form(const FamilyParameter& parameter, EventType event,
                                        const Member& member) const override {
    const auto left = left_at(axis_, event, member);
    if (!left) return std::nullopt;
    return stationary::normal_form({body(), potential(), *left}, parameter, Circle::none, event,
                                   member);
  }

 private:
  std::optional<EventEnclosure> event_enclosure(const FamilyParameter&, EventType event,
                                                const Member& member) const override {
    return enclose_sheared_event(body(), potential(), axis_, event, member);
  }

  /// Whether it is known that there are none; else they are only not sought.
  bool none_is_known() const { return none_ && potential().is_isotropic(); }

  Motion motion_;
  double nu_;
  ShearedAxis axis_;
  std::optional<std::string> none_;
  std::optional<ShearedEquations<N>> equations_;
};

}  // namespace

std::unique_ptr<Kind> sheared_kind(const Body& body, const Potential& potential, ShearedAxis axis,
                                   const Motion& motion, double nu) {
  if (potential.holds_volume())
    return std::make_unique<ShearedKind<3>>(body, potential, axis, motion, nu);
  return std::make_unique<ShearedKind<4>>(body, potential, axis, motion, nu);
}

}  // namespace stationary
