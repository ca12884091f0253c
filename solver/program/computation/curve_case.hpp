// The curves of an event in two numbers of the case (event_curves.hpp), as a table.
#pragma once

#include <string>

#include "solver/program/case/case_file.hpp"
#include "solver/program/session/run.hpp"
#include "solver/program/session/table_output.hpp"

namespace stationary::cli {

/// row: TABLE:N, TABLE:EVENT or TABLE:EVENT:K (row_start.hpp), an event whose curve is followed; empty:
/// every event of the case's family starts one. output: null for no table. Throws InputError before
/// anything is computed.
Outcome curve_case(const Case& given, const std::string& row, TableOutput* output, const Run& run);

}  // namespace stationary::cli
