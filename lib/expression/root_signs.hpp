// Whether the residues of an expression (residue.hpp) give its roots and powers the signs that those of real
// numbers have. They do of products of variables, parameters and numbers of small primes, which are squares modulo p
// where they are positive. A sum may be a number times a square however it is written, and a number of other primes
// none: of these the sign is open.
#pragma once

#include <optional>
#include <vector>

#include "lib/expression/graph.hpp"

namespace stationary::expression {

/// Under the roots and powers that x is made of, those whose sign is open; nothing where a parameter, which may be
/// negative, is to the power of another number.
std::optional<std::vector<NodeId>> roots_of_open_sign(const Graph& graph, NodeId x);

}  // namespace stationary::expression
