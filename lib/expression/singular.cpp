#include "lib/expression/singular.hpp"

#include <algorithm>
#include <cmath>

namespace stationary::expression {

bool is_singular(const Graph& graph, NodeId x) {
  const Node& node = graph[x];
  switch (node.kind) {
    case Kind::literal:
      return !std::isfinite(node.literal);
    case Kind::parameter:
    case Kind::variable:
      return false;
    case Kind::kernel:
      return is_singular(graph, node.a) || is_singular(graph, node.b) || is_singular(graph, node.c);
    default:
      return node.index == 1;
  }
}

bool has_singular_part(const Graph& graph, const Node& node) {
  const auto singular = [&](NodeId x) { return is_singular(graph, x); };
  switch (node.kind) {
    case Kind::coefficient_quotient:
      return graph.is_zero(node.b) || singular(node.a) || singular(node.b);
    case Kind::power: {
      const bool known = graph[node.b].kind == Kind::literal && graph[node.b].literal > 0.0;
      return (graph.is_zero(node.a) && !known) || singular(node.a) || singular(node.b);
    }
    case Kind::function:
      return (graph.is_zero(node.a) && node.function == Function::log) || singular(node.a);
    case Kind::coefficient_sum:
    case Kind::coefficient_product:
    case Kind::minimum:
    case Kind::maximum:
      return singular(node.a) || singular(node.b);
    case Kind::sum:
      return singular(node.a) || std::ranges::any_of(node.terms, [&](const Term& term) {
               return singular(term.coefficient) || singular(term.node);
             });
    case Kind::product:
      return std::ranges::any_of(node.terms,
                                 [&](const Term& factor) { return singular(factor.node); });
    default:
      return false;
  }
}

}  // namespace stationary::expression
