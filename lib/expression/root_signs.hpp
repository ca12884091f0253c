// Whether the residues of an expression (residue.hpp) give its roots and powers the signs that those of real
// numbers have: what is under a root has numbers of small primes alone, which are squares modulo p as they
// are of real numbers, and no parameter is to the power of another.
#pragma once

#include "lib/expression/graph.hpp"

namespace stationary::expression {

/// Of all roots and powers that x is made of. false: not known.
bool roots_have_real_signs(const Graph& graph, NodeId x);

}  // namespace stationary::expression
