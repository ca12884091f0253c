// Functions of the principal stretches lambda >= mu, written in what is smooth at the circle
// lambda = mu:
//
//   lambda = t/2 + s,  mu = t/2 - s,   s^2 = (t^2 - 4 d)/4,
//
// every subexpression as a + b s with a, b smooth functions of t and d (symmetric_kernel.hpp).
// Exchanging lambda and mu changes the sign of b: a symmetric function is its a, and has no square
// root in it.
#pragma once

#include <stdexcept>

#include "lib/expression/graph.hpp"

namespace stationary::expression {

/// x = even + odd s.
struct EvenOdd {
  NodeId even = 0;
  NodeId odd = 0;
};

/// Every principal stretch in x replaced.
EvenOdd split_at_circle(Graph& graph, NodeId x);

}  // namespace stationary::expression
