// The spectrum of a separable isotropic V at omega != 0, off the circle of (iii), by its balanced
// blocks (balanced_blocks.hpp): as block_spectrum(), in fewer operations and with tighter bounds.
#pragma once

#include "lib/balanced/pair_blocks.hpp"
#include "lib/stability/spectrum.hpp"

namespace stationary {

using BalancedBound = BalancedState<Conditioned, Conditioned>;

/// Whether no product of some of its numbers leaves the range of doubles.
bool in_range(const LeadingState& state);

/// blocks, of (i), or (ii) with axes 1 and 2 exchanged, or (iii), and conditioned: of the same
/// motion, and in_range().
Spectrum balanced_spectrum(const BlockFacts& facts, const InPlaneBlocks& blocks,
                           const BalancedBound& conditioned, const SpinUnits& units);
Spectrum balanced_spectrum(const BlockFacts& facts, const NormalBlocks& blocks,
                           const BalancedBound& conditioned, const SpinUnits& units);

}  // namespace stationary
