#include "lib/expression/differentiate.hpp"

#include <array>

#include "lib/expression/symmetric_kernel.hpp"

namespace stationary::expression {

NodeId Differentiation::operator()(NodeId x) {
  const std::array<NodeId, 1> root{x};
  for (const NodeId part : graph_.parts(root)) {
    if (!known_.contains(part)) {
      const NodeId derivative = of(part);
      known_.emplace(part, derivative);
    }
  }
  return known_.at(x);
}

NodeId Differentiation::of_variable(Variable v) {
  const auto itself = [&](bool logarithm, bool plain) {
    return logarithm ? graph_.variable(v) : plain ? graph_.one() : graph_.zero();
  };
  const bool plane = coordinate_ == Coordinate::log_plane;
  switch (v) {
    case Variable::alpha:
      return itself(plane, coordinate_ == Coordinate::alpha);
    case Variable::xi:
      return itself(plane || coordinate_ == Coordinate::log_xi, coordinate_ == Coordinate::xi);
    case Variable::zeta:
      return itself(plane || coordinate_ == Coordinate::log_zeta, coordinate_ == Coordinate::zeta);
    case Variable::rho:
      return itself(coordinate_ == Coordinate::log_rho, coordinate_ == Coordinate::rho);
    case Variable::t:
      return itself(false, coordinate_ == Coordinate::t);
    case Variable::d:
      return itself(coordinate_ == Coordinate::log_d, false);
    case Variable::discriminant:  // t^2 - 4 d
      if (coordinate_ == Coordinate::t)
        return graph_.multiply({graph_.number(2.0), graph_.variable(Variable::t)});
      if (coordinate_ == Coordinate::log_d)
        return graph_.multiply({graph_.number(-4.0), graph_.variable(Variable::d)});
      return graph_.zero();
    case Variable::lambda:
    case Variable::mu:
    case Variable::first_invariant:
      throw std::logic_error("a variable to be replaced before differentiation");
    case Variable::rate_xi:
    case Variable::rate_zeta:
    case Variable::rate_rho:
      return graph_.zero();
    default: {
      const int parameter = static_cast<int>(v) - static_cast<int>(Variable::first_parameter);
      const int by = static_cast<int>(coordinate_) - static_cast<int>(Coordinate::first_parameter);
      return itself(false, parameter == by);
    }
  }
}

/// x'/x where no division is needed for it.
std::optional<NodeId> Differentiation::undivided(NodeId x) {
  if (graph_.is_coefficient(x)) return graph_.zero();
  const NodeId slope = known_.at(x);
  if (graph_.is_zero(slope) || slope == x) return graph_.divide({slope, x});
  const Node node = graph_[x];
  switch (node.kind) {
    case Kind::sum:
      if (node.terms.size() == 1 && graph_.is_zero(node.a)) return undivided(node.terms[0].node);
      return {};
    case Kind::product: {
      NodeId out = graph_.zero();
      for (const Term& factor : node.terms) {
        const auto part = undivided(factor.node);
        if (!part) return {};
        out = graph_.add({out, graph_.multiply({graph_.number(factor.exponent), *part})});
      }
      return out;
    }
    case Kind::power: {
      const auto base = undivided(node.a);
      if (!base) return {};
      return graph_.multiply({node.b, *base});
    }
    case Kind::function:
      if (node.function == Function::exp) return known_.at(node.a);
      if (node.function == Function::sqrt) {
        const auto base = undivided(node.a);
        if (!base) return {};
        return graph_.multiply({graph_.number(0.5), *base});
      }
      return {};
    default:
      return {};
  }
}

/// x'/x.
NodeId Differentiation::relative(NodeId x) {
  if (const auto quick = undivided(x)) return *quick;
  const Node node = graph_[x];
  if (node.kind == Kind::sum && node.terms.size() == 1 && graph_.is_zero(node.a))
    return relative(node.terms[0].node);
  if (node.kind == Kind::product) {
    NodeId out = graph_.zero();
    for (const Term& factor : node.terms)
      out = graph_.add(
          {out, graph_.multiply({graph_.number(factor.exponent), relative(factor.node)})});
    return out;
  }
  return graph_.divide({known_.at(x), x});
}

NodeId Differentiation::of_function(const Node& node, NodeId id) {
  const NodeId slope = known_.at(node.a);
  if (graph_.is_zero(slope)) return slope;
  if (node.function == Function::sqrt) {
    if (const auto base = undivided(node.a))
      return graph_.multiply({graph_.multiply({graph_.number(0.5), id}), *base});
  }
  if (node.function == Function::log) return relative(node.a);
  return graph_.multiply({derivative(graph_, node.function, node.a), slope});
}

NodeId Differentiation::of(NodeId x) {
  if (graph_.is_coefficient(x)) return graph_.zero();
  const Node node = graph_[x];
  switch (node.kind) {
    case Kind::variable:
      return of_variable(static_cast<Variable>(node.index));
    case Kind::sum: {
      NodeId out = graph_.zero();
      for (const Term& term : node.terms)
        out = graph_.add({out, graph_.multiply({term.coefficient, known_.at(term.node)})});
      return out;
    }
    case Kind::product: {
      NodeId out = graph_.zero();
      for (const Term& factor : node.terms) {
        const NodeId share =
            graph_.multiply({graph_.number(factor.exponent), relative(factor.node)});
        out = graph_.add({out, graph_.multiply({share, x})});
      }
      return out;
    }
    case Kind::power: {
      const NodeId slope = known_.at(node.a);
      if (graph_.is_zero(slope)) return slope;
      const auto base = undivided(node.a);
      if (base) return graph_.multiply({graph_.multiply({node.b, x}), *base});
      const NodeId lower = graph_.power(node.a, graph_.subtract({node.b, graph_.one()}));
      return graph_.multiply({graph_.multiply({node.b, lower}), slope});
    }
    case Kind::function:
      return of_function(node, x);
    case Kind::kernel:
      return graph_.add({graph_.multiply({kernel_slope_a(graph_, x), known_.at(node.a)}),
                         graph_.multiply({kernel_slope_y(graph_, x), known_.at(node.b)})});
    default:
      return graph_.zero();
  }
}

}  // namespace stationary::expression
