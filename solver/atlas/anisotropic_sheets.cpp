#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lib/balance/anisotropic_balance.hpp"
#include "lib/number/elementary.hpp"
#include "solver/atlas/sheet_source.hpp"
#include "solver/family/anisotropic_family.hpp"
#include "solver/proof/anisotropic_enclosure.hpp"
#include "solver/search/anisotropic_search.hpp"

namespace stationary {
namespace {

constexpr double right_angle = 0.5 * std::numbers::pi;

class AnisotropicSheets final : public SheetSource {
 public:
  explicit AnisotropicSheets(const Problem& problem)
      : problem_(problem), V_(problem_.potential().anisotropic()) {
    if (branch() != Branch::iii && !V_.shear_free())
      throw std::invalid_argument("V_alpha = 0 at alpha = 0, for sheets about axis 1 or 2");
  }

  Branch branch() const override { return problem_.branch(); }

  SearchResult search(double nu, const SearchOptions& options) const override {
    return search_anisotropic(problem_, nu, options);
  }
  std::optional<KindCover> cover(double from, double to, const SearchOptions& options,
                                 bool classes) const override {
    return cover_oriented(problem_, false, from, to, options, classes);
  }
  std::optional<StabilityClass> proven_class(const Equilibrium& at, Inputs inputs) const override {
    return proven_class_of(problem_, at, inputs);
  }

  std::vector<Place> at_rest(const SolveOptions& options) const override {
    return places_at_rest(problem_, options);
  }

  /// Of an even V in (iii): that with alpha = 0, then that with any other.
  int families() const override { return bends() ? 2 : 1; }
  int family_of(const Place& at) const override { return bends() && at.q.alpha != 0.0 ? 1 : 0; }
  AnyFamily family(int which, bool spectrum) const override {
    return anisotropic_family(problem_.body(), V_, branch(), which == 1,
                              {.parameter = {}, .spectrum = spectrum});
  }

  Place canonical(const Place& at) const override {
    return V_.even_in_alpha() ? mirrored_upwards(at) : at;
  }

  EventType leaves_by() const override { return bends() ? EventType::shear : EventType::none; }
  bool leaves_at(const Member& at) const override { return at.q.alpha == 0.0; }
  DepartureResult departure(Branch, const Member& at, double) const override {
    return leave_mirror(family(1, false), at, branch());
  }

 private:
  bool bends() const { return branch() == Branch::iii && V_.even_in_alpha(); }

  Problem problem_;
  const AnisotropicPotential& V_;
};

class ObliqueSheets final : public SheetSource {
 public:
  ObliqueSheets(const Body& body, const Potential& potential)
      : body_(body), potential_(potential), V_(potential_.anisotropic()) {}

  Branch branch() const override { return Branch::i; }
  bool oblique() const override { return true; }

  SearchResult search(double nu, const SearchOptions& options) const override {
    return search_oblique(body_, potential_, {nu}, options);
  }
  std::optional<KindCover> cover(double from, double to, const SearchOptions& options,
                                 bool classes) const override {
    return cover_oriented({body_, potential_, Branch::i}, true, from, to, options, classes);
  }
  std::optional<StabilityClass> proven_class(const Equilibrium& at, Inputs inputs) const override {
    const ObliqueRotation motion{hypotenuse(at.nu[0], at.nu[1])};
    const Certificate proof = certify_oblique(body_, potential_, motion, at, inputs);
    if (!proof.proven) return std::nullopt;
    return enclose_oblique_spectrum(body_, potential_, motion, proof, {}, inputs).verdict;
  }

  /// About either axis of inertia, unless the families about these axes are branches (i), (ii).
  std::vector<Place> at_rest(const SolveOptions& options) const override {
    if (V_.shear_free()) return {};
    const Equilibrium rest = solve(Problem(body_, potential_, Branch::iii), 0.0, options);
    if (rest.status != SolveStatus::solved) return {};
    return {Place{rest.q, 0.0}, Place{rest.q, right_angle}};
  }

  /// By the axis it is nearer to.
  int families() const override { return 2; }
  int family_of(const Place& at) const override {
    return std::abs(at.axis) > 0.5 * right_angle ? 1 : 0;
  }
  AnyFamily family(int which, bool spectrum) const override {
    return oblique_family(body_, V_, {.parameter = {}, .spectrum = spectrum},
                          which == 0 ? Branch::i : Branch::ii);
  }

  Place canonical(const Place& at) const override {
    return V_.even_in_alpha() ? mirrored_upwards(at) : at;
  }

  EventType leaves_by() const override {
    return V_.shear_free() ? EventType::oblique : EventType::none;
  }
  bool leaves_at(const Member& at) const override { return at.q.alpha == 0.0; }
  DepartureResult departure(Branch parent, const Member& at, double) const override {
    return leave_mirror(oblique_family(body_, V_, {.parameter = {}, .spectrum = false}, parent), at,
                        parent);
  }

 private:
  Body body_;
  Potential potential_;
  const AnisotropicPotential& V_;
};

}  // namespace

std::unique_ptr<SheetSource> anisotropic_sheets(const Problem& problem) {
  return std::make_unique<AnisotropicSheets>(problem);
}

std::unique_ptr<SheetSource> oblique_sheets(const Body& body, const Potential& potential) {
  return std::make_unique<ObliqueSheets>(body, potential);
}

}  // namespace stationary
