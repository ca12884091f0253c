// The language of expressions in a case file, text -> lib/expression:
//
//   sum      = product { (+|-) product }          variables   alpha xi zeta rho t d I1 I2 I3
//   product  = signed { (*|/) signed }                        lambda mu_
//   signed   = { + | - } power                    constants   pi e
//   power    = operand { ^ { + | - } operand }    functions   sqrt exp log (or ln) sin cos tan
//   operand  = number | name | name ( sum {, sum} ) | ( sum ) tanh atan
//                                                             abs(x) pow(x, y) min(x, y) max(x, y)
//   condition = sum (< | <= | > | >=) sum
//
// ^ binds tightest and to the right: -x^2 is -(x^2), 2^3^2 is 2^9. lambda and mu_ are the principal
// stretches, lambda >= mu_; mu without the stroke is free for a parameter. A parameter that is
// called like a variable hides it (lambda_ is a second name of the stretch, for this); none may be
// called mu_, which has no other name. I2 = d^2 + rho^2 I1 and I3 = (d rho)^2 are those of the
// whole body, known to a coupled potential.
//
// A formula may define parts, each known by its name to what is read after it, and conditions that
// a stretch must meet; both sides of <= are apart too, for what is solved lies strictly inside.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "lib/formula/expression.hpp"

namespace stationary {

using ExpressionSlot = expression::Slot;

constexpr std::size_t largest_expression_length = 4096;
constexpr int largest_expression_depth = 64;         ///< of parentheses
constexpr std::size_t largest_part_count = 64;       ///< parts that a formula defines
constexpr std::size_t largest_condition_count = 32;  ///< conditions that its user states

/// One of the texts of a formula.
struct FormulaPart {
  enum class Kind : std::uint8_t { expression, definition, condition };
  Kind kind = Kind::expression;
  std::size_t index = 0;
};

/// What is wrong with a text, and where. what() says all of it in one line.
class ExpressionError : public std::invalid_argument {
 public:
  ExpressionError(std::size_t offset, std::string found, std::string allowed,
                  std::string remedy = {}, const FormulaPart& part = {});

  const FormulaPart& part() const { return part_; }
  std::size_t offset() const { return offset_; }  ///< of the character's first byte, from 0
  const std::string& found() const { return found_; }
  const std::string& allowed() const { return allowed_; }  ///< may be empty
  const std::string& remedy() const { return remedy_; }    ///< may be empty

 private:
  std::size_t offset_;
  std::string found_;
  std::string allowed_;
  std::string remedy_;
  FormulaPart part_;
};

/// A part made of numbers and parameters only, and where its function or operator stands. Of a
/// variable's divisor the reciprocal.
struct WrittenConstant {
  expression::NodeId node;
  std::size_t offset;
  FormulaPart part;
};

struct ParsedExpression {
  expression::Expression expression;
  std::vector<std::string> notes;          ///< sentences: names that are hidden, powers
  std::vector<std::string> unused;         ///< parameters that do not occur
  std::vector<std::string> unused_parts;   ///< likewise
  std::vector<WrittenConstant> constants;  ///< each after what it is made of

  void add_note(std::string note) {
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(std::move(note));
  }
};

/// A formula in the words of its user.
struct Formula {
  struct Part {
    std::string name;
    std::string text;
  };
  std::vector<Part> parts;
  std::vector<std::string> conditions;
  std::string expression;
};

/// Whether a parameter may not be called so: the variable it would hide has no other name.
bool is_reserved(std::string_view name, ExpressionSlot slot);

/// parameters: at most largest_parameter_count names, none reserved. Throws ExpressionError.
ParsedExpression parse_formula(const Formula& formula, std::span<const std::string> parameters,
                               ExpressionSlot slot);
/// Of an expression alone.
ParsedExpression parse_expression(std::string_view text, std::span<const std::string> parameters,
                                  ExpressionSlot slot);

/// The names a slot's expressions know, variables and constants.
std::vector<std::string_view> expression_variables(ExpressionSlot slot);
/// Those, and the functions: what no part may be called.
bool is_word_of_formulas(std::string_view name, ExpressionSlot slot);

}  // namespace stationary
