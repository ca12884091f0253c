// x.meta.json beside x.csv: what was asked, with overrides and defaults applied, what it cost, what
// is to be told of the curves beside their rows, and what was not computed and why. Its JSON Schema
// is metadata.schema.json.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solver/atlas/atlas.hpp"
#include "solver/atlas/least_energy.hpp"
#include "solver/event_curve/event_curve.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/curve_table.hpp"

namespace stationary {

/// What a study ran over, and what of it.
struct StudyRecord {
  std::string over;
  std::string task;
  std::size_t rows = 0;
};

/// Which part of a run shared out by hand a table is.
struct PartRecord {
  std::size_t number = 1;
  std::size_t of = 1;
  std::size_t first_row = 0;  ///< of the whole, from 0
  std::string work;           ///< what all its parts have in common
};

/// Of a run in tiles.
struct TileRecord {
  std::size_t computed = 0;
  std::size_t kept = 0;  ///< taken from a journal
  int ranks = 1;
};

/// A curve of events beside its rows.
struct EventCurveRecord {
  struct Special {
    std::string_view special;
    std::string_view other;  ///< of a double one: the other event
    long point = 0;
    std::array<double, 2> at;  ///< both parameters
  };
  int curve = 1;
  long points = 0;
  std::vector<Special> special;
  EventCurveEnd first;
  EventCurveEnd last;
};

/// Of what is written.
constexpr int metadata_schema = 2;

struct Metadata {
  std::string version;
  // Of the run, not of what it found: under the key `run`.
  std::vector<std::string> command_line;
  double seconds = 0.0;
  int threads = 1;
  std::optional<TileRecord> tiles;
  std::size_t merged_parts = 0;  ///< 0: it is not merged
  std::string instructions;      ///< that a map was marched by, or "scalar"; empty of all else

  const Case* input = nullptr;
  const CaseTree* source = nullptr;  ///< of the case where it is none by itself (`study`)
  std::optional<StudyRecord> study;
  std::optional<PartRecord> part;
  std::size_t rows = 0;
  std::string checksum;  ///< of the rows (TableChecksum)
  std::vector<std::pair<std::string_view, long>> counts;
  std::vector<SheetRecord> curves;  ///< the sheets followed
  std::vector<EventCurveRecord> event_curves;
  const Atlas* atlas = nullptr;                ///< its sheets, checkpoints and remarks
  std::vector<LeastEnergyPiece> least_energy;  ///< of its sheets
  /// Of `solve` with all: the sheets of rows found where the search is undecided, and not proven.
  std::vector<int> unproven_sheets;
  std::vector<PlanItem> plan;     ///< how each unknown is had
  std::vector<PlanItem> skipped;  ///< what was not computed, and why
  /// Outcome, method, connection, message, class, ... by name.
  std::vector<std::pair<std::string_view, std::string>> outcome;
};

/// The evaluation counts of one solve, by name.
std::vector<std::pair<std::string_view, long>> named_counts(const Counts& counts);

/// Whether metadata (JSON text) are of the same case but for how far and how finely it is followed
/// (continuation.step and max_points).
bool is_of_case(std::string_view metadata, const Case& input);

/// JSON text, indented, ending in a newline; bytes that are not UTF-8 are replaced. of_the_run: with
/// the key `run`, without which it is the same for every run of a case.
std::string metadata_json(const Metadata& metadata, bool of_the_run = true);

}  // namespace stationary
