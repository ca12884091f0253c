#include "solver/program/case/case_potential.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "solver/program/case/case_expression.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/text/ascii.hpp"

namespace stationary {
namespace {

/// Whether an inequality such as "mu + lambda > 0" speaks of the parameter.
bool mentions(std::string_view inequality, std::string_view parameter) {
  const auto is_word = [](char c) { return is_letter(c) || is_digit(c); };
  for (std::size_t at = inequality.find(parameter); at != std::string_view::npos;
       at = inequality.find(parameter, at + 1)) {
    const std::size_t end = at + parameter.size();
    if ((at == 0 || !is_word(inequality[at - 1])) &&
        (end == inequality.size() || !is_word(inequality[end])))
      return true;
  }
  return false;
}

/// Throws at the coefficient an inequality of the model's domain fails for: the last one it speaks
/// of, since the inequalities on the earlier ones alone come first and hold.
void require_domain(const CaseTree& tree, const ModelChoice& model) {
  if (model.tape) return;  // finite parameters are all that is asked of an expression
  try {
    const std::span<const double> values = model.coefficients;
    switch (model.description.kind) {
      case ModelDescription::Kind::planar:
        Potential::oriented_plane(model.description.name, values);
        break;
      case ModelDescription::Kind::thickness:
        Potential::thickness(model.description.name, values);
        break;
      case ModelDescription::Kind::coupled:
        Potential::coupled(model.description.name, values);
        break;
      case ModelDescription::Kind::fibre:
        if (!(values[0] > 0.0)) throw std::invalid_argument("k > 0");
    }
  } catch (const std::invalid_argument& error) {
    const std::string_view inequality = error.what();
    std::string key = "potential." + model.slot;
    std::string found;
    for (std::size_t k = 0; k < model.coefficients.size(); ++k) {
      const std::string_view parameter = model.description.parameters[k];
      if (!mentions(inequality, parameter)) continue;
      key = fmt::format("potential.{}.{}", model.slot, parameter);
      found += fmt::format("{}{} = {}", found.empty() ? "found " : ", ", parameter,
                           model.coefficients[k]);
    }
    throw fault_at(tree, key, found, std::string(inequality),
                   fmt::format("the domain of \"{}\"", model.description.name));
  }
}

}  // namespace

bool anisotropic(std::span<const ModelChoice> models) {
  return !std::ranges::all_of(models, [](const ModelChoice& m) { return m.description.isotropic; });
}

namespace {

ModelChoice written_out(const CaseTree& tree, const std::string& slot, const toml::table& table) {
  WrittenPotential written = read_written_out(tree, slot, table);
  ModelDescription description{model_kind("potential." + slot), "expression", written.tape->text,
                               written.tape->parameters,        {},           written.isotropic};
  return {slot,
          std::move(description),
          std::move(written.coefficients),
          std::move(written.tape),
          std::move(written.facts),
          std::move(written.assumed),
          std::move(written.formula),
          std::move(written.parts)};
}

ModelChoice built_in(const std::string& slot, const toml::table& table) {
  const ModelDescription::Kind kind = model_kind("potential." + slot);
  const std::string named =
      kind == ModelDescription::Kind::fibre ? "fibre" : table.get("model")->value_or(std::string());
  ModelChoice out{slot, *find_model(kind, named), {}};
  for (const std::string& parameter : out.description.parameters)
    out.coefficients.push_back(table.get(parameter)->value<double>().value_or(0.0));
  return out;
}

}  // namespace

void leave_replaced_coefficients(CaseTree& tree, const toml::table& before) {
  for (const std::string slot : {"plane", "thickness", "coupled"}) {
    const std::string path = "potential." + slot;
    const toml::table* old = before[slot].as_table();
    const toml::node* named = find(tree, path + ".model");
    if (old == nullptr || named == nullptr || !named->is_string() ||
        !tree.overrides().contains(path + ".model"))
      continue;
    const ModelDescription* model = find_model(model_kind(path), named->as_string()->get());
    if (model == nullptr) continue;
    for (const auto& [key, value] : *old) {
      const std::string_view name = key.str();
      const bool stays = name == "model" ||
                         std::ranges::find(model->parameters, name) != model->parameters.end() ||
                         tree.overrides().contains(dotted(path, name));
      if (!stays) tree.erase(path, name);
    }
  }
}

std::optional<std::vector<ModelChoice>> read_models(const CaseTree& tree, Faults& faults) {
  std::vector<ModelChoice> out;
  std::size_t bases = 0;
  bool sound = true;
  for (const std::string slot : {"plane", "thickness", "coupled", "fibre", "second_fibre"}) {
    const std::string path = "potential." + slot;
    const toml::node* node = find(tree, path);
    if (node == nullptr) continue;
    if (!faults.sound(path)) continue;
    const bool is_fibre = model_kind(path) == ModelDescription::Kind::fibre;
    if (!is_fibre) ++bases;
    sound = faults.collect([&] {
      const toml::table& table = *node->as_table();
      out.push_back(!is_fibre && is_written_out(table) ? written_out(tree, slot, table)
                                                       : built_in(slot, table));
      require_domain(tree, out.back());
    }) && sound;
  }
  if (!sound || !faults.sound("potential")) return std::nullopt;
  const auto has = [&out](std::string_view slot) {
    return std::ranges::find(out, slot, &ModelChoice::slot) != out.end();
  };
  constexpr std::string_view rule = "plane and thickness, or coupled instead of both";
  if (has("coupled") && bases > 1) {
    const std::string other = has("plane") ? "plane" : "thickness";
    faults.add(fault_at(tree, "potential.coupled", "found both coupled and " + other,
                        std::string(rule), "remove one of them"));
    return std::nullopt;
  }
  if (!has("coupled") && bases < 2) {
    const std::string found = bases == 0 ? "found neither" : "found " + out[0].slot + " alone";
    const std::string missing = has("plane") ? "thickness" : "plane";
    faults.add(fault_at(tree, "potential." + missing, found, std::string(rule), "add " + missing));
    return std::nullopt;
  }
  return out;
}

namespace {

AnyPlane<> any_plane(const ModelChoice& choice) {
  if (!choice.tape) return {{Potential::planar(choice.description.name, choice.coefficients)}};
  return {{PlanarExpression<>(choice.parts ? choice.parts->plane : choice.tape,
                              coefficient_list(choice.coefficients))}};
}

AnisotropicPotential::Plane oriented_plane(const ModelChoice& choice) {
  if (!choice.tape) return Potential::oriented_plane(choice.description.name, choice.coefficients);
  const auto coefficients = coefficient_list(choice.coefficients);
  if (choice.description.isotropic) return PlanarExpression<>(choice.tape, coefficients);
  return OrientedExpression<>(choice.tape, coefficients);
}

AnisotropicPotential::Coupled oriented_coupled(const ModelChoice& choice) {
  if (!choice.tape) {
    return std::visit([](const auto& model) -> AnisotropicPotential::Coupled { return model; },
                      Potential::coupled(choice.description.name, choice.coefficients));
  }
  const auto coefficients = coefficient_list(choice.coefficients);
  if (choice.description.isotropic) return CoupledExpression<>(choice.tape, coefficients);
  return OrientedExpression<>(choice.tape, coefficients);
}

AnyThickness<> any_thickness(const ModelChoice& choice) {
  if (!choice.tape) return {{Potential::thickness(choice.description.name, choice.coefficients)}};
  return {{ThicknessExpression<>(choice.parts ? choice.parts->thickness : choice.tape,
                                 coefficient_list(choice.coefficients))}};
}

}  // namespace

Potential make_potential(std::span<const ModelChoice> models) {
  const auto name = [&](std::size_t k) -> std::string_view { return models[k].description.name; };
  const auto values = [&](std::size_t k) { return std::span(models[k].coefficients); };
  if (anisotropic(models)) {
    std::vector<Fibre> fibres;
    for (const ModelChoice& model : models)
      if (model.description.kind == ModelDescription::Kind::fibre)
        fibres.push_back({model.coefficients[0], model.coefficients[1]});
    if (models[0].slot == "coupled")
      return Potential(AnisotropicPotential(oriented_coupled(models[0]), fibres));
    return Potential(
        AnisotropicPotential(oriented_plane(models[0]), any_thickness(models[1]), fibres));
  }
  const bool written_out =
      std::ranges::any_of(models, [](const ModelChoice& m) { return m.tape != nullptr; });
  if (written_out && models.size() == 1 && models[0].parts)
    return Potential(SeparableExpression{any_plane(models[0]), any_thickness(models[0])});
  if (written_out && models.size() == 1)
    return Potential(CoupledExpression<>(models[0].tape, coefficient_list(models[0].coefficients)));
  if (written_out) {
    return Potential(SeparableExpression{any_plane(models[0]), any_thickness(models[1])});
  }
  if (models.size() == 1) return Potential(Potential::coupled(name(0), values(0)));
  return {Potential::planar(name(0), values(0)), Potential::thickness(name(1), values(1))};
}

}  // namespace stationary
