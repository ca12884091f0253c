// How the motion of a case, its modes, and the events of its family move with each number of the
// case, and what uncertainty of these numbers means for them (output.uncertainty).
#pragma once

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/table_target.hpp"
#include "solver/program/session/run.hpp"

namespace stationary::cli {

/// events: of the events of the family of [continuation], not of the motion. target: null for no
/// table. Throws InputError before anything is computed.
Outcome sensitivity_case(const Case& input, bool events, TableTarget* target, const Run& run);

}  // namespace stationary::cli
