// The curves of an event in two numbers of the case (event_curves.hpp), as a table.
#pragma once

#include <string>

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/table_target.hpp"
#include "solver/program/session/run.hpp"

namespace stationary::cli {

/// row: TABLE:N, TABLE:EVENT or TABLE:EVENT:K (row_name.hpp), an event whose curve is followed; empty:
/// every event of the case's family starts one. target: null for no table. Throws InputError before
/// anything is computed.
Outcome curve_case(const Case& given, const std::string& row, TableTarget* target, const Run& run);

}  // namespace stationary::cli
