#include "solver/program/case/case_potential.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "lib/number/double_double.hpp"
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
        break;
      case ModelDescription::Kind::whole:
        break;  // read_whole_body() looks
    }
  } catch (const std::invalid_argument& error) {
    const std::string_view inequality = error.what();
    std::string key = "potential." + model.slot;
    std::string found;
    for (std::size_t k = 0; k < model.coefficients.size(); ++k) {
      const std::string_view parameter = model.description.parameters[k];
      if (!mentions(inequality, parameter)) continue;
      key = coefficient_key(model, parameter);
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

/// A number > 0 under this key; nothing where it is missing or refused.
std::optional<double> read_positive(const CaseTree& tree, const std::string& key, Faults& faults) {
  const toml::node* node = find(tree, key);
  if (node == nullptr || !faults.sound(key)) return std::nullopt;
  const double value = node->value<double>().value_or(0.0);
  if (value > 0.0) return value;
  faults.add(fault_at(tree, key, fmt::format("found {}", value), "a number > 0"));
  return std::nullopt;
}

/// Gravity and the held volume, as models of their own.
void read_whole_body(const CaseTree& tree, Faults& faults, std::vector<ModelChoice>& out) {
  using Kind = ModelDescription::Kind;
  std::optional<double> g = read_positive(tree, "gravity.g", faults);
  const std::optional<double> density = read_positive(tree, "gravity.pi_G_rho", faults);
  const bool has_g = find(tree, "gravity.g") != nullptr;
  const bool has_density = find(tree, "gravity.pi_G_rho") != nullptr;
  if (find(tree, "gravity") != nullptr && has_g == has_density)
    faults.add(fault_at(tree, "gravity", has_g ? "found both g and pi_G_rho" : "found neither",
                        "g or pi_G_rho", has_g ? "keep one of them" : "add one of them"));
  const std::vector<double> J = numbers(tree, "body.J");
  if (density && J.size() == 3) {
    // Rounded once.
    const DoubleDouble product = two_product(J[0], J[1]) * J[2];
    g = double(4.0 * (sqrt(product) * *density));
  }
  if (g)
    out.push_back({"gravity",
                   {Kind::whole,
                    "self-gravity",
                    "-g F(T, D, z),  g = 15 G (M/5)^(5/2)",
                    {"g"},
                    {"g > 0"},
                    true},
                   {*g}});
  if (const auto volume = read_positive(tree, "body.volume", faults))
    out.push_back({"volume",
                   {Kind::whole, "held volume", "det S = volume", {"volume"}, {"volume > 0"}, true},
                   {*volume}});
}

}  // namespace

bool is_whole_body(std::span<const ModelChoice> models) {
  return std::ranges::any_of(models, [](const ModelChoice& each) {
    return each.description.kind == ModelDescription::Kind::whole;
  });
}

std::string coefficient_key(const ModelChoice& model, std::string_view coefficient) {
  if (model.slot == "volume") return "body.volume";
  if (model.slot == "gravity") return fmt::format("gravity.{}", coefficient);
  return fmt::format("potential.{}.{}", model.slot, coefficient);
}

int place_in_body(const ModelChoice& model, int index) {
  const std::size_t first = model.slot == "volume"      ? BodyModel<>::volume_place
                            : model.slot == "gravity"   ? BodyModel<>::g_place
                            : model.slot == "thickness" ? ElasticPart<>::thickness_place
                                                        : ElasticPart<>::plane_place;
  return static_cast<int>(first) + index;
}

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
  read_whole_body(tree, faults, out);
  if (!sound || !faults.sound("potential") || !faults.sound("gravity") ||
      !faults.sound("body.volume"))
    return std::nullopt;
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
  if (!has("coupled") && bases < 2 && !(has("volume") && !has("thickness"))) {
    const std::string found = bases == 0 ? "found neither" : "found " + out[0].slot + " alone";
    const std::string missing = has("plane") ? "thickness" : "plane";
    faults.add(fault_at(tree, "potential." + missing, found, std::string(rule), "add " + missing));
    return std::nullopt;
  }
  if (bases == 0 && anisotropic(out)) {
    faults.add(fault_at(tree, "potential.fibre", "found a fibre alone",
                        "a fibre beside a plane, or beside coupled", "add plane"));
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

/// Of models with gravity or a held volume among them.
BodyModel<> whole_body(std::span<const ModelChoice> models, const Body& body) {
  BodyModel<> out;
  for (const ModelChoice& model : models) {
    if (model.slot == "plane") out.elastic.plane = any_plane(model);
    if (model.slot == "thickness") out.elastic.thickness = any_thickness(model);
    if (model.slot == "coupled" && model.tape)
      out.elastic.coupled = CoupledExpression<>(model.tape, coefficient_list(model.coefficients));
    if (model.slot == "coupled" && !model.tape)
      std::visit([&](const auto& each) { out.elastic.coupled = each; },
                 Potential::coupled(model.description.name, model.coefficients));
    if (model.slot == "gravity") {
      out.gravitates = true;
      out.g = model.coefficients[0];
      out.J = {body.J1, body.J2, body.J3};
    }
    if (model.slot == "volume") out.volume = model.coefficients[0];
  }
  return out;
}

}  // namespace

namespace {

AnisotropicPotential anisotropic_potential(std::span<const ModelChoice> models, const Body& body) {
  std::vector<Fibre> fibres;
  BodyTerms<double> terms;
  std::optional<AnyThickness<>> thickness;
  for (const ModelChoice& model : models) {
    if (model.description.kind == ModelDescription::Kind::fibre)
      fibres.push_back({model.coefficients[0], model.coefficients[1]});
    if (model.slot == "thickness") thickness = any_thickness(model);
    if (model.slot == "volume") terms.volume = model.coefficients[0];
    if (model.slot != "gravity") continue;
    terms.gravitates = true;
    terms.g = model.coefficients[0];
    terms.J = {body.J1, body.J2, body.J3};
  }
  const AnisotropicPotential out =
      models[0].slot == "coupled"
          ? AnisotropicPotential(oriented_coupled(models[0]), fibres)
          : AnisotropicPotential(oriented_plane(models[0]), thickness, fibres);
  return terms.any() ? out.with_body(terms) : out;
}

}  // namespace

Potential make_potential(std::span<const ModelChoice> models, const Body& body) {
  if (anisotropic(models)) return Potential(anisotropic_potential(models, body));
  if (is_whole_body(models)) return Potential(whole_body(models, body));
  const auto name = [&](std::size_t k) -> std::string_view { return models[k].description.name; };
  const auto values = [&](std::size_t k) { return std::span(models[k].coefficients); };
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
