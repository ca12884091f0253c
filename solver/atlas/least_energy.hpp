// Which of the motions of an atlas has the least energy at each |pi|: the one that a body comes to
// which loses energy and keeps its angular momentum. On every sheet
//
//   dE = |nu| d|pi|,
//
// so that E between two rows is the cubic in |pi| with the slopes |nu| at both, and the least of all
// sheets is the lower envelope of such pieces. The |pi| at which two motions have one energy is then
// solved for, and so is the place where a sheet leaves the box. Where |pi| turns, twice, along a sheet
// it may pass from one of its parts to another of them. It is of the motions listed: spins about the
// material axes, tilted and oblique ones with nu in the atlas's range; two-polar motions are left
// out, and so is what lies beyond the range or the box.
#pragma once

#include <vector>

#include "solver/atlas/atlas.hpp"

namespace stationary {

/// At an end of a piece: |pi|, and E and |nu| of the motion.
struct LeastEnergyEnd {
  double momentum;
  double energy;
  double spin;
};

/// One part of a sheet, along which |pi| does not turn, has the least energy from `from` to `to`.
struct LeastEnergyPiece {
  int sheet;  ///< its number
  LeastEnergyEnd from;
  LeastEnergyEnd to;
};

/// Ascending in |pi|, of the motions whose stretches are in the box of an atlas; where no sheet listed
/// has one there is no piece, nor any once box.stop is true. Solves for motions with the sheets' arcs, which one thread may do at a time.
std::vector<LeastEnergyPiece> least_energy(const std::vector<AtlasSheet>& sheets,
                                           const SearchOptions& box);

}  // namespace stationary
