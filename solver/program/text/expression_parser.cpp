#include "solver/program/text/expression_parser.hpp"

#include <algorithm>
#include <array>
#include <tao/pegtl.hpp>
#include <utility>

#include "solver/program/text/ascii.hpp"
#include "solver/program/text/expression_builder.hpp"

namespace stationary {
namespace {

namespace pegtl = tao::pegtl;

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
struct relation : seq<one<'<', '>'>, opt<one<'='>>> {};
struct comparison : must<blanks, sum, relation, blanks, sum, end> {};

template <class>
inline constexpr const char* expected = nullptr;
template <>
inline constexpr const char* expected<operand> = "a number, a name, \"(\" or a sign";
template <>
inline constexpr const char* expected<call_close> = "an operator, \",\" or \")\"";
template <>
inline constexpr const char* expected<bracket_close> = "an operator or \")\"";
template <>
inline constexpr const char* expected<relation> = "an operator or one of < <= > >=";
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
  static void apply(const Input& in, ExpressionBuilder& to) {
    to.number(in.string_view(), in.position().byte);
  }
};
template <>
struct action<name> {
  template <class Input>
  static void apply(const Input& in, ExpressionBuilder& to) {
    to.name(in.string_view(), in.position().byte);
  }
};
template <>
struct action<signs> {
  template <class Input>
  static void apply(const Input& in, ExpressionBuilder& to) {
    to.signs(in.string_view(), in.position().byte);
  }
};
struct operator_action {
  template <class Input>
  static void apply(const Input& in, ExpressionBuilder& to) {
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
  static void apply0(ExpressionBuilder& to) { to.lone_name(); }
};
template <>
struct action<call_open> {
  static void apply0(ExpressionBuilder& to) { to.open_call(); }
};
template <>
struct action<call> {
  template <class Input>
  static void apply(const Input& in, ExpressionBuilder& to) {
    to.close_call(in.position().byte + in.size());
  }
};
template <>
struct action<bracket> {
  template <class Input>
  static void apply(const Input& in, ExpressionBuilder& to) {
    to.bracket(in.position().byte, in.position().byte + in.size());
  }
};
template <>
struct action<relation> {
  template <class Input>
  static void apply(const Input& in, ExpressionBuilder& to) {
    to.comparison(in.string_view());
  }
};
template <>
struct action<begin_power> {
  static void apply0(ExpressionBuilder& to) { to.begin_power(); }
};
template <>
struct action<exponent> {
  static void apply0(ExpressionBuilder& to) { to.exponent(); }
};
template <>
struct action<power> {
  static void apply0(ExpressionBuilder& to) { to.end_power(); }
};
template <>
struct action<signed_power> {
  static void apply0(ExpressionBuilder& to) { to.signed_power(); }
};
template <>
struct action<product_step> {
  static void apply0(ExpressionBuilder& to) { to.apply_operation(); }
};
template <>
struct action<sum_step> {
  static void apply0(ExpressionBuilder& to) { to.apply_operation(); }
};

}  // namespace grammar

/// Bounds before the parser, which calls itself for every parenthesis.
void require_shallow(std::string_view text, const FormulaPart& part) {
  if (text.size() > largest_expression_length)
    throw ExpressionError(largest_expression_length, std::to_string(text.size()) + " characters",
                          "at most " + std::to_string(largest_expression_length), "", part);
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '(' && ++depth > largest_expression_depth)
      throw ExpressionError(
          k, "\"(\"",
          "at most " + std::to_string(largest_expression_depth) + " parentheses in one another", "",
          part);
    if (text[k] == ')') --depth;
  }
}

/// A sign of formulas that is none of the language, and what is written for it.
struct Sign {
  std::string_view sign;
  std::string_view written;
};
constexpr std::array<Sign, 19> foreign_signs{{{"\u03b1", "alpha"},
                                              {"\u03be", "xi"},
                                              {"\u03b6", "zeta"},
                                              {"\u03c1", "rho"},
                                              {"\u03f1", "rho"},
                                              {"\u03bb", "lambda"},
                                              {"\u03bc", "mu_"},
                                              {"\u00b5", "mu_"},  // the micro sign
                                              {"\u03c0", "pi"},
                                              {"\u2212", "\"-\""},
                                              {"\u2013", "\"-\""},
                                              {"\u00b2", "\"^2\""},
                                              {"\u00b3", "\"^3\""},
                                              {"\u00b7", "\"*\""},
                                              {"\u22c5", "\"*\""},
                                              {"\u00d7", "\"*\""},
                                              {"\u00f7", "\"/\""},
                                              {"\u221a", "sqrt( )"},
                                              {"\u2044", "\"/\""}}};

