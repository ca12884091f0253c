// The rest state of an anisotropic body, where its families start: grad V = 0, alpha among the
// unknowns.
//
// Where the potential's isotropic part has a rest state that is known, Newton from there, the
// fibres made stiff bit by bit where that fails. Where there is no such part (a written-out
// anisotropic potential) the minimum of V nearest to S = 1 among those that Newton finds from a few
// stretches around it; where it finds none, among those that an exhaustive search finds.
#pragma once

#include <optional>
#include <string>

#include "solver/solve/solve.hpp"

namespace stationary {

struct AnisotropicRest {
  std::optional<Stretch> q;
  std::string message;  ///< where none was found, which does not mean that there is none
};

/// options.search: whether the exhaustive search is allowed, options.stop ends it. Adds to counts.
/// The potential is not isotropic (std::bad_variant_access otherwise).
AnisotropicRest anisotropic_rest(const Body& body, const Potential& potential,
                                 const SolveOptions& options, Counts& counts);

}  // namespace stationary
