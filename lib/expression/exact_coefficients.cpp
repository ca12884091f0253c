#include "lib/expression/exact_coefficients.hpp"

#include <algorithm>
#include <cstdint>

#include "lib/number/double_double_functions.hpp"
#include "lib/number/interval_functions.hpp"

namespace stationary::expression {

ExactCoefficients::ExactCoefficients(const Graph& graph, std::span<const NodeId> roots,
                                     std::span<const Interval> parameters)
    : graph_(graph), parameters_(parameters.begin(), parameters.end()) {
  // Of roots of parameters, a point where all of them are squares.
  const std::vector<NodeId> parts = graph.parts(roots);
  constexpr std::uint64_t tries = 10000;
  for (std::uint64_t seed = 1; seed < tries; ++seed) {
    residues_.emplace(graph, seed);
    if (std::ranges::all_of(parts, [&](NodeId id) {
          return !graph.is_coefficient(id) || (*residues_)(id).has_value();
        }))
      return;
  }
  throw NotNormal("coefficients without residues");
}

ExactNumber ExactCoefficients::operator()(NodeId coefficient) {
  const Interval at = value(coefficient);
  if (!at.bounded()) throw NotNormal("a coefficient that is not bounded");
  return snapped({at, *(*residues_)(coefficient)});
}

Interval ExactCoefficients::value(NodeId x) {
  const auto found = values_.find(x);
  if (found != values_.end()) return found->second;
  const Node& node = graph_[x];
  Interval out = Interval::entire();
  switch (node.kind) {
    case Kind::literal:
      out = node.index == 0 ? Interval(node.literal) : Interval::decimal(node.literal);
      break;
    case Kind::parameter:
      out = parameters_[node.index];
      break;
    case Kind::pi:
      out = Interval(double_double_pi.hi, above(double_double_pi.hi));
      break;
    case Kind::euler:
      out = Interval(double_double_e.hi, above(double_double_e.hi));
      break;
    case Kind::coefficient_sum:
      out = value(node.a) + value(node.b);
      break;
    case Kind::coefficient_product:
      out = node.a == node.b ? square(value(node.a)) : value(node.a) * value(node.b);
      break;
    case Kind::coefficient_quotient:
      out = value(node.a) / value(node.b);
      break;
    case Kind::minimum:
      out = smaller(value(node.a), value(node.b));
      break;
    case Kind::maximum:
      out = -smaller(-value(node.a), -value(node.b));
      break;
    case Kind::power:
      out = pow(value(node.a), value(node.b));
      break;
    case Kind::function: {
      const Interval of = value(node.a);
      switch (node.function) {
        case Function::sqrt:
          out = sqrt(of);
          break;
        case Function::exp:
          out = exp(of);
          break;
        case Function::log:
          out = log(of);
          break;
        case Function::sin:
          out = sin(of);
          break;
        case Function::cos:
          out = cos(of);
          break;
        case Function::tan:
          out = tan(of);
          break;
        case Function::tanh:
          out = tanh(of);
          break;
        case Function::atan:
          out = atan(of);
          break;
        case Function::abs:
          out = absolute(of);
          break;
        case Function::power:
          break;
      }
      break;
    }
    default:
      break;
  }
  values_.emplace(x, out);
  return out;
}

}  // namespace stationary::expression
