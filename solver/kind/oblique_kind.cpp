#include "solver/kind/oblique_kind.hpp"

#include "solver/family/anisotropic_family.hpp"
#include "solver/family/branch_switch.hpp"
#include "solver/kind/oriented_event_enclosure.hpp"
#include "solver/proof/anisotropic_enclosure.hpp"
#include "solver/search/anisotropic_search.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"

namespace stationary {
namespace {

class ObliqueKind final : public Kind {
 public:
  ObliqueKind(const Body& body, const Potential& potential, const ObliqueRotation& motion)
      : Kind(body, potential), motion_(motion) {}

  Motion motion() const override { return motion_; }

  Equilibrium solve(const SolveOptions& options) const override {
    if (motion_.nu == 0.0) return at_rest();
    return solve_oblique(body(), potential(), motion_, options);
  }
#ifndef STATIONARY_SMALL_CODE  // pages have no maps
  std::optional<PlanItem> together() const override { return followed_together(); }
  void solve_each(bool spectra, const SolveOptions& options, const NumberRange& all,
                  std::span<AtValue> at) const override {
    solve_oblique_each(body(), potential(), motion_.near, spectra, options, all, at);
  }
#endif
  SearchResult search(const SearchOptions& options) const override {
    return search_oblique(body(), potential(), motion_, options);
  }

  std::optional<Spectrum> spectrum(const Equilibrium& solved) const override {
    return oblique_stability(body(), potential(), solved);
  }
  Certificate certify(const Equilibrium& equilibrium) const override {
    return certify_oblique(body(), potential(), motion_, equilibrium);
  }
  SpectrumEnclosure enclose(const Equilibrium&, const Certificate& certificate,
                            const Spectrum& spectrum) const override {
    return enclose_oblique_spectrum(body(), potential(), motion_, certificate, spectrum);
  }

  std::vector<PlanItem> unknowns() const override {
    return {{"alpha", "an unknown", "nothing makes it 0 where the spin is about no material axis"},
            {"axis", "an unknown, its angle in the plane of axes 1 and 2",
             "compatibility: nu is an eigenvector of the locked inertia"},
            {"xi, zeta, rho", "5 equations with alpha and the axis",
             potential().is_separable()
                 ? "the balance; rho's has no other unknown in it, and a search takes it apart"
                 : "the balance"}};
  }
  PlanItem spectrum_plan() const override {
    constexpr const char* why = "no reflection makes blocks of the dynamics about an oblique axis";
    if (potential().holds_volume())
      return {"spectrum", "4 modes from the whole problem, by a structure-preserving method", why};
    return {"spectrum", "5 modes from the whole problem, by a structure-preserving method", why};
  }
  std::string_view default_start() const override { return "the families connected to rest"; }

  AnyFamily family(const FamilyParameter& parameter, const FamilyOutputs& outputs,
                   const Stretch&) const override {
    return oblique_family(body(), potential().anisotropic(),
                          {.nu = motion_.nu, .parameter = parameter, .spectrum = outputs.spectrum},
                          motion_.near.value_or(Branch::i));
  }
  std::optional<Beginning> beginning(EventType event, const Member& at,
                                     std::optional<Branch> branch, const Interval&) const override {
    if (event != EventType::oblique || !branch) return std::nullopt;
    const auto start =
        leave_straight(oblique_family(body(), potential().anisotropic(),
                                      {.nu = at.nu, .parameter = {}, .spectrum = false}, *branch),
                       at, *branch);
    if (!start) return std::nullopt;
    return Beginning{ObliqueRotation{start->parameter, *branch}, start->q};
  }
  std::optional<NormalForm> normal_form(const FamilyParameter& parameter, EventType event,
                                        const Member& member) const override {
    return oblique_normal_form(body(), potential(), parameter, event, member);
  }

 private:
  std::optional<EventEnclosure> event_enclosure(const FamilyParameter& parameter, EventType event,
                                                const Member& member) const override {
    return enclose_oblique_event(body(), potential().anisotropic(), parameter, event, member);
  }

  ObliqueRotation motion_;
};

}  // namespace

std::unique_ptr<Kind> oblique_kind(const Body& body, const Potential& potential,
                                   const ObliqueRotation& motion) {
  return std::make_unique<ObliqueKind>(body, potential, motion);
}

}  // namespace stationary
