// Whether an expression x of alpha, xi, zeta, rho and parameters is 0 whatever they are:
//
//   term by term     it is 0 as it is written
//   exactly          it is 0 in residues at random points (residue.hpp): but for a probability
//                    below 1e-30, for all stretches and parameters
//   at points        |x| <= 2^-66 (the size of its terms; what is larger by decimal numbers alone
//                    refutes nothing) at fixed pseudo-random points: stretches
//                    in [1e-3, 1e3], the matrix positive definite, parameters of both signs in
//                    [1e-2, 1e2]; one point where it is not refutes it. What is 0 in residues but for the signs
//                    of roots, which show in a few digits, need be 0 to 2^-40 alone
//
// Coefficients with a branch (abs, min, max; sqrt, log, atan and powers of parameters) are given
// values of their own at points, as if each were one more parameter: min(k, 0) is 0 for one half of
// all k, which proves nothing about the other half. What is 0 only because of how such a
// coefficient depends on its parameters is undecided.
// Points are no proof: what is 0 nearly everywhere passes. They are asked only where residues
// cannot tell, because of functions whose rules they do not know (sin(x + y) = ...) or of roots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "lib/expression/graph.hpp"

namespace stationary::expression {

/// refuted: for some values of the parameters, or for those given. undecided: none of the others,
/// or x is defined at too few of the points.
enum class Verdict : std::uint8_t { term_by_term, exactly, at_points, refuted, undecided };

/// values: of the parameters, where they are known: points with these are looked at as well.
Verdict vanishes(const Graph& graph, NodeId x, std::size_t parameter_count,
                 std::span<const double> values = {});

}  // namespace stationary::expression
