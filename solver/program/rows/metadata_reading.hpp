// What is read back of x.meta.json (metadata.hpp), JSON text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/program/rows/metadata.hpp"

namespace stationary {

/// Whether a text of JSON nests more deeply than metadata ever do. What copies, compares and writes
/// its tree is recursive, and the stack ends before such a text does.
bool nests_too_deep(std::string_view json);

/// What metadata of `continue` say of its table.
struct CurveRecord {
  std::size_t rows = 0;
  std::string checksum;
  std::vector<EventRecord> events;
  std::vector<RecordedSegment> segments;  ///< in order
  std::string first_reason;               ///< why the curve ends there
  std::string last_reason;
  bool last_is_open = false;  ///< it does not end there, and was not followed on
};
/// Nothing where a text is no such metadata.
std::optional<CurveRecord> curve_record(std::string_view metadata);

/// Whether it is JSON as this program's metadata are.
bool is_metadata(std::string_view metadata);

/// What is found where metadata are of another version of the program, or of another schema; empty where
/// they are of this one, or are none.
std::string other_program(std::string_view metadata, std::string_view version);

/// Whether the table was interrupted, or stopped for its length: --resume needs them.
bool is_to_be_gone_on_with(std::string_view metadata);

/// Whether a text is of a table of so many rows, and not of another that was written beside it since.
bool is_of_table(std::string_view metadata, std::size_t rows);

/// The title of the case in a text; empty where it has none, or is no such text.
std::string case_title(std::string_view metadata);

/// Of a part of a run that is shared out by hand, for merging.
struct PartMetadata {
  PartRecord part;
  std::string command;  ///< "map", "study", "atlas"
  std::string status;   ///< "done", "interrupted"
  std::size_t rows = 0;
  std::string checksum;
  std::string case_file;
  std::string case_text;     ///< the case and its overrides, to be told from others
  std::string instructions;  ///< empty of an HDF5 file, which tells nothing of its run
  std::vector<std::pair<std::string, long>> counts;
  std::optional<StudyRecord> study;
  bool certificate = false;  ///< of the case: each row was to be proven
};

/// Nothing where a text is no metadata of a part.
std::optional<PartMetadata> part_metadata(std::string_view metadata);

/// PartMetadata::case_text of what would be written.
std::string case_text(const Metadata& metadata);

}  // namespace stationary
