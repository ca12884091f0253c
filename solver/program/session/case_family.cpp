#include "solver/program/session/case_family.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/family/two_polar_family.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/session/computation_plan.hpp"
#include "solver/program/session/family_choice.hpp"
#include "solver/program/session/interrupt.hpp"

namespace stationary::cli {
namespace {

/// nu = 0 where the range has it and no start is given (the family through the rest state), else
/// the case's own value if it lies in the range, else the range's beginning. A tilted family has no
/// rest state: the case's own value.
/// Whether the case's family about axis 1 or 2 is at rest alone: alpha = 0, which compatibility
/// asks for there, leaves a force V_alpha.
bool only_at_rest(const Case& input) {
  const auto* rotation = std::get_if<AxisRotation>(&input.motion);
  return rotation != nullptr && rotation->branch != Branch::iii &&
         !input.potential.is_isotropic() && !input.potential.anisotropic().shear_free();
}

double start_parameter(const Case& input) {
  const Case::Continuation& range = *input.continuation;
  const bool in_nu = range.parameter == "nu";
  const bool from_rest = !input.tilted() && !input.oblique() && !only_at_rest(input);
  if (in_nu && from_rest && !input.solve.start && range.from <= 0.0 && range.to >= 0.0) return 0.0;
  const double own = parameter_value({input.body, input.models, input.motion}, range.parameter);
  if (own >= range.from && own <= range.to) return own;
  if (!input.solve.start && from_rest) return range.from;
  throw fault_at(
      input.source, in_nu ? "motion.nu" : range.parameter,
      fmt::format("found {} = {}, outside the range followed, with {}", range.parameter, own,
                  input.solve.start ? std::string("solve.start")
                                    : "branch " + in_quotes(input.branch_name())),
      fmt::format("a value in [{}, {}]", range.from, range.to),
      input.solve.start ? "solve.start is a guess of the solution there"
                        : "the family is followed from its member there");
}

FamilyParameters at_parameter(const Case& input, double p) {
  return with_parameter({input.body, input.models, input.motion}, input.continuation->parameter, p);
}

Start start_at(const Case& input, double p) { return {at_parameter(input, p), p, {}}; }

Problem problem_of(const FamilyParameters& at) {
  return {at.body, make_potential(at.models), std::get<AxisRotation>(at.motion).branch};
}

}  // namespace

Start solved_start(const Case& input, const ComputeOptions& options) {
  Start out = start_at(input, start_parameter(input));
  const SolveOptions how{.method = input.solve.method,
                         .start = input.solve.start,
                         .threads = options.threads,
                         .stop = &stop_on_signals()};
  if (auto* tilted = std::get_if<TiltedMotion>(&out.at.motion)) {
    out.found = tilted_start(input, make_potential(out.at.models), *tilted, how);
  } else if (auto* oblique = std::get_if<ObliqueRotation>(&out.at.motion)) {
    out.found = oblique_start(input, out.at.body, make_potential(out.at.models), *oblique, how);
  } else if (const auto* two_polar = std::get_if<TwoPolarMotion>(&out.at.motion)) {
    const TwoPolarEquilibrium found =
        solve_two_polar(out.at.body, make_potential(out.at.models), *two_polar, how);
    out.found.status = found.status;
    out.found.message = found.message;
    out.found.counts = found.counts;
    out.found.q = {0.0, found.x[0], found.x[1], found.x[2]};
  } else {
    const AxisRotation motion = std::get<AxisRotation>(out.at.motion);
    out.found = solve(problem_of(out.at), motion.nu, how);
    if (out.found.status == SolveStatus::solved && only_at_rest(input)) {
      out.found.status = SolveStatus::none_exists;
      out.found.message =
          "at rest alone there is an ellipsoid: about this axis compatibility asks for alpha = 0, "
          "which leaves a force V_alpha";
    }
    if (out.found.status == SolveStatus::not_isolated && how.start) {
      out.found.status = SolveStatus::solved;
      out.found.message = "the given start, on a vertical branch";
      out.found.connection = Connection::given_start;
      out.found.q = *how.start;
    }
  }
  return out;
}

Start resumed_start(const Case& input, const ResumedTable& old) {
  const CurvePlace at = old.first ? old.first->at : old.last->at;
  Start out = start_at(input, at.p);
  out.found.status = SolveStatus::solved;
  out.found.message = "resumed from the table";
  out.found.connection = Connection::given_start;
  out.found.q = at.q;
  if (auto* tilted = std::get_if<TiltedMotion>(&out.at.motion); tilted && !tilted->plane) {
    const bool second =
        std::ranges::any_of(old.rows, [](const TableRow& row) { return row[Column::nu2] != 0.0; });
    tilted->plane = second ? TiltPlane::two_three : TiltPlane::one_three;
  }
  return out;
}

AnyFamily family_of(const Case& input, const Start& start, bool with_spectrum, bool to_table) {
  if (const auto* tilted = std::get_if<TiltedMotion>(&start.at.motion)) {
    return tilted_family(start.at.body, make_potential(start.at.models), *tilted->plane,
                         with_spectrum);
  }
  if (const auto* two_polar = std::get_if<TwoPolarMotion>(&start.at.motion)) {
    return two_polar_family(
        start.at.body, make_potential(start.at.models),
        {.motion = *two_polar,
         .parameter = family_parameter(input.continuation->parameter, input.models),
         .spectrum = with_spectrum});
  }
  if (const auto* oblique = std::get_if<ObliqueRotation>(&start.at.motion)) {
    return oblique_family(
        start.at.body, make_potential(start.at.models).anisotropic(),
        {.nu = oblique->nu,
         .parameter = family_parameter(input.continuation->parameter, input.models),
         .spectrum = with_spectrum},
        oblique->near.value_or(Branch::i));
  }
  const AxisRotation motion = std::get<AxisRotation>(start.at.motion);
  const bool alpha_free = start.found.q.alpha != 0.0;
  return axis_family(problem_of(start.at),
                     {.nu = motion.nu,
                      .parameter = family_parameter(input.continuation->parameter, input.models),
                      .spectrum = with_spectrum,
                      .errors = wants_column(input, Column::residual, to_table) ||
                                wants_column(input, Column::compatibility, to_table),
                      .energy = wants_column(input, Column::energy, to_table)},
                     alpha_free);
}

void prove_rows(const Case& input, const Start& start, CurveTable& rows) {
  if (const auto* tilted = std::get_if<TiltedMotion>(&start.at.motion)) {
    const TiltPlane plane = *tilted->plane;
    rows.prove([&input, plane](const Member& member, const Equilibrium& found, TableRow& row) {
      return prove_row(input.body, input.potential, TiltedRotation{plane, member.parameter}, found,
                       member.spectrum, row);
    });
    return;
  }
  if (input.oblique()) {
    rows.prove([&input](const Member& member, const Equilibrium& found, TableRow& row) {
      const FamilyParameters at = at_parameter(input, member.parameter);
      return prove_row(at.body, make_potential(at.models), ObliqueRotation{member.nu}, found,
                       member.spectrum, row);
    });
    return;
  }
  if (!input.potential.is_isotropic()) {  // its events have no enclosures
    rows.prove([&input](const Member& member, const Equilibrium& found, TableRow& row) {
      return prove_row(problem_of(at_parameter(input, member.parameter)), found, member.spectrum,
                       row);
    });
    return;
  }
  if (input.two_polar()) {
    rows.prove([&input](const Member& member, const Equilibrium&, TableRow& row) {
      const FamilyParameters at = at_parameter(input, member.parameter);
      TwoPolarEquilibrium found;
      found.x = {member.q.xi, member.q.zeta, member.q.rho};
      found.circle = member.q.xi == member.q.zeta;
      found.rates = member.two_polar->rates;
      found.momenta = member.two_polar->momenta;
      return prove_row(at.body, make_potential(at.models), std::get<TwoPolarMotion>(at.motion),
                       found, member.spectrum, row);
    });
    return;
  }
  rows.prove([&input](double p) { return problem_of(at_parameter(input, p)); },
             family_parameter(input.continuation->parameter, input.models));
}

}  // namespace stationary::cli