/// "write lambda" where a sign stands; nothing elsewhere. A parameter may have a stretch's name.
std::string remedy_of_sign(std::string_view rest, std::span<const std::string> parameters) {
  const auto found = std::ranges::find_if(
      foreign_signs, [&](const Sign& each) { return rest.starts_with(each.sign); });
  if (found == foreign_signs.end()) return {};
  const std::string write = "write " + std::string(found->written);
  const auto has = [&](std::string_view name) {
    return std::ranges::find(parameters, name) != parameters.end();
  };
  if (found->written == "mu_" && has("mu")) return write + ", or mu for the parameter";
  if (found->written == "lambda" && has("lambda"))
    return "write lambda_, or lambda for the parameter";
  return write;
}

/// Where a sign stands that the language has not got, two operands side by side, or two stars.
std::string remedy_at(std::string_view text, std::size_t offset, const FormulaPart& part,
                      std::span<const std::string> parameters) {
  if (std::string sign = remedy_of_sign(text.substr(offset), parameters); !sign.empty())
    return sign;
  const std::size_t before = text.substr(0, offset).find_last_not_of(" \t\n\r\v\f");
  if (offset >= text.size() || before == std::string_view::npos) return {};
  const char left = text[before];
  const char right = text[offset];
  if (left == '*' && right == '*') return "a power is written with \"^\"";
  if (right == '<' || right == '>')
    return part.kind == FormulaPart::Kind::condition ? "one comparison each, in a list of them"
                                                     : "conditions are given by the key domain";
  const bool ends = is_letter(left) || is_digit(left) || left == ')';
  const bool begins = is_letter(right) || is_digit(right) || right == '(';
  return ends && begins ? "a product is written with \"*\"" : "";
}

std::string one_line(std::size_t offset, const std::string& found, const std::string& allowed,
                     const std::string& remedy) {
  std::string out = "byte " + std::to_string(offset + 1) + ": found " + found;
  if (!allowed.empty()) out += ", allowed: " + allowed;
  if (!remedy.empty()) out += "; " + remedy;
  return out;
}

/// Reads one text by the grammar's rule.
template <class Rule>
void read(std::string_view text, const FormulaPart& part, std::span<const std::string> parameters,
          ExpressionBuilder& builder) {
  require_shallow(text, part);
  builder.begin(text, part);
  pegtl::memory_input<pegtl::tracking_mode::eager, pegtl::eol::lf> input(
      text.data(), text.data() + text.size(), "expression");
  try {
    pegtl::parse<Rule, grammar::action, grammar::control>(input, builder);
  } catch (const pegtl::parse_error& error) {
    const std::size_t offset = error.positions().front().byte;
    throw ExpressionError(offset, token_at(text, offset), std::string(error.message()),
                          remedy_at(text, offset, part, parameters), part);
  }
}

}  // namespace

ExpressionError::ExpressionError(std::size_t offset, std::string found, std::string allowed,
                                 std::string remedy, const FormulaPart& part)
    : std::invalid_argument(one_line(offset, found, allowed, remedy)),
      offset_(offset),
      found_(std::move(found)),
      allowed_(std::move(allowed)),
      remedy_(std::move(remedy)),
      part_(part) {}

ParsedExpression parse_formula(const Formula& formula, std::span<const std::string> parameters,
                               ExpressionSlot slot) {
  using Kind = FormulaPart::Kind;
  const auto at_most = [](std::size_t count, std::size_t most, const char* what) {
    if (count > most)
      throw ExpressionError(0, std::to_string(count) + what, "at most " + std::to_string(most));
  };
  at_most(parameters.size(), expression::largest_parameter_count, " parameters");
  at_most(formula.parts.size(), largest_part_count, " parts");
  at_most(formula.conditions.size(), largest_condition_count, " conditions");
  for (const std::string& name : parameters)
    if (is_reserved(name, slot)) throw ExpressionError(0, "a parameter " + name, "another name");
  ExpressionBuilder builder(parameters, slot);
  for (std::size_t k = 0; k < formula.parts.size(); ++k) {
    read<grammar::whole>(formula.parts[k].text, {Kind::definition, k}, parameters, builder);
    builder.define(formula.parts[k].name);
  }
  for (std::size_t k = 0; k < formula.conditions.size(); ++k) {
    read<grammar::comparison>(formula.conditions[k], {Kind::condition, k}, parameters, builder);
    builder.add_condition();
  }
  read<grammar::whole>(formula.expression, {}, parameters, builder);
  return builder.take();
}

ParsedExpression parse_expression(std::string_view text, std::span<const std::string> parameters,
                                  ExpressionSlot slot) {
  return parse_formula({{}, {}, std::string(text)}, parameters, slot);
}

}  // namespace stationary
