#include "solver/expression_builder.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "lib/double_double.hpp"
#include "solver/characters.hpp"
#include "solver/input_error.hpp"
#include "solver/nearest_name.hpp"

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

/// "a, b or c".
template <class Names>
std::string listed(const Names& names) {
  std::string out;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (k > 0) out += k + 1 == names.size() ? " or " : ", ";
    out += names[k];
  }
  return out;
}

/// Whether a decimal number of up to 15 digits, "12.5e3" and the like, is the double `value`:
/// D = value 10^n or value = D 10^n, both checked exactly. Longer ones count as rounded.
bool is_double(std::string_view text, double value) {
  double digits = 0.0;
  int count = 0;
  int exponent = 0;
  bool point = false;
  std::size_t at = 0;
  for (; at < text.size() && text[at] != 'e' && text[at] != 'E'; ++at) {
    if (text[at] == '.') {
      point = true;
      continue;
    }
    if (digits != 0.0 || text[at] != '0') ++count;
    if (count > 15) return false;
    digits = 10.0 * digits + (text[at] - '0');
    if (point) --exponent;
  }
  if (digits == 0.0) return true;
  if (at < text.size()) {
    int power = 0;
    const char* begin = text.data() + at + (text[at + 1] == '+' ? 2 : 1);
    const char* end = text.data() + text.size();
    if (std::from_chars(begin, end, power).ec != std::errc() || std::abs(power) > 40) return false;
    exponent += power;
  }
  double scale = 1.0;  // 10^22 is the last that is a double
  if (std::abs(exponent) > 22) return false;
  for (int k = 0; k < std::abs(exponent); ++k) scale *= 10.0;
  const DoubleDouble product = two_product(exponent < 0 ? value : digits, scale);
  return product.hi == (exponent < 0 ? digits : value) && product.lo == 0.0;
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

template <class F>
NodeId ExpressionBuilder::at(std::size_t offset, const F& f) {
  try {
    const NodeId out = f();
    if (graph().is_coefficient(out)) out_.constants.push_back({out, offset});
    return out;
  } catch (const expression::NotSmooth& error) {  // of a function: its name stands there
    const std::string function = token_at(text_, offset);
    throw ExpressionError(offset, function + " of a variable",
                          function + " of numbers and parameters alone", error.what());
  } catch (const expression::TooLarge& error) {
    throw ExpressionError(offset, token_at(text_, offset), error.what());
  }
}

void ExpressionBuilder::number(std::string_view digits, std::size_t offset) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    throw ExpressionError(offset, in_quotes(digits), "a number that a double can hold");
  operands_.push_back({graph().number(value, !is_double(digits, value)), false});
}

void ExpressionBuilder::open_call() {
  const auto found = std::ranges::find(functions, word_.text);
  if (found == functions.end()) unknown_function(word_);
  calls_.push_back({word_, static_cast<std::size_t>(found - functions.begin()), operands_.size()});
}

NodeId ExpressionBuilder::meaning(const Word& word) {
  const auto parameter = std::ranges::find(parameters_, word.text);
  if (parameter != parameters_.end()) {
    const auto index = static_cast<std::size_t>(parameter - parameters_.begin());
    used_[index] = true;
    return graph().parameter(static_cast<int>(index));
  }
  const auto variable = std::ranges::find(variables, word.text, &NamedVariable::name);
  if (variable != variables.end()) {
    if (is_known_in(variable->variable, slot_)) return graph().variable(variable->variable);
    throw ExpressionError(word.offset, in_quotes(word.text), allowed_names(),
                          std::string(word.text) + " does not occur in a potential of the " +
                              (slot_ == ExpressionSlot::plane ? "plane" : "thickness") +
                              "; write one expression of both as `coupled`");
  }
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
  std::string out = "a variable (" + listed(variable_names()) + ")";
  if (!parameters_.empty()) {
    const std::vector<std::string> own(parameters_.begin(), parameters_.end());
    out += " or a parameter (" + listed(own) + ")";
  }
  return out;
}

