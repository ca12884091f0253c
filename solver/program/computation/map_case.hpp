// The case's grid over one or two of its parameters, every cell solved on the rest state's sheet (or
// as `solve` does, where a kind of motion has none), by all threads; the table in the grid's order.
#pragma once

#include <string>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/table_target.hpp"
#include "solver/program/session/run.hpp"
#include "solver/program/tiles/tiled_run.hpp"

namespace stationary::cli {

/// target: null for no table. Throws InputError before anything is computed.
Outcome map_case(const Case& input, TableTarget* target, const Run& run);
/// The same with a journal, of one part, or with other processes.
Outcome tiled_map_case(const Case& input, const TiledRun& tiled, TableTarget* target,
                       const Run& run);
/// The parts' tables in one.
Outcome merged_map_case(const Case& input, const std::vector<std::string>& paths,
                        TableTarget& target, const Run& run);

}  // namespace stationary::cli
