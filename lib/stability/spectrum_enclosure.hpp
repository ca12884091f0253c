// What is proven of the spectrum of a stationary motion whose state is known in intervals: an
// enclosure of every Lambda = s^2, the number of negative directions of the second variation and
// the class, each for every stationary motion in the intervals.
//
// The block forms of linearization.hpp in interval arithmetic; roots by discs (root_discs.hpp),
// counts from the signs of minors. What the intervals do not decide is not claimed: an enclosure
// that holds 0 has no sign, two Lambda whose discs touch may be a double root or a complex pair.
#pragma once

#include <array>
#include <optional>

#include "lib/number/root_discs.hpp"
#include "lib/number/sloped.hpp"
#include "lib/stability/linearization.hpp"
#include "lib/stability/spectrum.hpp"

namespace stationary {

struct SpectrumEnclosure {
  int modes = 0;  ///< as Spectrum has them
  /// Of the modes of the Spectrum it was made for, in its order; exactly 0 where a symmetry forces
  /// a zero.
  std::array<ComplexInterval, 5> lambda;
  std::optional<int> negative;            ///< Spectrum::negative
  std::optional<StabilityClass> verdict;  ///< never marginal, which is no statement
};

/// What must be known exactly, beside the state.
struct EnclosureFacts {
  Branch branch;
  bool at_rest;            ///< nu = 0
  bool material_symmetry;  ///< J1 = J2 and V isotropic
  bool circle;             ///< xi = zeta exactly; only told with material_symmetry or at rest
  bool rho_coupled;
  bool isotropic = true;  ///< as BlockFacts has them
  bool volume_held = false;
};

/// state at alpha = 0, V even in alpha. approximate is only used for the order of the modes.
SpectrumEnclosure enclose_spectrum(const EnclosureFacts& facts,
                                   const StraightState<Interval>& state,
                                   const Spectrum& approximate);
/// Of all states along a curve.
SpectrumEnclosure enclose_spectrum(const EnclosureFacts& facts, const StraightState<Sloped>& state,
                                   const Spectrum& approximate);

/// Likewise of a two-polar motion with lambda != mu (two_polar_spectrum()): state.xi, zeta, omega
/// are lambda, mu, omega. wobbles: s3 is not exactly 0.
SpectrumEnclosure enclose_two_polar_spectrum(const StraightState<Interval>& state,
                                             const Interval& theta_dot, bool wobbles,
                                             const Spectrum& approximate, bool volume_held = false);

}  // namespace stationary
