#include "solver/program/session/answer.hpp"

#include <algorithm>
#include <chrono>
#include <variant>

#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/rows/metadata.hpp"
#include "solver/program/session/interrupt.hpp"
#include "solver/program/session/report.hpp"
#include "solver/search/anisotropic_search.hpp"
#include "solver/search/search.hpp"
#include "solver/search/tilted_search.hpp"
#include "solver/search/two_polar_search.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "solver/solve/nonexistence.hpp"
#include "solver/solve/stability.hpp"
#include "solver/solve/tilted_equilibrium.hpp"

namespace stationary::cli {
namespace {

/// prove() -> RowProof, if the case asks for one.
template <class Prove>
void add_proof(const Case& input, const Prove& prove, Solution& out) {
  if (!input.output.certificate) return;
  const RowProof proof = prove();
  out.proven = proof.proven;
  out.proof = proof.proven ? "exactly one stationary ellipsoid is within the error bound"
                           : "not proven: " + proof.reason;
  if (out.spectrum)
    out.proof += proof.class_proven ? "; its class is proven too" : "; its class is not proven";
}

/// The families, each as: solve one, search all, and a found one as a row with its proof.
struct AxisAnswers {
  const Case& input;
  const AxisRotation& motion;
  bool with_spectrum;
  const ColumnSet& wanted;
  Problem problem = input.problem();

  Equilibrium one(const SolveOptions& options) const { return solve(problem, motion.nu, options); }
  SearchResult all(const SearchOptions& options) const {
    return search(problem, motion.nu, options);
  }
  /// Why there is none outside the box either.
  std::optional<std::string> none_anywhere() const {
    return nonexistence_reason(problem, motion.nu);
  }
  Solution solution(const Equilibrium& found) const {
    Solution out;
    fill_row(name(problem.branch()), input.body, input.potential, found, wanted, out.row);
    if (with_spectrum) out.spectrum = stability(problem, found);
    add_proof(
        input, [&] { return prove_row(problem, found, out.spectrum, out.row); }, out);
    return out;
  }
};

struct TiltedAnswers {
  const Case& input;
  TiltedRotation motion;
  bool with_spectrum;
  const ColumnSet& wanted;

  Equilibrium one(const SolveOptions& options) const {
    return solve_tilted(input.body, input.potential, motion, options);
  }
  SearchResult all(const SearchOptions& options) const {
    return search_tilted(input.body, input.potential, motion, options);
  }
  std::optional<std::string> none_anywhere() const { return std::nullopt; }
  Solution solution(const Equilibrium& found) const {
    Solution out;
    fill_row(tilted_name, input.body, input.potential, found, wanted, out.row);
    if (with_spectrum) out.spectrum = tilted_stability(input.body, input.potential, motion, found);
    add_proof(
        input,
        [&] {
          return prove_row(input.body, input.potential, motion, found, out.spectrum, out.row);
        },
        out);
    return out;
  }
};

struct ObliqueAnswers {
  const Case& input;
  ObliqueRotation motion;
  bool with_spectrum;
  const ColumnSet& wanted;

  Equilibrium one(const SolveOptions& options) const {
    return solve_oblique(input.body, input.potential, motion, options);
  }
  SearchResult all(const SearchOptions& options) const {
    return search_oblique(input.body, input.potential, motion, options);
  }
  std::optional<std::string> none_anywhere() const { return std::nullopt; }
  Solution solution(const Equilibrium& found) const {
    Solution out;
    fill_row(oblique_name, input.body, input.potential, found, wanted, out.row);
    if (with_spectrum) out.spectrum = oblique_stability(input.body, input.potential, found);
    add_proof(
        input,
        [&] {
          return prove_row(input.body, input.potential, motion, found, out.spectrum, out.row);
        },
        out);
    return out;
  }
};

struct TwoPolarAnswers {
  const Case& input;
  const TwoPolarMotion& motion;
  bool with_spectrum;
  const ColumnSet& wanted;

