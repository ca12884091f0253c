// Every tilted motion of one plane at a |nu|, with proof: branch and prune on the balance without
// its tilt (search.hpp) and, of each solution, the signs of nu's squared components. Both proven
// positive: a motion; one proven negative: none; else the box is undecided, as where the axis comes
// to a material one.
#pragma once

#include <array>

#include "lib/balance/tilted_balance.hpp"
#include "lib/body/motion.hpp"
#include "solver/search/model_terms.hpp"
#include "solver/search/search.hpp"

namespace stationary {

/// As search(); all of xi, zeta, rho in the box. nu3 and the other component are taken >= 0: their
/// signs make no other motion. Throws std::invalid_argument unless |nu| is finite and > 0, and for
/// a box search() refuses.
SearchResult search_tilted(const Body& body, const Potential& potential,
                           const TiltedRotation& motion, const SearchOptions& options = {});

/// Narrows (xi, zeta) of a TiltedBoxSystem by the formulas of its model: by the rows of all three stretches, of
/// which those of the plane's axis and of rho have any share of |nu|^2. False where nothing is left.
template <class System>
bool narrow_tilted(const System& system, const StretchTerms& terms, Box<2>& x) {
  if (!terms.any()) return true;
  const bool first = system.plane == TiltPlane::one_three;
  const Interval all = system.square_nu;
  const Interval some = all * Interval(0.0, 1.0);
  const std::array<Interval, 3> rates{system.J.J1 * (first ? some : all),
                                      system.J.J2 * (first ? all : some), system.J.J3 * some};
  std::array<Interval, 3> box{x[0], x[1], system.thickness(x)};
  if (!terms.contract(rates, box)) return false;
  Interval& own = box[first ? 0 : 1];
  const Interval by_rho = box[2] / tilted_slenderness<Interval>(system.J, system.plane);
  if (own.apart_from(by_rho)) return false;
  own = common(own, by_rho);
  for (std::size_t k = 0; k < 2; ++k) {
    if (box[k].apart_from(x[k])) return false;
    x[k] = common(x[k], box[k]);
  }
  return true;
}

}  // namespace stationary
