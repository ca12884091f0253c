// A study as far as it does not depend on how it is run: the case with each row of a table, and what is
// done of it.
#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/table/cell_table.hpp"
#include "solver/program/tiles/part.hpp"
#include "solver/program/tiles/study_answer.hpp"
#include "solver/program/tiles/study_source.hpp"
#include "solver/program/tiles/tiled_run.hpp"

namespace stationary::cli {

struct StudyRun {
  const CaseTree* base;                ///< need be a case only with a row's values
  std::vector<std::string> overrides;  ///< of --set
  const StudySource* source;           ///< which outlives what is made of it
  StudyPlan plan;                      ///< but for its columns
  TiledRun tiled = {};
};

class Study {
 public:
  /// Throws InputError, also of a case that none of the rows makes one.
  explicit Study(const StudyRun& asked);

  const StudySource& source() const { return source_; }
  const StudyPlan& plan() const { return plan_; }
  const CaseTree& tree() const { return tree_; }
  /// The case by itself, where it is one without a row's values.
  std::optional<Case> alone() const;
  std::vector<CellColumn> header() const;
  /// Solves are short, and a record of the journal for each would not be.
  std::size_t rows_a_tile() const { return plan_.task == StudyTask::solve ? 16 : 1; }
  /// The lines of rows; nothing where it was interrupted. May be called by several threads.
  std::optional<std::string> lines(const Share& rows, const std::atomic<bool>* stop) const;
  /// Of all that decides them.
  std::string hash() const;

 private:
  void require_some_case() const;
  /// Of solve's rows: those the case asks for, of any kind of motion that a row may have.
  std::vector<Column> columns() const;

  const StudySource& source_;
  const CaseTree& base_;
  std::vector<Override> options_;  ///< of --set
  CaseTree tree_;                  ///< with these
  StudyPlan plan_;
};

/// study_row, the columns run over, status, message, and those of what is done.
std::vector<CellColumn> study_header(const std::vector<CellColumn>& source,
                                     const std::vector<CellColumn>& cells);

}  // namespace stationary::cli
