#include "lib/formula/vanishing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <vector>

#include "lib/expression/residue.hpp"
#include "lib/formula/expression.hpp"
#include "lib/number/elementary.hpp"
#include "lib/tape/tape_run.hpp"

namespace stationary::expression {
namespace {

/// Numbers in [0, 1) that are the same everywhere (Knuth's 64-bit generator).
class Points {
 public:
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  /// In (1/range, range), uniform in its logarithm.
  double scale(double range) { return pow(range, 2.0 * next() - 1.0); }

 private:
  std::uint64_t state_ = 20101131;
};

/// Factors up to which stretches and parameters are from 1. Narrow ranges are there for what is
/// defined, or large enough to be seen, in them alone.
struct Range {
  double stretch;
  double parameter;
  bool signs;  ///< parameters of both signs
};
constexpr std::array<Range, 4> ranges{
    {{3.0, 4.0, false}, {10.0, 10.0, true}, {1e3, 100.0, true}, {100.0, 100.0, false}}};
constexpr int points_per_range = 32;
constexpr int enough = 12;  ///< of points in a range
constexpr int fewest = 8;   ///< in all

struct Point {
  std::array<double, 4> stretch;
  std::vector<double> parameters;
};

Point random_point(Points& points, const Range& range, std::size_t parameter_count) {
  Point out;
  const double xi = points.scale(range.stretch);
  const double zeta = points.scale(range.stretch);
  const double alpha = (1.8 * points.next() - 0.9) * std::sqrt(xi * zeta);
  out.stretch = {alpha, xi, zeta, points.scale(range.stretch)};
  for (std::size_t k = 0; k < parameter_count; ++k) {
    const double size = points.scale(range.parameter);
    const bool negative = points.next() < 0.5;
    out.parameters.push_back(range.signs && negative ? -size : size);
  }
  return out;
}

bool has_branch(Operation operation) {
  switch (operation) {
    case Operation::absolute:
    case Operation::minimum:
    case Operation::maximum:
    case Operation::sqrt:
    case Operation::log:
    case Operation::atan:
    case Operation::power:
      return true;
    default:
      return false;
  }
}

int operand_count(Operation operation) {
  switch (operation) {
    case Operation::add:
    case Operation::multiply:
    case Operation::divide:
    case Operation::power:
    case Operation::minimum:
    case Operation::maximum:
      return 2;
    case Operation::literal:
    case Operation::decimal:
    case Operation::parameter:
    case Operation::pi:
    case Operation::euler:
      return 0;
    default:
      return 1;
  }
}

/// Every step with a branch that a parameter decides is a new parameter; counts these too.
Coefficients without_branches(Coefficients c, std::size_t& parameter_count) {
  std::vector<bool> varies(c.steps.size(), false);
  for (std::size_t k = 0; k < c.steps.size(); ++k) {
    Instruction& step = c.steps[k];
    const int operands = operand_count(step.operation);
    varies[k] = step.operation == Operation::parameter || (operands >= 1 && varies[step.a]) ||
                (operands == 2 && varies[step.b]);
    if (varies[k] && has_branch(step.operation)) {
      step.operation = Operation::parameter;
      step.a = static_cast<std::uint16_t>(parameter_count++);
    }
  }
  return c;
}

/// Numbers, pi and e counted as inputs: the size of what is made of them alone, which may be 0 to all digits.
Coefficients with_numbers_as_inputs(Coefficients c) {
  for (Instruction& step : c.steps) {
    const bool pi = step.operation == Operation::pi;
    if (pi || step.operation == Operation::euler) {
      step.a = static_cast<std::uint16_t>(c.literals.size());
      c.literals.push_back(pi ? std::numbers::pi : std::numbers::e);
      step.operation = Operation::decimal;
    }
    if (step.operation == Operation::literal) step.operation = Operation::decimal;
  }
  return c;
}

class Test {
 public:
  Test(const Graph& graph, NodeId x) : writer_(graph) {
    const std::array<NodeId, 1> root{x};
    program_ = writer_.program(anisotropic_inputs, root);
  }

  const Coefficients& coefficients() const { return writer_.coefficients(); }

  enum class Outcome { undefined, zero, too_small, not_zero };

  /// sized: c with numbers as inputs. relative: of the size of its terms, below which it is 0.
  Outcome operator()(const Coefficients& c, const Coefficients& sized, const Point& at,
                     double relative) const {
    const auto value =
        double(value_at<DoubleDouble>(c, at, [](double x) { return DoubleDouble(x); }));
    const Conditioned size = value_at<Conditioned>(sized, at, Conditioned::input);
    if (!std::isfinite(value) || !std::isfinite(size.condition)) return Outcome::undefined;
    if (std::abs(value) > std::max(relative * size.condition, least)) {
      // Decimal numbers are doubles here.
      const bool certain = !c.has_decimals || std::abs(value) > 0x1p-50 * size.condition;
      return certain ? Outcome::not_zero : Outcome::undefined;
    }
    return size.condition > least ? Outcome::zero : Outcome::too_small;
  }

 private:
  /// Terms below this have lost digits to underflow, or are 0.
  static constexpr double least = 1e-200;

