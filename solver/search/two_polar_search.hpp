// Every two-polar motion at given rates or momenta, with proof (branch_and_prune.hpp): ellipses
// lambda > mu, each for itself and its mirror image (mu, lambda), and circles lambda = mu, which
// only rates or s3 = p_theta have (as decimals they are taken to be equal where they are as
// doubles).
//
// Rates on a line of solutions (rates_verdict()) are not searched and said by name; another
// continuum ends as undecided boxes.
#pragma once

#include <memory>

#include "solver/motion/family_parameter.hpp"
#include "solver/motion/two_polar_motion.hpp"
#include "solver/search/search.hpp"

namespace stationary {

/// Solutions descending in lambda/mu (circles last), then ascending in lambda; the xi and zeta of
/// undecided boxes are lambda and mu.
/// Throws as require_two_polar(), and for a box search() refuses.
SearchResult search_two_polar(const Body& body, const Potential& potential,
                              const TwoPolarMotion& motion, const SearchOptions& options = {});

/// The same of many motions that differ in one number. A search with that number an interval, coarse,
/// serves a block of the range's values; smaller blocks go on with the boxes that it leaves, and so does each
/// motion. One that this leaves undecided is searched by itself.
class TwoPolarSearches {
 public:
  /// motion: its other number. Body, potential and the range's values must outlive it. Throws as search_two_polar().
  TwoPolarSearches(const Body& body, const Potential& potential, const TwoPolarMotion& motion,
                   const NumberRange& range, const SearchOptions& options = {});
  ~TwoPolarSearches();

  TwoPolarMotion motion_at(double value) const;
  /// At one of the range's values. What was asked for before changes nothing of it.
  SearchResult at(double value);
  long shared() const { return shared_; }  ///< answers that searches of blocks began
  long boxes() const { return boxes_; }    ///< examined so far, those of blocks too

  /// The blocks of one type of potential and of motion.
  class Blocks;

 private:
  const Body& body_;
  const Potential& potential_;
  TwoPolarMotion motion_;
  NumberRange range_;
  SearchOptions options_;
  long shared_ = 0;
  long boxes_ = 0;
  std::unique_ptr<Blocks> blocks_;
};

}  // namespace stationary
