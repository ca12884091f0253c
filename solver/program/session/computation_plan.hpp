// What will be computed of a case and how, what will not be and why: for `check`, for the summary
// and for the metadata.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/table/table.hpp"

namespace stationary::cli {

struct ComputationPlan {
  std::vector<PlanItem> computed;
  std::vector<PlanItem> skipped;
};

/// Whether the spectrum is asked for: not with output.spectrum = false, nor for a table whose
/// output.columns have none of it.
bool wants_spectrum(const Case& input, bool to_table);
/// Likewise whether a column is written.
bool wants_column(const Case& input, Column column, bool to_table);

/// What proofs about the case rest on beside interval arithmetic, if anything.
std::optional<PlanItem> proof_caveat(const Case& input);

/// Why solve.all = true does not use solve.start.
constexpr std::string_view unused_start =
    "solve.all looks for every solution, from nowhere in particular";

/// What a plan is of. Each command uses other parts of a case; `check` tells all of them, as `solve` and
/// `continue` use them.
enum class PlanOf { check, solve, follow, curve, map, atlas };

ComputationPlan computation_plan(const Case& input, bool to_table, PlanOf of);

}  // namespace stationary::cli
