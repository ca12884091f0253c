#include "solver/expression_parser.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <tao/pegtl.hpp>
#include <utility>

#include "lib/double_double.hpp"
#include "solver/nearest_name.hpp"

namespace stationary {
namespace {

using expression::Function;
using expression::Graph;
using expression::NodeId;
using expression::Variable;
namespace pegtl = tao::pegtl;

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

std::string in_quotes(std::string_view text) { return "\"" + std::string(text) + "\""; }

/// The names and commas between, "a, b and c".
template <class Names>
std::string listed(const Names& names, std::string_view last = " and ") {
  std::string out;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (k > 0) out += k + 1 == names.size() ? last : ", ";
    out += names[k];
  }
  return out;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The word, number or character at an offset, as a message names it.
std::string token_at(std::string_view text, std::size_t offset) {
  if (offset >= text.size()) return "the end";
  std::size_t end = offset + 1;
  if (is_letter(text[offset])) {
    while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
  } else if (is_digit(text[offset])) {
    while (end < text.size() && (is_digit(text[end]) || text[end] == '.')) ++end;
  } else {
    // A character of several bytes is shown whole.
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
  }
  return in_quotes(text.substr(offset, end - offset));
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

/// Turns what the grammar finds into the graph: operands on a stack.
class Builder {
 public:
  Builder(std::string_view text, std::span<const std::string> parameters, ExpressionSlot slot)
      : text_(text), parameters_(parameters), slot_(slot), used_(parameters.size(), false) {
    out_.expression.text = std::string(text);
    out_.expression.parameters.assign(parameters.begin(), parameters.end());
  }

  void number(std::string_view digits, std::size_t offset) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
      throw ExpressionError(offset, in_quotes(digits), "a number that a double can hold");
    operands_.push_back({graph().number(value, !is_double(digits, value)), false});
  }
  void name(std::string_view word, std::size_t offset) { word_ = {word, offset}; }
  void lone_name() { operands_.push_back({meaning(word_), false}); }
  void open_call() {
    const auto found = std::ranges::find(functions, word_.text);
    if (found == functions.end()) unknown_function(word_);
    calls_.push_back(
        {word_, static_cast<std::size_t>(found - functions.begin()), operands_.size()});
  }
  void close_call();
  void signs(std::string_view characters) {
    minus_.push_back(std::ranges::count(characters, '-') % 2 == 1);
  }
  void signed_power() {
    if (take_sign()) replace(1, graph().negate(top(0)));
  }
  void begin_power() { powers_.push_back(operands_.size()); }
  void exponent() { operands_.back().negative = take_sign(); }
  void end_power();
  void operation(char symbol, std::size_t offset) { operators_.push_back({symbol, offset}); }
  void apply_operation();

  ParsedExpression take();

 private:
  struct Word {
    std::string_view text;
    std::size_t offset = 0;
  };
  struct Operand {
    NodeId node;
    bool negative;  ///< of an exponent whose sign is still to be applied
  };
  struct Call {
    Word name;
    std::size_t function;
    std::size_t first;  ///< of its arguments among the operands
  };
  struct Operator {
    char symbol;
    std::size_t offset;
  };

  Graph& graph() { return out_.expression.graph; }
  NodeId top(std::size_t below) const { return operands_[operands_.size() - 1 - below].node; }
  void replace(std::size_t count, NodeId by) {
    operands_.resize(operands_.size() - count);
    operands_.push_back({by, false});
  }
  bool take_sign() {
    const bool out = minus_.back();
    minus_.pop_back();
    return out;
  }
  /// f(), its complaints about the graph as errors at `offset`.
  template <class F>
  NodeId at(std::size_t offset, const F& f) {
    try {
      return f();
    } catch (const expression::NotSmooth& error) {
      throw ExpressionError(offset, token_at(text_, offset),
                            "only numbers and parameters in it: " + std::string(error.what()));
    } catch (const expression::TooLarge& error) {
      throw ExpressionError(offset, token_at(text_, offset), error.what());
    }
  }
  NodeId meaning(const Word& word);
  [[noreturn]] void unknown_name(const Word& word) const;
  [[noreturn]] void unknown_function(const Word& word) const;

  std::string_view text_;
  std::span<const std::string> parameters_;
  ExpressionSlot slot_;
  ParsedExpression out_;
  std::vector<bool> used_;
  Word word_;
  std::vector<Operand> operands_;
  std::vector<Call> calls_;
  std::vector<bool> minus_;
  std::vector<std::size_t> powers_;
  std::vector<Operator> operators_;
};

NodeId Builder::meaning(const Word& word) {
  const auto parameter = std::ranges::find(parameters_, word.text);
  if (parameter != parameters_.end()) {
    const auto index = static_cast<std::size_t>(parameter - parameters_.begin());
    used_[index] = true;
    return graph().parameter(static_cast<int>(index));
  }
  const auto variable = std::ranges::find(variables, word.text, &NamedVariable::name);
  if (variable != variables.end()) {
    if (is_known_in(variable->variable, slot_)) return graph().variable(variable->variable);
    throw ExpressionError(word.offset, in_quotes(word.text),
                          slot_ == ExpressionSlot::plane
                              ? "no rho in a potential of the plane"
                              : "rho as the only variable in a potential of the thickness",
                          "write one expression of both as `coupled`");
  }
  if (word.text == "pi") return graph().pi();
  if (word.text == "e") return graph().euler();
  unknown_name(word);
}

void Builder::unknown_name(const Word& word) const {
  std::vector<std::string_view> known(parameters_.begin(), parameters_.end());
  const std::vector<std::string_view> names = expression_variables(slot_);
  known.insert(known.end(), names.begin(), names.end());
  if (std::ranges::find(functions, word.text) != functions.end())
    throw ExpressionError(word.offset, in_quotes(word.text), "\"(\" after the name of a function");
  const auto nearest = nearest_name(word.text, known);
  std::string allowed = "a variable (" + listed(names, " or ") + ")";
  if (!parameters_.empty()) {
    const std::vector<std::string> own(parameters_.begin(), parameters_.end());
    allowed += " or a parameter (" + listed(own, " or ") + ")";
  }
  throw ExpressionError(
      word.offset, in_quotes(word.text), allowed,
      nearest ? "did you mean " + in_quotes(*nearest) + "?"
              : "a parameter is given beside the expression: " + std::string(word.text) + " = 1.0");
}

void Builder::unknown_function(const Word& word) const {
  const auto nearest = nearest_name(word.text, functions);
  const bool is_name =
      std::ranges::find(parameters_, word.text) != parameters_.end() ||
      std::ranges::find(variables, word.text, &NamedVariable::name) != variables.end() ||
      std::ranges::find(constants, word.text) != constants.end();
  throw ExpressionError(word.offset, in_quotes(std::string(word.text) + "("),
                        "a function (" + listed(functions, " or ") + ")",
                        is_name   ? "a product is written with \"*\""
                        : nearest ? "did you mean " + in_quotes(*nearest) + "?"
                                  : "");
}

void Builder::close_call() {
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
    if (call.name.text == "pow") return graph().power(top(1), top(0));
    return call.name.text == "min" ? graph().minimum(top(1), top(0))
                                   : graph().maximum(top(1), top(0));
  });
  replace(count, out);
}