void ExpressionBuilder::unknown_name(const Word& word) const {
  std::vector<std::string_view> known(parameters_.begin(), parameters_.end());
  const std::vector<std::string_view> names = variable_names();
  known.insert(known.end(), names.begin(), names.end());
  if (std::ranges::find(functions, word.text) != functions.end())
    throw ExpressionError(word.offset, in_quotes(word.text), "\"(\" after the name of a function");
  const auto nearest = nearest_name(word.text, known);
  throw ExpressionError(
      word.offset, in_quotes(word.text), allowed_names(),
      nearest ? "did you mean " + in_quotes(*nearest) + "?"
              : "a parameter is given beside the expression: " + std::string(word.text) + " = 1.0");
}

void ExpressionBuilder::unknown_function(const Word& word) const {
  const auto nearest = word.text == "ln" ? std::optional<std::string_view>("log")
                                         : nearest_name(word.text, functions);
  const bool names_number =
      is_parameter(word.text) ||
      std::ranges::find(variables, word.text, &NamedVariable::name) != variables.end() ||
      std::ranges::find(constants, word.text) != constants.end();
  throw ExpressionError(word.offset, in_quotes(std::string(word.text) + "("),
                        "a function (" + listed(functions) + ")",
                        names_number ? "a product is written with \"*\"" : did_you_mean(nearest));
}

void ExpressionBuilder::close_call() {
  const Call call = calls_.back();
  calls_.pop_back();
  const std::size_t count = operands_.size() - call.first;
  const std::size_t wanted = call.function < one_argument ? 1 : 2;
  if (count != wanted) {
    throw ExpressionError(call.name.offset,
                          std::string(call.name.text) + " of " + std::to_string(count) +
                              (count == 1 ? " argument" : " arguments"),
                          wanted == 1 ? "one argument" : "two arguments");
  }
  const NodeId out = at(call.name.offset, [&] {
    if (wanted == 1) return graph().apply(static_cast<Function>(call.function), top(0));
    if (call.name.text == "pow") return power(top(1), top(0), call.name.offset);
    return call.name.text == "min" ? graph().minimum(top(1), top(0))
                                   : graph().maximum(top(1), top(0));
  });
  replace(count, out);
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
    out = at(caret, [&] { return power(operands_[k - 1].node, out, caret); });
  }
  replace(count, out);
}

void ExpressionBuilder::require_divisor(NodeId x, std::size_t offset) const {
  if (graph().is_zero(x))
    throw ExpressionError(offset, "a division by 0", "a divisor that is not 0");
}

NodeId ExpressionBuilder::power(NodeId base, NodeId exponent, std::size_t offset) {
  const expression::Node& by = graph()[exponent];
  if (by.kind == expression::Kind::literal && by.literal < 0.0) require_divisor(base, offset);
  return graph().power(base, exponent);
}

void ExpressionBuilder::apply_operation() {
  const Operator by = operators_.back();
  operators_.pop_back();
  const NodeId out = at(by.offset, [&]() -> NodeId {
    switch (by.symbol) {
      case '+':
        return graph().add(top(1), top(0));
      case '-':
        return graph().subtract(top(1), top(0));
      case '*':
        return graph().multiply(top(1), top(0));
      default:
        require_divisor(top(0), by.offset);
        // d/k is 1/k times d, in which 1/k is a constant that may not be finite.
        if (graph().is_coefficient(top(0)) && !graph().is_coefficient(top(1)))
          at(by.offset, [&] { return graph().divide(graph().one(), top(0)); });
        return graph().divide(top(1), top(0));
    }
  });
  replace(2, out);
}

ParsedExpression ExpressionBuilder::take() {
  out_.expression.root = operands_.back().node;
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    const std::string& name = parameters_[k];
    if (!used_[k]) out_.unused.push_back(name);
    const bool hides_constant = std::ranges::find(constants, name) != constants.end();
    if (!used_[k] || (!hides_constant && !is_variable_in(name, slot_))) continue;
    const bool has_second_name = name == "lambda" && !is_parameter("lambda_");
    out_.notes.push_back(name + " is the parameter here, not the " +
                         (hides_constant ? "constant" : "variable") +
                         (has_second_name ? " (the larger principal stretch is lambda_)" : ""));
  }
  return std::move(out_);
}

std::vector<std::string_view> expression_variables(ExpressionSlot slot) {
  std::vector<std::string_view> out;
  for (const NamedVariable& known : variables)
    if (known.name != "lambda_" && is_known_in(known.variable, slot)) out.push_back(known.name);
  out.insert(out.end(), constants.begin(), constants.end());
  return out;
}

}  // namespace stationary
