#include "solver/program/case/case_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "lib/formula/apart.hpp"
#include "lib/formula/facts.hpp"
#include "lib/tape/tape_run.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/text/ascii.hpp"
#include "solver/program/text/expression_parser.hpp"

namespace stationary {
namespace {

constexpr std::string_view expression_key = "expression";
constexpr std::string_view parts_key = "let";
constexpr std::string_view domain_key = "domain";

/// Keys beside an expression that are no parameters.
bool is_own_key(std::string_view name) {
  return name == expression_key || name == parts_key || name == domain_key;
}

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

/// The value of a part of numbers and parameters as a model has it: computed in extended precision,
/// then rounded.
double value_of(const expression::Graph& graph, expression::NodeId constant,
                std::span<const double> parameters) {
  expression::TapeWriter writer(graph);
  writer.constant(constant);
  std::array<DoubleDouble, expression::largest_parameter_count> given;
  std::array<DoubleDouble, expression::largest_constant_count> value;
  std::ranges::copy(parameters, given.begin());
  expression::compute_constants<DoubleDouble>(writer.coefficients(), given.data(), value.data());
  return double(value[0]);
}

constexpr const char* not_finite = "a constant that is no finite number";
constexpr const char* finite = "constants that are finite at the parameters given";

/// Throws at the first constant that is not finite: as it is written, ExpressionError; as
/// (k*d)^-1 becomes 1/k times 1/d, InputError.
void require_finite_constants(const CaseTree& tree, const std::string& key,
                              const ParsedExpression& parsed, std::span<const double> parameters) {
  const expression::Graph& graph = parsed.expression.graph;
  const auto is_finite = [&](expression::NodeId node) {
    return std::isfinite(value_of(graph, node, parameters));
  };
  for (const auto& [node, offset, part] : parsed.constants)
    if (!is_finite(node)) throw ExpressionError(offset, not_finite, finite, "", part);
  const std::array<expression::NodeId, 1> root{parsed.expression.root};
  for (const expression::NodeId part : graph.parts(root))
    if (graph.is_coefficient(part) && !is_finite(part))
      throw fault_at(tree, key, std::string("found ") + not_finite, finite);
}

/// Throws where a condition on the parameters alone does not hold.
void require_conditions(const CaseTree& tree, const std::string& key,
                        const expression::Expression& e, std::span<const double> parameters) {
  for (const expression::Condition& each : e.conditions) {
    if (!e.graph.is_coefficient(each.node)) continue;
    const double value = value_of(e.graph, each.node, parameters);
    if (each.positive ? value > 0.0 : value != 0.0) continue;
    throw fault_at(tree, key,
                   parameters.empty() ? "found a condition that holds nowhere"
                                      : "found parameters with which it is defined nowhere",
                   each.text);
  }
}

/// The words of a text.
std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> out;
  for (std::size_t k = 0; k < text.size();) {
    std::size_t end = k;
    const bool is_number = is_digit(text[k]);  // 1.e3 has no word e3
    while (end < text.size() &&
           (is_letter(text[end]) || is_digit(text[end]) || (is_number && text[end] == '.')))
      ++end;
    if (end > k && is_letter(text[k])) out.push_back(text.substr(k, end - k));
    k = std::max(end, k + 1);
  }
  return out;
}

/// The parts of a formula, each after those that it is made of.
class Parts {
 public:
  Parts(const CaseTree& tree, std::string path, const toml::table& table)
      : tree_(tree), path_(std::move(path)) {
    for (const auto& [name, node] : table)
      all_.push_back({std::string(name.str()), node.as_string()->get()});
  }

  std::vector<Formula::Part> in_order() {
    for (std::size_t k = 0; k < all_.size(); ++k) visit(k);
    return std::move(out_);
  }

 private:
  enum class State : std::uint8_t { unseen, entered, done };

