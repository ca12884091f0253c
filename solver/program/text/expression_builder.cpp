#include "solver/program/text/expression_builder.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "solver/program/text/ascii.hpp"
#include "solver/program/text/input_error.hpp"
#include "solver/program/text/nearest_name.hpp"
#include "solver/program/text/written_number.hpp"

namespace stationary {

using expression::Function;
using expression::Graph;
using expression::NodeId;
using expression::Variable;

namespace {

struct NamedVariable {
  std::string_view name;
  Variable variable;
};
constexpr std::array<NamedVariable, 10> variables{{{"alpha", Variable::alpha},
                                                   {"xi", Variable::xi},
                                                   {"zeta", Variable::zeta},
                                                   {"rho", Variable::rho},
                                                   {"t", Variable::t},
                                                   {"d", Variable::d},
                                                   {"I1", Variable::first_invariant},
                                                   {"lambda", Variable::lambda},
                                                   {"mu_", Variable::mu},
                                                   {"lambda_", Variable::lambda}}};
constexpr std::array<std::string_view, 2> constants{"pi", "e"};
constexpr std::array<std::string_view, 12> functions{"sqrt", "exp",  "log", "sin", "cos", "tan",
                                                     "tanh", "atan", "abs", "pow", "min", "max"};
constexpr std::size_t one_argument = 9;  ///< of them, in the order of Function

bool is_known_in(Variable v, ExpressionSlot slot) {
  switch (slot) {
    case ExpressionSlot::plane:
      return v != Variable::rho;
    case ExpressionSlot::thickness:
      return v == Variable::rho;
    case ExpressionSlot::coupled:
      return true;
  }
  return false;
}

/// Invariants of the whole body, made of the variables.
constexpr std::array<std::string_view, 2> body_invariants{"I2", "I3"};

/// "a, b or c".
template <class Names>
std::string either_of(const Names& names) {
  std::string out;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (k > 0) out += k + 1 == names.size() ? " or " : ", ";
    out += names[k];
  }
  return out;
}

bool is_variable_in(std::string_view name, ExpressionSlot slot) {
  const auto found = std::ranges::find(variables, name, &NamedVariable::name);
  return found != variables.end() && is_known_in(found->variable, slot);
}

}  // namespace

bool is_reserved(std::string_view name, ExpressionSlot slot) {
  return name == "mu_" && is_variable_in(name, slot);
}

std::string token_at(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return "the end";
  std::size_t end = offset + 1;
  if (is_letter(text[offset])) {
    while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
  } else if (is_digit(text[offset])) {
    while (end < text.size() && (is_digit(text[end]) || text[end] == '.')) ++end;
  } else {
    // A character of several bytes is shown whole.
    while (end < text.size() && is_continuation(text[end])) ++end;
  }
  return in_quotes(text.substr(offset, end - offset));
}

void ExpressionBuilder::fail(std::size_t offset, std::string found, std::string allowed,
                             std::string remedy) const {
  throw ExpressionError(offset, std::move(found), std::move(allowed), std::move(remedy), part_);
}

template <class F>
NodeId ExpressionBuilder::at(std::size_t offset, const F& f) {
  try {
    const NodeId out = f();
    if (graph().is_coefficient(out)) out_.constants.push_back({out, offset, part_});
    return out;
  } catch (const expression::NotSmooth& error) {  // of a function: its name stands there
    const std::string function = token_at(text_, offset);
    fail(offset, function + " of a variable", function + " of numbers and parameters alone",
         error.what());
  } catch (const expression::TooLarge& error) {
    fail(offset, token_at(text_, offset), error.what());
  }
}

void ExpressionBuilder::replace(std::size_t count, NodeId by) {
  const Operand out{by, top(count - 1).begin, top(0).end};
  operands_.resize(operands_.size() - count);
  operands_.push_back(out);
}

