// One stationary ellipsoid of a potential that is not isotropic: S, and of an oblique motion the
// axis, given nu.
//
// With a start: Newton there. Without: the family through the rest state is followed to nu;
// oblique, that which starts at rest about one of the axes of inertia there or, where V is even in
// alpha, which leaves (i) or (ii) at an event `oblique`. Where neither comes to anything branch and
// prune decides (anisotropic_search.hpp). All end in the family's correction with an
// extended-precision residual; what is returned is recomputed in lib, and that decides.
//
// About axis 1 or 2 with a V that is not even in alpha there is as good as never a motion: the
// answer says so, and how far from one the nearest solution of the balance is.
#pragma once

#include <optional>
#include <span>

#include "solver/family/anisotropic_family.hpp"
#include "solver/solve/at_values.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

/// As solve(), of a problem whose potential is not isotropic. options.method: automatic or newton.
Equilibrium solve_anisotropic(const Problem& problem, double nu, const SolveOptions& options);

/// near not given: the family near axis 1 first. nu and -nu are one motion, given with nu1 + nu2 >=
/// 0. Throws std::invalid_argument for an isotropic
/// potential, a nu that is not finite and > 0, or a start that is not positive definite.
Equilibrium solve_oblique(const Body& body, const Potential& potential,
                          const ObliqueRotation& motion, const SolveOptions& options = {});

/// At each |nu| that has no motion yet what solve_oblique() finds without a start, families connected
/// to rest followed once for all. near: as ObliqueRotation has it. spectra: theirs too. all: where they lie. options:
/// search and stop. Throws as solve_oblique().
void solve_oblique_each(const Body& body, const Potential& potential, std::optional<Branch> near,
                        bool spectra, const SolveOptions& options, const NumberRange& all,
                        std::span<AtValue> at);

/// Spectra of many motions of one problem, whose models are made once. The problem must outlive it.
class AnisotropicSpectra {
 public:
  explicit AnisotropicSpectra(const Problem& problem) : problem_(problem) {}

  /// Of a motion as correctly rounded as solve() leaves it. Throws std::invalid_argument of one that
  /// is not solved.
  Spectrum at(const Equilibrium& rounded);
  /// Of one that may be corrected first; nothing where that does not converge.
  std::optional<Spectrum> corrected(const Equilibrium& equilibrium);

 private:
  /// alpha an unknown where the motion has one.
  const AnyFamily& family_of(const Equilibrium& equilibrium);

  const Problem& problem_;
  std::optional<AnyFamily> family_;
  Branch branch_ = Branch::iii;
  bool sheared_ = false;
};

/// Of a solved one.
std::optional<Spectrum> anisotropic_stability(const Problem& problem,
                                              const Equilibrium& equilibrium);
std::optional<Spectrum> oblique_stability(const Body& body, const Potential& potential,
                                          const Equilibrium& equilibrium);

}  // namespace stationary
