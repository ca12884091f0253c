#include "lib/tape/tape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>

namespace stationary::expression {
namespace {

Operation operation_of(Function f) {
  switch (f) {
    case Function::sqrt:
      return Operation::sqrt;
    case Function::exp:
      return Operation::exp;
    case Function::log:
      return Operation::log;
    case Function::sin:
      return Operation::sin;
    case Function::cos:
      return Operation::cos;
    case Function::tan:
      return Operation::tan;
    case Function::tanh:
      return Operation::tanh;
    case Function::atan:
      return Operation::atan;
    case Function::abs:
      return Operation::absolute;
    case Function::power:
      break;
  }
  return Operation::power;
}

/// Places among the operands a, b of an operation.
int place_operands(Operation operation) {
  switch (operation) {
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::divide:
    case Operation::add_scaled:
    case Operation::add_literal_scaled:
      return 2;
    case Operation::kernel:
    case Operation::constant:
      return 0;
    default:
      return 1;
  }
}

/// One program in the making: operations on values of which there are as many as it takes, then
/// places for them.
class ProgramWriter {
 public:
  ProgramWriter(const Graph& graph, TapeWriter& tape, std::span<const Variable> inputs)
      : graph_(graph), tape_(tape), input_count_(static_cast<std::uint32_t>(inputs.size())) {
    for (std::size_t k = 0; k < inputs.size(); ++k)
      input_of_.emplace(static_cast<int>(inputs[k]), static_cast<std::uint32_t>(k));
  }

  Program write(std::span<const NodeId> results);

 private:
  using Value = std::uint32_t;  ///< the inputs, then step by step
  struct Step {
    Operation operation;
    Value a = 0;
    Value b = 0;
    std::uint16_t c = 0;
    auto operator<=>(const Step&) const = default;
  };
  struct Kernel {
    const Node* node;
    Value a, y, norm;
    std::uint16_t exponent;
  };

  Value emit(Operation operation, Value a, Value b = 0, std::uint16_t c = 0);
  Value value(NodeId x) const { return value_of_.at(x); }
  Value value_of(NodeId x);
  Value sum(const Node& node);
  Value scaled_sum(std::optional<Value> before, const Term& term);
  Value product(const Node& node);
  Value power(Value base, int n);
  Value kernel(const Node& node);
  std::vector<NodeId> order(std::span<const NodeId> results) const;
  void count_reciprocals(std::span<const NodeId> parts);
  std::vector<Value> last_uses(std::span<const Value> kept) const;