std::string ExpressionBuilder::condition(const Operand& x, const char* relation) const {
  constexpr std::size_t most = 120;
  std::string out(text_.substr(x.begin, x.end - x.begin));
  if (out.size() > most) out = out.substr(0, most - 3) + "...";
  return out + relation;
}
void ExpressionBuilder::require_positive(const Operand& x) {
  expression::require_positive(graph(), x.node, condition(x, " > 0"), out_.expression.conditions);
}
void ExpressionBuilder::require_nonzero(const Operand& x) {
  expression::require_nonzero(graph(), x.node, condition(x, " != 0"), out_.expression.conditions);
}

void ExpressionBuilder::number(std::string_view digits, std::size_t offset) {
  const auto read = written_number(digits);
  if (!read) fail(offset, in_quotes(digits), "a number that a double can hold");
  const NodeId node = read->is_double ? graph().number(read->value)
                                      : graph().rounded_number(read->value, read->decimal);
  operands_.push_back({node, offset, offset + digits.size()});
}

void ExpressionBuilder::lone_name() {
  operands_.push_back({meaning(word_), word_.offset, word_.offset + word_.text.size()});
}

void ExpressionBuilder::open_call() {
  const std::string_view name = word_.text == "ln" ? "log" : word_.text;
  const auto found = std::ranges::find(functions, name);
  if (found == functions.end()) unknown_function(word_);
  calls_.push_back({word_, static_cast<std::size_t>(found - functions.begin()), operands_.size()});
}

void ExpressionBuilder::bracket(std::size_t begin, std::size_t end) {
  operands_.back().begin = begin;
  operands_.back().end = end;
}

void ExpressionBuilder::signed_power() {
  const SignRun sign = take_sign();
  if (!sign.negative) return;
  const Operand& x = top(0);
  operands_.back() = {graph().negate(x.node), sign.offset, x.end};
}

void ExpressionBuilder::exponent() { operands_.back().negative = take_sign().negative; }

NodeId ExpressionBuilder::meaning(const Word& word) {
  const auto parameter = std::ranges::find(parameters_, word.text);
  if (parameter != parameters_.end()) {
    const auto index = static_cast<std::size_t>(parameter - parameters_.begin());
    used_[index] = true;
    return graph().parameter(static_cast<int>(index));
  }
  const auto defined = std::ranges::find(definitions_, word.text, &Definition::name);
  if (defined != definitions_.end()) {
    defined->used = true;
    return defined->node;
  }
  const auto variable = std::ranges::find(variables, word.text, &NamedVariable::name);
  const bool of_body = std::ranges::find(body_invariants, word.text) != body_invariants.end();
  if (of_body && slot_ == ExpressionSlot::coupled) {
    const NodeId d = graph().variable(Variable::d);
    const NodeId rho = graph().variable(Variable::rho);
    if (word.text == "I3") return graph().power(graph().multiply({d, rho}), 2);
    return graph().add(
        {graph().power(d, 2),
         graph().multiply({graph().power(rho, 2), graph().variable(Variable::first_invariant)})});
  }
  if (variable != variables.end() && is_known_in(variable->variable, slot_))
    return graph().variable(variable->variable);
  if (variable != variables.end() || of_body)
    fail(word.offset, in_quotes(word.text), allowed_names(),
         std::string(word.text) + " does not occur in a potential of the " +
             (slot_ == ExpressionSlot::plane ? "plane" : "thickness") +
             "; write one expression of both as `coupled`");
  if (word.text == "pi") return graph().pi();
  if (word.text == "e") return graph().euler();
  unknown_name(word);
}

std::vector<std::string_view> ExpressionBuilder::variable_names() const {
  std::vector<std::string_view> out;
  for (std::string_view name : expression_variables(slot_)) {
    if (name == "lambda" && is_parameter(name)) name = "lambda_";
    if (!is_parameter(name)) out.push_back(name);
  }
  return out;
}

