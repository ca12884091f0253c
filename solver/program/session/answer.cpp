#include "solver/program/session/answer.hpp"

#include <algorithm>
#include <chrono>

#include "solver/kind/kind.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/rows/metadata.hpp"
#include "solver/program/session/report.hpp"

namespace stationary::cli {
namespace {

/// What is asked of every ellipsoid found.
struct Asked {
  const Case& input;
  bool spectrum;
  const ColumnSet& columns;
};

/// As far as it is asked for.
void add_proof(const Kind& kind, const Equilibrium& found, const Asked& asked, Solution& out) {
  if (!asked.input.output.certificate) return;
  const RowProof proof = prove_row(kind, found, out.spectrum, out.row);
  out.proven = proof.proven;
  out.proof = proof.proven ? "exactly one stationary ellipsoid is within the error bound"
                           : "not proven: " + proof.reason;
  if (out.spectrum)
    out.proof += proof.class_proven ? "; its class is proven too" : "; its class is not proven";
}

/// A found ellipsoid as a row, with its spectrum and its proof as far as they are asked for.
Solution solution(const Kind& kind, const Equilibrium& found, const Asked& asked) {
  Solution out;
  out.motion = kind.motion();
  fill_row(name(kind.motion()), kind.body(), kind.potential(), found, asked.columns, out.row);
  if (asked.spectrum) out.spectrum = kind.spectrum(found);
  add_proof(kind, found, asked, out);
  tell_in(asked.input.coordinates, asked.columns, out.row);
  return out;
}

Answer one(const Kind& kind, const SolveOptions& options, const Asked& asked) {
  const Equilibrium found = kind.solve(options);
  Answer out;
  out.status = found.status;
  out.message = found.message;
  // Of an anisotropic body only a search says so.
  out.only_in_box = found.status == SolveStatus::none_exists && !kind.potential().is_isotropic();
  out.connection = found.connection;
  out.counts = named_counts(found.counts);
  if (!out.solved()) return out;
  const Solution& only = out.solutions.emplace_back(solution(kind, found, asked));
  if (asked.input.output.certificate && !only.proven) out.warning = only.proof;
  return out;
}

/// Every solution, by exhaustive search.
Answer all(const Kind& kind, const SolveOptions& options, const Asked& asked) {
  const SearchResult found = kind.search({.box = asked.input.solve.box, .stop = options.stop});
  Answer out;
  out.message = found.message;
  out.counts = {{"boxes", found.boxes},
                {"proven", static_cast<long>(found.solutions.size())},
                {"undecided", static_cast<long>(found.undecided.size())},
                {"found_unproven", static_cast<long>(found.unproven.size())}};
  if (found.status == SearchStatus::interrupted) {
    out.status = SolveStatus::interrupted;
    return out;
  }
  for (const auto& [list, listed] : {std::pair{&found.solutions, Listed::proven},
                                     std::pair{&found.unproven, Listed::unproven}}) {
    for (const Equilibrium& each : *list) {
      out.solutions.push_back(solution(kind, each, asked));
      out.solutions.back().listed = listed;
    }
  }
  const bool complete = found.status == SearchStatus::complete;
  if (!out.solutions.empty()) {
    out.status = SolveStatus::solved;
    if (!complete) out.warning = found.message;
  } else if (complete) {
    out.status = SolveStatus::none_exists;
    const auto reason = kind.nonexistence();
    out.only_in_box = !reason;
    if (reason) out.message += "; with other stretches neither: " + *reason;
  } else {
    out.status = found.on_line ? SolveStatus::not_isolated : SolveStatus::failed;
  }
  return out;
}

/// One or all, as the case asks.
Answer answer(const Kind& kind, const SolveOptions& options, const Asked& asked) {
  return asked.input.solve.all ? all(kind, options, asked) : one(kind, options, asked);
}

void append(std::string& text, const std::string& more, std::string_view between = "; ") {
  if (!text.empty() && !more.empty()) text += between;
  text += more;
}

/// The answers of all alternatives as one: solved where either is, none where neither has any.
Answer joined(std::vector<std::pair<std::string, Answer>> parts) {
  // What outweighs what in the status of the whole.
  constexpr SolveStatus order[] = {SolveStatus::interrupted, SolveStatus::solved,
                                   SolveStatus::failed, SolveStatus::not_found,
                                   SolveStatus::none_exists};
  Answer out;
  for (const SolveStatus status : order) {
    const bool has =
        std::ranges::any_of(parts, [&](const auto& part) { return part.second.status == status; });
    if (has && out.status == SolveStatus::not_run) out.status = status;
  }
  out.only_in_box = out.status == SolveStatus::none_exists;
  for (auto& [label, part] : parts) {
    append(out.message, label + ": " + part.message);
    if (!part.warning.empty()) append(out.warning, label + ": " + part.warning);
    if (out.solved() && part.status == SolveStatus::failed)
      append(out.warning, label + ": " + part.message);
    if (out.connection == Connection::unknown) out.connection = part.connection;
    for (const auto& [what, count] : part.counts) {
      const auto at =
          std::ranges::find(out.counts, what, &std::pair<std::string_view, long>::first);
      if (at == out.counts.end()) {
        out.counts.emplace_back(what, count);
      } else {
        at->second += count;
      }
    }
    for (Solution& each : part.solutions) out.solutions.push_back(std::move(each));
  }
  return out;
}

/// Of each alternative, and where none comes to anything of whatever there is.
Answer answer(const Alternatives& kinds, const SolveOptions& options, const Asked& asked) {
  if (kinds.each.size() == 1) return answer(*kinds.each.front().kind, options, asked);
  const SolveOptions how = for_each_of(kinds, options);
  std::vector<std::pair<std::string, Answer>> parts;
  for (const auto& [label, kind] : kinds.each) parts.emplace_back(label, answer(*kind, how, asked));
  Answer out = joined(std::move(parts));
  return kinds.any && out.status == SolveStatus::not_found ? answer(*kinds.any, options, asked)
                                                           : out;
}

}  // namespace

Answer answer_of(const Case& input, const Run& run, bool with_spectrum, const ColumnSet& wanted) {
  const SolveOptions options{.method = input.solve.method,
                             .start = input.solve.start,
                             .threads = run.threads,
                             .stop = run.stop};
  const auto begin = std::chrono::steady_clock::now();
  const Alternatives kinds = alternatives(input.body, input.potential, input.motion,
                                          input.solve.all || input.solve.start.has_value());
  Answer out = answer(kinds, options, {input, with_spectrum, wanted});
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  long spectra = 0;
  int sheet = 0;
  for (Solution& each : out.solutions) {
    each.row[Column::sheet] = ++sheet;
    each.row[Column::point] = 0;
    if (!each.spectrum) continue;
    fill_spectrum(*each.spectrum, each.row);
    ++spectra;
  }
  out.counts.emplace_back("spectra", spectra);
  return out;
}

}  // namespace stationary::cli
