#include "lib/expression/symmetric_kernel.hpp"

namespace stationary::expression {

NodeId derivative(Graph& g, Function f, NodeId x) {
  switch (f) {
    case Function::sqrt:
      return g.divide({g.number(0.5), g.apply(Function::sqrt, x)});
    case Function::exp:
      return g.apply(Function::exp, x);
    case Function::log:
      return g.divide({g.one(), x});
    case Function::sin:
      return g.apply(Function::cos, x);
    case Function::cos:
      return g.negate(g.apply(Function::sin, x));
    case Function::tan:
      return g.add({g.one(), g.power(g.apply(Function::tan, x), 2)});
    case Function::tanh:
      return g.subtract({g.one(), g.power(g.apply(Function::tanh, x), 2)});
    case Function::atan:
      return g.divide({g.one(), g.add({g.one(), g.power(x, 2)})});
    case Function::abs:
    case Function::power:
      break;
  }
  throw std::logic_error("no derivative");
}

namespace {

NodeId with_index(Graph& g, const Node& kernel, int derivatives, KernelPart part) {
  return g.kernel(kernel.function, kernel_index(derivatives, part), kernel.a, kernel.b, kernel.c,
                  kernel.terms[0].node);
}

}  // namespace

NodeId kernel_slope_a(Graph& g, NodeId kernel) {
  const Node node = g[kernel];
  if (node.function == Function::log) {
    // Of f' = 1/x: E = a/norm, O = -1/norm, O_y = -1/norm^2.
    switch (kernel_part(node.index)) {
      case KernelPart::even:
        return g.divide({node.a, node.c});
      case KernelPart::odd:
        return g.negate(g.power(node.c, -1));
      case KernelPart::odd_y:
        return g.negate(g.power(node.c, -2));
      case KernelPart::odd_yy:
        return g.multiply({g.number(-2.0), g.power(node.c, -3)});
    }
  }
  return with_index(g, node, kernel_derivatives(node.index) + 1, kernel_part(node.index));
}

NodeId kernel_slope_y(Graph& g, NodeId kernel) {
  const Node node = g[kernel];
  const int derivatives = kernel_derivatives(node.index);
  switch (kernel_part(node.index)) {
    case KernelPart::even:
      if (node.function == Function::log) return g.multiply({g.number(-0.5), g.power(node.c, -1)});
      return g.multiply({g.number(0.5), with_index(g, node, derivatives + 1, KernelPart::odd)});
    case KernelPart::odd:
      return with_index(g, node, derivatives, KernelPart::odd_y);
    case KernelPart::odd_y:
      return with_index(g, node, derivatives, KernelPart::odd_yy);
    case KernelPart::odd_yy:
      break;
  }
  throw std::logic_error("a third derivative of a potential");
}

}  // namespace stationary::expression
