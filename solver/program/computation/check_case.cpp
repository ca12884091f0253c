#include "solver/program/computation/check_case.hpp"

#include <fmt/format.h>

#include "solver/kind/kind.hpp"
#include "solver/program/case/case_motion.hpp"
#include "solver/program/computation/event_curves.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/report.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace {

std::string coefficients_text(const ModelChoice& model) {
  std::string out;
  for (std::size_t k = 0; k < model.coefficients.size(); ++k) {
    out += fmt::format("{}{} = {}", out.empty() ? "" : ", ", model.description.parameters[k],
                       model.coefficients[k]);
  }
  return out;
}

std::string start_text(const Case& input) {
  const auto& start = input.own_solve.start;
  if (!start)
    return std::string(kind_of(input.body, input.potential, input.motion)->default_start());
  return fmt::format("(alpha, {}, rho) = ({}, {}, {}, {})",
                     has_rates(input.motion) ? "lambda, mu" : "xi, zeta", start->alpha, start->xi,
                     start->zeta, start->rho);
}

/// Why `curve` does not take the case, if it does not: every other command does.
std::string curve_refusal(const Case& input) {
  try {
    require_curve(input);
  } catch (const InputError& fault) {
    return fmt::format("`curve` refuses it: {}: {}; expected {}", fault.key(), fault.found(),
                       fault.allowed());
  }
  try {
    require_second_in_range(input);
  } catch (const InputError& fault) {
    return fmt::format("`curve` needs --from: {}: {}", fault.key(), fault.found());
  }
  return {};
}

const char* symmetry_text(const Potential& potential) {
  if (potential.has_turned_gravity()) return "isotropic but for gravity (J1 != J2)";
  if (potential.is_isotropic()) return "isotropic";
  const AnisotropicPotential& V = potential.anisotropic();
  if (V.even_in_alpha()) return "anisotropic, even in alpha: V_alpha = 0 at alpha = 0";
  if (V.shear_free()) return "anisotropic, V_alpha = 0 at alpha = 0";
  return V.sheared() ? "anisotropic, V_alpha != 0 at alpha = 0"
                     : "anisotropic, V_alpha at alpha = 0 is not known to vanish";
}

}  // namespace

std::string check_case(const Case& input) {
  constexpr std::size_t label_width = 14;
  Report out(label_width);
  out.line("case", printable(input.source.name()));
  if (!input.title.empty()) out.line("title", printable(input.title));
  for (const auto& [key, option] : input.source.overrides())
    out.line("override", fmt::format("{} by {}", key, printable(option)));
  out.gap();
  out.line("body", fmt::format("J = ({}, {}, {}){}", input.own_body.J1, input.own_body.J2,
                               input.own_body.J3, input.own_body.symmetric() ? ", J1 = J2" : ""));
  if (!input.coordinates.are_own())
    out.line("", fmt::format("computed as J = ({0}, {0}, {0}): of a fluid J is a choice of "
                             "coordinates; S is told in those of its own",
                             input.body.J1));
  for (const ModelChoice& model : input.models) {
    out.line(model.slot, fmt::format("{}: {}", model.description.name, coefficients_text(model)));
    out.line("", model.description.formula);
    for (const std::string& fact : model.facts) out.line("", fact);
  }
  out.line("potential",
           fmt::format("{}, {}", input.potential.is_separable() ? "separable" : "coupled",
                       symmetry_text(input.potential)));
  if (input.potential.of_whole_body()) {
    if (is_fluid(input.potential))
      out.line("",
               "a fluid: material rotations are a symmetry, Jacobi's ellipsoids have a zero mode");
    out.line("",
             "of a free body: the modes of alpha, xi, zeta and rho in (iii) and two-polar motions");
    out.line("", "of the Kirchhoff-Love body alone: the wobble, and every class in (i) and (ii)");
  }
  out.line("motion", motion_text(input.motion));
  out.line("solve",
           fmt::format("method {}, start: {}", name(input.solve.method), start_text(input)));
  if (const auto& continuation = input.continuation) {
    out.line("continuation",
             fmt::format("{} from {} to {}, tolerance {}", continuation->parameter,
                         continuation->from, continuation->to, continuation->tolerance));
    if (!continuation->start_row.empty())
      out.line("", "from the row " + printable(continuation->start_row) + " of a table");
  }
  if (const auto& curve = input.curve) {
    out.line("curve",
             fmt::format("{} in {} from {} to {} and {} from {} to {}, tolerance {}",
                         name(curve->event), curve->parameters[0], curve->from[0], curve->to[0],
                         curve->parameters[1], curve->from[1], curve->to[1], curve->tolerance));
    if (const std::string refused = curve_refusal(input); !refused.empty()) out.line("", refused);
  }
  if (input.atlas.complete) out.line("atlas", "complete");
  if (input.atlas.checkpoints)
    out.line("atlas", fmt::format("{} checkpoints", *input.atlas.checkpoints));
  if (input.map) {
    for (const MapAxis* axis : input.map->axes())
      out.line(axis == &input.map->x ? "map" : "", axis_text(*axis));
  }
  std::string columns;
  for (const std::string& column : input.output.columns)
    columns += (columns.empty() ? "" : ", ") + column;
  out.line("output", "columns: " + (columns.empty() ? "all that is computed" : columns));
  for (const auto& [number, uncertainty] : input.output.uncertainty)
    out.line("", fmt::format("uncertainty of {}: {}", number, uncertainty));
  out.gap();
  const ComputationPlan plan = computation_plan(input, true, PlanOf::check);
  add_plan(out, plan.computed);
  add_plan(out, plan.skipped);
  return out.text();
}

}  // namespace stationary::cli