std::string ExpressionBuilder::allowed_names() const {
  std::vector<std::string> own(parameters_.begin(), parameters_.end());
  std::string out = "a variable (" + either_of(variable_names()) + ")";
  if (!own.empty()) out += " or a parameter (" + either_of(own) + ")";
  own.clear();
  for (const Definition& each : definitions_) own.push_back(each.name);
  if (!own.empty()) out += " or a part defined before (" + either_of(own) + ")";
  return out;
}

void ExpressionBuilder::unknown_name(const Word& word) const {
  std::vector<std::string_view> known(parameters_.begin(), parameters_.end());
  const std::vector<std::string_view> names = variable_names();
  known.insert(known.end(), names.begin(), names.end());
  for (const Definition& each : definitions_) known.push_back(each.name);
  if (std::ranges::find(functions, word.text) != functions.end() || word.text == "ln")
    fail(word.offset, in_quotes(word.text), "\"(\" after the name of a function");
  const auto nearest = nearest_name(word.text, known);
  fail(word.offset, in_quotes(word.text), allowed_names(),
       nearest
           ? "did you mean " + in_quotes(*nearest) + "?"
           : "a parameter is given beside the expression: " + std::string(word.text) + " = 1.0");
}

void ExpressionBuilder::unknown_function(const Word& word) const {
  const bool names_number =
      is_parameter(word.text) ||
      std::ranges::find(variables, word.text, &NamedVariable::name) != variables.end() ||
      std::ranges::find(body_invariants, word.text) != body_invariants.end() ||
      std::ranges::find(definitions_, word.text, &Definition::name) != definitions_.end() ||
      std::ranges::find(constants, word.text) != constants.end();
  fail(word.offset, in_quotes(std::string(word.text) + "("),
       "a function (" + either_of(functions) + "; ln is log)",
       names_number ? "a product is written with \"*\""
                    : did_you_mean(nearest_name(word.text, functions)));
}

NodeId ExpressionBuilder::applied(const Call& call) {
  const std::string_view name = functions[call.function];
  if (name == "pow") return power(top(1), top(0).node, call.name.offset);
  if (name == "min") return graph().minimum({top(1).node, top(0).node});
  if (name == "max") return graph().maximum({top(1).node, top(0).node});
  const Operand& x = top(0);
  if (name == "log" || (name == "sqrt" && !graph().is_coefficient(x.node))) require_positive(x);
  if (name == "tan") {
    const NodeId cosine = graph().apply(Function::cos, x.node);
    expression::require_nonzero(graph(), cosine, "cos(" + condition(x, ") != 0"),
                                out_.expression.conditions);
  }
  return graph().apply(static_cast<Function>(call.function), x.node);
}

void ExpressionBuilder::close_call(std::size_t end) {
  const Call call = calls_.back();
  calls_.pop_back();
  const std::size_t count = operands_.size() - call.first;
  const std::size_t wanted = call.function < one_argument ? 1 : 2;
  if (count != wanted) {
    fail(call.name.offset,
         std::string(call.name.text) + " of " + std::to_string(count) +
             (count == 1 ? " argument" : " arguments"),
         wanted == 1 ? "one argument" : "two arguments");
  }
  const NodeId out = at(call.name.offset, [&] { return applied(call); });
  replace(count, out);
  bracket(call.name.offset, end);
}

void ExpressionBuilder::end_power() {
  const std::size_t first = powers_.back();
  powers_.pop_back();
  const std::size_t count = operands_.size() - first;
  if (count == 1) return;
  NodeId out = operands_.back().node;
  for (std::size_t k = operands_.size() - 1; k > first; --k) {
    // From the right: the last operator is the caret before the last operand.
    if (operands_[k].negative) out = graph().negate(out);
    const std::size_t caret = operators_.back().offset;
    operators_.pop_back();
    out = at(caret, [&] { return power(operands_[k - 1], out, caret); });
  }
  replace(count, out);
}

void ExpressionBuilder::require_divisor(NodeId x, std::size_t offset) const {
  if (graph().is_zero(x)) fail(offset, "a division by 0", "a divisor that is not 0");
}

