// The balance of a potential in its normal form (normal_form.hpp), as a table of shared terms,
//
//   G_i = sum_k C_ik tau_k - c_i exp(2 x_i),      dG_i/dx_j = sum_k C_ijk tau_k - 2 c_i exp(2 x_i),
//
// in the logarithms x of those of xi, zeta and rho that are unknown, c_i the rates J nu^2 of the
// centrifugal force, with what has to hold where it is defined. C are intervals that hold the exact
// coefficients.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lib/expression/normal_form.hpp"
#include "lib/formula/expression.hpp"

namespace stationary::expression {

/// coefficient * term number `term`.
struct TermEntry {
  int term = 0;
  Interval coefficient;
  /// By which equal coefficients are known, where it is (exact_number.hpp).
  std::optional<Residue> key = {};
};

struct TermTable {
  struct AtomSum {
    Atom::Kind kind = Atom::Kind::base;
    Function function = Function::exp;
    bool positive = false;  ///< N > 0
    std::vector<TermEntry> sum;
  };
  struct Domain {
    std::vector<TermEntry> sum;
    bool positive = true;  ///< else: not 0
  };

  std::vector<int> coordinates;  ///< which of 0, 1, 2 are unknown
  std::vector<Monomial> terms;
  std::vector<AtomSum> atoms;                 ///< each after those that its sum is made of
  std::vector<std::vector<TermEntry>> force;  ///< by row
  std::vector<int> pull;                      ///< the term exp(2 x_i) of each row
  /// By row and column, the upper triangle.
  std::vector<std::vector<std::vector<TermEntry>>> slope;
  std::vector<Domain> domain;
};

/// Of an expression at alpha = 0, xi and zeta its principal stretches. coordinates: ascending.
/// Nothing where it has no normal form with that many terms.
std::shared_ptr<const TermTable> term_table(const Expression& expression,
                                            std::span<const int> coordinates,
                                            std::span<const Interval> parameters);

}  // namespace stationary::expression
