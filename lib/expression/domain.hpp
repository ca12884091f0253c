// Where a formula is defined: what must be positive,
//
//   x > 0    of log(x), and of sqrt(x) and x^r of what varies, r no whole number;   what its user
//            asks for besides
//   x != 0   of 1/x and of x to a negative whole power;       the domain falls into parts there
//
// What holds of every stretch tensor (d > 0, 1 + rho^2 > 0) is no condition, a factor that has a
// sign is left out of its product, and a product is not 0 where no factor is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/expression/graph.hpp"

namespace stationary::expression {

struct Condition {
  NodeId node = 0;
  bool positive = true;  ///< else: not 0
  std::string text;      ///< as it is written: "1 - (I1 - 3)/Jm > 0"
};

/// Adds what x > 0 asks for beyond what always holds; text: the condition, for a person.
void require_positive(Graph& graph, NodeId x, std::string_view text, std::vector<Condition>& out);
/// Likewise x != 0.
void require_nonzero(Graph& graph, NodeId x, std::string_view text, std::vector<Condition>& out);

/// What is known of the sign of x wherever the conditions of its own parts hold.
enum class Sign : std::uint8_t { unknown, not_negative, positive };
Sign sign(const Graph& graph, NodeId x);

}  // namespace stationary::expression
