#include "lib/expression/principal_pairs.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "lib/expression/symmetric_kernel.hpp"

namespace stationary::expression {
namespace {

/// a + b s, its product with a - b s, and whether both are positive for what they are.
struct Split {
  NodeId a;
  NodeId b;
  NodeId norm;
  bool positive = false;
};

class Splitter {
 public:
  explicit Splitter(Graph& graph)
      : g_(graph),
        half_trace_(g_.multiply({g_.number(0.5), g_.variable(Variable::t)})),
        square_(g_.multiply({g_.number(0.25), g_.variable(Variable::discriminant)})) {}

  EvenOdd split(NodeId x) {
    const std::array<NodeId, 1> root{x};
    for (const NodeId id : g_.parts(root)) known_.emplace(id, of(id));
    const Split& out = known_.at(x);
    return {out.a, out.b};
  }

 private:
  Split even(NodeId a) { return {a, g_.zero(), g_.power(a, 2), false}; }
  Split with_norm(NodeId a, NodeId b) {
    const NodeId odd = g_.multiply({g_.power(b, 2), square_});
    return {a, b, g_.subtract({g_.power(a, 2), odd}), false};
  }
  Split product(const Split& x, const Split& y);
  Split power(const Split& x, int n);
  Split sum(const Node& node);
  Split product(const Node& node);
  Split function(const Node& node, NodeId id);
  Split kernels(Function f, const Split& x, NodeId exponent);
  Split of(NodeId id);

  Graph& g_;
  NodeId half_trace_;
  NodeId square_;  ///< s^2
  std::map<NodeId, Split> known_;
};

Split Splitter::product(const Split& x, const Split& y) {
  if (x.a == y.a && g_.is_zero(g_.add({x.b, y.b})))  // conjugate
    return {x.norm, g_.zero(), g_.power(x.norm, 2), x.positive && y.positive};
  const NodeId both = g_.multiply({g_.multiply({x.b, y.b}), square_});
  return {g_.add({g_.multiply({x.a, y.a}), both}),
          g_.add({g_.multiply({x.a, y.b}), g_.multiply({x.b, y.a})}), g_.multiply({x.norm, y.norm}),
          x.positive && y.positive};
}

Split Splitter::power(const Split& x, int n) {
  if (g_.is_zero(x.b)) {
    Split out = even(g_.power(x.a, n));
    out.positive = x.positive;
    return out;
  }
  if (n < 0) {
    const Split below = power(x, -n);
    const NodeId inverse = g_.divide({g_.one(), below.norm});
    return {g_.multiply({below.a, inverse}), g_.negate(g_.multiply({below.b, inverse})), inverse,
            x.positive};
  }
  if (n == 1) return x;
  const Split half = power(x, n / 2);
  const Split whole = product(half, half);
  return n % 2 == 0 ? whole : product(whole, x);
}

Split Splitter::sum(const Node& node) {
  NodeId a = node.a;
  NodeId b = g_.zero();
  for (const Term& term : node.terms) {
    const Split& part = known_.at(term.node);
    a = g_.add({a, g_.multiply({term.coefficient, part.a})});
    b = g_.add({b, g_.multiply({term.coefficient, part.b})});
  }
  if (g_.is_zero(b)) return even(a);
  if (node.terms.size() == 1 && g_.is_zero(node.a)) {
    const Split& part = known_.at(node.terms[0].node);
    const NodeId c = node.terms[0].coefficient;
    const bool positive = part.positive && g_.is_exact_literal(c) && g_[c].literal > 0.0;
    return {a, b, g_.multiply({g_.power(c, 2), part.norm}), positive};
  }
  return with_norm(a, b);
}

/// Powers of lambda and mu that both occur are powers of d = lambda mu first.
Split Splitter::product(const Node& node) {
  const NodeId lambda = g_.variable(Variable::lambda);
  const NodeId mu = g_.variable(Variable::mu);
  std::map<NodeId, int> exponents;
  for (const Term& factor : node.terms) exponents[factor.node] = factor.exponent;
  int common = 0;
  if (exponents.contains(lambda) && exponents.contains(mu)) {
    const int m = exponents[lambda];
    const int n = exponents[mu];
    common = m > 0 && n > 0 ? std::min(m, n) : m < 0 && n < 0 ? std::max(m, n) : m > 0 ? n : m;
    exponents[lambda] -= common;
    exponents[mu] -= common;
  }
  Split out = even(g_.power(g_.variable(Variable::d), common));
  out.positive = true;
  for (const auto& [base, exponent] : exponents)
    if (exponent != 0) out = product(out, power(known_.at(base), exponent));
  return out;
}

Split Splitter::kernels(Function f, const Split& x, NodeId exponent) {
  const NodeId y = g_.multiply({g_.power(x.b, 2), square_});
  const auto kernel = [&](KernelPart part) {
    return g_.kernel(f, kernel_index(0, part), x.a, y, x.norm, exponent);
  };
  return with_norm(kernel(KernelPart::even), g_.multiply({x.b, kernel(KernelPart::odd)}));
}

Split Splitter::function(const Node& node, NodeId id) {
  const Split x = known_.at(node.a);
  if (g_.is_zero(x.b)) {
    const NodeId value =
        node.kind == Kind::power ? g_.power(x.a, node.b) : g_.apply(node.function, x.a);
    Split out = even(value);
    out.positive = x.positive && (node.kind == Kind::power || node.function == Function::sqrt);
    return out;
  }
  if (node.kind == Kind::power) {
    Split out = kernels(Function::power, x, node.b);
    if (x.positive) out.norm = g_.power(x.norm, node.b);
    out.positive = x.positive;
    return out;
  }
  switch (node.function) {
    case Function::log: {
      Split out = kernels(Function::log, x, g_.one());
      if (!x.positive) return out;
      return with_norm(g_.multiply({g_.number(0.5), g_.apply(Function::log, x.norm)}), out.b);
    }
    case Function::sqrt: {
      // (sqrt x + sqrt x')/2 = sqrt((a + sqrt(x x'))/2), x' = a - b s.
      const NodeId root = g_.apply(Function::sqrt, x.norm);
      const NodeId a = g_.apply(Function::sqrt, g_.multiply({g_.number(0.5), g_.add({x.a, root})}));
      return {a, g_.divide({g_.multiply({g_.number(0.5), x.b}), a}), root, x.positive};
    }
    case Function::exp: {
      Split out = kernels(Function::exp, x, g_.one());
      out.norm = g_.apply(Function::exp, g_.multiply({g_.number(2.0), x.a}));
      out.positive = true;
      return out;
    }
    default:
      break;
  }
  return kernels(g_[id].function, x, g_.one());
}

Split Splitter::of(NodeId id) {
  const Node node = g_[id];
  switch (node.kind) {
    case Kind::variable: {
      const auto v = static_cast<Variable>(node.index);
      const NodeId d = g_.variable(Variable::d);
      if (v == Variable::lambda) return {half_trace_, g_.one(), d, true};
      if (v == Variable::mu) return {half_trace_, g_.number(-1.0), d, true};
      Split out = even(id);
      out.positive = v != Variable::alpha && v != Variable::discriminant;
      return out;
    }
    case Kind::sum:
      return sum(node);
    case Kind::product:
      return product(node);
    case Kind::function:
    case Kind::power:
      return g_.is_coefficient(id) ? even(id) : function(node, id);
    default:
      return even(id);
  }
}

}  // namespace

EvenOdd split_at_circle(Graph& graph, NodeId x) { return Splitter(graph).split(x); }

}  // namespace stationary::expression
