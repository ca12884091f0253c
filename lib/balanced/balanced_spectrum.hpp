// The spectrum of a separable isotropic V at omega != 0, off the circle of (iii), by its balanced
// blocks (balanced_blocks.hpp): as block_spectrum(), in fewer operations and with tighter bounds.
#pragma once

#include "lib/balanced/balanced_blocks.hpp"
#include "lib/stability/spectrum.hpp"

namespace stationary {

using BalancedPair = BalancedState<DoubleDouble, double>;
using BalancedBound = BalancedState<Conditioned, Conditioned>;

/// Whether no product of some of its numbers leaves the range of doubles.
bool in_range(const BalancedPair& state);

/// state and conditioned: of the same motion, for (ii) with axes 1 and 2 exchanged, and in_range().
Spectrum balanced_spectrum(const BlockFacts& facts, const BalancedPair& state,
                           const BalancedBound& conditioned, const SpinUnits& units);

}  // namespace stationary
