// An expression as a function of its parameters too: what a change of each does to a potential's
// derivatives (bounds of errors, a family followed in a parameter), from one short program instead
// of a dual number of many directions through all of it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lib/expression/graph.hpp"

namespace stationary::expression {

/// x with parameters as variables. None where they enter by abs, min, max or as the exponent of a
/// principal stretch.
std::optional<NodeId> with_parameters_varied(Graph& graph, NodeId x);

/// All of x, then for each parameter the derivative of all of x in it, parameters as variables.
/// Empty where one cannot be had.
std::vector<NodeId> parameter_slopes(Graph& graph, std::span<const NodeId> x, int parameter_count);

}  // namespace stationary::expression
