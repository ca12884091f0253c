// The modes of a leaf whose Lambda come too close to each other, or to zero, for vectors in double:
// by iterations in pairs of doubles. Lambda are eigenvalues of a skew-symmetric matrix where E'' is
// definite, else of H^2 in Van Loan's square-reduced form; vectors are those of the least singular
// value of H - s, by inverse iteration. Bounds are first-order estimates, made large by the overlap of
// the left and right vectors, which vanishes where two Lambda meet. Some tens of times slower than
// reversible_leaf.hpp and whole_leaf.hpp.
// Source: C. F. Van Loan, Lin. Alg. Appl. 61 (1984), 233.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "lib/leaf/leaf_modes.hpp"
#include "lib/leaf/symplectic_leaf.hpp"

namespace stationary {

struct IteratedMode {
  std::complex<double> lambda = 0.0;
  double error = 0.0;
  int energy = 0;
  bool forced = false;
};

/// As many as the leaf has pairs; of conjugates that with im > 0 first. definite: E'' is positive.
std::vector<IteratedMode> iterated_modes(const Leaf& leaf, const LeafFacts& facts, bool definite);

/// x of J E'' x = s x, in the leaf's own coordinates.
struct LeafVector {
  std::vector<std::complex<double>> x;
  double residual;  ///< |J E'' x - s x| in the coordinates made alike in size, over |J E''| |x|
};

/// before: how many vectors of the same s are others; each is orthogonal to these.
LeafVector leaf_vector(const Leaf& leaf, std::complex<double> s, std::size_t before);

}  // namespace stationary
