// The steps every certificate takes (certify.hpp): a solution proven near x, and that x is not
// provably off it; then that there is no second one within the error bound.
#pragma once

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>

#include "solver/proof/certify.hpp"
#include "solver/proof/krawczyk.hpp"

namespace stationary {

/// Units in the last place by which a solution may be off before it is none.
constexpr double allowed_error = 0x1p-50;

/// What every certificate of a potential begins with: what it takes for granted, and that its
/// formula is defined at q.
inline Certificate begun(const Potential& potential, const Stretch& q) {
  Certificate out;
  out.assuming = potential.assumptions();
  if (const char* inequality = violated_inequality(q)) {
    out.reason = std::string("S is not positive definite: it needs ") + inequality;
    return out;
  }
  for (const ConditionValue& each : potential.conditions_at(q))
    if (!each.holds()) out.reason = "beyond the domain of the potential: " + each.condition->text;
  return out;
}

/// What every proof ends with, of a solution or of an event: that what is taken for granted is not
/// refuted where it lies.
template <class Claim>
void require_assumptions(const Potential& potential, Inputs inputs, const StretchBox& at,
                         Claim& out) {
  if (!out.proven || out.assuming.empty()) return;
  if (!potential.assumptions_refuted({at.alpha, at.xi, at.zeta, at.rho},
                                     inputs == Inputs::decimals))
    return;
  out.proven = false;
  out.reason = "proven not to be one: there the formula is not as was taken for granted (" +
               out.assuming.front() + ")";
}

/// The proof at x, or why there is none.
template <int N>
Proof<N> prove_solution(const Krawczyk<N>& test, const ReducedVector<N>& x, const char* names,
                        Certificate& out) {
  auto proof = test.prove();
  if (!proof.proven) {
    out.reason = std::string("no solution could be proven near these ") + names +
                 ": there is none, or a second one (a fold, a bifurcation) is too near";
    return proof;
  }
  double least = 0.0;  // the error is at least this
  for (int i = 0; i < N; ++i)
    least = std::max(least, log(proof.solution[static_cast<std::size_t>(i)] / x[i]).mignitude());
  if (least > allowed_error) {
    std::ostringstream text;
    text.precision(2);
    text << "proven not to be a solution: the nearest has " << names << " farther off than "
         << std::scientific << least << " of themselves";
    out.reason = text.str();
    proof.proven = false;
  }
  return proof;
}

/// That there is no second solution within the error bound of any of the stretches.
inline void conclude(const std::optional<StretchBox>& unique, const StretchBox& solution,
                     double bound, Certificate& out) {
  if (!unique) {
    out.reason = "a second solution (a fold, a bifurcation) may lie within the error bound";
    return;
  }
  out.proven = true;
  out.unique = *unique;
  out.solution = solution;
  out.error_bound = bound;
}

}  // namespace stationary
