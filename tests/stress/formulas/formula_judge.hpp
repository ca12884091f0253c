// Everything that is claimed of a random formula's case, held against 50 digits and against
// Newton's method from many starts, both with the tester's own evaluation of the formula.
#pragma once

#include <string>
#include <vector>

#include "tests/stress/formulas/random_formula.hpp"

namespace stationary::stress {

struct FormulaTally {
  long cases = 0;
  long anisotropic = 0;
  long poles = 0;
  long refused = 0;   ///< as input, with a message
  long searches = 0;  ///< one a case
  long undecided = 0;
  long proven = 0;  ///< solutions
  long none = 0;    ///< searches that proved that there is none in the box
  long certified = 0;
  long rows = 0;         ///< of followed sheets
  long domain_ends = 0;  ///< of those
  std::vector<std::string> faults;

  FormulaTally& operator+=(const FormulaTally& other);
};

/// What the tester is told falsely, to show that it sees.
struct Falsified {
  double bounds = 1.0;          ///< every error bound times this
  bool without_domain = false;  ///< the program is not told of the domain
};

/// `count` cases of one seed; the order of the faults is that in which the threads came by.
FormulaTally judged_formulas(long count, std::uint64_t seed, const Falsified& how = {},
                             int threads = 1);

std::string text_of(const FormulaTally& tally);

}  // namespace stationary::stress
