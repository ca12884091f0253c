// Every sheet of the case's body and potential (atlas.hpp) over its range of nu, connected to rest or not, and what
// is proven of there being no others.
#pragma once

#include <optional>
#include <string>

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/table_target.hpp"
#include "solver/program/session/run.hpp"

namespace stationary::cli {

struct AtlasRun {
  std::optional<int> checkpoints;      ///< none: by the body's symmetry
  std::optional<std::string> journal;  ///< the table beside which finished searches are kept
  bool resume = false;                 ///< goes on with these
  bool complete = false;               ///< for every nu, not at the checkpoints alone
  std::string least_energy = {};       ///< file of the motions of least energy; empty: none
};

/// target: null for no table. Throws InputError before anything is computed.
Outcome atlas_case(const Case& input, const AtlasRun& asked, TableTarget* target, const Run& run);

}  // namespace stationary::cli
