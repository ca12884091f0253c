#include "lib/expression/slopes.hpp"

#include <array>
#include <map>

#include "lib/expression/differentiate.hpp"

namespace stationary::expression {
namespace {

using Known = std::map<NodeId, NodeId>;

NodeId varied_sum(Graph& g, const Node& node, const Known& now) {
  NodeId out = now.at(node.a);
  for (const Term& term : node.terms)
    out = g.add({out, g.multiply({now.at(term.coefficient), now.at(term.node)})});
  return out;
}

NodeId varied_product(Graph& g, const Node& node, const Known& now) {
  NodeId out = g.one();
  for (const Term& factor : node.terms)
    out = g.multiply({out, g.power(now.at(factor.node), factor.exponent)});
  return out;
}

std::optional<NodeId> varied(Graph& g, NodeId id, const Known& now) {
  const Node node = g[id];
  switch (node.kind) {
    case Kind::parameter:
      return g.variable(parameter_variable(node.index));
    case Kind::coefficient_sum:
      return g.add({now.at(node.a), now.at(node.b)});
    case Kind::coefficient_product:
      return g.multiply({now.at(node.a), now.at(node.b)});
    case Kind::coefficient_quotient:
      return g.divide({now.at(node.a), now.at(node.b)});
    case Kind::minimum:
    case Kind::maximum:
      if (now.at(node.a) != node.a || now.at(node.b) != node.b) return {};
      return id;
    case Kind::function:
      if (node.function == Function::abs && now.at(node.a) != node.a) return {};
      return g.apply(node.function, now.at(node.a));
    case Kind::power:
      return g.power(now.at(node.a), now.at(node.b));
    case Kind::sum:
      return varied_sum(g, node, now);
    case Kind::product:
      return varied_product(g, node, now);
    case Kind::kernel: {
      const NodeId exponent = node.terms[0].node;
      if (now.at(exponent) != exponent) return {};
      return g.kernel(node.function, node.index, now.at(node.a), now.at(node.b), now.at(node.c),
                      exponent);
    }
    case Kind::literal:
    case Kind::pi:
    case Kind::euler:
    case Kind::variable:
      break;
  }
  return id;
}

}  // namespace

std::optional<NodeId> with_parameters_varied(Graph& graph, NodeId x) {
  const std::array<NodeId, 1> root{x};
  Known now;
  for (const NodeId id : graph.parts(root)) {
    const std::optional<NodeId> out = varied(graph, id, now);
    if (!out) return {};
    now.emplace(id, *out);
  }
  return now.at(x);
}

std::vector<NodeId> parameter_slopes(Graph& graph, std::span<const NodeId> x, int parameter_count) {
  std::vector<NodeId> out;
  for (const NodeId each : x) {
    const std::optional<NodeId> in_parameters = with_parameters_varied(graph, each);
    if (!in_parameters) return {};
    out.push_back(*in_parameters);
  }
  for (int k = 0; k < parameter_count; ++k) {
    Differentiation by(graph, parameter_coordinate(k));
    for (std::size_t i = 0; i < x.size(); ++i) out.push_back(by(out[i]));
  }
  return out;
}

}  // namespace stationary::expression
