// What a study says of one case: whether it came to anything, why not, and its row.
#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/atlas_rows.hpp"
#include "solver/program/table/cell_table.hpp"

namespace stationary::cli {

enum class StudyTask { solve, follow, atlas };
constexpr std::string_view study_task_names[] = {"solve", "continue", "atlas"};
constexpr std::string_view name(StudyTask t) { return study_task_names[static_cast<int>(t)]; }
/// Of that name, if there is one.
std::optional<StudyTask> study_task(std::string_view name);

enum class StudyStatus { solved, none, not_found, failed, bad_input };
constexpr std::string_view study_status_names[] = {"solved", "none", "not-found", "failed",
                                                   "bad-input"};
constexpr std::string_view name(StudyStatus s) { return study_status_names[static_cast<int>(s)]; }

/// What is done of every case.
struct StudyPlan {
  StudyTask task = StudyTask::solve;
  std::optional<int> checkpoints;  ///< of an atlas
  bool certify = false;
  std::vector<Column> columns;  ///< of solve

  std::vector<CellColumn> cell_columns() const;
};

struct StudyAnswer {
  StudyStatus status = StudyStatus::failed;
  std::string message;
  /// Of each row (several where solve.all finds several; one, empty, where there is none).
  std::vector<std::string> cells;
};

/// Of an atlas, its rows into a table, which may be null; nothing where it was interrupted.
std::optional<StudyAnswer> atlas_answer(const AtlasBody& of, const AtlasOptions& how,
                                        RowSink* rows);

/// Nothing where it was interrupted: stop became true. May be called by several threads.
std::optional<StudyAnswer> study_answer(const StudyPlan& plan, const CaseTree& base,
                                        std::span<const Override> overrides,
                                        const std::atomic<bool>* stop);

}  // namespace stationary::cli
