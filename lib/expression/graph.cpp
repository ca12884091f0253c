#include "lib/expression/graph.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "lib/expression/singular.hpp"
#include "lib/number/double_double.hpp"

namespace stationary::expression {
namespace {

bool is_power_of_two(double x) {
  int exponent = 0;
  return std::isnormal(x) && std::abs(std::frexp(x, &exponent)) == 0.5;
}

bool is_whole(double x) { return x == std::floor(x); }

}  // namespace

NodeId Graph::intern(Node node) {
  if (has_singular_part(*this, node)) node.index = 1;
  const auto found = known_.find(node);
  if (found != known_.end()) return found->second;
  if (nodes_.size() >= largest_size)
    throw TooLarge("an expression whose derivatives have at most " + std::to_string(largest_size) +
                   " parts");
  const auto id = static_cast<NodeId>(nodes_.size());
  bool coefficient = false;
  switch (node.kind) {
    case Kind::variable:
    case Kind::sum:
    case Kind::product:
    case Kind::kernel:
      break;
    case Kind::function:
      coefficient = coefficient_[node.a];
      break;
    case Kind::power:
      coefficient = coefficient_[node.a] && coefficient_[node.b];
      break;
    default:
      coefficient = true;
  }
  known_.emplace(node, id);
  nodes_.push_back(std::move(node));
  coefficient_.push_back(coefficient);
  return id;
}

NodeId Graph::leaf(Kind kind, int index) {
  Node node;
  node.kind = kind;
  node.index = static_cast<std::uint8_t>(index);
  return intern(std::move(node));
}

NodeId Graph::number(double value) {
  Node node;
  node.literal = value == 0.0 ? 0.0 : value;  // no negative zero
  return intern(std::move(node));
}

NodeId Graph::rounded_number(double value, const Decimal& written) {
  Node node;
  node.index = 1;
  node.literal = value;
  node.decimal = written;
  return intern(std::move(node));
}

NodeId Graph::coefficient_add(NodeId x, NodeId y) {
  if (is_zero(x)) return y;
  if (is_zero(y)) return x;
  const Node& p = nodes_[x];
  const Node& q = nodes_[y];
  if (is_exact_literal(x) && is_exact_literal(y)) {
    const DoubleDouble sum = two_sum(p.literal, q.literal);
    if (sum.lo == 0.0 && std::isfinite(sum.hi)) return number(sum.hi);
  }
  // c x + c' x
  const auto split = [&](NodeId id) -> std::pair<NodeId, NodeId> {
    const Node& n = nodes_[id];
    if (n.kind == Kind::coefficient_product && is_exact_literal(n.a)) return {n.a, n.b};
    return {one(), id};
  };
  const auto [cx, bx] = split(x);
  const auto [cy, by] = split(y);
  if (bx == by) return coefficient_multiply(coefficient_add(cx, cy), bx);
  Node node;
  node.kind = Kind::coefficient_sum;
  node.a = std::min(x, y);
  node.b = std::max(x, y);
  return intern(std::move(node));
}

NodeId Graph::coefficient_multiply(NodeId x, NodeId y) {
  if ((is_zero(x) && !is_singular(*this, y)) || (is_zero(y) && !is_singular(*this, x)))
    return zero();
  if (is_literal(x, 1.0)) return y;
  if (is_literal(y, 1.0)) return x;
  if (is_exact_literal(y)) std::swap(x, y);
  const bool literal = is_exact_literal(x);
  if (literal && is_exact_literal(y)) {
    const double a = nodes_[x].literal;
    const double b = nodes_[y].literal;
    const double p = a * b;
    const bool in_range = std::abs(p) > 0x1p-900 && std::abs(p) < 0x1p900 &&
                          std::abs(a) < 0x1p900 && std::abs(b) < 0x1p900;
    if (in_range && two_product(a, b).lo == 0.0) return number(p);
  }
  // Literals to the front, where they meet.
  const auto has_literal = [&](NodeId id) {
    const Node& n = nodes_[id];
    return n.kind == Kind::coefficient_product && is_exact_literal(n.a);
  };
  if (has_literal(y) && literal) {
    const NodeId front = coefficient_multiply(x, nodes_[y].a);
    if (is_exact_literal(front)) return coefficient_multiply(front, nodes_[y].b);
  } else if (has_literal(x)) {
    const Node p = nodes_[x];
    return coefficient_multiply(p.a, coefficient_multiply(p.b, y));
  } else if (has_literal(y)) {
    const Node q = nodes_[y];
    return coefficient_multiply(q.a, coefficient_multiply(x, q.b));
  }
  Node node;
  node.kind = Kind::coefficient_product;
  node.a = literal ? x : std::min(x, y);
  node.b = literal ? y : std::max(x, y);
  return intern(std::move(node));
}

NodeId Graph::coefficient_divide(NodeId x, NodeId y) {
  if (is_zero(x) && !is_zero(y) && !is_singular(*this, y)) return x;
  if (x == y && !is_zero(x) && !is_singular(*this, x)) return one();
  const Node& q = nodes_[y];
  if (is_exact_literal(y)) {
    if (q.literal == 1.0) return x;
    if (is_power_of_two(q.literal)) return coefficient_multiply(number(1.0 / q.literal), x);
    const Node& p = nodes_[x];
    if (is_exact_literal(x) && q.literal != 0.0) {
      const double quotient = p.literal / q.literal;
      const bool in_range = std::abs(quotient) > 0x1p-900 && std::abs(quotient) < 0x1p900 &&
                            std::abs(p.literal) > 0x1p-900 && std::abs(p.literal) < 0x1p900;
      const DoubleDouble back = two_product(quotient, q.literal);
      if (in_range && back.hi == p.literal && back.lo == 0.0) return number(quotient);
    }
  }
  Node node;
  node.kind = Kind::coefficient_quotient;
  node.a = x;
  node.b = y;
  return intern(std::move(node));
}

Term Graph::scaled(NodeId x) {
  if (is_coefficient(x)) return {one(), x, 0};
  const Node& node = nodes_[x];
  if (node.kind == Kind::sum && node.terms.size() == 1 && is_zero(node.a)) return node.terms[0];
  return {x, one(), 0};
}

void Graph::accumulate(LinearForm& form, NodeId coefficient, NodeId x, bool expand) {
  struct Summand {
    NodeId coefficient;
    NodeId node;
  };
  std::vector<Summand> left{{coefficient, x}};
  while (!left.empty()) {
    const Summand s = left.back();
    left.pop_back();
    if (is_coefficient(s.node)) {
      form.constant = coefficient_add(form.constant, coefficient_multiply(s.coefficient, s.node));
      continue;
    }
    const Node& node = nodes_[s.node];
    const bool flat =
        expand || is_literal(s.coefficient, 1.0) || (node.terms.size() == 1 && is_zero(node.a));
    if (node.kind == Kind::sum && flat) {
      const Node sum = node;
      form.constant = coefficient_add(form.constant, coefficient_multiply(s.coefficient, sum.a));
      for (const Term& term : sum.terms)
        left.push_back({coefficient_multiply(s.coefficient, term.coefficient), term.node});
      continue;
    }
    const auto [at, fresh] = form.coefficient.try_emplace(s.node, s.coefficient);
    if (!fresh) at->second = coefficient_add(at->second, s.coefficient);
  }
}

NodeId Graph::from(const LinearForm& form) {
  Node node;
  node.kind = Kind::sum;
  node.a = form.constant;
  for (const auto& [term, coefficient] : form.coefficient)
    if (!is_zero(coefficient) || is_singular(*this, term))
      node.terms.push_back({term, coefficient, 0});
  if (node.terms.empty()) return form.constant;
  if (node.terms.size() == 1 && is_zero(node.a)) {
    if (is_literal(node.terms[0].coefficient, 1.0)) return node.terms[0].node;
  }
  return intern(std::move(node));
}

NodeId Graph::add(Operands of) {
  auto [x, y] = of;
  if (is_coefficient(x) && is_coefficient(y)) return coefficient_add(x, y);
  LinearForm form{zero(), {}};
  accumulate(form, one(), x, false);
  accumulate(form, one(), y, false);
  return from(form);
}

NodeId Graph::expanded(NodeId x) {
  if (is_coefficient(x)) return x;
  LinearForm form{zero(), {}};
  accumulate(form, one(), x, true);
  return from(form);
}

NodeId Graph::times(NodeId coefficient, NodeId x) {
  LinearForm form{zero(), {}};
  accumulate(form, coefficient, x, false);
  return from(form);
}

NodeId Graph::negate(NodeId x) {
  const NodeId minus = number(-1.0);
  if (is_coefficient(x)) return coefficient_multiply(minus, x);
  // A minus sign goes into a sum: x - (y - z) is a sum of three.
  LinearForm form{zero(), {}};
  const Node node = nodes_[x];
  if (node.kind != Kind::sum) return times(minus, x);
  form.constant = coefficient_multiply(minus, node.a);
  for (const Term& term : node.terms)
    form.coefficient[term.node] = coefficient_multiply(minus, term.coefficient);
  return from(form);
}

NodeId Graph::multiply(Operands of) {
  auto [x, y] = of;
  if (is_coefficient(x) && is_coefficient(y)) return coefficient_multiply(x, y);
  if (is_coefficient(x)) return times(x, y);
  if (is_coefficient(y)) return times(y, x);
  NodeId coefficient = one();
  std::map<NodeId, int> factors;
  for (const NodeId side : {x, y}) {
    const Term term = scaled(side);
    coefficient = coefficient_multiply(coefficient, term.coefficient);
    const Node& node = nodes_[term.node];
    if (node.kind == Kind::product) {
      for (const Term& factor : node.terms) factors[factor.node] += factor.exponent;
    } else {
      factors[term.node] += 1;
    }
  }
  Node product;
  product.kind = Kind::product;
  for (const auto& [base, exponent] : factors) {
    if (exponent == 0) continue;
    if (std::abs(exponent) > largest_exponent)
      throw TooLarge("whole powers up to " + std::to_string(largest_exponent));
    product.terms.push_back({base, 0, exponent});
  }
  if (product.terms.empty()) return coefficient;
  const NodeId whole = product.terms.size() == 1 && product.terms[0].exponent == 1
                           ? product.terms[0].node
                           : intern(std::move(product));
  return times(coefficient, whole);
}

NodeId Graph::power(NodeId x, int n) {
  if (std::abs(n) > largest_exponent)
    throw TooLarge("whole powers up to " + std::to_string(largest_exponent));
  if (n == 0) return one();
  if (n == 1) return x;
  if (is_coefficient(x)) {
    if (n < 0) return coefficient_divide(one(), power(x, -n));
    const NodeId half = power(x, n / 2);
    const NodeId even = coefficient_multiply(half, half);
    return n % 2 == 0 ? even : coefficient_multiply(even, x);
  }
  // (c x)^n is c^n x^n, but for large n: c^n alone may overflow, or vanish, where (c x)^n does not.
  constexpr int moderate = 16;
  Term term = scaled(x);
  if (std::abs(n) > moderate && !is_literal(term.coefficient, -1.0)) term = {x, one(), 0};
  const Node base = nodes_[term.node];
  Node product;
  product.kind = Kind::product;
  if (base.kind == Kind::product) {
    for (Term factor : base.terms) {
      const long exponent = static_cast<long>(factor.exponent) * n;
      if (std::abs(exponent) > largest_exponent)
        throw TooLarge("whole powers up to " + std::to_string(largest_exponent));
      factor.exponent = static_cast<int>(exponent);
      product.terms.push_back(factor);
    }
  } else {
    product.terms.push_back({term.node, 0, n});
  }
  const bool plain = product.terms.size() == 1 && product.terms[0].exponent == 1;
  const NodeId whole = plain ? product.terms[0].node : intern(std::move(product));
  return times(power(term.coefficient, n), whole);
}

NodeId Graph::divide(Operands of) {
  auto [x, y] = of;
  if (is_coefficient(x) && is_coefficient(y)) return coefficient_divide(x, y);
  if (is_coefficient(y)) return times(coefficient_divide(one(), y), x);
  return multiply({x, power(y, -1)});
}

NodeId Graph::power(NodeId x, NodeId y) {
  const Node& exponent = nodes_[y];
  if (is_exact_literal(y) && is_whole(exponent.literal)) {
    if (std::abs(exponent.literal) > largest_exponent)
      throw TooLarge("whole powers up to " + std::to_string(largest_exponent));
    return power(x, static_cast<int>(exponent.literal));
  }
  if (is_literal(y, 0.5)) return apply(Function::sqrt, x);
  if (is_literal(x, 1.0)) return x;
  if (!is_coefficient(y)) return apply(Function::exp, multiply({y, apply(Function::log, x)}));
  Node node;
  node.kind = Kind::power;
  node.a = x;
  node.b = y;
  return intern(std::move(node));
}

NodeId Graph::apply(Function f, NodeId x) {
  if (f == Function::abs && !is_coefficient(x))
    throw NotSmooth("abs has no second derivative where its argument is 0");
  if (is_zero(x) && f != Function::log) {
    return f == Function::exp || f == Function::cos ? one() : zero();
  }
  if (is_literal(x, 1.0) && f == Function::log) return zero();
  if (is_literal(x, 1.0) && f == Function::sqrt) return one();
  const Node& node = nodes_[x];
  if (node.kind == Kind::function) {
    if (f == Function::log && node.function == Function::exp) return node.a;
    if (f == Function::exp && node.function == Function::log) return node.a;
  }
  Node out;
  out.kind = Kind::function;
  out.function = f;
  out.a = x;
  return intern(std::move(out));
}

NodeId Graph::minimum(Operands of) {
  auto [x, y] = of;
  if (!is_coefficient(x) || !is_coefficient(y))
    throw NotSmooth("min has no derivative where its arguments are equal");
  Node node;
  node.kind = Kind::minimum;
  node.a = x;
  node.b = y;
  return intern(std::move(node));
}

NodeId Graph::maximum(Operands of) {
  auto [x, y] = of;
  if (!is_coefficient(x) || !is_coefficient(y))
    throw NotSmooth("max has no derivative where its arguments are equal");
  Node node;
  node.kind = Kind::maximum;
  node.a = x;
  node.b = y;
  return intern(std::move(node));
}

NodeId Graph::kernel(Function f, int which, NodeId a, NodeId y, NodeId norm, NodeId exponent) {
  Node node;
  node.kind = Kind::kernel;
  node.function = f;
  node.index = static_cast<std::uint8_t>(which);
  node.a = a;
  node.b = y;
  node.c = norm;
  node.terms.push_back({exponent, 0, 0});
  return intern(std::move(node));
}

std::vector<NodeId> Graph::parts(std::span<const NodeId> of) const {
  std::vector<bool> wanted(nodes_.size(), false);
  for (const NodeId id : of) wanted[id] = true;
  std::vector<NodeId> out;
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    if (!wanted[k]) continue;
    out.push_back(static_cast<NodeId>(k));
    const Node& node = nodes_[k];
    switch (node.kind) {
      case Kind::literal:
      case Kind::parameter:
      case Kind::pi:
      case Kind::euler:
      case Kind::variable:
        break;
      case Kind::function:
        wanted[node.a] = true;
        break;
      case Kind::sum:
        wanted[node.a] = true;
        for (const Term& term : node.terms) wanted[term.node] = wanted[term.coefficient] = true;
        break;
      case Kind::product:
        for (const Term& term : node.terms) wanted[term.node] = true;
        break;
      case Kind::kernel:
        wanted[node.a] = wanted[node.b] = wanted[node.c] = true;
        wanted[node.terms[0].node] = true;
        break;
      default:
        wanted[node.a] = wanted[node.b] = true;
    }
  }
  return {out.rbegin(), out.rend()};
}

}  // namespace stationary::expression
