// A potential as its user wrote it, and what becomes of it: a tape (tape.hpp) for each way the
// library evaluates a potential.
//
//   plane      W(t, l)        l = ln d       value; W_t, W_l; W_tt, W_tl, W_ll
//   thickness  V(r)           r = ln rho     value; V_r; V_rr
//   coupled    W(t, l, r)     all of those and W_tr, W_lr
//   balance    in (u, v, w) = ln (xi, zeta, rho) at alpha = 0, with the centrifugal terms
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "lib/expression/domain.hpp"
#include "lib/expression/graph.hpp"
#include "lib/tape/tape.hpp"

namespace stationary::expression {

/// What a potential depends on, and so which variables it may name.
enum class Slot : std::uint8_t { plane, thickness, coupled };

struct Expression {
  Graph graph;
  NodeId root = 0;
  std::string text;
  std::vector<std::string> parameters;  ///< names, in the order of their coefficients
  std::vector<Condition> conditions;    ///< where it is defined
  std::vector<std::string> assumed;     ///< what its tape takes for granted (Facts::assumed)
  /// Where it takes something for granted: anisotropic_tape() of all of the formula, to hold what
  /// is found against.
  std::shared_ptr<const struct Tape> whole = {};
};

/// An expression that is no potential of the kind asked for; the message says why.
class Unsuitable : public std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// What has to hold where a tape is evaluated (domain.hpp).
struct TapeCondition {
  std::string text;
  bool positive = true;  ///< else: not 0
};
/// Of a coefficient alone.
struct CoefficientCondition {
  TapeCondition condition;
  std::uint16_t constant = 0;
};

struct Tape {
  /// What it was made of; none of oriented_tape()'s parts.
  std::shared_ptr<const Expression> source;
  std::string text;
  std::vector<std::string> parameters;
  Coefficients coefficients;
  /// Identities that its programs take for granted, known at points only (Facts::assumed), and all
  /// of the formula without them.
  std::vector<std::string> assumed;
  std::shared_ptr<const Tape> whole;
  /// The last results of evaluate, balance and residual are the values of these, in this order.
  std::vector<TapeCondition> conditions;
  std::vector<CoefficientCondition> coefficient_conditions;
  std::array<Program, 3> evaluate;  ///< by order; each also gives what the lower ones give
  /// evaluate[1] and [2] without the value, and without what it alone takes: all that a balance
  /// needs. None of anisotropic_tape().
  std::array<Program, 2> forces;
  Program balance;   ///< LogBalance: residuals, then the upper triangle by rows
  Program residual;  ///< the residuals alone; none of thickness_tape()
  /// Value and gradient, then the derivative of both in each parameter: of the inputs and the
  /// parameters. No results where it could not be had (slopes.hpp).
  Program slopes;
  /// Of the residuals the derivatives alone.
  Program residual_slopes;
  std::vector<double> fixed_constants;  ///< the constants in which no parameter is
  bool has_principal_stretches = false;
  /// Of oriented_tape(): the terms that are isotropic as they are written, where there are any,
  /// with the same parameters; the programs above are then of the other terms.
  std::shared_ptr<const Tape> isotropic_terms = {};
  /// Of oriented_tape(), of the whole: what is established (facts.hpp).
  bool shear_free = false;  ///< V_alpha = 0 at alpha = 0
  bool sheared = false;     ///< V_alpha != 0 there, somewhere
  bool even = false;        ///< V(-alpha) = V(alpha)
  /// Of anisotropic_tape(): alpha V_alpha + xi V_xi + zeta V_zeta, as one expression: over
  /// intervals narrower than that sum. No result where there is no room for it.
  Program plane_pull = {};
};

/// Inputs of the programs, in order.
inline constexpr std::array planar_inputs{Variable::t, Variable::d, Variable::discriminant};
inline constexpr std::array thickness_inputs{Variable::rho};
inline constexpr std::array coupled_inputs{Variable::t, Variable::d, Variable::discriminant,
                                           Variable::rho};
inline constexpr std::array planar_balance_inputs{Variable::xi, Variable::zeta, Variable::rate_xi,
                                                  Variable::rate_zeta};
inline constexpr std::array thickness_balance_inputs{Variable::rho, Variable::rate_rho};
inline constexpr std::array coupled_balance_inputs{Variable::xi,        Variable::zeta,
                                                   Variable::rho,       Variable::rate_xi,
                                                   Variable::rate_zeta, Variable::rate_rho};

inline constexpr std::array anisotropic_inputs{Variable::alpha, Variable::xi, Variable::zeta,
                                               Variable::rho};

/// Of isotropic expressions (facts.hpp). Throw Unsuitable where one is not, TooLarge.
std::shared_ptr<const Tape> planar_tape(Expression expression);
std::shared_ptr<const Tape> coupled_tape(Expression expression);
std::shared_ptr<const Tape> thickness_tape(Expression expression);
/// V(alpha, xi, zeta, rho) with its derivatives in these; without balance, residual and slopes.
std::shared_ptr<const Tape> anisotropic_tape(Expression expression);

/// The same in two parts, with what is known of alpha: sums of isotropic and of other terms are as
/// accurate, and over intervals as narrow, as built-in models with fibres.
std::shared_ptr<const Tape> oriented_tape(Expression expression);

/// Conditions that a tape has room for.
constexpr std::size_t largest_tape_condition_count = 32;

/// A condition in alpha, xi, zeta and rho alone, lambda and mu_ by the root of t^2 - 4 d.
NodeId condition_in_stretch(Graph& graph, NodeId x);

/// At alpha = 0 with xi and zeta the principal stretches: in xi, zeta and rho alone. A condition's
/// lambda is the larger of them.
NodeId at_principal_axes(Graph& graph, NodeId x);
NodeId condition_at_principal_axes(Graph& graph, NodeId x);

/// In t, d, t^2 - 4 d and rho alone; Unsuitable where the expression is not isotropic.
NodeId in_invariants(Expression& expression);
/// In alpha, xi, zeta and rho alone; Unsuitable where lambda and mu_ do not enter symmetrically.
NodeId in_stretch(Expression& expression);

/// x with variables replaced; those not named stay.
NodeId substitute(Graph& graph, NodeId x, const std::map<Variable, NodeId>& by);

}  // namespace stationary::expression
