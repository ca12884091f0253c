// A study (tiles/study.hpp): every row solved, followed or charted by all threads in tiles, what came of
// each in one table in the rows' order.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/program/rows/table_target.hpp"
#include "solver/program/session/run.hpp"
#include "solver/program/tiles/study.hpp"

namespace stationary::cli {

/// target: null for no table. Throws InputError before anything is computed.
Outcome study_case(const StudyRun& asked, TableTarget* target, const Run& run);

/// The parts' tables in one. The table that is run over may be null; where it is there all that is asked
/// has to be what the parts were made with, else the task, if there is one.
Outcome merged_study_case(const StudyRun& asked, std::optional<StudyTask> task,
                          const std::vector<std::string>& paths, TableTarget& target,
                          const Run& run);

}  // namespace stationary::cli
