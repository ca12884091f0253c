// A random case with a formula for its potential, kept both as text and as a tree that is evaluated
// here, apart from the library: stored energies of the literature plus terms made from a grammar
// with every function and operator of the formula table.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/stress/judge/jet.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary::stress {

enum class Operation {
  number,  ///< a decimal, kept as text
  alpha,
  xi,
  zeta,
  rho,
  plus,
  minus,
  times,
  over,
  power,  ///< first^second, second a decimal
  sqrt,
  exp,
  log,
  sin,
  cos,
  tan,
  tanh,
  atan,
  abs,  ///< these three of numbers
  min,
  max
};

struct Term {
  Operation operation;
  std::string text;       ///< of a number
  bool harmless = false;  ///< its argument is positive at every stretch tensor: no condition
  std::vector<std::shared_ptr<const Term>> of;
  std::string spelling;  ///< how the whole is written in the case
};
using TermPointer = std::shared_ptr<const Term>;

/// What became of an evaluation.
template <class T>
struct Evaluated {
  Jet<T> energy;
  bool defined = true;         ///< every argument of log, root and power > 0, no denominator 0
  T nearest = T(1e300);        ///< the smallest of these arguments, and denominators in size
  std::vector<bool> positive;  ///< of every denominator, in order
};

/// At alpha, xi, zeta, rho. T: double or a wide number made from a decimal's text.
template <class T>
Evaluated<T> evaluated(const Term& term, const std::array<T, 4>& q);

struct FormulaCase {
  TermPointer energy;
  TermPointer domain;  ///< must be > 0; none: null
  bool anisotropic = false;
  bool has_pole = false;
  bool has_condition = false;  ///< some argument can change its sign
  std::array<std::string, 3> inertia;
  char branch = 1;  ///< 1, 2, 3: about which axis
  std::string nu;
  std::string text(bool with_domain = true) const;  ///< a case file
};

FormulaCase random_formula_case(support::Random& random);

}  // namespace stationary::stress
