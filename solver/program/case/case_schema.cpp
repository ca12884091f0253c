#include "solver/program/case/case_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "lib/body/motion.hpp"
#include "solver/motion/event.hpp"
#include "solver/program/case/case_expression.hpp"
#include "solver/program/case/case_grid.hpp"
#include "solver/program/table/table.hpp"
#include "solver/program/text/nearest_name.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {
namespace {

using enum KeyType;

constexpr std::string_view branches[] = {name(Branch::i), name(Branch::ii), name(Branch::iii),
                                         tilted_name,     oblique_name,     two_polar_name};
/// All but the ends of a sheet and what is unexplained.
constexpr std::span<const std::string_view> curve_events =
    std::span(event_names)
        .subspan(1, static_cast<std::size_t>(EventType::unexplained) - std::size_t{1});
constexpr std::string_view oblique_axes[] = {"1", "2"};
constexpr std::string_view a_boolean = "true or false";
constexpr std::string_view a_number = "a finite number";

constexpr std::string_view map_axis =
    "a table, { parameter = \"nu\", from = 0.0, to = 1.5, count = 400 }";
constexpr std::string_view map_parameter = "\"nu\" or the dotted key of a number of the case";
constexpr std::string_view map_count = "a whole number >= 2";

constexpr CaseKey keys[] = {
    {"title", text, false, "a text"},
    {"body", table, true, "a table with J"},
    {"body.J", numbers, true, "three finite numbers > 0, J = [J1, J2, J3]", 3},
    {"body.volume", number, false, "a number > 0, the determinant of S, held"},
    {"gravity", table, false, "a table with g or pi_G_rho"},
    {"gravity.g", number, false, "a number > 0"},
    {"gravity.pi_G_rho", number, false, "a number > 0; g = 4 sqrt(J1 J2 J3) pi_G_rho"},
    {"potential", table, true, "a table with plane and thickness, or coupled"},
    {"potential.plane", model, false, "a table of model, or expression, and its coefficients"},
    {"potential.thickness", model, false, "a table of model, or expression, and its coefficients"},
    {"potential.coupled", model, false, "a table of model, or expression, and its coefficients"},
    {"potential.fibre", coefficients, false, "a table, { k = 0.4, degrees = 30 }"},
    {"potential.second_fibre", coefficients, false, "a table, { k = 0.4, degrees = 30 }"},
    {"motion", table, true, "a table with branch and nu, or two-polar's numbers instead of nu"},
    {"motion.branch", text, true, "", 0, branches},
    // Which of these seven a branch takes, the case reader checks.
    {"motion.nu", number, false,
     "a finite number (the spin along the branch's axis; |nu| in \"tilted\", \"oblique\")"},
    {"motion.omega", number, false, a_number},
    {"motion.theta_dot", number, false, a_number},
    {"motion.s3", number, false, a_number},
    {"motion.p_theta", number, false, a_number},
    {"motion.plane", text, false, "", 0, tilt_plane_names},
    {"motion.axis", text, false, "", 0, oblique_axes},
    {"solve", table, false, "a table"},
    {"solve.start", numbers, false, "four finite numbers, start = [alpha, xi, zeta, rho]", 4},
    {"solve.method", text, false, "", 0, method_names},
    {"solve.all", boolean, false, a_boolean},
    {"solve.box", ranges, false,
     "two numbers, box = [min, max], or three such pairs, of xi, zeta and rho (of a two-polar "
     "motion lambda, mu and rho)",
     3},
    {"continuation", table, false, "a table with from and to"},
    {"continuation.parameter", text, false, "\"nu\" or the dotted key of a number of the case"},
    {"continuation.from", number, true, a_number},
    {"continuation.to", number, true, a_number},
    {"continuation.tolerance", number, false, "a number > 0 and <= 1"},
    {"continuation.step", number, false, "a number from 1e-12 to 0.5"},
    {"continuation.max_points", number, false, "a whole number >= 2"},
    {"continuation.events", texts, false, "an array of names of events"},
    {"continuation.start_row", text, false, "TABLE:N, TABLE:EVENT or TABLE:EVENT:K"},
    {"map", table, false, "a table with x, and y for two parameters"},
    {"map.x", table, true, map_axis},
    {"map.x.parameter", text, true, map_parameter},
    {"map.x.from", number, true, a_number},
    {"map.x.to", number, true, a_number},
    {"map.x.count", number, true, map_count},
    {"map.x.scale", text, false, "", 0, axis_scale_names},
    {"map.y", table, false, map_axis},
    {"map.y.parameter", text, true, map_parameter},
    {"map.y.from", number, true, a_number},
    {"map.y.to", number, true, a_number},
    {"map.y.count", number, true, map_count},
    {"map.y.scale", text, false, "", 0, axis_scale_names},
    {"curve", table, false, "a table with event, parameters, from and to"},
    {"curve.event", text, true, "", 0, curve_events},
    {"curve.parameters", texts, true,
     "two numbers of the case or ratios of two, [\"nu\", \"body.J.1\"]"},
    {"curve.from", numbers, true, "two finite numbers, one for each parameter", 2},
    {"curve.to", numbers, true, "two finite numbers, one for each parameter", 2},
    {"curve.tolerance", number, false, "a number > 0 and <= 1"},
    {"atlas", table, false, "a table of complete and checkpoints"},
    {"atlas.complete", boolean, false, a_boolean},
    {"atlas.checkpoints", number, false, "a whole number >= 1"},
    {"output", table, false, "a table"},
    {"output.spectrum", boolean, false, a_boolean},
    {"output.certificate", boolean, false, a_boolean},
    {"output.columns", texts, false, "an array of column names"},
    {"output.uncertainty", uncertainties, false,
     "a table of numbers of the case, each with its standard uncertainty > 0, "
     "{ \"body.J.0\" = 1e-3 }"},
};

std::string_view last_name(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

std::string_view parent(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view() : path.substr(0, dot);
}

std::vector<std::string_view> names_below(std::string_view prefix) {
  std::vector<std::string_view> out;
  for (const CaseKey& key : keys)
    if (parent(key.path) == prefix) out.push_back(last_name(key.path));
  return out;
}

std::string place_of(std::string_view prefix) {
  return prefix.empty() ? "at the top level" : "in [" + std::string(prefix) + "]";
}

[[noreturn]] void refuse_unknown(const CaseTree& tree, std::string_view prefix,
                                 std::string_view name,
                                 const std::vector<std::string_view>& allowed) {
  std::string remedy = did_you_mean(nearest_name(name, allowed));
  if (remedy.empty()) {
    // The right key in the wrong table; of several the first.
    for (const CaseKey& key : keys)
      if (remedy.empty() && last_name(key.path) == name && parent(key.path) != prefix)
        remedy = did_you_mean(std::optional(key.path));
  }
  const std::string path = dotted(prefix, name);
  throw InputError(tree.key_origin(path), printable(path), "found an unknown key",
                   "one of " + listed(allowed) + ' ' + place_of(prefix), remedy);
}

/// The text is one of the choices.
void require_choice(const CaseTree& tree, const CaseKey& key, const std::string& value) {
  if (key.choices.empty()) return;
  if (std::ranges::find(key.choices, std::string_view(value)) != key.choices.end()) return;
  throw fault_at(tree, key.path, "found the string " + in_quotes(value),
                 "one of " + listed(key.choices), did_you_mean(nearest_name(value, key.choices)));
}

bool finite_number(const toml::node& node) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  return value && std::isfinite(*value);
}

void require_numbers(const CaseTree& tree, const std::string& path, const toml::node& node,
                     const CaseKey& key) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() != static_cast<std::size_t>(key.count))
    throw fault_at(tree, path, "found " + describe(node), std::string(key.allowed));
  std::vector<InputError> faults;
  std::size_t index = 0;
  for (const toml::node& element : *array) {
    if (!finite_number(element))
      faults.push_back(fault_at(tree, dotted(path, std::to_string(index)),
                                "found " + describe(element), std::string(key.allowed)));
    ++index;
  }
  if (!faults.empty()) throw InputError(faults);
}

