// Derivatives of an expression, as expressions of the same graph: forward differentiation of the
// graph itself, once, instead of carrying derivatives along in every evaluation. What is
// structurally zero is then not there, and values and derivatives share what they have in common.
//
//   (x1^n1 x2^n2 ...)' = x1^n1 x2^n2 ... (n1 x1'/x1 + n2 x2'/x2 + ...),
//
// with x'/x formed first: it has no division where x is d, rho, a power or an exponential, and the
// variables are logarithms.
#pragma once

#include <optional>
#include <unordered_map>

#include "lib/expression/graph.hpp"

namespace stationary::expression {

/// With respect to what: the logarithms of d (at fixed t), rho, xi, zeta, of a factor of alpha, xi
/// and zeta alike; or a variable itself.
enum class Coordinate : std::uint8_t {
  t,
  log_d,
  log_rho,
  log_xi,
  log_zeta,
  log_plane,
  alpha,
  xi,
  zeta,
  rho,
  first_parameter  ///< and those after it
};
constexpr Coordinate parameter_coordinate(int index) {
  return static_cast<Coordinate>(static_cast<int>(Coordinate::first_parameter) + index);
}

/// Derivatives of any number of expressions with respect to one coordinate.
class Differentiation {
 public:
  Differentiation(Graph& graph, Coordinate coordinate) : graph_(graph), coordinate_(coordinate) {}

  NodeId operator()(NodeId x);

 private:
  NodeId of(NodeId x);
  NodeId of_variable(Variable v);
  NodeId of_function(const Node& node, NodeId id);
  NodeId relative(NodeId x);
  std::optional<NodeId> undivided(NodeId x);

  Graph& graph_;
  Coordinate coordinate_;
  std::unordered_map<NodeId, NodeId> known_;
};

}  // namespace stationary::expression
