// Spectra of the rest state's sheet by
//   blocks         the exact blocks at alpha = 0 (lib/stability/spectrum.hpp), with bounds and
//                  classes
//   general        the structure-preserving method on the leaf
//                  (lib/stability/general_spectrum.hpp), likewise
//   eigen-qr-11x11 Eigen's real Schur form of the Lie-Poisson equations linearized in all of
//                  z = (pi, q, p), as one would without the leaf: eigenvalues alone
// from the equilibrium in double; the first two begin with its correction. Errors are those of each
// Lambda = s^2, relative to itself, against 50 digits.
#pragma once

#include <vector>

#include "tests/bench/measurement.hpp"
#include "tests/bench/work_precision/references.hpp"

namespace stationary::bench {

struct Spectra {
  std::string model;
  Problem problem;
  std::vector<Equilibrium> motions;
  std::vector<std::vector<ExactLambda>> exact;
};

/// At count nu, evenly spaced from 0 (left out) to 0.5.
Spectra spectra(std::string_view model, Branch branch, int count);

/// `of` must outlive the entries.
void add_spectra(const Spectra& of, const std::string& what, std::vector<Entry>& out);

}  // namespace stationary::bench