NodeId ExpressionBuilder::power(const Operand& base, NodeId exponent, std::size_t offset) {
  const expression::Node by = graph()[exponent];
  const bool whole = graph().is_exact_literal(exponent) && by.literal == std::floor(by.literal);
  if (by.kind == expression::Kind::literal && by.literal < 0.0) require_divisor(base.node, offset);
  // A root or power of numbers alone is a number, which the case is refused for where it is none.
  if (graph().is_coefficient(base.node) && graph().is_coefficient(exponent))
    return graph().power(base.node, exponent);
  if (!whole) {
    require_positive(base);
    if (by.kind == expression::Kind::parameter)
      out_.add_note("a power of the parameter " + std::string(parameters_[by.index]) +
                    " has a base > 0 even where that is a whole number");
  } else if (by.literal < 0.0) {
    require_nonzero(base);
  }
  return graph().power(base.node, exponent);
}

void ExpressionBuilder::apply_operation() {
  const Operator by = operators_.back();
  operators_.pop_back();
  const NodeId out = at(by.offset, [&]() -> NodeId {
    const NodeId left = top(1).node;
    const NodeId right = top(0).node;
    switch (by.symbol) {
      case '+':
        return graph().add({left, right});
      case '-':
        return graph().subtract({left, right});
      case '*':
        return graph().multiply({left, right});
      default:
        require_divisor(right, by.offset);
        require_nonzero(top(0));
        // d/k is 1/k times d, in which 1/k is a constant that may not be finite.
        if (graph().is_coefficient(right) && !graph().is_coefficient(left))
          at(by.offset, [&] { return graph().divide({graph().one(), right}); });
        return graph().divide({left, right});
    }
  });
  replace(2, out);
}

void ExpressionBuilder::define(const std::string& name) {
  definitions_.push_back({name, operands_.back().node});
  operands_.pop_back();
}

void ExpressionBuilder::add_condition() {
  const NodeId left = top(1).node;
  const NodeId right = top(0).node;
  operands_.resize(operands_.size() - 2);
  const NodeId excess =
      is_less_ ? graph().subtract({right, left}) : graph().subtract({left, right});
  expression::require_positive(graph(), excess, text_, out_.expression.conditions);
}

ParsedExpression ExpressionBuilder::take() {
  out_.expression.root = operands_.back().node;
  out_.expression.text = std::string(text_);
  for (const Definition& each : definitions_)
    if (!each.used) out_.unused_parts.push_back(each.name);
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    const std::string& name = parameters_[k];
    if (!used_[k]) out_.unused.push_back(name);
    const bool hides_constant = std::ranges::find(constants, name) != constants.end();
    const bool hides_variable = is_variable_in(name, slot_) ||
                                (slot_ == ExpressionSlot::coupled &&
                                 std::ranges::find(body_invariants, name) != body_invariants.end());
    if (!used_[k] || (!hides_constant && !hides_variable)) continue;
    const bool has_second_name = name == "lambda" && !is_parameter("lambda_");
    out_.add_note(name + " is the parameter here, not the " +
                  (hides_constant ? "constant" : "variable") +
                  (has_second_name ? " (the larger principal stretch is lambda_)" : ""));
  }
  return std::move(out_);
}

std::vector<std::string_view> expression_variables(ExpressionSlot slot) {
  std::vector<std::string_view> out;
  for (const NamedVariable& known : variables)
    if (known.name != "lambda_" && is_known_in(known.variable, slot)) out.push_back(known.name);
  if (slot == ExpressionSlot::coupled)
    out.insert(out.end(), body_invariants.begin(), body_invariants.end());
  out.insert(out.end(), constants.begin(), constants.end());
  return out;
}

bool is_word_of_formulas(std::string_view name, ExpressionSlot slot) {
  const std::vector<std::string_view> names = expression_variables(slot);
  return name == "ln" || name == "lambda_" || std::ranges::find(names, name) != names.end() ||
         std::ranges::find(functions, name) != functions.end();
}

}  // namespace stationary
