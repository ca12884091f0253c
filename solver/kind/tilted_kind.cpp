#include "solver/kind/tilted_kind.hpp"

#include "solver/family/tilted_family.hpp"
#include "solver/kind/tilted_event_enclosure.hpp"
#include "solver/proof/tilted_enclosure.hpp"
#include "solver/search/tilted_search.hpp"
#include "solver/solve/tilted_equilibrium.hpp"

namespace stationary {
namespace {

class TiltedKind final : public Kind {
 public:
  TiltedKind(const Body& body, const Potential& potential, const TiltedRotation& motion)
      : Kind(body, potential), motion_(motion) {}

  Motion motion() const override { return TiltedMotion{motion_.plane, motion_.nu}; }

  Equilibrium solve(const SolveOptions& options) const override {
    if (motion_.nu == 0.0) return at_rest();
    return solve_tilted(body(), potential(), motion_, options);
  }
#ifndef STATIONARY_SMALL_CODE  // pages have no maps
  std::optional<PlanItem> together() const override { return followed_together(); }
  void solve_each(bool spectra, const SolveOptions& options, const NumberRange& all,
                  std::span<AtValue> at) const override {
    solve_tilted_each(body(), potential(), motion_.plane, spectra, options, all, at);
  }
#endif
  SearchResult search(const SearchOptions& options) const override {
    return search_tilted(body(), potential(), motion_, options);
  }

  std::optional<Spectrum> spectrum(const Equilibrium& solved) const override {
    return tilted_stability(body(), potential(), motion_, solved);
  }
  Certificate certify(const Equilibrium& equilibrium) const override {
    return certify_tilted(body(), potential(), motion_, equilibrium);
  }
  SpectrumEnclosure enclose(const Equilibrium&, const Certificate& certificate,
                            const Spectrum& spectrum) const override {
    return enclose_spectrum(body(), potential(), motion_, certificate, spectrum);
  }

  std::vector<PlanItem> unknowns() const override {
    return {{"alpha", "0, not an unknown",
             "isotropic potential: the plane of the axis is a plane of material axes"},
            {"rho", motion_.plane == TiltPlane::one_three ? "sqrt(J1/J3) xi" : "sqrt(J2/J3) zeta",
             "compatibility: the locked inertias of the plane's two axes are equal"},
            {"xi, zeta", "2 equations",
             potential().holds_volume()
                 ? "the part of the balance that knows |nu|, no tilt and no pressure; the volume"
                 : "the balance, its parts that know |nu| and no tilt"},
            {"nu", "closed form", "the rest of the balance gives the squares of its components"}};
  }
  PlanItem spectrum_plan() const override {
    const bool held = potential().holds_volume();
    return {"spectrum",
            held ? "4 modes from the whole problem, by a structure-preserving method"
                 : "5 modes from the whole problem, by a structure-preserving method",
            held ? "no reflection makes blocks of the dynamics about a tilted axis, on the "
                   "8-dimensional leaf of fixed |pi|"
                 : "no reflection makes blocks of the dynamics about a tilted axis, on the "
                   "10-dimensional leaf of fixed |pi|"};
  }
  std::string_view default_start() const override {
    return "the tilts of the sheets connected to rest";
  }

  AnyFamily family(const FamilyParameter&, const FamilyOutputs& outputs,
                   const Stretch&) const override {
    return tilted_family(body(), potential(), motion_.plane, outputs.spectrum);
  }
  std::optional<Beginning> beginning(EventType event, const Member& at,
                                     std::optional<Branch> branch,
                                     const Interval& within) const override {
    if (event != EventType::tilt || !branch) return std::nullopt;
    if (plane_of_tilt(*branch, body(), at.q) != motion_.plane) return std::nullopt;
    const auto family = tilted_family(body(), potential(), motion_.plane, false);
    auto start = just_inside(*family, at.q, at.nu, within);
    if (!start) start = just_inside(*family, at.q, at.nu);
    if (!start) return std::nullopt;
    return Beginning{TiltedMotion{motion_.plane, start->nu}, start->q};
  }
  std::optional<NormalForm> normal_form(const FamilyParameter&, EventType event,
                                        const Member& member) const override {
    return tilted_normal_form(body(), potential(), motion_.plane, event, member);
  }

 private:
  std::optional<EventEnclosure> event_enclosure(const FamilyParameter&, EventType event,
                                                const Member& member) const override {
    return enclose_tilted_event(body(), potential(), motion_.plane, event, member);
  }

  TiltedRotation motion_;
};

}  // namespace

std::unique_ptr<Kind> tilted_kind(const Body& body, const Potential& potential,
                                  const TiltedRotation& motion) {
  return std::make_unique<TiltedKind>(body, potential, motion);
}

}  // namespace stationary
