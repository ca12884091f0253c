// The case's family followed in its parameter, both ways from the start, with the stability of every
// point and every event located.
#pragma once

#include <optional>
#include <string>

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/table_target.hpp"
#include "solver/program/session/run.hpp"

namespace stationary::cli {

struct ContinueFrom {
  std::string row;                     ///< of a table (row_start.hpp); empty: solved for
  std::optional<std::string> resumed;  ///< the interrupted table gone on with (resume.hpp)
};

/// target: null for no table. Throws InputError before anything is computed.
Outcome continue_case(const Case& given, const ContinueFrom& from, TableTarget* target,
                      const Run& run);

}  // namespace stationary::cli
