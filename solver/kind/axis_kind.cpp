#include "solver/kind/axis_kind.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "solver/family/anisotropic_family.hpp"
#include "solver/kind/oriented_event_enclosure.hpp"
#include "solver/kind/sheared_kind.hpp"
#include "solver/motion/body_circle.hpp"
#include "solver/search/search_message.hpp"
#include "solver/solve/nonexistence.hpp"
#include "solver/solve/stability.hpp"

namespace stationary {
namespace {

/// Of a potential that is not isotropic.
PlanItem oriented_spectrum_plan(const AnisotropicPotential& V, double nu) {
  const bool held = V.body().volume.has_value();
  if (V.shear_free() && nu != 0.0) {
    return {"spectrum",
            std::string(held ? "4" : "5") +
                " modes from blocks where alpha = 0, else from the whole problem",
            "V_alpha = 0 at alpha = 0: reflections split the dynamics about a material axis"};
  }
  return {"spectrum",
          std::to_string((nu == 0.0 ? 4 : 5) - int(held)) +
              " modes from the whole problem, by a structure-preserving method",
          "V_alpha != 0 at alpha = 0, or not known to vanish, or nu = 0: no blocks"};
}

/// Of a body whose volume is held: a mode less.
PlanItem held_volume_plan(const AxisRotation& motion) {
  constexpr const char* why =
      "alpha = 0 and det S held: rho's velocity is that of xi and zeta, the leaf has two "
      "dimensions "
      "less";
  if (motion.nu == 0.0) return {"spectrum", "3 modes from 1 block: alpha, xi, zeta (3)", why};
  switch (motion.branch) {
    case Branch::i:
      return {"spectrum", "4 modes from 2 blocks: xi, zeta (2) and alpha, pi2, pi3 (2)", why};
    case Branch::ii:
      return {"spectrum", "4 modes from 2 blocks: xi, zeta (2) and alpha, pi1, pi3 (2)", why};
    case Branch::iii:
      break;
  }
  return {"spectrum", "4 modes from 2 blocks: pi1, pi2 (1) and alpha, xi, zeta (3)", why};
}

class AxisKind final : public Kind {
 public:
  AxisKind(const Body& body, const Potential& potential, const AxisRotation& motion)
      : Kind(body, potential), motion_(motion), problem_(body, potential, motion.branch) {
    if (motion.branch == Branch::iii && potential.may_shear())
      sheared_ = sheared_kind(body, potential, ShearedAxis::third, motion, motion.nu);
  }

  Motion motion() const override { return motion_; }

  Equilibrium solve(const SolveOptions& options) const override {
    if (options.start && is_sheared(*options.start)) {
      if (motion_.nu != 0.0) return sheared_->solve(options);
      SolveOptions straight = options;  // at rest alpha = 0
      straight.start->alpha = 0.0;
      return solve(straight);
    }
    Equilibrium out = stationary::solve(problem_, motion_.nu, options);
    const bool look = options.search && !options.start && options.method == Method::automatic;
    if (sheared_ && motion_.nu != 0.0 && look && out.status == SolveStatus::not_found)
      return or_sheared(std::move(out), options);
    return out;
  }
  SearchResult search(const SearchOptions& options) const override {
    SearchResult out = stationary::search(problem_, motion_.nu, options);
    if (sheared_ && motion_.nu != 0.0 && out.status != SearchStatus::interrupted)
      join(sheared_->search(options), options, out);
    return out;
  }
  std::optional<std::string> nonexistence() const override {
    if (sheared_) return std::nullopt;
    return nonexistence_reason(problem_, motion_.nu);
  }