void Builder::end_power() {
  const std::size_t first = powers_.back();
  powers_.pop_back();
  const std::size_t count = operands_.size() - first;
  if (count == 1) return;
  NodeId out = operands_.back().node;
  for (std::size_t k = operands_.size() - 1; k > first; --k) {
    // The offset is not kept of every operand; the operators are met from the left.
    if (operands_[k].negative) out = graph().negate(out);
    const Operator& caret = operators_.back();
    out = at(caret.offset, [&] { return graph().power(operands_[k - 1].node, out); });
    operators_.pop_back();
  }
  replace(count, out);
}

void Builder::apply_operation() {
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
        if (graph().is_zero(top(0)))
          throw ExpressionError(by.offset, "a division by 0", "a divisor that is not 0");
        return graph().divide(top(1), top(0));
    }
  });
  replace(2, out);
}

ParsedExpression Builder::take() {
  out_.expression.root = operands_.back().node;
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    const std::string& name = parameters_[k];
    if (!used_[k]) out_.unused.push_back(name);
    const bool hides_variable =
        std::ranges::find(variables, name, &NamedVariable::name) != variables.end();
    const bool hides_constant = std::ranges::find(constants, name) != constants.end();
    if (!used_[k] || (!hides_variable && !hides_constant)) continue;
    out_.notes.push_back(name + " is the parameter here, not the " +
                         (hides_constant ? "constant" : "variable") +
                         (name == "lambda" ? " (the larger principal stretch is lambda_)" : ""));
  }
  return std::move(out_);
}

