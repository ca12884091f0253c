#include "solver/program/session/case_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/session/computation_plan.hpp"

namespace stationary::cli {
namespace {

/// nu = 0 where the range has it and no start is given (the family through the rest state), else
/// the case's own value if it lies in the range, else the range's beginning. Of a family that is not
/// followed from rest: the case's own value.
double start_parameter(const Case& input) {
  const Case::Continuation& range = *input.continuation;
  const bool in_nu = range.parameter == "nu";
  const bool from_rest = kind_of(own_numbers(input))->from_rest();
  if (in_nu && from_rest && !input.solve.start && range.from <= 0.0 && range.to >= 0.0) return 0.0;
  const double own = parameter_value(own_numbers(input), range.parameter);
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
  return with_parameter(own_numbers(input), input.continuation->parameter, p);
}

FamilyParameter family_parameter_of(const Case& input) {
  return family_parameter(input.continuation->parameter, input.models);
}

/// Where there are families of the kind, of other numbers. reason: Kind::no_family().
void require_followable(const Case& input, const Kind& kind, const std::string& reason) {
  if (!kind.from_rest()) return;
  throw fault_at(input.source, "continuation.parameter",
                 "found " + in_quotes(input.continuation->parameter),
                 "another number for branch " + in_quotes(input.branch_name()), reason);
}

Start start_at(const Case& input, double p) { return {at_parameter(input, p), p, {}}; }

/// The motion of the only alternative that has one, which is left in `motion`. Throws InputError
/// where two have one and the case does not choose.
Equilibrium only_one(const Case& input, const Alternatives& kinds, const SolveOptions& options,
                     Motion& motion) {
  auto [only, several] = only_found(kinds, options);
  if (several) {
    throw fault_at(input.source, std::string(kinds.key), "found no such key, and " + kinds.both,
                   std::string(kinds.values) + " for continue",
                   "a table follows one of the two families");
  }
  if (only.equilibrium.status == SolveStatus::solved && only.kind != kinds.any.get())
    motion = only.kind->motion();
  return std::move(only.equilibrium);
}

}  // namespace

void require_range(const Case& input) {
  if (input.continuation) return;
  throw fault_at(input.source, "continuation", "found no such key", "a table with from and to",
                 "add [continuation]");
}

FollowOptions follow_options(const Case& input, double unit, const Run& run) {
  const Case::Continuation& asked = *input.continuation;
  FollowOptions out;
  out.continuation.from = asked.from * unit;
  out.continuation.to = asked.to * unit;
  out.continuation.unit = input.unit_stretch();
  out.continuation.step.tolerance = asked.tolerance;
  out.continuation.step.first = asked.step;
  out.events = asked.event_set();
  out.max_points = static_cast<long>(asked.max_points);
  out.stop = run.stop;
  if (!run.progress) return out;
  // Both ways from the start, and back at folds: done is what lies between the outermost points.
  out.progress = [&run, &asked, unit, low = std::numeric_limits<double>::infinity(),
                  high = -std::numeric_limits<double>::infinity()](double in_family,
                                                                   long points) mutable {
    const double p = in_family / unit;
    low = std::min(low, p);
    high = std::max(high, p);
    run.progress((high - low) / std::abs(asked.to - asked.from),
                 fmt::format("{} = {:<12.6g} {} points", asked.parameter, p, points));
  };
  return out;
}

Start solved_start(const Case& input, const Run& run) {
  Start out = start_at(input, start_parameter(input));
  const SolveOptions how{.method = input.solve.method,
                         .start = input.solve.start,
                         .threads = run.threads,
                         .stop = run.stop};
  const Alternatives kinds = alternatives(out.at.body, make_potential(out.at.models, out.at.body),
                                          out.at.motion, how.start.has_value());
  out.found = only_one(input, kinds, how, out.at.motion);
  const Kind& kind = *kinds.each.front().kind;
  out.only_in_box =
      out.found.status == SolveStatus::none_exists && !kind.potential().is_isotropic();
  if (out.found.status == SolveStatus::solved) {
    if (const auto reason = kind.no_family(family_parameter_of(input), out.found.q)) {
      require_followable(input, kind, *reason);
      out.found.status = SolveStatus::none_exists;
      out.found.message = *reason;
    }
  }
  if (out.found.status == SolveStatus::not_isolated && how.start && kind.follows_continuum()) {
    out.found.status = SolveStatus::solved;
    out.found.message = "the given start, on a vertical branch";
    out.found.connection = Connection::given_start;
    out.found.q = *how.start;
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
  out.at.motion = decided(out.at.motion, std::ranges::any_of(old.rows, [](const TableRow& row) {
                            return row[Column::nu2] != 0.0;
                          }));
  return out;
}

AnyFamily family_of(const Case& input, const Start& start, bool with_spectrum, bool to_table) {
  return kind_of(start.at)->family(family_parameter_of(input),
                                   {.spectrum = with_spectrum,
                                    .errors = wants_column(input, Column::residual, to_table) ||
                                              wants_column(input, Column::compatibility, to_table),
                                    .energy = wants_column(input, Column::energy, to_table)},
                                   start.found.q);
}

void ask_kinds(const Case& input, const Start& start, CurveTable& rows) {
  const std::string key(parts_of(input.continuation->parameter).first);
  const auto kind_at = [at = start.at, key](double p) {
    return kind_of(with_parameter(at, key, p));
  };
  const FamilyParameter parameter = family_parameter_of(input);
  rows.tell_normal_forms(kind_at, parameter);
  if (input.output.certificate) rows.prove(kind_at, parameter);
}

}  // namespace stationary::cli
