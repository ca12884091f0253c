#include "solver/case_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "lib/expression/apart.hpp"
#include "lib/expression/facts.hpp"
#include "lib/expression/tape_run.hpp"
#include "solver/case_keys.hpp"
#include "solver/characters.hpp"
#include "solver/expression_parser.hpp"

namespace stationary {
namespace {

constexpr std::string_view expression_key = "expression";

ExpressionSlot slot_of(std::string_view slot) {
  if (slot == "plane") return ExpressionSlot::plane;
  return slot == "thickness" ? ExpressionSlot::thickness : ExpressionSlot::coupled;
}

/// Where the character at a byte of the text stands: exactly where the text is written as it is,
/// between two quotes on one line; else where the text begins. Columns count characters.
Origin character_origin(const CaseTree& tree, const std::string& key, const toml::node& node,
                        std::size_t offset) {
  Origin out = tree.origin(key);
  const auto& [begin, end, path] = node.source();
  const std::string_view text = node.as_string()->get();
  const std::size_t length = character_count(text);
  const bool as_it_is = out.option.empty() && begin.line == end.line &&
                        end.column == begin.column + static_cast<toml::source_index>(length) + 2;
  if (as_it_is) out.column += 1 + static_cast<int>(character_count(text.substr(0, offset)));
  return out;
}

/// Whether a part of numbers and parameters is a finite number as a model has it: computed in
/// extended precision, then rounded.
bool is_finite(const expression::Graph& graph, expression::NodeId constant,
               std::span<const double> parameters) {
  expression::TapeWriter writer(graph);
  writer.constant(constant);
  std::array<DoubleDouble, expression::largest_parameter_count> given;
  std::array<DoubleDouble, expression::largest_constant_count> value;
  std::ranges::copy(parameters, given.begin());
  expression::compute_constants<DoubleDouble>(writer.coefficients(), given.data(), value.data());
  return std::isfinite(double(value[0]));
}

constexpr const char* not_finite = "a constant that is no finite number";
constexpr const char* finite = "constants that are finite at the parameters given";

/// Throws at the first constant that is not finite: as it is written, ExpressionError; as
/// (k*d)^-1 becomes 1/k times 1/d, InputError.
void require_finite_constants(const CaseTree& tree, const std::string& key,
                              const ParsedExpression& parsed, std::span<const double> parameters) {
  const expression::Graph& graph = parsed.expression.graph;
  for (const auto& [node, offset] : parsed.constants)
    if (!is_finite(graph, node, parameters)) throw ExpressionError(offset, not_finite, finite);
  const std::array<expression::NodeId, 1> root{parsed.expression.root};
  for (const expression::NodeId part : graph.parts(root))
    if (graph.is_coefficient(part) && !is_finite(graph, part, parameters))
      throw fault_at(tree, key, std::string("found ") + not_finite, finite);
}

std::shared_ptr<const expression::Tape> compiled(ExpressionSlot slot,
                                                 expression::Expression expression,
                                                 const expression::Facts& facts) {
  if (slot != ExpressionSlot::thickness && !facts.is_isotropic()) {
    // With what is known of alpha for these values of the parameters.
    auto out =
        std::make_shared<expression::Tape>(*expression::oriented_tape(std::move(expression)));
    out->shear_free = out->shear_free && facts.is_shear_free();
    out->even = out->even && facts.is_even();
    out->sheared = facts.shear_free == expression::Verdict::refuted;
    return out;
  }
  switch (slot) {
    case ExpressionSlot::plane:
      return expression::planar_tape(std::move(expression));
    case ExpressionSlot::thickness:
      return expression::thickness_tape(std::move(expression));
    case ExpressionSlot::coupled:
      break;
  }
  return expression::coupled_tape(std::move(expression));
}

}  // namespace

bool is_written_out(const toml::table& table) { return table.contains(expression_key); }

void require_written_out(const CaseTree& tree, const std::string& path, const toml::table& table) {
  constexpr std::string_view allowed = "expression and its parameters, or model and its own";
  for (const auto& [name, node] : table) {
    const std::string key = dotted(path, name.str());
    if (name.str() == expression_key) {
      if (!node.is_string())
        throw fault_at(tree, key, "found " + describe(node), "a text, \"mu*(I1 - 2*d)\"");
    } else if (name.str() == "model") {
      throw InputError(tree.key_origin(key), key, "found both model and expression",
                       std::string(allowed), "remove one of them");
    } else if (!is_name(name.str())) {
      throw InputError(tree.key_origin(key), printable(key),
                       "found " + in_quotes(name.str()) + ", which an expression cannot name",
                       "a letter, then letters, digits and _");
    } else if (is_reserved(name.str(), slot_of(path.substr(path.rfind('.') + 1)))) {
      throw InputError(tree.key_origin(key), key, "found a parameter " + std::string(name.str()),
                       "another name",
                       "mu_ is the smaller principal stretch, mu is free for a parameter");
    } else if (!node.is_number() || !std::isfinite(node.value<double>().value_or(NAN))) {
      throw fault_at(tree, printable(key), "found " + describe(node), "a finite number");
    }
  }
}

WrittenPotential read_written_out(const CaseTree& tree, std::string_view slot,
                                  const toml::table& table) {
  const std::string path = "potential." + std::string(slot);
  const std::string key = dotted(path, expression_key);
  const toml::node& node = *table.get(expression_key);
  WrittenPotential out;
  std::vector<std::string> parameters;
  for (const auto& [name, value] : table) {
    if (name.str() == expression_key) continue;
    parameters.emplace_back(name.str());
    out.coefficients.push_back(value.value<double>().value_or(0.0));
  }
  const std::string& text = node.as_string()->get();
  try {
    ParsedExpression parsed = parse_expression(text, parameters, slot_of(slot));
    require_finite_constants(tree, key, parsed, out.coefficients);
    if (!parsed.unused.empty()) {
      const std::string unused = dotted(path, parsed.unused[0]);
      throw InputError(tree.key_origin(unused), unused,
                       "found a parameter that does not occur in the expression",
                       "parameters of the expression", "remove it, or correct its name");
    }
    const expression::Facts facts =
        expression::facts(parsed.expression, slot_of(slot), out.coefficients);
    out.facts = facts.sentences;
    out.facts.insert(out.facts.end(), parsed.notes.begin(), parsed.notes.end());
    out.at_points = facts.any_at_points();
    out.isotropic = slot_of(slot) == ExpressionSlot::thickness || facts.is_isotropic();
    if (out.isotropic && facts.is_separable() && slot_of(slot) == ExpressionSlot::coupled) {
      if (auto parts = expression::taken_apart(parsed.expression)) {
        out.parts = {expression::planar_tape(std::move(parts->plane)),
                     expression::thickness_tape(std::move(parts->thickness))};
      }
    }
    out.tape = compiled(slot_of(slot), std::move(parsed.expression), facts);
  } catch (const ExpressionError& error) {
    throw InputError(
        character_origin(tree, key, node, error.offset()), key,
        fmt::format("found {} at character {} of the expression", error.found(),
                    1 + character_count(std::string_view(text).substr(0, error.offset()))),
        error.allowed(), error.remedy());
  } catch (const std::invalid_argument& error) {  // Unsuitable, NotSmooth
    throw fault_at(tree, key, "found an expression that cannot be used", "", error.what());
  } catch (const std::length_error& error) {
    throw fault_at(tree, key, "found too long an expression", "", error.what());
  }
  return out;
}

}  // namespace stationary