  TwoPolarEquilibrium one(const SolveOptions& options) const {
    return solve_two_polar(input.body, input.potential, motion, options);
  }
  TwoPolarSearchResult all(const SearchOptions& options) const {
    return search_two_polar(input.body, input.potential, motion, options);
  }
  std::optional<std::string> none_anywhere() const { return std::nullopt; }
  Solution solution(const TwoPolarEquilibrium& found) const {
    Solution out;
    fill_row(input.body, input.potential, found, wanted, out.row);
    if (with_spectrum) out.spectrum = stability(input.body, input.potential, found);
    add_proof(
        input,
        [&] {
          return prove_row(input.body, input.potential, motion, found, out.spectrum, out.row);
        },
        out);
    return out;
  }
};

Connection connection_of(const Equilibrium& found, const SolveOptions&) { return found.connection; }
Connection connection_of(const TwoPolarEquilibrium& found, const SolveOptions& options) {
  return options.start && !found.circle ? Connection::given_start : Connection::unknown;
}

template <class Family>
Answer one(const Case& input, const Family& family, const SolveOptions& options) {
  const auto found = family.one(options);
  Answer out;
  out.status = found.status;
  out.message = found.message;
  // Of an anisotropic body only a search says so.
  out.only_in_box = found.status == SolveStatus::none_exists && !input.potential.is_isotropic();
  out.connection = connection_of(found, options);
  out.counts = named_counts(found.counts);
  if (!out.solved()) return out;
  const Solution& only = out.solutions.emplace_back(family.solution(found));
  if (input.output.certificate && !only.proven) out.warning = only.proof;
  return out;
}

bool on_line(const SearchResult&) { return false; }
bool on_line(const TwoPolarSearchResult& found) { return found.on_line; }

/// Every solution, by exhaustive search.
template <class Family>
Answer all(const Family& family, const SolveOptions& options) {
  const auto found = family.all({.stop = options.stop});
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
  for (const auto& each : found.solutions) {
    out.solutions.push_back(family.solution(each));
    out.solutions.back().listed = Listed::proven;
  }
  for (const auto& each : found.unproven) {
    out.solutions.push_back(family.solution(each));
    out.solutions.back().listed = Listed::unproven;
  }
  const bool complete = found.status == SearchStatus::complete;
  if (!out.solutions.empty()) {
    out.status = SolveStatus::solved;
    if (!complete) out.warning = found.message;
  } else if (complete) {
    out.status = SolveStatus::none_exists;
    const auto reason = family.none_anywhere();
    out.only_in_box = !reason;
    if (reason) out.message += "; with other stretches neither: " + *reason;
  } else {
    out.status = on_line(found) ? SolveStatus::not_isolated : SolveStatus::failed;
  }
  return out;
}

/// One or all, as the case asks.
template <class Family>
Answer answer(const Case& input, const Family& family, const SolveOptions& options) {
  return input.solve.all ? all(family, options) : one(input, family, options);
}

Answer answer(const Case& input, const AxisRotation& motion, const SolveOptions& options,
              bool with_spectrum, const ColumnSet& wanted) {
  return answer(input, AxisAnswers{input, motion, with_spectrum, wanted}, options);
}

Answer answer(const Case& input, const TwoPolarMotion& motion, const SolveOptions& options,
              bool with_spectrum, const ColumnSet& wanted) {
  return answer(input, TwoPolarAnswers{input, motion, with_spectrum, wanted}, options);
}

void append(std::string& text, const std::string& more, std::string_view between = "; ") {
  if (!text.empty() && !more.empty()) text += between;
  text += more;
}

/// The answers of both planes, or axes, as one: solved where either is, none where neither has any.
Answer joined(std::vector<std::pair<std::string, Answer>> parts, const std::string& what) {
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
  for (auto& [plane, part] : parts) {
    append(out.message, plane + what + ": " + part.message);
    if (!part.warning.empty()) append(out.warning, plane + what + ": " + part.warning);
    if (out.solved() && part.status == SolveStatus::failed)
      append(out.warning, plane + what + ": " + part.message);
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

Answer answer(const Case& input, const TiltedMotion& motion, const SolveOptions& options,
              bool with_spectrum, const ColumnSet& wanted) {
  std::vector<std::pair<std::string, Answer>> parts;
  for (const TiltedRotation& rotation : motion.rotations()) {
    const TiltedAnswers family{input, rotation, with_spectrum, wanted};
    parts.emplace_back(plane_text(rotation.plane), answer(input, family, options));
  }
  return parts.size() == 1 ? std::move(parts[0].second) : joined(std::move(parts), " plane");
}

/// Without axis and start the families of both axes, and where neither comes to anything whatever
/// there is.
Answer answer(const Case& input, const ObliqueRotation& motion, const SolveOptions& options,
              bool with_spectrum, const ColumnSet& wanted) {
  const ObliqueAnswers any{input, motion, with_spectrum, wanted};
  if (input.solve.all || motion.near || options.start) return answer(input, any, options);
  SolveOptions followed = options;
  followed.search = false;
  std::vector<std::pair<std::string, Answer>> parts;
  for (const Branch near : {Branch::i, Branch::ii}) {
    const ObliqueAnswers family{input, {motion.nu, near}, with_spectrum, wanted};
    parts.emplace_back(near == Branch::i ? "axis 1" : "axis 2", answer(input, family, followed));
  }
  Answer out = joined(std::move(parts), "");
  return out.status == SolveStatus::not_found ? answer(input, any, options) : out;
}

}  // namespace

Answer answer_of(const Case& input, int threads, bool with_spectrum, const ColumnSet& wanted) {
  const SolveOptions options{.method = input.solve.method,
                             .start = input.solve.start,
                             .threads = threads,
                             .stop = &stop_on_signals()};
  const auto begin = std::chrono::steady_clock::now();
  Answer out = std::visit(
      [&](const auto& motion) { return answer(input, motion, options, with_spectrum, wanted); },
      input.motion);
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
