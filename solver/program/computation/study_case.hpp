// The case with the values of each row of a table, solved, followed or charted, and what came of each in
// one table. The rows are computed by all threads in tiles and written in the order of the table; a
// journal keeps the tiles that are finished.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/table_target.hpp"
#include "solver/program/session/run.hpp"
#include "solver/program/tiles/study_answer.hpp"
#include "solver/program/tiles/study_source.hpp"

namespace stationary::cli {

struct StudyRun {
  const CaseTree* base;                ///< need be a case only with a row's values
  std::vector<std::string> overrides;  ///< of --set
  const StudySource* source;
  StudyPlan plan;                      ///< but for its columns
  std::optional<std::string> journal;  ///< the table beside which finished rows are kept
  bool resume = false;                 ///< goes on with these
};

/// target: null for no table. Throws InputError before anything is computed.
Outcome study_case(const StudyRun& asked, TableTarget* target, const Run& run);

}  // namespace stationary::cli
