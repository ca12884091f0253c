// The language of expressions in a case file, text -> lib/expression:
//
//   sum      = product { (+|-) product }          variables   alpha xi zeta rho t d I1 lambda mu_
//   product  = signed { (*|/) signed }            constants   pi e
//   signed   = { + | - } power                    functions   sqrt exp log sin cos tan tanh atan
//   power    = operand { ^ { + | - } operand }                abs(x) pow(x, y) min(x, y) max(x, y)
//   operand  = number | name | name ( sum {, sum} ) | ( sum )
//
// ^ binds tightest and to the right: -x^2 is -(x^2), 2^3^2 is 2^9. lambda and mu_ are the principal
// stretches, lambda >= mu_; mu without the stroke is free for a parameter. A parameter that is
// called like a variable hides it (lambda_ is a second name of the stretch, for this); none may be
// called mu_, which has no other name.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "lib/expression/expression.hpp"

namespace stationary {

using ExpressionSlot = expression::Slot;

constexpr std::size_t largest_expression_length = 4096;
constexpr int largest_expression_depth = 64;  ///< of parentheses

/// What is wrong with a text, and where. what() says all of it in one line.
class ExpressionError : public std::invalid_argument {
 public:
  ExpressionError(std::size_t offset, std::string found, std::string allowed,
                  std::string remedy = {});

  std::size_t offset() const { return offset_; }  ///< of the character's first byte, from 0
  const std::string& found() const { return found_; }
  const std::string& allowed() const { return allowed_; }  ///< may be empty
  const std::string& remedy() const { return remedy_; }    ///< may be empty

 private:
  std::size_t offset_;
  std::string found_;
  std::string allowed_;
  std::string remedy_;
};

/// A part made of numbers and parameters only, and where its function or operator stands. Of a
/// variable's divisor the reciprocal.
struct WrittenConstant {
  expression::NodeId node;
  std::size_t offset;
};

struct ParsedExpression {
  expression::Expression expression;
  std::vector<std::string> notes;          ///< sentences: names that are hidden
  std::vector<std::string> unused;         ///< parameters that do not occur
  std::vector<WrittenConstant> constants;  ///< each after what it is made of
};

/// Whether a parameter may not be called so: the variable it would hide has no other name.
bool is_reserved(std::string_view name, ExpressionSlot slot);

/// parameters: at most largest_parameter_count names, none reserved. Throws ExpressionError.
ParsedExpression parse_expression(std::string_view text, std::span<const std::string> parameters,
                                  ExpressionSlot slot);

/// The names a slot's expressions know, variables and constants.
std::vector<std::string_view> expression_variables(ExpressionSlot slot);

}  // namespace stationary