/// A pair of numbers, or an array of key.count such pairs.
void require_ranges(const CaseTree& tree, const toml::node& node, const CaseKey& key) {
  const toml::array* array = node.as_array();
  const CaseKey pair{key.path, numbers, false, key.allowed, 2};
  if (array == nullptr || array->empty() || !array->front().is_array())
    return require_numbers(tree, std::string(key.path), node, pair);
  if (array->size() != static_cast<std::size_t>(key.count))
    throw fault_at(tree, key.path, "found " + describe(node), std::string(key.allowed));
  std::size_t index = 0;
  for (const toml::node& each : *array)
    require_numbers(tree, dotted(key.path, std::to_string(index++)), each, pair);
}

/// Built-in models of a kind.
std::vector<const ModelDescription*> models_of(ModelDescription::Kind kind) {
  std::vector<const ModelDescription*> out;
  for (const auto* list : {&model_descriptions(), &anisotropic_descriptions()})
    for (const ModelDescription& each : *list)
      if (each.kind == kind) out.push_back(&each);
  return out;
}

/// All the coefficients of the model are there and finite, and no other key than those allowed.
void require_coefficients(const CaseTree& tree, const std::string& path, const toml::table& table,
                          const ModelDescription& description,
                          std::vector<std::string_view> allowed, Faults& faults) {
  const std::vector<std::string_view> parameters(description.parameters.begin(),
                                                 description.parameters.end());
  allowed.insert(allowed.end(), parameters.begin(), parameters.end());
  bool all_known = true;
  for (const auto& [name, value] : table) {
    if (std::ranges::find(allowed, name.str()) != allowed.end()) continue;
    faults.collect([&, &key = name] { refuse_unknown(tree, path, key.str(), allowed); });
    all_known = false;
  }
  std::vector<std::string_view> missing;
  for (const std::string_view parameter : parameters) {
    const toml::node* value = table.get(parameter);
    if (value == nullptr) {
      missing.push_back(parameter);
    } else if (!finite_number(*value)) {
      faults.add(fault_at(tree, dotted(path, parameter), "found " + describe(*value),
                          std::string(a_number)));
    }
  }
  if (missing.empty() || !all_known) return;  // a misspelt one is not missing too
  const std::string model = dotted(path, "model");
  const auto option = tree.overrides().find(model);
  faults.add(
      {tree.origin(option == tree.overrides().end() ? dotted(path, missing[0]) : model),
       dotted(path, missing[0]),
       fmt::format("found no coefficient{} {}", missing.size() > 1 ? "s" : "", listed(missing)),
       "all of " + listed(parameters) + " for " + in_quotes(description.name),
       option == tree.overrides().end()
           ? std::string()
           : fmt::format("give them with the model, as --set {}=1.0", dotted(path, missing[0]))});
}

