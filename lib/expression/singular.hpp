// Parts of an expression that are infinite or no number whatever the variables are:
//
//   1/0,  0^-1,  log 0,  a literal beyond the range of doubles,  and all that is made of them.
//
// 0 times such a part is not 0: it is what is left of a kink or a pole, sqrt(alpha^2)/alpha, at
// alpha = 0.
#pragma once

#include "lib/expression/graph.hpp"

namespace stationary::expression {

/// Of a node of the graph.
bool is_singular(const Graph& graph, NodeId x);

/// Of a node that is about to be made: whether its index is to be 1, where an index means nothing
/// else (is_singular() looks there).
bool has_singular_part(const Graph& graph, const Node& node);

}  // namespace stationary::expression
