#include "solver/program/session/computation_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "solver/kind/kind.hpp"
#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/table/table.hpp"

namespace stationary::cli {
namespace {

bool names_spectral_column(const std::vector<std::string>& names) {
  return std::ranges::any_of(names, [](const std::string& name) {
    const auto column = find_column(name);
    return column && needs_spectrum(*column);
  });
}

std::string box_text(const Case& input) {
  const SearchOptions where{.box = input.solve.box};
  const std::array ranges{where.range(0), where.range(1), where.range(2)};
  const auto text = [](const Interval& each) {
    return fmt::format("[{:g}, {:g}]", each.lo, each.hi);
  };
  if (text(ranges[0]) == text(ranges[1]) && text(ranges[0]) == text(ranges[2]))
    return "every stretch in " + text(ranges[0]);
  const bool two_polar = has_rates(input.motion);
  return fmt::format("{} in {}, {} in {}, rho in {}", two_polar ? "lambda" : "xi", text(ranges[0]),
                     two_polar ? "mu" : "zeta", text(ranges[1]), text(ranges[2]));
}

}  // namespace

bool wants_spectrum(const Case& input, bool to_table) {
  if (!input.output.spectrum) return false;
  const std::vector<std::string>& columns = input.output.columns;
  if (!to_table || columns.empty() || names_spectral_column(columns)) return true;
  return input.continuation && !input.continuation->events.empty() &&
         std::ranges::any_of(spectral_events, [&](EventType each) {
           return input.continuation->event_set().has(each);
         });
}

bool wants_column(const Case& input, Column column, bool to_table) {
  const std::vector<std::string>& columns = input.output.columns;
  return to_table && (columns.empty() || std::ranges::find(columns, name(column)) != columns.end());
}

std::optional<PlanItem> proof_caveat(const Case& input) {
  const std::vector<std::string> assumed = input.potential.assumptions();
  if (assumed.empty()) return std::nullopt;
  return PlanItem{"proofs", "take for granted: " + fmt::format("{}", fmt::join(assumed, "; ")),
                  "found at points, which is no proof (`check`)"};
}

ComputationPlan computation_plan(const Case& input, bool to_table) {
  ComputationPlan out;
  const auto kinds = alternatives(input.body, input.potential, input.motion, true);
  const Kind& kind = *kinds.each.front().kind;
  out.computed = kind.unknowns();
  for (std::size_t k = 1; k < kinds.each.size(); ++k) {
    // What differs between the alternatives is said of each.
    const std::vector<PlanItem> other = kinds.each[k].kind->unknowns();
    for (std::size_t i = 0; i < other.size(); ++i)
      if (other[i].how != out.computed[i].how)
        out.computed[i].how += " in the " + kinds.each[0].label + ", " + other[i].how + " in the " +
                               kinds.each[k].label;
  }
  if (const auto caveat = proof_caveat(input)) out.computed.push_back(*caveat);
  if (input.solve.all) {
    out.computed.push_back({"all solutions", "exhaustive search, to be proven complete",
                            box_text(input) + ": boxes in interval arithmetic"});
    if (input.solve.start || input.solve.method != Method::automatic) {
      out.skipped.push_back({"start, method", "not used", "solve.all = true searches everywhere"});
    }
  } else if (input.solve.box) {
    out.skipped.push_back(
        {"solve.box", "not used", "it is the box of solve.all = true, and of an atlas"});
  }
  if (input.output.certificate) {
    out.computed.push_back({"certificate",
                            "existence, uniqueness, error bound and class, to be proven",
                            "interval arithmetic, for all decimals that read as the inputs"});
  }
  if (input.continuation) {
    const auto [first, second] = parts_of(input.continuation->parameter);
    if (!second.empty())
      out.computed.push_back(
          {"ratio",
           fmt::format("{} varies, {} = {} is held", first, second,
                       parameter_value({input.body, input.models, input.motion}, second)),
           "a ratio; error bounds and proofs are of the varied number, which is the ratio in the "
           "table "
           "times the held one within rounding"});
  }
  if (input.continuation && !input.continuation->events.empty()) {
    out.computed.push_back({"events",
                            fmt::format("{}", fmt::join(input.continuation->events, ", ")),
                            "continuation.events: of no others is a function evaluated"});
  }
  if (wants_spectrum(input, to_table)) {
    out.computed.push_back(kind.spectrum_plan());
  } else if (!input.output.spectrum) {
    out.skipped.push_back({"spectrum", "skipped", "output.spectrum = false"});
  } else {
    out.skipped.push_back({"spectrum", "skipped",
                           "output.columns names none of its columns (without -o it is computed)"});
  }
  return out;
}

}  // namespace stationary::cli
