// Metadata of the parts of a run that is shared out by hand, read back for merging.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/program/rows/metadata.hpp"

namespace stationary {

struct PartMetadata {
  PartRecord part;
  std::string command;  ///< "map", "study", "atlas"
  std::string status;   ///< "done", "interrupted"
  std::size_t rows = 0;
  std::string checksum;
  std::string case_file;
  std::string case_text;  ///< the case and its overrides, to be told from others
  std::string instructions;
  std::vector<std::pair<std::string, long>> counts;
  std::optional<StudyRecord> study;
  bool certificate = false;  ///< of the case: each row was to be proven
};

/// Nothing where a text is no metadata of a part.
std::optional<PartMetadata> part_metadata(std::string_view metadata);

/// The same text of what would be written.
std::string case_text(const Metadata& metadata);

}  // namespace stationary