  std::optional<Spectrum> spectrum(const Equilibrium& solved) const override {
    if (is_sheared(solved.q)) return sheared_->spectrum(solved);
    return stability(problem_, solved);
  }
  Certificate certify(const Equilibrium& equilibrium) const override {
    if (is_sheared(equilibrium.q)) return sheared_->certify(equilibrium);
    return stationary::certify(problem_, equilibrium);
  }
  SpectrumEnclosure enclose(const Equilibrium& equilibrium, const Certificate& certificate,
                            const Spectrum& spectrum) const override {
    if (is_sheared(equilibrium.q)) return sheared_->enclose(equilibrium, certificate, spectrum);
    return enclose_spectrum(problem_, equilibrium, certificate, spectrum);
  }

  std::vector<PlanItem> unknowns() const override {
    std::vector<PlanItem> out = problem_.plan();
    if (sheared_)
      out.front() = {"alpha", "0 from rest; an unknown from a start with another",
                     "isotropic but for gravity, J1 != J2: alpha != 0 asks for W_t = 0"};
    return out;
  }
  /// The blocks that alpha = 0 and an isotropic potential split the linearization into.
  PlanItem spectrum_plan() const override {
    const auto [branch, nu] = motion_;
    if (!potential().is_isotropic()) return oriented_spectrum_plan(potential().anisotropic(), nu);
    constexpr const char* split = "alpha = 0 and an isotropic potential: reflections split the ";
    if (potential().holds_volume()) return held_volume_plan(motion_);
    const bool separable = potential().is_separable();
    if (nu == 0.0) {
      return {"spectrum",
              separable ? "4 modes from 2 blocks: rho (1) and alpha, xi, zeta (3)"
                        : "4 modes from 1 block: alpha, xi, zeta, rho (4)",
              "at rest there is no angular momentum, the leaf has 8 dimensions"};
    }
    std::string how = "5 modes from ";
    if (branch != Branch::iii) {
      how += branch == Branch::i ? "2 blocks: xi, zeta, rho (3) and alpha, pi2, pi3 (2)"
                                 : "2 blocks: xi, zeta, rho (3) and alpha, pi1, pi3 (2)";
    } else if (separable) {
      how += "3 blocks: pi1, pi2 (1), rho (1) and alpha, xi, zeta (3)";
    } else {
      how += "2 blocks: pi1, pi2 (1) and alpha, xi, zeta, rho (4)";
    }
    return {"spectrum", how, std::string(split) + "10-dimensional leaf of fixed |pi|"};
  }
  std::string_view default_start() const override { return "the solution connected to rest"; }

  AnyFamily family(const FamilyParameter& parameter, const FamilyOutputs& outputs,
                   const Stretch& start) const override {
    if (is_sheared(start)) return sheared_->family(parameter, outputs, start);
    return axis_family(problem_,
                       {.nu = motion_.nu,
                        .parameter = parameter,
                        .spectrum = outputs.spectrum,
                        .errors = outputs.errors,
                        .energy = outputs.energy},
                       start.alpha != 0.0);
  }
  /// About axis 1 or 2 compatibility asks for alpha = 0, which may leave a force V_alpha.
  bool from_rest() const override {
    return motion_.branch == Branch::iii || potential().is_isotropic() ||
           potential().anisotropic().shear_free();
  }

  std::optional<std::string> no_family(const FamilyParameter& parameter,
                                       const Stretch& start) const override {
    if (is_sheared(start)) return sheared_->no_family(parameter, start);
    const bool straight = motion_.branch != Branch::iii && !potential().is_isotropic();
    if (!straight || keeps_shear_free(potential().anisotropic(), parameter)) return std::nullopt;
    if (from_rest())
      return "at its other values alpha = 0, which compatibility asks for about this axis, leaves "
             "a "
             "force V_alpha; with branch = \"oblique\" the axis may turn";
    return "at rest alone there is an ellipsoid: about this axis compatibility asks for alpha = 0, "
           "which leaves a force V_alpha";
  }
  /// A vertical branch.
  bool follows_continuum() const override { return true; }
  /// The end of a family whose axis has come to this one.
  std::optional<Beginning> beginning(EventType event, const Member& at,
                                     std::optional<Branch> branch, const Interval&) const override {
    if (branch || (event != EventType::tilt && event != EventType::oblique)) return std::nullopt;
    const int own = axis(motion_.branch);
    Vector3<double> across = at.angular_velocity;
    across[own] = 0.0;
    if (!(across.norm() <= 1e-6 * at.angular_velocity.norm())) return std::nullopt;
    return Beginning{AxisRotation{motion_.branch, at.angular_velocity[own]}, at.q, true};
  }