  /// The one result of the program.
  template <class R, class Input>
  R value_at(const Coefficients& c, const Point& at, const Input& input) const {
    std::vector<R> parameters(at.parameters.size());
    std::array<R, largest_constant_count> constants;
    Workspace<R, largest_place_count> workspace;
    std::ranges::transform(at.parameters, parameters.begin(), input);
    compute_constants<R>(c, parameters.data(), constants.data());
    std::ranges::transform(at.stretch, workspace.data(), input);
    run<R>(program_, c.literals.data(), constants.data(), workspace.data());
    const Result result = program_.results[0];
    return result.constant ? constants[result.at] : workspace.data()[result.at];
  }

  TapeWriter writer_;
  Program program_;
};

constexpr double all_digits = 0x1p-66;

/// at_points, refuted or undecided; values: of all parameters, or none.
Verdict at_points(const Test& test, const Coefficients& c, std::size_t parameter_count,
                  std::span<const double> values = {}, double relative = all_digits) {
  const Coefficients sized = with_numbers_as_inputs(c);
  Points points;
  int zero = 0;
  for (const Range& range : ranges) {
    int here = 0;
    for (int k = 0; k < points_per_range && here < enough; ++k) {
      Point at = random_point(points, range, parameter_count);
      if (!values.empty()) at.parameters.assign(values.begin(), values.end());
      const Test::Outcome outcome = test(c, sized, at, relative);
      if (outcome == Test::Outcome::not_zero) return Verdict::refuted;
      // A coefficient may well be 0 for the values given.
      here += outcome == Test::Outcome::zero ||
              (outcome == Test::Outcome::too_small && !values.empty());
    }
    zero += here;
  }
  return zero >= fewest ? Verdict::at_points : Verdict::undecided;
}

/// The verdict of points, of all parameters and of those given.
Verdict numerically(const Graph& graph, NodeId x, std::size_t parameter_count,
                    std::span<const double> values) {
  const Test test(graph, x);
  std::size_t freed_count = parameter_count;
  const Coefficients freed = without_branches(test.coefficients(), freed_count);
  const Verdict anyhow = at_points(test, freed, freed_count);
  if (values.empty()) {
    if (anyhow != Verdict::refuted || freed_count == parameter_count) return anyhow;
    const Verdict itself = at_points(test, test.coefficients(), parameter_count);
    return itself == Verdict::refuted ? itself : Verdict::undecided;
  }
  const Verdict given = at_points(test, test.coefficients(), parameter_count, values);
  if (given == Verdict::refuted) return given;
  return anyhow == Verdict::at_points && given == anyhow ? anyhow : Verdict::undecided;
}

/// Of what is 0 but for the signs of roots: these show at points, of the parameters given and of others, in a
/// few digits, and are no proof there.
Verdict with_signs(const Graph& graph, NodeId x, std::size_t parameter_count,
                   std::span<const double> values) {
  constexpr double few_digits = 0x1p-40;
  const Test test(graph, x);
  const Coefficients& c = test.coefficients();
  const Verdict given = at_points(test, c, parameter_count, values, few_digits);
  if (given != Verdict::at_points || values.empty()) return given;
  const Verdict others = at_points(test, c, parameter_count, {}, few_digits);
  return others == Verdict::refuted ? Verdict::undecided : given;
}

/// Functions that may be related by more than residues know.
bool has_other_rules(const Graph& graph, NodeId x) {
  const std::array<NodeId, 1> root{x};
  return std::ranges::any_of(graph.parts(root), [&](NodeId id) {
    const Node& node = graph[id];
    // Logarithms, powers and roots of numbers: log(6) = log(2) + log(3).
    if (graph.is_coefficient(id) && (node.kind == Kind::function || node.kind == Kind::power))
      return true;
    switch (node.kind) {
      case Kind::minimum:
      case Kind::maximum:
        return true;
      case Kind::function:
        return node.function != Function::sqrt && node.function != Function::exp &&
               node.function != Function::log && node.function != Function::tanh;
      case Kind::kernel:
        return node.function != Function::exp && node.function != Function::log &&
               node.function != Function::power;
      default:
        return false;
    }
  });
}

}  // namespace

Verdict vanishes(const Graph& graph, NodeId x, std::size_t parameter_count,
                 std::span<const double> values) {
  if (!values.empty() && values.size() != parameter_count)
    throw std::invalid_argument("as many values as parameters, or none");
  if (graph.is_zero(x)) return Verdict::term_by_term;
  if (parameter_count > largest_parameter_count) return Verdict::undecided;
  const Residues formally = residues(graph, x);
  if (formally == Residues::zero) return Verdict::exactly;
  if (formally == Residues::zero_but_for_signs)
    return with_signs(graph, x, parameter_count, values);
  const Verdict out = numerically(graph, x, parameter_count, values);
  // No identity by the rules of exp, log and powers, but small wherever it was tried.
  const bool refuted = formally == Residues::not_zero && !has_other_rules(graph, x);
  return out == Verdict::at_points && refuted ? Verdict::undecided : out;
}

}  // namespace stationary::expression
