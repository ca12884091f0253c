// Whether the residues of an expression (residue.hpp) give its roots and powers the signs that those of real
// numbers have. They do
//
//   of products of variables and numbers     where the numbers are made of small primes, squares modulo p
//   of what is no square at some point       there it has no root, so that it is not a number times a square
//
// and where no parameter is to the power of another. Of what has a sum in it and is a square at every point the sign
// is open.
#pragma once

#include <optional>
#include <vector>

#include "lib/expression/graph.hpp"

namespace stationary::expression {

/// Under the roots and powers that x is made of, those whose sign is open; nothing where that of another is not
/// known. no_square: by node, whether it was none at some point.
std::optional<std::vector<NodeId>> roots_of_open_sign(const Graph& graph, NodeId x,
                                                      const std::vector<bool>& no_square);

}  // namespace stationary::expression