  std::optional<NormalForm> normal_form(const FamilyParameter& parameter, EventType event,
                                        const Member& member) const override {
    if (is_sheared(member.q)) return std::nullopt;
    const auto circle = circle_with(event, parameter, member);
    if (!circle) return std::nullopt;
    return stationary::normal_form(problem_, parameter, *circle, event, member);
  }

 private:
  std::optional<EventEnclosure> event_enclosure(const FamilyParameter& parameter, EventType event,
                                                const Member& member) const override {
    if (is_sheared(member.q)) return sheared_->enclose_event(parameter, event, member);
    if (!potential().is_isotropic())
      return enclose_oriented_event(problem_, parameter, event, member);
    if (!has_enclosure(event)) return std::nullopt;
    const auto circle = circle_with(event, parameter, member);
    if (!circle) return std::nullopt;
    return stationary::enclose_event(problem_, parameter, *circle, event, member);
  }

  /// Of an isotropic body with gravity about axis 3.
  bool is_sheared(const Stretch& q) const { return sheared_ && q.alpha != 0.0; }

  /// What a search of the motions with alpha != 0 adds to one of the others.
  void join(SearchResult more, const SearchOptions& options, SearchResult& out) const {
    const auto append = [](auto& to, auto& from) {
      to.insert(to.end(), std::make_move_iterator(from.begin()),
                std::make_move_iterator(from.end()));
    };
    append(out.solutions, more.solutions);
    append(out.unproven, more.unproven);
    append(out.undecided, more.undecided);
    for (auto* list : {&out.solutions, &out.unproven})
      std::ranges::sort(*list, {}, [](const Equilibrium& at) {
        return std::tuple(at.q.xi, at.q.zeta, at.q.rho, at.q.alpha);
      });
    out.boxes += more.boxes;
    if (more.status != SearchStatus::complete) out.status = more.status;
    out.message = search_message(options, out.status, out.solutions.size(), out.undecided) +
                  unproven_text(out.unproven.size());
  }
  /// Where none with alpha = 0 was found: one with another.
  Equilibrium or_sheared(Equilibrium none, const SolveOptions& options) const {
    Equilibrium found = sheared_->solve(options);
    if (found.status != SolveStatus::not_found) return found;
    none.message += " With alpha != 0: " + found.message + ".";
    return none;
  }

  /// The circle that the member's sheet keeps; at its end, the one that it breaks there, nothing where this body
  /// has none to be broken.
  std::optional<Circle> circle_with(EventType event, const FamilyParameter& parameter,
                                    const Member& member) const {
    if (const Circle broken = broken_circle(event); broken != Circle::none) {
      if (circle_of(problem_, parameter) != broken) return std::nullopt;
      return broken;
    }
    if (mirror_symmetric(problem_, member.nu) && member.q.xi == member.q.zeta)
      return Circle::xi_zeta;
    const Circle circle = circle_of(problem_, parameter);
    return is_on(circle, member.q) ? circle : Circle::none;
  }

  AxisRotation motion_;
  Problem problem_;
  std::unique_ptr<Kind> sheared_;  ///< its motions with alpha != 0, where there may be any
};

}  // namespace

std::unique_ptr<Kind> axis_kind(const Body& body, const Potential& potential,
                                const AxisRotation& motion) {
  return std::make_unique<AxisKind>(body, potential, motion);
}

}  // namespace stationary
