#include "lib/expression/root_signs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "lib/expression/residue.hpp"

namespace stationary::expression {
namespace {

class RootSigns {
 public:
  explicit RootSigns(const Graph& graph) : graph_(graph), point_(graph, 1) {}

  std::optional<std::vector<NodeId>> open(NodeId x) {
    std::vector<NodeId> out;
    const std::array<NodeId, 1> root{x};
    for (const NodeId id : graph_.parts(root)) {
      const Node& node = graph_[id];
      const bool is_power = node.kind == Kind::power;
      // exp(c log x) is a power of x too.
      const bool is_root = node.kind == Kind::function &&
                           (node.function == Function::sqrt || node.function == Function::log);
      if (!is_power && !is_root) continue;
      // What varies and is to a power has to be positive (domain.hpp); a parameter may be negative, and its
      // exponent whole.
      if (is_power && graph_.is_coefficient(id) && has_parameter(node.a)) return std::nullopt;
      if (has_sum(node.a) || !of_small_primes(node.a)) out.push_back(node.a);
    }
    return out;
  }

 private:
  static bool of_small_primes(std::uint64_t digits) {
    for (const unsigned prime : {2U, 3U, 5U, 7U, 11U, 13U, 17U, 19U, 23U, 29U, 31U, 37U, 41U, 43U})
      while (digits != 0 && digits % prime == 0) digits /= prime;
    return digits <= 1;
  }
  static bool of_small_primes(const Node& literal) {
    if (literal.index != 0)
      return literal.decimal.known() && of_small_primes(literal.decimal.digits);
    int power = 0;
    const double fraction = std::frexp(std::abs(literal.literal), &power);
    return of_small_primes(static_cast<std::uint64_t>(std::ldexp(fraction, 53)));
  }
  bool of_small_primes(NodeId x) {
    const std::array<NodeId, 1> root{x};
    return std::ranges::all_of(graph_.parts(root), [this](NodeId id) {
      return graph_[id].kind != Kind::literal || of_small_primes(graph_[id]);
    });
  }
  /// Whether there is a sum in it, but for numbers that together are one of small primes: powers, roots and exp are
  /// positive, as squares are modulo p, and of other functions nothing is a square at every point.
  bool has_sum(NodeId x) {
    const Node& node = graph_[x];
    const auto in = [this](NodeId id) { return has_sum(id); };
    switch (node.kind) {
      case Kind::coefficient_sum:
        return has_parameter(x) || !is_short_number(x);
      case Kind::coefficient_product:
      case Kind::coefficient_quotient:
        return in(node.a) || in(node.b);
      case Kind::sum:
        return node.terms.size() > 1 || !graph_.is_zero(node.a) || in(node.terms[0].node) ||
               in(node.terms[0].coefficient);
      case Kind::product:
        return std::ranges::any_of(node.terms, in, &Term::node);
      default:
        return node.kind == Kind::kernel;
    }
  }
  /// Whether a coefficient without parameters is a decimal number of few digits, made of small primes: the same
  /// to its last digit, and not only near it.
  bool is_short_number(NodeId x) {
    const std::optional<Residue> known = point_(x);
    if (!known) return false;
    const Residue tenth = *reciprocal(Residue{10, 10});
    Residue unit{1, 1};
    constexpr double largest = 1e15;
    for (double scaled = std::abs(number(x)); scaled < largest; scaled *= 10.0) {
      const auto digits = static_cast<std::uint64_t>(std::round(scaled));
      const Residue found = residue_of(digits) * unit;
      if (*known == found || *known == -found) return of_small_primes(digits);
      if (scaled == 0.0) break;
      unit = unit * tenth;
    }
    return false;
  }
  double number(NodeId x) const {
    const Node& node = graph_[x];
    switch (node.kind) {
      case Kind::literal:
        return node.literal;
      case Kind::coefficient_sum:
        return number(node.a) + number(node.b);
      case Kind::coefficient_product:
        return number(node.a) * number(node.b);
      case Kind::coefficient_quotient:
        return number(node.a) / number(node.b);
      default:
        return std::numeric_limits<double>::quiet_NaN();
    }
  }
  bool has_parameter(NodeId x) const {
    const std::array<NodeId, 1> root{x};
    return std::ranges::any_of(graph_.parts(root),
                               [this](NodeId id) { return graph_[id].kind == Kind::parameter; });
  }
  const Graph& graph_;
  ResiduePoint point_;
};

}  // namespace

std::optional<std::vector<NodeId>> roots_of_open_sign(const Graph& graph, NodeId x) {
  return RootSigns(graph).open(x);
}

}  // namespace stationary::expression
