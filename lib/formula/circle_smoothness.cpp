#include "lib/formula/circle_smoothness.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "lib/formula/facts.hpp"

namespace stationary::expression {
namespace {

/// What the node is not smooth of where that is 0.
std::vector<NodeId> bases(const Graph& g, NodeId id) {
  const Node& node = g[id];
  if (g.is_coefficient(id)) return {};
  switch (node.kind) {
    case Kind::function:
      if (node.function == Function::sqrt || node.function == Function::log) return {node.a};
      return {};
    case Kind::power:
      if (g[node.b].kind == Kind::literal && g[node.b].literal > 2.0) return {};
      return {node.a};
    case Kind::product: {
      std::vector<NodeId> out;
      for (const Term& factor : node.terms)
        if (factor.exponent < 0) out.push_back(factor.node);
      return out;
    }
    default:
      return {};
  }
}

}  // namespace

void require_smooth_at_circle(Expression& e) {
  Graph& g = e.graph;
  const NodeId xi = g.variable(Variable::xi);
  const NodeId twice = g.multiply({g.number(2.0), xi});
  const NodeId square = g.power(xi, 2);
  const std::map<Variable, NodeId> circle{
      {Variable::lambda, xi},
      {Variable::mu, xi},
      {Variable::t, twice},
      {Variable::d, square},
      {Variable::first_invariant, g.multiply({g.number(2.0), square})}};
  const std::array<NodeId, 1> root{e.root};
  for (const NodeId id : g.parts(root)) {
    for (const NodeId base : bases(g, id)) {
      if (g[base].kind == Kind::variable || g.is_coefficient(base) ||
          occurs(g, base, {Variable::alpha, Variable::xi, Variable::zeta}))
        continue;
      const NodeId there = g.expanded(substitute(g, base, circle));
      if (Facts::holds(vanishes(g, there, e.parameters.size())))
        throw Unsuitable(
            "sqrt, log, a quotient or a power is taken of what is 0 wherever lambda = mu_, as in "
            "sqrt((lambda - mu_)^2): at this circle the potential has a kink or is infinite, or "
            "cannot be evaluated as it is written");
    }
  }
}

}  // namespace stationary::expression
