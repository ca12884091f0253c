// An expression as a graph in which equal subexpressions are one node.
//
//   sum      c0 + c1 x1 + c2 x2 + ...     c: coefficients (constants, parameters and what is made
//   product  x1^n1 x2^n2 ...              of them), x: anything that varies, n: whole numbers
//
// Sums and products are kept in this form, so that what cancels is gone and what is a factor is
// seen: d/d is 1, and the derivative of log(d) with respect to ln d is exactly 1. Nothing is
// multiplied out. Coefficients are not evaluated here, for their values change (a parameter is
// followed) and so does the number type; two literals are combined only where that is exact.
// A node's operands have smaller numbers than the node: every pass over a graph is a loop.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <stdexcept>
#include <vector>

namespace stationary::expression {

/// What an expression may be made of; also names what a tape is given (inputs).
enum class Variable : std::uint8_t {
  alpha,
  xi,
  zeta,
  rho,
  t,
  d,
  lambda,
  mu,
  first_invariant,  ///< I1 = tr S^2 in the plane
  discriminant,     ///< t^2 - 4 d, not a word of the language
  rate_xi,          ///< centrifugal rates of a balance, likewise
  rate_zeta,
  rate_rho,
  first_parameter  ///< and those after it: the parameters themselves, where they are varied
};
constexpr Variable parameter_variable(int index) {
  return static_cast<Variable>(static_cast<int>(Variable::first_parameter) + index);
}

/// power: of kernels only (elsewhere a power is a node of its own).
enum class Function : std::uint8_t { sqrt, exp, log, sin, cos, tan, tanh, atan, abs, power };

enum class Kind : std::uint8_t {
  // Coefficients.
  literal,
  parameter,
  pi,
  euler,
  coefficient_sum,
  coefficient_product,
  coefficient_quotient,
  minimum,
  maximum,
  // Either.
  function,  ///< of `a`
  power,     ///< a^b, b a coefficient that is no whole literal
  // What varies.
  variable,
  sum,
  product,
  // Of the symmetric part of functions of the principal stretches (principal_pairs.hpp).
  kernel
};

using NodeId = std::uint32_t;

/// A factor or a summand: coefficient * node, or node^exponent.
struct Term {
  NodeId node = 0;
  NodeId coefficient = 0;  ///< of a sum
  int exponent = 0;        ///< of a product
  auto operator<=>(const Term&) const = default;
};

/// digits 10^power; digits 0: more of them than fit, and power tells such numbers apart.
struct Decimal {
  std::uint64_t digits = 0;
  int power = 0;
  bool known() const { return digits != 0; }
  auto operator<=>(const Decimal&) const = default;
};

struct Node {
  Kind kind = Kind::literal;
  Function function = Function::sqrt;  ///< of function and kernel
  std::uint8_t index = 0;              ///< variable, number of the parameter, part of the kernel;
                                       ///< 1: a literal that only rounds to it; singular.hpp others
  double literal = 0.0;
  Decimal decimal = {};  ///< of a literal that only rounds to a double: what was written
  NodeId a = 0;
  NodeId b = 0;
  NodeId c = 0;
  std::vector<Term> terms;  ///< of sum (whose constant is `a`) and product
  auto operator<=>(const Node&) const = default;
};

/// More than a tape has room for, or an exponent beyond use; the message is the bound.
class TooLarge : public std::length_error {
  using std::length_error::length_error;
};

/// A derivative that does not exist everywhere: abs, min or max of what varies.
class NotSmooth : public std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// In braces, and so made in this order by every compiler: terms are added in the order in which they
/// were made.
struct Operands {
  NodeId x;
  NodeId y;
};

class Graph {
 public:
  static constexpr std::size_t largest_size = 20000;
  static constexpr int largest_exponent = 4096;

  const Node& operator[](NodeId id) const { return nodes_[id]; }
  std::size_t size() const { return nodes_.size(); }

  NodeId number(double value);
  /// A number that was written as a decimal and is no double; value is the nearest one.
  NodeId rounded_number(double value, const Decimal& written);
  NodeId pi() { return leaf(Kind::pi, 0); }
  NodeId euler() { return leaf(Kind::euler, 0); }
  NodeId parameter(int index) { return leaf(Kind::parameter, index); }
  NodeId variable(Variable v) { return leaf(Kind::variable, static_cast<int>(v)); }

  NodeId add(Operands of);
  NodeId subtract(Operands of) { return add({of.x, negate(of.y)}); }
  NodeId negate(NodeId x);
  NodeId multiply(Operands of);
  NodeId divide(Operands of);
  NodeId power(NodeId x, int n);
  NodeId power(NodeId x, NodeId y);
  NodeId apply(Function f, NodeId x);
  /// Of coefficients only; NotSmooth otherwise.
  NodeId minimum(Operands of);
  NodeId maximum(Operands of);
  /// As read: no simplification. See symmetric_kernel.hpp.
  NodeId kernel(Function f, int which, NodeId a, NodeId y, NodeId norm, NodeId exponent);

  NodeId zero() { return number(0.0); }
  NodeId one() { return number(1.0); }
  /// A number that is the double `value` itself.
  bool is_literal(NodeId x, double value) const {
    return is_exact_literal(x) && nodes_[x].literal == value;
  }
  bool is_exact_literal(NodeId x) const {
    return nodes_[x].kind == Kind::literal && nodes_[x].index == 0;
  }
  bool is_zero(NodeId x) const { return is_literal(x, 0.0); }
  /// Made of numbers and parameters only.
  bool is_coefficient(NodeId x) const { return coefficient_[x]; }

  /// x as coefficient * node, the node no sum of one term.
  Term scaled(NodeId x);
  /// The sum with coefficients multiplied into sums they stand before.
  NodeId expanded(NodeId x);

  /// Every node that x is made of, x itself last, in ascending order.
  std::vector<NodeId> parts(std::span<const NodeId> of) const;

 private:
  struct LinearForm {
    NodeId constant;
    std::map<NodeId, NodeId> coefficient;
  };

  NodeId intern(Node node);
  NodeId leaf(Kind kind, int index);
  NodeId coefficient_add(NodeId x, NodeId y);
  NodeId coefficient_multiply(NodeId x, NodeId y);
  NodeId coefficient_divide(NodeId x, NodeId y);
  NodeId times(NodeId coefficient, NodeId x);
  void accumulate(LinearForm& form, NodeId coefficient, NodeId x, bool expand);
  NodeId from(const LinearForm& form);

  std::vector<Node> nodes_;
  std::vector<bool> coefficient_;
  std::map<Node, NodeId> known_;
};

}  // namespace stationary::expression
