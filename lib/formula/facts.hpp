// What can be found out about a potential from its expression: which variables it has, whether it
// turns with the body (isotropic), whether plane and thickness are apart, whether a body that lies
// along its material axes feels no shear. Each is an identity that holds whatever the parameters
// are, and comes with how it was established: term by term, exactly or at points (vanishing.hpp).
//
// Isotropic:  V_alpha (xi - zeta) + 2 alpha (V_zeta - V_xi) = 0,  the derivative along a rotation.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "lib/formula/expression.hpp"
#include "lib/formula/vanishing.hpp"

namespace stationary::expression {

struct Facts {
  Verdict symmetric = Verdict::undecided;   ///< in lambda and mu_
  Verdict isotropic = Verdict::undecided;   ///< a function of t, d and rho
  Verdict shear_free = Verdict::undecided;  ///< V_alpha = 0 at alpha = 0
  Verdict even = Verdict::undecided;        ///< V(-alpha) = V(alpha)
  Verdict separable = Verdict::undecided;   ///< V_plane + V_rho
  std::vector<std::string> sentences;       ///< all of it, for a person to read

  /// What is known by points alone, which is no proof: "isotropic (a function of ...)", ...
  std::vector<std::string> assumed;

  static bool holds(Verdict v) { return v <= Verdict::at_points; }
  bool is_isotropic() const { return holds(isotropic); }
  bool is_shear_free() const { return holds(shear_free); }
  bool is_even() const { return holds(even); }
  bool is_separable() const { return holds(separable); }
};

/// values: of the parameters, where they are known (vanishing.hpp). Throws Unsuitable where lambda
/// and mu_ do not enter symmetrically or what they enter by is not smooth (circle_smoothness.hpp),
/// TooLarge.
Facts facts(Expression expression, Slot slot, std::span<const double> values = {});

/// Whether any of the variables occurs in x.
bool occurs(const Graph& graph, NodeId x, std::initializer_list<Variable> variables);

/// The expression with lambda and mu_ replaced by what is smooth at the circle
/// (principal_pairs.hpp); throws Unsuitable where they do not enter symmetrically. how: by which
/// verdict they do.
NodeId without_principal_stretches(Expression& expression, Verdict* how = nullptr);

/// Of an expression in which lambda and mu_ enter symmetrically, its domain included.
Verdict isotropy(Expression& expression, std::span<const double> values = {});
/// V_alpha = 0 at alpha = 0, likewise.
Verdict shear_freedom(Expression& expression, std::span<const double> values = {});
/// V(-alpha, xi, zeta, rho) = V(alpha, xi, zeta, rho), likewise.
Verdict evenness(Expression& expression, std::span<const double> values = {});

}  // namespace stationary::expression
