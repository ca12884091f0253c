// One tilted motion: S and the axis, given |nu|.
//
// With a start: Newton on the family's equations (tilted_family.hpp) there. Without: the sheets of
// the two branches of the plane's axes are followed from the rest state to where they tilt, that is
// to where the locked inertias of the plane's axes are equal, and the tilted family that begins
// there to |nu|. Both end in the family's correction with an extended-precision residual; what is
// returned is recomputed in lib, and that decides.
#pragma once

#include <optional>
#include <span>

#include "solver/family/tilted_family.hpp"
#include "solver/solve/at_values.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

/// options: start, method (automatic or newton: the same) and stop. Throws std::invalid_argument
/// for a nu that is not finite and > 0 or a start that is not positive definite with alpha = 0.
Equilibrium solve_tilted(const Body& body, const Potential& potential, const TiltedRotation& motion,
                         const SolveOptions& options = {});

/// At each |nu| that has no motion yet what solve_tilted() finds without a start, sheets followed once
/// for all. spectra: theirs too. all: where they lie. options: search and stop. Throws as solve_tilted().
void solve_tilted_each(const Body& body, const Potential& potential, TiltPlane plane, bool spectra,
                       const SolveOptions& options, const NumberRange& all, std::span<AtValue> at);

/// Of a solved one.
std::optional<Spectrum> tilted_stability(const Body& body, const Potential& potential,
                                         const TiltedRotation& motion,
                                         const Equilibrium& equilibrium);

}  // namespace stationary
