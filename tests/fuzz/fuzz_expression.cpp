// Any text as a potential: parsed, and, of one in 64, since it takes a hundred times as long, its
// facts found, differentiated, made into tapes and evaluated. The first character chooses what it
// is a potential of. Either that works or an exception says what is wrong, at a place in the text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "lib/formula/facts.hpp"
#include "lib/material/models/anisotropic_expression.hpp"
#include "solver/program/text/expression_parser.hpp"

namespace {

using namespace stationary;

ExpressionSlot slot_of(char c) {
  return c == 't'   ? ExpressionSlot::thickness
         : c == 'c' ? ExpressionSlot::coupled
                    : ExpressionSlot::plane;
}

/// The same choice every time (Fowler, Noll, Vo).
bool is_chosen(std::string_view text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return (hash >> 20) % 64 == 0;
}

void evaluate(const expression::Expression& parsed, ExpressionSlot slot) {
  CoefficientList<double> coefficients(parsed.parameters.size());
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    coefficients[k] = 0.75 + 0.5 * static_cast<double>(k);
  if (slot == ExpressionSlot::thickness) {
    const ThicknessExpression<> model(expression::thickness_tape(parsed), coefficients);
    model.evaluate<2>(1.25);
    return;
  }
  if (!expression::facts(parsed, slot).is_isotropic()) {
    const AnisotropicExpression<> model(expression::anisotropic_tape(parsed), coefficients);
    model.derivatives<2>(Stretch{0.125, 1.25, 0.875, 1.0});
    return;
  }
  const CoupledExpression<> model(expression::coupled_tape(parsed), coefficients);
  model.evaluate<2>(planar_invariants(1.25, 0.875), 1.0);
  model.log_balance(1.25, 0.875, 1.0, 0.125, 0.125, 0.0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const ExpressionSlot slot = slot_of(static_cast<char>(data[0]));
  static const std::vector<std::string> parameters{"mu", "k", "lambda"};
  try {
    const ParsedExpression parsed = parse_expression(text, parameters, slot);
    if (is_chosen(text)) evaluate(parsed.expression, slot);
  } catch (const ExpressionError& error) {
    if (error.offset() > text.size()) std::abort();
  } catch (const expression::Unsuitable&) {
  } catch (const expression::TooLarge&) {
  }
  return 0;
}
