// From what the grammar of expression_parser.cpp finds, in its order, to the graph of an
// expression: operands on a stack, names given their meaning, numbers and names refused where they
// have none. One builder reads the texts of a formula one after the other into one graph.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/text/expression_parser.hpp"

namespace stationary {

/// The word, number or character that begins at an offset, as a message names it.
std::string token_at(std::string_view text, std::size_t offset);

class ExpressionBuilder {
 public:
  ExpressionBuilder(std::span<const std::string> parameters, ExpressionSlot slot)
      : parameters_(parameters), slot_(slot), used_(parameters.size(), false) {
    out_.expression.parameters.assign(parameters.begin(), parameters.end());
  }

  /// What follows is read from this text.
  void begin(std::string_view text, const FormulaPart& part) {
    text_ = text;
    part_ = part;
  }
  const FormulaPart& part() const { return part_; }

  void number(std::string_view digits, std::size_t offset);
  void name(std::string_view word, std::size_t offset) { word_ = {word, offset}; }
  void lone_name();
  void open_call();
  void close_call(std::size_t end);
  void bracket(std::size_t begin, std::size_t end);
  void signs(std::string_view characters, std::size_t offset) {
    signs_.push_back({std::ranges::count(characters, '-') % 2 == 1, offset});
  }
  void signed_power();
  void begin_power() { powers_.push_back(operands_.size()); }
  void exponent();
  void end_power();
  void operation(char symbol, std::size_t offset) { operators_.push_back({symbol, offset}); }
  void apply_operation();
  void comparison(std::string_view symbol) { is_less_ = symbol.front() == '<'; }

  /// The text was that of a part with a name of its own.
  void define(const std::string& name);
  /// It was a comparison.
  void add_condition();
  /// It was the potential itself, and the last.
  ParsedExpression take();

 private:
  struct Word {
    std::string_view text;
    std::size_t offset = 0;
  };
  struct Operand {
    expression::NodeId node = 0;
    std::size_t begin = 0;  ///< of its text
    std::size_t end = 0;
    bool negative = false;  ///< of an exponent whose sign is still to be applied
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
  struct SignRun {
    bool negative;
    std::size_t offset;
  };
  struct Definition {
    std::string name;
    expression::NodeId node;
    bool used = false;
  };

  expression::Graph& graph() { return out_.expression.graph; }
  const expression::Graph& graph() const { return out_.expression.graph; }
  const Operand& top(std::size_t below) const { return operands_[operands_.size() - 1 - below]; }
  /// The last operands by one that stands for all their text.
  void replace(std::size_t count, expression::NodeId by);
  SignRun take_sign() {
    const SignRun out = signs_.back();
    signs_.pop_back();
    return out;
  }
  /// "x > 0" with the text of an operand.
  std::string condition(const Operand& x, const char* relation) const;
  void require_positive(const Operand& x);
  void require_nonzero(const Operand& x);
  /// f(), its complaints about the graph as errors at `offset`; notes a constant.
  template <class F>
  expression::NodeId at(std::size_t offset, const F& f);
  void require_divisor(expression::NodeId x, std::size_t offset) const;
  expression::NodeId power(const Operand& base, expression::NodeId exponent, std::size_t offset);
  expression::NodeId applied(const Call& call);
  expression::NodeId meaning(const Word& word);
  bool is_parameter(std::string_view name) const {
    return std::ranges::find(parameters_, name) != parameters_.end();
  }
  /// The variables and constants that no parameter hides.
  std::vector<std::string_view> variable_names() const;
  /// These, the parameters and the parts defined so far, for a message.
  std::string allowed_names() const;
  [[noreturn]] void fail(std::size_t offset, std::string found, std::string allowed,
                         std::string remedy = {}) const;
  [[noreturn]] void unknown_name(const Word& word) const;
  [[noreturn]] void unknown_function(const Word& word) const;

  std::string_view text_;
  FormulaPart part_;
  std::span<const std::string> parameters_;
  ExpressionSlot slot_;
  ParsedExpression out_;
  std::vector<bool> used_;
  std::vector<Definition> definitions_;
  Word word_;
  std::vector<Operand> operands_;
  std::vector<Call> calls_;
  std::vector<SignRun> signs_;
  std::vector<std::size_t> powers_;
  std::vector<Operator> operators_;
  bool is_less_ = false;
};

}  // namespace stationary
