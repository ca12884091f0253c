#include "solver/program/session/computation_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

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
  const SearchOptions where{.box = input.own_solve.box};
  std::array<Interval, 3> ranges;
  for (std::size_t k = 0; k < ranges.size(); ++k)
    ranges[k] = where.box ? where.range(k) : input.coordinates.unit[k] * where.range(k);
  const auto text = [](const Interval& each) {
    return fmt::format("[{:g}, {:g}]", each.lo, each.hi);
  };
  if (text(ranges[0]) == text(ranges[1]) && text(ranges[0]) == text(ranges[2]))
    return "every stretch in " + text(ranges[0]);
  const bool two_polar = has_rates(input.motion);
  return fmt::format("{} in {}, {} in {}, rho in {}", two_polar ? "lambda" : "xi", text(ranges[0]),
                     two_polar ? "mu" : "zeta", text(ranges[1]), text(ranges[2]));
}

/// How the unknowns of each alternative are had.
std::vector<PlanItem> unknowns_plan(const Alternatives& kinds) {
  std::vector<PlanItem> out = kinds.each.front().kind->unknowns();
  for (std::size_t k = 1; k < kinds.each.size(); ++k) {
    // What differs between the alternatives is said of each.
    const std::vector<PlanItem> other = kinds.each[k].kind->unknowns();
    for (std::size_t i = 0; i < other.size(); ++i)
      if (other[i].how != out[i].how)
        out[i].how += " in the " + kinds.each[0].label + ", " + other[i].how + " in the " +
                      kinds.each[k].label;
  }
  return out;
}

/// Of the keys of [solve] and [continuation] those that are set and not used, and why.
std::vector<PlanItem> unused_keys(const Case& input, PlanOf of) {
  std::vector<PlanItem> out;
  const auto unused = [&](bool set, std::string_view key, std::string_view why) {
    if (set) out.push_back({std::string(key), "not used", std::string(why)});
  };
  const auto start_and_method = [&](std::string_view why) {
    unused(input.solve.start.has_value(), "solve.start", why);
    unused(input.solve.method != Method::automatic, "solve.method", why);
  };
  if (of == PlanOf::map)
    start_and_method("every cell is solved on the sheet of its own rest state");
  if (of == PlanOf::atlas) start_and_method("an atlas searches everywhere");
  if (input.solve.all && of == PlanOf::solve) start_and_method(unused_start);
  if (input.solve.all && of == PlanOf::check)
    start_and_method(input.continuation ? "solve.all = true searches everywhere; `continue` uses it"
                                        : "solve.all = true searches everywhere");
  if (of == PlanOf::map)
    unused(input.solve.all, "solve.all",
           "a cell is one motion, on the sheet of its own rest state");
  if (of == PlanOf::follow)
    unused(input.solve.all, "solve.all",
           "one sheet is followed, from one motion; `atlas` follows every sheet");
  if (of == PlanOf::curve)
    unused(input.solve.all, "solve.all", "a curve is followed from events of a family");
  const bool searches =
      of == PlanOf::atlas || (input.solve.all && (of == PlanOf::solve || of == PlanOf::check));
  unused(input.solve.box.has_value() && !searches, "solve.box",
         "it is the box of solve.all = true, and of an atlas");
  if (of == PlanOf::atlas)
    unused(!input.continuation->start_row.empty(), "continuation.start_row",
           "an atlas searches everywhere");
  if (of == PlanOf::atlas)
    unused(!input.continuation->events.empty(), "continuation.events",
           "an atlas locates every event that it can");
  return out;
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

ComputationPlan computation_plan(const Case& input, bool to_table, PlanOf of) {
  const bool follows = of == PlanOf::check || of == PlanOf::follow;
  ComputationPlan out{{}, unused_keys(input, of)};
  PlanItem spectrum;
  if (of == PlanOf::atlas) {
    out.computed.push_back({"sheets", "searched at checkpoints, then followed over nu",
                            box_text(input) + ": boxes in interval arithmetic"});
    spectrum = {"spectrum", "of every row of every sheet", "as each kind of motion has it"};
  } else {
    const auto kinds = alternatives(input.body, input.potential, input.motion, true);
    out.computed = unknowns_plan(kinds);
    spectrum = kinds.each.front().kind->spectrum_plan();
  }
  if (const auto caveat = proof_caveat(input)) out.computed.push_back(*caveat);
  if (input.solve.all && (of == PlanOf::solve || of == PlanOf::check))
    out.computed.push_back({"all solutions", "exhaustive search, to be proven complete",
                            box_text(input) + ": boxes in interval arithmetic"});
  if (input.output.certificate) {
    out.computed.push_back({"certificate",
                            of == PlanOf::curve
                                ? "each event, and no other near it, to be proven"
                                : "existence, uniqueness, error bound and class, to be proven",
                            "interval arithmetic, for all real numbers that round to the inputs"});
  }
  if (input.continuation && follows) {
    const auto [first, second] = parts_of(input.continuation->parameter);
    if (!second.empty())
      out.computed.push_back(
          {"ratio",
           fmt::format("{} varies, {} = {} is held", first, second,
                       parameter_value(own_numbers(input), second)),
           "a ratio; error bounds and proofs are of the varied number, which is the ratio in the "
           "table times the held one within rounding"});
  }
  if (input.continuation && follows && !input.continuation->events.empty()) {
    out.computed.push_back({"events",
                            fmt::format("{}", fmt::join(input.continuation->events, ", ")),
                            "continuation.events: of no others is a function evaluated"});
  }
  if (!input.output.spectrum) {
    out.skipped.push_back({"spectrum", "skipped", "output.spectrum = false"});
  } else if (!wants_spectrum(input, to_table)) {
    out.skipped.push_back({"spectrum", "skipped",
                           "output.columns names none of its columns (without -o it is computed)"});
  } else {
    out.computed.push_back(std::move(spectrum));
  }
  return out;
}

}  // namespace stationary::cli
