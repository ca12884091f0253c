#include "solver/kind/two_polar_kind.hpp"

#include "solver/family/two_polar_family.hpp"
#include "solver/kind/two_polar_event_enclosure.hpp"
#include "solver/proof/two_polar_enclosure.hpp"
#include "solver/search/two_polar_search.hpp"
#include "solver/solve/two_polar_equilibrium.hpp"

namespace stationary {
namespace {

class TwoPolarKind final : public Kind {
 public:
  TwoPolarKind(const Body& body, const Potential& potential, const TwoPolarMotion& motion)
      : Kind(body, potential), motion_(motion) {}

  Motion motion() const override { return motion_; }

  Equilibrium solve(const SolveOptions& options) const override {
    return solve_two_polar(body(), potential(), motion_, options);
  }
#ifndef STATIONARY_SMALL_CODE  // pages have no maps
  std::optional<PlanItem> together() const override {
    return PlanItem{
        "cells", "by searches that serve all cells of a block",
        "x is a number of the motion; a cell that no block decides is searched by itself"};
  }
  void solve_each(bool spectra, const SolveOptions& options, const NumberRange& all,
                  std::span<AtValue> at) const override {
    solve_two_polar_each(body(), potential(), motion_, spectra, options, all, at);
  }
#endif
  SearchResult search(const SearchOptions& options) const override {
    return search_two_polar(body(), potential(), motion_, options);
  }

  std::optional<Spectrum> spectrum(const Equilibrium& solved) const override {
    return two_polar_stability(body(), potential(), solved);
  }
  Certificate certify(const Equilibrium& equilibrium) const override {
    return certify_two_polar(body(), potential(), motion_, equilibrium);
  }
  SpectrumEnclosure enclose(const Equilibrium& equilibrium, const Certificate& certificate,
                            const Spectrum& spectrum) const override {
    return enclose_spectrum(body(), potential(), motion_, equilibrium, certificate, spectrum);
  }

  std::vector<PlanItem> unknowns() const override {
    const bool separable = potential().is_separable();
    return {{"alpha", "0, not an unknown",
             "the two-polar form: S is diagonal in the frame that turns at theta_dot"},
            separable ? PlanItem{"rho", "closed form", "separable potential; V_rho'(rho) = 0"}
                      : PlanItem{"rho", "an unknown", "the potential couples it to lambda and mu"},
            {"lambda, mu", separable ? "2 equations" : "3 equations with rho",
             "the balance at the prescribed rates or momenta, searched for globally; S has "
             "xi = lambda, zeta = mu at theta = 0"}};
  }
  PlanItem spectrum_plan() const override {
    if (potential().holds_volume()) {
      return {
          "spectrum",
          "3 modes from 2 blocks: lambda, mu (2) and the wobble of axis 3 (1, none where s3 = 0); "
          "on the circle lambda = mu the 4 modes of branch (iii)",
          "alpha = 0 and det S held: reflections split the 6-dimensional leaf of fixed |pi| and "
          "p_theta"};
    }
    return {"spectrum",
            "4 modes from 2 blocks: lambda, mu, rho (3) and the wobble of axis 3 (1, none where "
            "s3 = 0); on the circle lambda = mu the 5 modes of branch (iii)",
            "alpha = 0 and an isotropic potential: reflections split the 8-dimensional leaf of "
            "fixed |pi| and p_theta"};
  }
  std::string_view default_start() const override { return "a global search"; }

  AnyFamily family(const FamilyParameter& parameter, const FamilyOutputs& outputs,
                   const Stretch&) const override {
    return two_polar_family(
        body(), potential(),
        {.motion = motion_, .parameter = parameter, .spectrum = outputs.spectrum});
  }
  bool from_rest() const override { return true; }
  std::optional<NormalForm> normal_form(const FamilyParameter& parameter, EventType event,
                                        const Member& member) const override {
    return two_polar_normal_form(body(), potential(), motion_, parameter, event, member);
  }

 private:
  std::optional<EventEnclosure> event_enclosure(const FamilyParameter& parameter, EventType event,
                                                const Member& member) const override {
    return enclose_two_polar_event(body(), potential(), motion_, parameter, event, member);
  }

  TwoPolarMotion motion_;
};

}  // namespace

std::unique_ptr<Kind> two_polar_kind(const Body& body, const Potential& potential,
                                     const TwoPolarMotion& motion) {
  return std::make_unique<TwoPolarKind>(body, potential, motion);
}

}  // namespace stationary