// The grammar at the top of the header. What must follow where something else is found is said by
// `expected`.
namespace grammar {

using namespace tao::pegtl;

struct blanks : star<space> {};
struct sum;
struct exponent_part : seq<one<'e', 'E'>, opt<one<'+', '-'>>, plus<digit>> {};
struct number : seq<sor<seq<plus<digit>, opt<one<'.'>, star<digit>>>, seq<one<'.'>, plus<digit>>>,
                    opt<exponent_part>> {};
struct name : identifier {};
struct call_open : one<'('> {};
struct argument : seq<sum> {};
struct call_close : one<')'> {};
struct more_arguments : star<if_must<one<','>, blanks, argument>> {};
struct call : if_must<call_open, blanks, argument, more_arguments, call_close> {};
struct lone_name : success {};
struct named : seq<name, blanks, sor<call, lone_name>> {};
struct bracket_close : one<')'> {};
struct bracket : if_must<one<'('>, blanks, sum, bracket_close> {};
struct operand : seq<sor<number, named, bracket>, blanks> {};
struct signs : star<one<'+', '-'>, blanks> {};
struct exponent : seq<signs, must<operand>> {};
struct caret : one<'^'> {};
struct begin_power : success {};
struct power : seq<begin_power, must<operand>, star<if_must<caret, blanks, exponent>>> {};
struct signed_power : seq<signs, power> {};
struct product_operator : one<'*', '/'> {};
struct factor : seq<signed_power> {};
struct product_step : if_must<product_operator, blanks, factor> {};
struct product : seq<signed_power, star<product_step>> {};
struct sum_operator : one<'+', '-'> {};
struct summand : seq<product> {};
struct sum_step : if_must<sum_operator, blanks, summand> {};
struct sum : seq<product, star<sum_step>> {};
struct end : eof {};
struct whole : must<blanks, sum, end> {};

template <class>
inline constexpr const char* expected = nullptr;
template <>
inline constexpr const char* expected<operand> = "a number, a name, \"(\" or a sign";
template <>
inline constexpr const char* expected<call_close> = "an operator, \",\" or \")\"";
template <>
inline constexpr const char* expected<bracket_close> = "an operator or \")\"";
template <>
inline constexpr const char* expected<end> = "an operator or the end";

struct Expected {
  template <class Rule>
  static constexpr auto message = expected<Rule>;
};
template <class Rule>
using control = must_if<Expected, normal, false>::control<Rule>;

template <class Rule>
struct action : nothing<Rule> {};
template <>
struct action<number> {
  template <class Input>
  static void apply(const Input& in, Builder& to) {
    to.number(in.string_view(), in.position().byte);
  }
};
template <>
struct action<name> {
  template <class Input>
  static void apply(const Input& in, Builder& to) {
    to.name(in.string_view(), in.position().byte);
  }
};
template <>
struct action<signs> {
  template <class Input>
  static void apply(const Input& in, Builder& to) {
    to.signs(in.string_view());
  }
};
struct operator_action {
  template <class Input>
  static void apply(const Input& in, Builder& to) {
    to.operation(*in.begin(), in.position().byte);
  }
};
template <>
struct action<caret> : operator_action {};
template <>
struct action<product_operator> : operator_action {};
template <>
struct action<sum_operator> : operator_action {};
template <>
struct action<lone_name> {
  static void apply0(Builder& to) { to.lone_name(); }
};
template <>
struct action<call_open> {
  static void apply0(Builder& to) { to.open_call(); }
};
template <>
struct action<call> {
  static void apply0(Builder& to) { to.close_call(); }
};
template <>
struct action<begin_power> {
  static void apply0(Builder& to) { to.begin_power(); }
};
template <>
struct action<exponent> {
  static void apply0(Builder& to) { to.exponent(); }
};
template <>
struct action<power> {
  static void apply0(Builder& to) { to.end_power(); }
};
template <>
struct action<signed_power> {
  static void apply0(Builder& to) { to.signed_power(); }
};
template <>
struct action<product_step> {
  static void apply0(Builder& to) { to.apply_operation(); }
};
template <>
struct action<sum_step> {
  static void apply0(Builder& to) { to.apply_operation(); }
};

}  // namespace grammar