/// `model` names a model of the kind, and the other keys are its coefficients, all of them; or the
/// potential is written out.
void require_model(const CaseTree& tree, const std::string& path, const toml::table& table,
                   Faults& faults) {
  if (is_written_out(table)) return require_written_out(tree, path, table);
  const ModelDescription::Kind kind = model_kind(path);
  std::vector<std::string_view> names;
  for (const ModelDescription* each : models_of(kind)) names.push_back(each->name);

  const std::string model_path = dotted(path, "model");
  const toml::node* model_node = table.get("model");
  if (model_node == nullptr) {
    std::string remedy;
    for (const auto& [name, value] : table)
      for (const std::string_view meant : {"model", "expression"})
        if (remedy.empty() && edit_distance(name.str(), meant) <= 2)
          remedy =
              in_quotes(name.str()) + " is no key here; did you mean " + in_quotes(meant) + "?";
    throw fault_at(tree, model_path, "found no model",
                   "model = one of " + listed(names) + ", or expression = \"...\"", remedy);
  }
  if (!model_node->is_string())
    throw fault_at(tree, model_path, "found " + describe(*model_node), "one of " + listed(names));
  const std::string& chosen = model_node->as_string()->get();
  const ModelDescription* description = find_model(kind, chosen);
  if (description == nullptr) {
    std::string remedy = did_you_mean(nearest_name(chosen, names));
    for (const ModelDescription& each : model_descriptions()) {
      if (each.name != chosen) continue;
      const std::string_view slot = each.kind == ModelDescription::Kind::planar      ? "plane"
                                    : each.kind == ModelDescription::Kind::thickness ? "thickness"
                                                                                     : "coupled";
      remedy = in_quotes(chosen) + " belongs under potential." + std::string(slot);
    }
    throw fault_at(tree, model_path, "found the string " + in_quotes(chosen),
                   "one of " + listed(names), remedy);
  }
  require_coefficients(tree, path, table, *description, {"model"}, faults);
}

/// How to write a choice that was read as a number: 13 for "13".
std::string quoted_choice(const CaseTree& tree, const CaseKey& key, const toml::node& node) {
  const auto number = node.value<long>();
  if (!number || std::ranges::find(key.choices, std::to_string(*number)) == key.choices.end())
    return {};
  if (tree.overrides().contains(std::string(key.path)))
    return fmt::format("in quotes: --set '{}=\"{}\"'", key.path, *number);
  return fmt::format("in quotes: {} = \"{}\"", last_name(key.path), *number);
}

void require_type(const CaseTree& tree, const CaseKey& key, const toml::node& node) {
  const auto require = [&](bool right) {
    if (right) return;
    if (key.choices.empty())
      throw fault_at(tree, key.path, "found " + describe(node), std::string(key.allowed));
    throw fault_at(tree, key.path, "found " + describe(node), "one of " + listed(key.choices),
                   quoted_choice(tree, key, node));
  };
  switch (key.type) {
    case table:
    case model:
    case coefficients:
      require(node.is_table());
      break;
    case text:
      require(node.is_string());
      require_choice(tree, key, node.as_string()->get());
      break;
    case number:
      require(finite_number(node));
      break;
    case numbers:
      require_numbers(tree, std::string(key.path), node, key);
      break;
    case ranges:
      require_ranges(tree, node, key);
      break;
    case boolean:
      require(node.is_boolean());
      break;
    case uncertainties:
      require(node.is_table());
      for (const auto& [name, value] : *node.as_table())
        if (!finite_number(value) || !(*value.value<double>() > 0.0))
          throw fault_at(tree, key.path, "found " + in_quotes(name.str()) + " = " + describe(value),
                         "a standard uncertainty > 0");
      break;
    case texts: {
      require(node.is_array());
      int index = 0;
      for (const toml::node& element : *node.as_array()) {
        if (!element.is_string()) {
          throw fault_at(tree, dotted(key.path, std::to_string(index)),
                         "found " + describe(element), std::string(key.allowed));
        }
        ++index;
      }
    }
  }
}

