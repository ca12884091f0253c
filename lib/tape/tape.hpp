// An expression and its derivatives as lists of simple operations on a few numbers:
//
//   out = a + b,  a - b,  a b,  a/b,  a^2,  a + k b,  k a,  log a, ...
//
// Two parts. The coefficients (all that is made of numbers and parameters) are computed once for a
// set of parameters: constants k. What varies is computed at every evaluation: a program takes its
// inputs in the first places of a small workspace and leaves each result in a place or in a
// constant. Places are used again as soon as their number is not needed any more.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lib/expression/graph.hpp"

namespace stationary::expression {

enum class Operation : std::uint8_t {
  // Of places, in a program; of earlier values, in the list of coefficients.
  add,
  subtract,
  multiply,
  divide,
  square,
  negate,
  reciprocal,
  sqrt,
  exp,
  log,
  sin,
  cos,
  tan,
  tanh,
  atan,
  // a and a constant k: b counts constants (add_scaled: a + k b, c counts constants).
  add_constant,
  multiply_constant,
  constant,  ///< b alone
  add_scaled,
  power,
  // a and a literal, likewise.
  add_literal,
  multiply_literal,
  add_literal_scaled,
  kernel,  ///< number a of Program::kernels
  // Of coefficients only.
  literal,
  decimal,  ///< a literal that is the rounded value of what was written
  parameter,
  pi,
  euler,
  absolute,
  minimum,
  maximum
};

struct Instruction {
  Operation operation;
  std::uint16_t out = 0;
  std::uint16_t a = 0;
  std::uint16_t b = 0;
  std::uint16_t c = 0;
};

/// symmetric_kernel.hpp: of the numbers in places a, y, norm.
struct KernelCall {
  Function function;
  std::uint8_t index;
  std::uint16_t a;
  std::uint16_t y;
  std::uint16_t norm;
  std::uint16_t exponent;  ///< a constant; of Function::power
};

struct Result {
  bool constant = false;
  std::uint16_t at = 0;
};

struct Program {
  std::vector<Instruction> code;
  std::vector<KernelCall> kernels;
  std::vector<Result> results;
};

/// Bounds that a workspace on the stack is made for.
constexpr std::size_t largest_node_count = 256;  ///< of the expression as it is written
constexpr std::size_t largest_place_count = 96;
constexpr std::size_t largest_constant_count = 96;
constexpr std::size_t largest_coefficient_steps = 256;
constexpr std::size_t largest_parameter_count = 32;

/// What the programs of one potential share.
struct Coefficients {
  std::vector<double> literals;
  std::vector<Instruction> steps;        ///< step k leaves its value in k
  std::vector<std::uint16_t> constants;  ///< which values are the constants
  bool has_decimals = false;             ///< literals that are not the doubles they round to
};

/// Makes programs from one graph, with one list of coefficients.
class TapeWriter {
 public:
  explicit TapeWriter(const Graph& graph) : graph_(graph) {}

  /// The inputs in the places 0, 1, ...; the results in the order asked for. Throws TooLarge.
  Program program(std::span<const Variable> inputs, std::span<const NodeId> results);

  const Coefficients& coefficients() const { return coefficients_; }

  std::uint16_t literal(double value);
  std::uint16_t constant(NodeId coefficient);

 private:
  std::uint16_t step(NodeId coefficient);

  const Graph& graph_;
  Coefficients coefficients_;
  std::map<NodeId, std::uint16_t> step_of_;
  std::map<NodeId, std::uint16_t> constant_of_;
  std::map<double, std::uint16_t> literal_of_;
};

}  // namespace stationary::expression