  void visit(std::size_t k) {
    state_.resize(all_.size(), State::unseen);
    if (state_[k] == State::done) return;
    const Formula::Part& part = all_[k];
    if (state_[k] == State::entered) {
      const std::string key = dotted(path_, part.name);
      throw fault_at(tree_, key, "found a part that is made of itself",
                     "parts made of others that can be had without them");
    }
    state_[k] = State::entered;
    for (const std::string_view word : words(part.text)) {
      const auto other = std::ranges::find(all_, word, &Formula::Part::name);
      if (other != all_.end()) visit(static_cast<std::size_t>(other - all_.begin()));
    }
    state_[k] = State::done;
    out_.push_back(part);
  }

  const CaseTree& tree_;
  std::string path_;
  std::vector<Formula::Part> all_;
  std::vector<State> state_;
  std::vector<Formula::Part> out_;
};

Formula read_formula(const CaseTree& tree, const std::string& path, const toml::table& table) {
  Formula out;
  out.expression = table.get(expression_key)->as_string()->get();
  if (const toml::node* parts = table.get(parts_key))
    out.parts = Parts(tree, dotted(path, parts_key), *parts->as_table()).in_order();
  if (const toml::node* domain = table.get(domain_key)) {
    if (const auto* one = domain->as_string()) {
      out.conditions.push_back(one->get());
    } else {
      for (const toml::node& each : *domain->as_array())
        out.conditions.push_back(each.as_string()->get());
    }
  }
  return out;
}

/// The key of a text of the formula, and its node.
std::pair<std::string, const toml::node*> node_of(const std::string& path, const toml::table& table,
                                                  const Formula& formula, const FormulaPart& part) {
  switch (part.kind) {
    case FormulaPart::Kind::definition: {
      const std::string& name = formula.parts[part.index].name;
      const std::string key = dotted(dotted(path, parts_key), name);
      return {key, table.get(parts_key)->as_table()->get(name)};
    }
    case FormulaPart::Kind::condition: {
      const std::string key = dotted(path, domain_key);
      const toml::node* node = table.get(domain_key);
      if (const auto* all = node->as_array())
        return {dotted(key, std::to_string(part.index)), all->get(part.index)};
      return {key, node};
    }
    case FormulaPart::Kind::expression:
      break;
  }
  return {dotted(path, expression_key), table.get(expression_key)};
}

void require_parts(const CaseTree& tree, const std::string& path, const toml::table& table,
                   ExpressionSlot slot) {
  const std::string key = dotted(path, parts_key);
  const toml::table* parts = table.get(parts_key)->as_table();
  if (parts == nullptr)
    throw fault_at(tree, key, "found " + describe(*table.get(parts_key)),
                   "a table of texts, let = { J = \"d*rho\" }");
  for (const auto& [name, node] : *parts) {
    const std::string own = dotted(key, name.str());
    if (!is_name(name.str()))
      throw InputError(tree.key_origin(own), printable(own),
                       "found " + in_quotes(name.str()) + ", which an expression cannot name",
                       "a letter or _, then letters, digits and _");
    if (is_word_of_formulas(name.str(), slot) || table.contains(name.str()))
      throw InputError(tree.key_origin(own), own,
                       "found a part called like a " +
                           std::string(table.contains(name.str()) && !is_own_key(name.str())
                                           ? "parameter"
                                           : "word of the language"),
                       "another name");
    if (!node.is_string())
      throw fault_at(tree, own, "found " + describe(node), "a text, \"d*rho\"");
  }
}

void require_conditions_as_texts(const CaseTree& tree, const std::string& path,
                                 const toml::node& node) {
  constexpr const char* allowed = "a comparison, \"I1 < 4\", or a list of comparisons";
  const std::string key = dotted(path, domain_key);
  if (node.is_string()) return;
  const toml::array* all = node.as_array();
  if (all == nullptr) throw fault_at(tree, key, "found " + describe(node), allowed);
  for (std::size_t k = 0; k < all->size(); ++k)
    if (!all->get(k)->is_string())
      throw fault_at(tree, dotted(key, std::to_string(k)), "found " + describe(*all->get(k)),
                     allowed);
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
  const ExpressionSlot slot = slot_of(path.substr(path.rfind('.') + 1));
  for (const auto& [name, node] : table) {
    const std::string key = dotted(path, name.str());
    if (name.str() == parts_key) {
      require_parts(tree, path, table, slot);
    } else if (name.str() == domain_key) {
      require_conditions_as_texts(tree, path, node);
    } else if (name.str() == expression_key) {
      if (!node.is_string())
        throw fault_at(tree, key, "found " + describe(node), "a text, \"mu*(I1 - 2*d)\"");
    } else if (name.str() == "model") {
      throw InputError(tree.key_origin(key), key, "found both model and expression",
                       std::string(allowed), "remove one of them");
    } else if (!is_name(name.str())) {
      throw InputError(tree.key_origin(key), printable(key),
                       "found " + in_quotes(name.str()) + ", which an expression cannot name",
                       "a letter or _, then letters, digits and _");
    } else if (is_reserved(name.str(), slot)) {
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
  WrittenPotential out;
  std::vector<std::string> parameters;
  for (const auto& [name, value] : table) {
    if (is_own_key(name.str())) continue;
    parameters.emplace_back(name.str());
    out.coefficients.push_back(value.value<double>().value_or(0.0));
  }
  const Formula& formula = out.formula = read_formula(tree, path, table);
  try {
    ParsedExpression parsed = parse_formula(formula, parameters, slot_of(slot));
    require_finite_constants(tree, key, parsed, out.coefficients);
    require_conditions(tree, key, parsed.expression, out.coefficients);
    const auto require_used = [&](const std::vector<std::string>& unused, const std::string& in,
                                  const std::string& what) {
      if (unused.empty()) return;
      const std::string own = dotted(in, unused[0]);
      throw InputError(tree.key_origin(own), own,
                       "found a " + what + " that does not occur in the expression",
                       what + "s of the expression", "remove it, or correct its name");
    };
    require_used(parsed.unused, path, "parameter");
    require_used(parsed.unused_parts, dotted(path, parts_key), "part");
    const expression::Facts facts =
        expression::facts(parsed.expression, slot_of(slot), out.coefficients);
    out.facts = facts.sentences;
    out.facts.insert(out.facts.end(), parsed.notes.begin(), parsed.notes.end());
    for (const expression::Condition& each : parsed.expression.conditions)
      out.facts.push_back("defined where " + each.text);
    out.assumed = parsed.expression.assumed = facts.assumed;
    if (!out.assumed.empty())
      parsed.expression.whole = expression::anisotropic_tape(parsed.expression);
    out.isotropic = slot_of(slot) == ExpressionSlot::thickness || facts.is_isotropic();
    if (out.isotropic && facts.is_separable() && slot_of(slot) == ExpressionSlot::coupled) {
      if (auto parts = expression::taken_apart(parsed.expression)) {
        out.parts = {expression::planar_tape(std::move(parts->plane)),
                     expression::thickness_tape(std::move(parts->thickness))};
      }
    }
    out.tape = compiled(slot_of(slot), std::move(parsed.expression), facts);
  } catch (const ExpressionError& error) {
    const auto [own, node] = node_of(path, table, formula, error.part());
    const std::string_view text = node->as_string()->get();
    const char* what =
        error.part().kind == FormulaPart::Kind::condition ? "the condition" : "the expression";
    throw InputError(character_origin(tree, own, *node, error.offset()), own,
                     fmt::format("found {} at character {} of {}", error.found(),
                                 1 + character_count(text.substr(0, error.offset())), what),
                     error.allowed(), error.remedy());
  } catch (const std::invalid_argument& error) {  // Unsuitable, NotSmooth
    throw fault_at(tree, key, "found an expression that cannot be used", "", error.what());
  } catch (const std::length_error& error) {
    throw fault_at(tree, key, "found too long an expression", "", error.what());
  }
  return out;
}

}  // namespace stationary