/// Bounds before the parser, which calls itself for every parenthesis.
void require_shallow(std::string_view text) {
  if (text.size() > largest_expression_length)
    throw ExpressionError(largest_expression_length, std::to_string(text.size()) + " characters",
                          "at most " + std::to_string(largest_expression_length));
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '(' && ++depth > largest_expression_depth)
      throw ExpressionError(
          k, "\"(\"",
          "at most " + std::to_string(largest_expression_depth) + " parentheses in one another");
    if (text[k] == ')') --depth;
  }
}

/// Where two operands stand side by side, or two stars.
std::string remedy_at(std::string_view text, std::size_t offset) {
  const std::size_t before = text.substr(0, offset).find_last_not_of(" \t\n\r\v\f");
  if (offset >= text.size() || before == std::string_view::npos) return {};
  const char left = text[before];
  const char right = text[offset];
  if (left == '*' && right == '*') return "a power is written with \"^\"";
  const bool ends = is_letter(left) || is_digit(left) || left == ')';
  const bool begins = is_letter(right) || is_digit(right) || right == '(';
  return ends && begins ? "a product is written with \"*\"" : "";
}

std::string one_line(std::size_t offset, const std::string& found, const std::string& allowed,
                     const std::string& remedy) {
  std::string out = "column " + std::to_string(offset + 1) + ": found " + found;
  if (!allowed.empty()) out += ", allowed: " + allowed;
  if (!remedy.empty()) out += "; " + remedy;
  return out;
}

}  // namespace

ExpressionError::ExpressionError(std::size_t offset, std::string found, std::string allowed,
                                 std::string remedy)
    : std::invalid_argument(one_line(offset, found, allowed, remedy)),
      offset_(offset),
      found_(std::move(found)),
      allowed_(std::move(allowed)),
      remedy_(std::move(remedy)) {}

std::vector<std::string_view> expression_variables(ExpressionSlot slot) {
  std::vector<std::string_view> out;
  for (const NamedVariable& known : variables)
    if (known.name != "lambda_" && is_known_in(known.variable, slot)) out.push_back(known.name);
  out.insert(out.end(), constants.begin(), constants.end());
  return out;
}

std::span<const std::string_view> expression_functions() { return functions; }

ParsedExpression parse_expression(std::string_view text, std::span<const std::string> parameters,
                                  ExpressionSlot slot) {
  require_shallow(text);
  if (parameters.size() > expression::largest_parameter_count)
    throw ExpressionError(0, std::to_string(parameters.size()) + " parameters",
                          "at most " + std::to_string(expression::largest_parameter_count));
  Builder builder(text, parameters, slot);
  pegtl::memory_input<pegtl::tracking_mode::eager, pegtl::eol::lf> input(
      text.data(), text.data() + text.size(), "expression");
  try {
    pegtl::parse<grammar::whole, grammar::action, grammar::control>(input, builder);
  } catch (const pegtl::parse_error& error) {
    const std::size_t offset = error.positions().front().byte;
    throw ExpressionError(offset, token_at(text, offset), std::string(error.message()),
                          remedy_at(text, offset));
  }
  return builder.take();
}

}  // namespace stationary