void require_table(const CaseTree& tree, const std::string& prefix, const toml::table& table,
                   Faults& faults) {
  const std::vector<std::string_view> known = names_below(prefix);
  std::vector<std::string_view> meant;  ///< what a misspelt key was to be
  for (const auto& [name, node] : table) {
    const std::string path = dotted(prefix, name.str());
    const bool plain = name.str().find('.') == std::string_view::npos && !name.empty();
    const CaseKey* key = plain ? find_case_key(path) : nullptr;
    if (key == nullptr) {
      if (const auto nearest = nearest_name(name.str(), known)) meant.push_back(*nearest);
      faults.collect([&, &found = name] { refuse_unknown(tree, prefix, found.str(), known); });
      continue;
    }
    if (!faults.collect([&, &value = node] { require_type(tree, *key, value); })) continue;
    if (key->type == KeyType::table) require_table(tree, path, *node.as_table(), faults);
    if (key->type == KeyType::model)
      faults.collect([&, &value = node] { require_model(tree, path, *value.as_table(), faults); });
    if (key->type == KeyType::coefficients)
      require_coefficients(tree, path, *node.as_table(), *models_of(model_kind(path)).front(), {},
                           faults);
  }
  for (const CaseKey& key : keys) {
    const std::string_view name = last_name(key.path);
    if (!key.required || parent(key.path) != prefix || table.contains(name) ||
        std::ranges::find(meant, name) != meant.end())
      continue;
    // A fluid whose volume is held needs none.
    if (key.path == "potential" && find(tree, "body.volume") != nullptr) continue;
    const std::string allowed =
        key.choices.empty() ? std::string(key.allowed) : "one of " + listed(key.choices);
    faults.add(fault_at(tree, key.path, "found no such key", allowed,
                        "add " + std::string(name) + ' ' + place_of(prefix)));
  }
}

}  // namespace

std::span<const CaseKey> case_keys() { return keys; }

const CaseKey* find_case_key(std::string_view path) {
  const auto at = std::ranges::find(keys, path, &CaseKey::path);
  return at == std::end(keys) ? nullptr : &*at;
}

ModelDescription::Kind model_kind(std::string_view path) {
  const std::string_view slot = last_name(path);
  if (slot == "plane") return ModelDescription::Kind::planar;
  if (slot == "fibre" || slot == "second_fibre") return ModelDescription::Kind::fibre;
  return slot == "thickness" ? ModelDescription::Kind::thickness : ModelDescription::Kind::coupled;
}

const ModelDescription* find_model(ModelDescription::Kind kind, std::string_view name) {
  for (const ModelDescription* each : models_of(kind))
    if (each->name == name) return each;
  return nullptr;
}

void require_known_keys(const CaseTree& tree, Faults& faults) {
  require_table(tree, "", tree.root(), faults);
}

bool may_be_set(std::string_view path) {
  if (find_case_key(path) != nullptr) return true;
  const CaseKey* above = find_case_key(parent(path));
  if (above == nullptr) return false;
  if (above->type == model || above->type == coefficients) return true;
  const std::string_view index = last_name(path);
  return above->type == KeyType::numbers && index.size() == 1 && index[0] >= '0' &&
         index[0] < '0' + above->count;
}

bool is_number_of_case(std::string_view path) {
  constexpr std::string_view tops[] = {"body.", "gravity.", "potential.", "motion."};
  if (std::ranges::none_of(tops, [&](std::string_view top) { return path.starts_with(top); }))
    return false;
  if (const CaseKey* key = find_case_key(path)) return key->type == number;
  constexpr std::string_view texts[] = {"model", "expression", "domain"};
  return may_be_set(path) && std::ranges::find(texts, last_name(path)) == std::end(texts);
}

InputError fault_at(const CaseTree& tree, std::string_view key, std::string found,
                    std::string allowed, std::string remedy) {
  return InputError(tree.origin(key), printable(key), std::move(found), std::move(allowed),
                    std::move(remedy));
}

}  // namespace stationary
