// The even and the odd part of a function of a + b s, where s^2 is known and smooth and s is not
// (half the difference of the principal stretches). With y = b^2 s^2,
//
//   f(a + b s) = E(a, y) + b s O(a, y),
//   E = (f(a + sqrt y) + f(a - sqrt y))/2,   O = (f(a + sqrt y) - f(a - sqrt y))/(2 sqrt y),
//
// both smooth at y = 0, and so are their derivatives:
//   E_a = E[f'],  E_y = O[f']/2,  O_a = O[f'],  O_y and O_yy kernels of their own.
// A kernel node is (f, derivatives of f taken, which of E, O, O_y, O_yy) of (a, y), with the
// product (a + sqrt y)(a - sqrt y) beside it, which is often known better than as a^2 - y.
#pragma once

#include "lib/expression/graph.hpp"

namespace stationary::expression {

enum class KernelPart : std::uint8_t { even, odd, odd_y, odd_yy };

/// Node::index of a kernel node.
constexpr int kernel_index(int derivatives, KernelPart part) {
  return 4 * derivatives + static_cast<int>(part);
}
constexpr int kernel_derivatives(int index) { return index / 4; }
constexpr KernelPart kernel_part(int index) { return static_cast<KernelPart>(index % 4); }

/// f'(x) of one of the functions (not abs, not power).
NodeId derivative(Graph& graph, Function f, NodeId x);

/// d/da and d/dy of a kernel node.
NodeId kernel_slope_a(Graph& graph, NodeId kernel);
NodeId kernel_slope_y(Graph& graph, NodeId kernel);

}  // namespace stationary::expression
