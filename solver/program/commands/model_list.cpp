#include "solver/program/commands/model_list.hpp"

#include <fmt/format.h>

#include "solver/program/case/case_schema.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary::cli {
namespace {

using Kind = ModelDescription::Kind;

constexpr std::size_t label_width = 26;

std::string joined(const std::vector<std::string>& parts) {
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string_view heading(Kind kind) {
  switch (kind) {
    case Kind::planar:
      return "planar, W(S) of [potential] plane";
    case Kind::thickness:
      return "thickness, V(rho) of [potential] thickness";
    case Kind::coupled:
      return "coupled, V(S, rho) of [potential] coupled";
    case Kind::fibre:
      return "fibres, beside any of them: fibre and second_fibre of [potential]";
    case Kind::whole:
      break;
  }
  return {};
}

void add_model(Report& out, const ModelDescription& model) {
  const bool wide = model.name.size() >= label_width;
  if (wide) out.line(model.name, "");
  out.line(wide ? "" : model.name, model.formula);
  out.line("  parameters", joined(model.parameters));
  out.line("  domain", joined(model.domain));
  out.line("  assumed", assumption(model));
}

}  // namespace

std::vector<ModelDescription> all_models() {
  std::vector<ModelDescription> out = model_descriptions();
  out.insert(out.end(), anisotropic_descriptions().begin(), anisotropic_descriptions().end());
  return out;
}

std::string_view assumption(const ModelDescription& model) {
  if (model.kind == Kind::planar && !model.isotropic)
    return "axes 1 and 2 are axes of symmetry (even in alpha); separable";
  switch (model.kind) {
    case Kind::planar:
      return "isotropic in the plane; separable: the thickness has a potential of its own";
    case Kind::thickness:
      return "separable: a function of rho alone";
    case Kind::coupled:
      return "isotropic; the thickness enters together with xi, zeta, alpha";
    case Kind::fibre:
      return "even in alpha only at 0 or 90 degrees, or as one of two like fibres at opposite "
             "angles";
    case Kind::whole:
      break;
  }
  return {};
}

std::string model_list(const std::string& only) {
  Report out(label_width);
  const std::vector<ModelDescription> all = all_models();
  if (!only.empty()) {
    std::vector<std::string_view> names;
    for (const ModelDescription& model : all) {
      names.push_back(model.name);
      if (model.name == only) add_model(out, model);
    }
    if (out.text().empty()) {
      throw InputError(Origin::of_option("models"), "", "found the name " + in_quotes(only),
                       "one of " + listed(names), did_you_mean(nearest_name(only, names)));
    }
    return out.text();
  }
  out.line("t = xi + zeta", "trace of the planar stretch S");
  out.line("d = xi zeta - alpha^2", "its determinant; tr S^2 = t^2 - 2 d, E = (S^2 - 1)/2");
  out.line("mu, lambda", "coefficients here, not the principal stretches");
  for (const Kind kind : {Kind::planar, Kind::thickness, Kind::coupled, Kind::fibre}) {
    out.gap();
    out.line(heading(kind), "");
    for (const ModelDescription& model : all) {
      if (model.kind != kind) continue;
      out.gap();
      add_model(out, model);
    }
  }
  return out.text();
}

}  // namespace stationary::cli
