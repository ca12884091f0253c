// From what the grammar of expression_parser.cpp finds, in its order, to the graph of an
// expression: operands on a stack, names given their meaning, numbers and names refused where they
// have none.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/expression_parser.hpp"

namespace stationary {

/// The word, number or character that begins at an offset, as a message names it.
std::string token_at(std::string_view text, std::size_t offset);

/// Turns what the grammar finds into the graph: operands on a stack.
class ExpressionBuilder {
 public:
  ExpressionBuilder(std::string_view text, std::span<const std::string> parameters,
                    ExpressionSlot slot)
      : text_(text), parameters_(parameters), slot_(slot), used_(parameters.size(), false) {
    out_.expression.text = std::string(text);
    out_.expression.parameters.assign(parameters.begin(), parameters.end());
  }

  void number(std::string_view digits, std::size_t offset);
  void name(std::string_view word, std::size_t offset) { word_ = {word, offset}; }
  void lone_name() { operands_.push_back({meaning(word_), false}); }
  void open_call();
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
    expression::NodeId node;
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

  expression::Graph& graph() { return out_.expression.graph; }
  const expression::Graph& graph() const { return out_.expression.graph; }
  expression::NodeId top(std::size_t below) const {
    return operands_[operands_.size() - 1 - below].node;
  }
  void replace(std::size_t count, expression::NodeId by) {
    operands_.resize(operands_.size() - count);
    operands_.push_back({by, false});
  }
  bool take_sign() {
    const bool out = minus_.back();
    minus_.pop_back();
    return out;
  }
  /// f(), its complaints about the graph as errors at `offset`; notes a constant.
  template <class F>
  expression::NodeId at(std::size_t offset, const F& f);
  void require_divisor(expression::NodeId x, std::size_t offset) const;
  expression::NodeId power(expression::NodeId base, expression::NodeId exponent,
                           std::size_t offset);
  expression::NodeId meaning(const Word& word);
  bool is_parameter(std::string_view name) const {
    return std::ranges::find(parameters_, name) != parameters_.end();
  }
  /// The variables and constants that no parameter hides.
  std::vector<std::string_view> variable_names() const;
  /// These and the parameters, for a message.
  std::string allowed_names() const;
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

}  // namespace stationary
