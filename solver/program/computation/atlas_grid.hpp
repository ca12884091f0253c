// An atlas of every cell of the case's grid ([map]), a row each: what its sheets and events come to, and if
// that is asked for all their tables in one HDF5 file, a group a cell.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/table_target.hpp"
#include "solver/program/session/run.hpp"
#include "solver/program/tiles/tiled_run.hpp"

namespace stationary::cli {

struct AtlasGridAsked {
  std::optional<int> checkpoints;  ///< none: by the body's symmetry
  std::string tables;              ///< the file of all tables; empty: none
};

/// target: null for no table. Throws InputError before anything is computed.
Outcome atlas_grid(const Case& input, const AtlasGridAsked& asked, const TiledRun& tiled,
                   TableTarget* target, const Run& run);

/// The parts' tables in one, and where asked.tables names a file the parts' own such files in it; paths: of
/// all of them.
Outcome merged_atlas_grid(const Case& input, const AtlasGridAsked& asked,
                          const std::vector<std::string>& paths, TableTarget& target,
                          const Run& run);

}  // namespace stationary::cli