  const Graph& graph_;
  TapeWriter& tape_;
  std::uint32_t input_count_;
  std::map<int, std::uint32_t> input_of_;
  std::map<NodeId, Value> value_of_;
  std::map<NodeId, int> reciprocals_;
  std::vector<Step> steps_;
  std::vector<Kernel> kernels_;
  std::map<Step, Value> known_;
};

ProgramWriter::Value ProgramWriter::emit(Operation operation, Value a, Value b, std::uint16_t c) {
  if (operation == Operation::add || operation == Operation::multiply)
    std::tie(a, b) = std::minmax({a, b});
  const Step step{operation, a, b, c};
  const auto found = known_.find(step);
  if (found != known_.end()) return found->second;
  const Value out = input_count_ + static_cast<Value>(steps_.size());
  steps_.push_back(step);
  known_.emplace(step, out);
  return out;
}

/// before + coefficient * term.
ProgramWriter::Value ProgramWriter::scaled_sum(std::optional<Value> before, const Term& term) {
  const Value x = value(term.node);
  const NodeId k = term.coefficient;
  if (graph_.is_literal(k, 1.0)) return before ? emit(Operation::add, *before, x) : x;
  if (graph_.is_literal(k, -1.0))
    return before ? emit(Operation::subtract, *before, x) : emit(Operation::negate, x);
  if (graph_.is_exact_literal(k)) {
    const std::uint16_t at = tape_.literal(graph_[k].literal);
    return before ? emit(Operation::add_literal_scaled, *before, x, at)
                  : emit(Operation::multiply_literal, x, at);
  }
  const std::uint16_t at = tape_.constant(k);
  return before ? emit(Operation::add_scaled, *before, x, at)
                : emit(Operation::multiply_constant, x, at);
}

ProgramWriter::Value ProgramWriter::sum(const Node& node) {
  // A term that is simply added begins.
  std::vector<Term> terms = node.terms;
  const auto plain = std::find_if(terms.begin(), terms.end(), [&](const Term& term) {
    return graph_.is_literal(term.coefficient, 1.0);
  });
  if (plain != terms.end()) std::rotate(terms.begin(), plain, plain + 1);
  std::optional<Value> out;
  for (const Term& term : terms) out = scaled_sum(out, term);
  if (graph_.is_zero(node.a)) return *out;
  if (graph_.is_exact_literal(node.a))
    return emit(Operation::add_literal, *out, tape_.literal(graph_[node.a].literal));
  return emit(Operation::add_constant, *out, tape_.constant(node.a));
}

ProgramWriter::Value ProgramWriter::power(Value base, int n) {
  if (n == 1) return base;
  if (n % 2 == 0) return power(emit(Operation::square, base), n / 2);
  return emit(Operation::multiply, power(base, n - 1), base);
}

/// Divisions are shared where a reciprocal is wanted more than once.
ProgramWriter::Value ProgramWriter::product(const Node& node) {
  std::optional<Value> numerator;
  std::optional<Value> denominator;
  const auto times = [&](std::optional<Value>& side, Value factor) {
    side = side ? emit(Operation::multiply, *side, factor) : factor;
  };
  const bool all_below =
      std::ranges::all_of(node.terms, [](const Term& factor) { return factor.exponent < 0; });
  for (const Term& factor : node.terms) {
    const Value base = value(factor.node);
    if (factor.exponent > 0) {
      times(numerator, power(base, factor.exponent));
    } else if (reciprocals_.at(factor.node) > 1 || all_below) {
      times(numerator, power(emit(Operation::reciprocal, base), -factor.exponent));
    } else {
      times(denominator, power(base, -factor.exponent));
    }
  }
  return denominator ? emit(Operation::divide, *numerator, *denominator) : *numerator;
}

ProgramWriter::Value ProgramWriter::kernel(const Node& node) {
  const bool power = node.function == Function::power;
  // A number of its own where an operand is a coefficient: nothing else takes both.
  const auto operand = [&](NodeId x) {
    return graph_.is_coefficient(x) ? emit(Operation::constant, 0, tape_.constant(x)) : value(x);
  };
  kernels_.push_back({&node, operand(node.a), operand(node.b), operand(node.c),
                      power ? tape_.constant(node.terms[0].node) : std::uint16_t{0}});
  return emit(Operation::kernel, static_cast<Value>(kernels_.size() - 1));
}

ProgramWriter::Value ProgramWriter::value_of(NodeId x) {
  const Node& node = graph_[x];
  switch (node.kind) {
    case Kind::variable:
      return input_of_.at(node.index);
    case Kind::sum:
      return sum(node);
    case Kind::product:
      return product(node);
    case Kind::power:
      return emit(Operation::power, value(node.a), tape_.constant(node.b));
    case Kind::function:
      return emit(operation_of(node.function), value(node.a));
    case Kind::kernel:
      return kernel(node);
    default:
      throw std::logic_error("a coefficient is no value of a program");
  }
}

/// What varies, operands before what they enter and each as late as that allows.
std::vector<NodeId> ProgramWriter::order(std::span<const NodeId> results) const {
  std::vector<NodeId> out;
  std::vector<bool> done(graph_.size(), false);
  std::vector<std::pair<NodeId, bool>> left;
  for (std::size_t k = results.size(); k-- > 0;) left.emplace_back(results[k], false);
  while (!left.empty()) {
    const auto [id, entered] = left.back();
    left.pop_back();
    if (done[id] || graph_.is_coefficient(id)) continue;
    if (entered) {
      done[id] = true;
      out.push_back(id);
      continue;
    }
    left.emplace_back(id, true);
    const Node& node = graph_[id];
    if (node.kind == Kind::function || node.kind == Kind::power) left.emplace_back(node.a, false);
    if (node.kind == Kind::kernel)
      for (const NodeId operand : {node.a, node.b, node.c}) left.emplace_back(operand, false);
    if (node.kind == Kind::sum || node.kind == Kind::product)
      for (const Term& term : node.terms) left.emplace_back(term.node, false);
  }
  return out;
}

void ProgramWriter::count_reciprocals(std::span<const NodeId> parts) {
  for (const NodeId id : parts) {
    if (graph_[id].kind != Kind::product) continue;
    for (const Term& factor : graph_[id].terms)
      if (factor.exponent < 0) ++reciprocals_[factor.node];
  }
}

/// Of each value the last step that reads it; never, for those kept.
std::vector<ProgramWriter::Value> ProgramWriter::last_uses(std::span<const Value> kept) const {
  std::vector<Value> last(input_count_ + steps_.size(), 0);
  for (Value k = 0; k < steps_.size(); ++k) {
    const Step& step = steps_[k];
    const int operands = place_operands(step.operation);
    if (operands >= 1) last[step.a] = k;
    if (operands == 2) last[step.b] = k;
    if (step.operation == Operation::kernel) {
      const Kernel& call = kernels_[step.a];
      last[call.a] = last[call.y] = last[call.norm] = k;
    }
  }
  for (const Value v : kept) last[v] = std::numeric_limits<Value>::max();
  return last;
}

Program ProgramWriter::write(std::span<const NodeId> results) {
  const std::vector<NodeId> parts = order(results);
  count_reciprocals(parts);
  for (const NodeId id : parts) {
    const Value v = value_of(id);
    value_of_.emplace(id, v);
  }
  std::vector<Value> kept;
  for (const NodeId id : results)
    if (!graph_.is_coefficient(id)) kept.push_back(value(id));
  const std::vector<Value> last = last_uses(kept);

  Program out;
  std::vector<std::uint16_t> place(last.size(), 0);
  std::vector<std::uint16_t> free;
  auto used = static_cast<std::uint16_t>(input_count_);
  const auto release = [&](Value v, Value now) {
    if (last[v] == now && std::ranges::find(free, place[v]) == free.end()) free.push_back(place[v]);
  };
  for (std::uint16_t k = 0; k < input_count_; ++k) place[k] = k;
  for (Value k = 0; k < steps_.size(); ++k) {
    const Step& step = steps_[k];
    Instruction instruction{step.operation, 0, static_cast<std::uint16_t>(step.a),
                            static_cast<std::uint16_t>(step.b), step.c};
    const int operands = place_operands(step.operation);
    if (operands >= 1) instruction.a = place[step.a];
    if (operands == 2) instruction.b = place[step.b];
    if (step.operation == Operation::kernel) {
      const Kernel& call = kernels_[step.a];
      out.kernels.push_back({call.node->function, call.node->index, place[call.a], place[call.y],
                             place[call.norm], call.exponent});
      release(call.a, k);
      release(call.y, k);
      release(call.norm, k);
    }
    if (operands >= 1) release(step.a, k);
    if (operands == 2) release(step.b, k);
    if (free.empty()) {
      if (used == largest_place_count)
        throw TooLarge("an expression that needs at most " + std::to_string(largest_place_count) +
                       " numbers at a time");
      place[input_count_ + k] = used++;
    } else {
      place[input_count_ + k] = free.back();
      free.pop_back();
    }
    instruction.out = place[input_count_ + k];
    out.code.push_back(instruction);
  }
  for (const NodeId id : results) {
    if (graph_.is_coefficient(id)) {
      out.results.push_back({true, tape_.constant(id)});
    } else {
      out.results.push_back({false, place[value(id)]});
    }
  }
  return out;
}

}  // namespace

std::uint16_t TapeWriter::literal(double value) {
  const auto [at, fresh] =
      literal_of_.try_emplace(value, static_cast<std::uint16_t>(coefficients_.literals.size()));
  if (fresh) coefficients_.literals.push_back(value);
  return at->second;
}

std::uint16_t TapeWriter::step(NodeId root) {
  const std::array<NodeId, 1> roots{root};
  for (const NodeId id : graph_.parts(roots)) {
    if (step_of_.contains(id)) continue;
    const Node& node = graph_[id];
    const auto operand = [&](NodeId x) { return step_of_.at(x); };
    Instruction next{Operation::literal};
    next.out = static_cast<std::uint16_t>(coefficients_.steps.size());
    switch (node.kind) {
      case Kind::literal:
        next.operation = node.index == 0 ? Operation::literal : Operation::decimal;
        coefficients_.has_decimals = coefficients_.has_decimals || node.index != 0;
        next.a = literal(node.literal);
        break;
      case Kind::parameter:
        next.operation = Operation::parameter;
        next.a = node.index;
        break;
      case Kind::pi:
        next.operation = Operation::pi;
        break;
      case Kind::euler:
        next.operation = Operation::euler;
        break;
      case Kind::function:
        next.operation = operation_of(node.function);
        next.a = operand(node.a);
        break;
      default:
        next.operation = node.kind == Kind::coefficient_sum        ? Operation::add
                         : node.kind == Kind::coefficient_product  ? Operation::multiply
                         : node.kind == Kind::coefficient_quotient ? Operation::divide
                         : node.kind == Kind::minimum              ? Operation::minimum
                         : node.kind == Kind::maximum              ? Operation::maximum
                                                                   : Operation::power;
        next.a = operand(node.a);
        next.b = operand(node.b);
    }
    if (coefficients_.steps.size() == largest_coefficient_steps)
      throw TooLarge("at most " + std::to_string(largest_coefficient_steps) +
                     " operations on numbers and parameters alone");
    step_of_.emplace(id, next.out);
    coefficients_.steps.push_back(next);
  }
  return step_of_.at(root);
}

std::uint16_t TapeWriter::constant(NodeId coefficient) {
  const auto found = constant_of_.find(coefficient);
  if (found != constant_of_.end()) return found->second;
  if (coefficients_.constants.size() == largest_constant_count)
    throw TooLarge("at most " + std::to_string(largest_constant_count) + " different coefficients");
  const auto at = static_cast<std::uint16_t>(coefficients_.constants.size());
  coefficients_.constants.push_back(step(coefficient));
  constant_of_.emplace(coefficient, at);
  return at;
}

Program TapeWriter::program(std::span<const Variable> inputs, std::span<const NodeId> results) {
  return ProgramWriter(graph_, *this, inputs).write(results);
}

}  // namespace stationary::expression
