#include "lib/expression/domain.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace stationary::expression {
namespace {

bool is_positive_variable(Variable v) {
  switch (v) {
    case Variable::xi:
    case Variable::zeta:
    case Variable::rho:
    case Variable::t:
    case Variable::d:
    case Variable::lambda:
    case Variable::mu:
    case Variable::first_invariant:
      return true;
    default:
      return false;
  }
}

Sign of_product(Sign x, Sign y) { return std::min(x, y); }
/// Neither negative: positive where one of them is.
Sign of_sum(Sign x, Sign y) {
  return x == Sign::unknown || y == Sign::unknown ? Sign::unknown : std::max(x, y);
}
Sign even_power(Sign x) { return x == Sign::positive ? x : Sign::not_negative; }

class Signs {
 public:
  explicit Signs(const Graph& graph) : graph_(graph), known_(graph.size(), Sign::unknown) {}

  Sign operator()(NodeId x) {
    const std::array<NodeId, 1> root{x};
    for (const NodeId part : graph_.parts(root)) known_[part] = of(graph_[part]);
    return known_[x];
  }

 private:
  Sign of(const Node& node) const {
    switch (node.kind) {
      case Kind::literal:
        return node.literal > 0.0    ? Sign::positive
               : node.literal == 0.0 ? Sign::not_negative
                                     : Sign::unknown;
      case Kind::pi:
      case Kind::euler:
        return Sign::positive;
      case Kind::coefficient_sum:
        return of_sum(known_[node.a], known_[node.b]);
      case Kind::coefficient_product:
        if (node.a == node.b) return even_power(known_[node.a]);
        return of_product(known_[node.a], known_[node.b]);
      case Kind::coefficient_quotient:
        return of_product(known_[node.a], known_[node.b]);
      case Kind::maximum:
        return std::max(known_[node.a], known_[node.b]);
      case Kind::minimum:
        return std::min(known_[node.a], known_[node.b]);
      case Kind::function:
        return of_function(node);
      case Kind::power:
        return of_root(node.a, Sign::unknown);
      case Kind::variable:
        return is_positive_variable(static_cast<Variable>(node.index))       ? Sign::positive
               : static_cast<Variable>(node.index) == Variable::discriminant ? Sign::not_negative
                                                                             : Sign::unknown;
      case Kind::sum: {
        Sign out = known_[node.a];
        for (const Term& term : node.terms)
          out = of_sum(out, of_product(known_[term.coefficient], known_[term.node]));
        return out;
      }
      case Kind::product: {
        Sign out = Sign::positive;
        for (const Term& factor : node.terms) {
          const Sign base = known_[factor.node];
          out = of_product(out, factor.exponent % 2 == 0 ? even_power(base) : base);
        }
        return out;
      }
      default:
        return Sign::unknown;
    }
  }

  Sign of_function(const Node& node) const {
    switch (node.function) {
      case Function::exp:
        return Sign::positive;
      case Function::sqrt:
        return of_root(node.a, Sign::not_negative);
      case Function::tanh:
      case Function::atan:
        return known_[node.a];
      case Function::abs:
        return even_power(known_[node.a]);
      default:
        return Sign::unknown;
    }
  }

  /// Of what varies the domain asks for a positive base; a coefficient's power may be 0 or negative.
  Sign of_root(NodeId base, Sign else_of_coefficients) const {
    return known_[base] == Sign::positive || !graph_.is_coefficient(base) ? Sign::positive
                                                                          : else_of_coefficients;
  }

  const Graph& graph_;
  std::vector<Sign> known_;
};

void add(Condition condition, std::vector<Condition>& out) {
  const auto same = [&](const Condition& each) {
    return each.node == condition.node && each.positive == condition.positive;
  };
  if (std::ranges::none_of(out, same)) out.push_back(std::move(condition));
}

/// x with a multiple of xi zeta - alpha^2 as one of what it is, d, by itself or as a factor.
NodeId with_determinant(Graph& g, NodeId x) {
  if (g.is_coefficient(x)) return x;
  const NodeId product = g.multiply({g.variable(Variable::xi), g.variable(Variable::zeta)});
  const NodeId square = g.power(g.variable(Variable::alpha), 2);
  // Over d, where that is a coefficient.
  const auto over_determinant = [&](NodeId of) -> std::optional<NodeId> {
    const Node node = g[of];
    if (node.kind != Kind::sum || node.terms.size() != 2 || !g.is_zero(node.a)) return std::nullopt;
    const std::size_t first = node.terms[0].node == product ? 0 : 1;
    const Term& plus = node.terms[first];
    const Term& minus = node.terms[1 - first];
    if (plus.node != product || minus.node != square) return std::nullopt;
    if (!g.is_zero(g.add({plus.coefficient, minus.coefficient}))) return std::nullopt;
    return plus.coefficient;
  };
  const Term term = g.scaled(x);
  const Node node = g[term.node];
  const std::vector<Term> factors =
      node.kind == Kind::product ? node.terms : std::vector<Term>{{term.node, 0, 1}};
  NodeId out = term.coefficient;
  bool found = false;
  for (const Term& factor : factors) {
    const auto multiple = over_determinant(factor.node);
    const NodeId base = multiple ? g.multiply({*multiple, g.variable(Variable::d)}) : factor.node;
    out = g.multiply({out, g.power(base, factor.exponent)});
    found = found || multiple;
  }
  return found ? out : x;
}

}  // namespace

Sign sign(const Graph& graph, NodeId x) { return Signs(graph)(x); }

void require_nonzero(Graph& graph, NodeId given, std::string_view text,
                     std::vector<Condition>& out) {
  const NodeId x = with_determinant(graph, given);
  if (sign(graph, x) == Sign::positive) return;
  if (graph.is_exact_literal(x) && !graph.is_zero(x)) return;
  const Term term = graph.scaled(x);
  if (!graph.is_coefficient(x)) {
    if (!graph.is_literal(term.coefficient, 1.0)) {
      require_nonzero(graph, term.coefficient, text, out);
      require_nonzero(graph, term.node, text, out);
      return;
    }
    const Node node = graph[x];
    if (node.kind == Kind::product) {
      for (const Term& factor : node.terms) require_nonzero(graph, factor.node, text, out);
      return;
    }
  }
  add({x, false, std::string(text)}, out);
}

void require_positive(Graph& graph, NodeId given, std::string_view text,
                      std::vector<Condition>& out) {
  const NodeId x = with_determinant(graph, given);
  if (sign(graph, x) == Sign::positive) return;
  const Term term = graph.scaled(x);
  NodeId odd = term.coefficient;
  if (!graph.is_coefficient(x)) {
    const Node node = graph[term.node];
    if (node.kind == Kind::product) {
      for (const Term& factor : node.terms) {
        if (factor.exponent % 2 == 0) {
          require_nonzero(graph, factor.node, text, out);
        } else if (sign(graph, factor.node) != Sign::positive) {
          odd = graph.multiply({odd, factor.node});
        }
      }
    } else if (sign(graph, term.node) != Sign::positive) {
      odd = graph.multiply({odd, term.node});
    }
  }
  if (sign(graph, odd) != Sign::positive) add({odd, true, std::string(text)}, out);
}

}  // namespace stationary::expression
