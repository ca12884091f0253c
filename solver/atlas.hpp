// Every sheet of a body's steady rotations about its material axes over a range of nu, connected to
// rest or not:
//
//   1. at checkpoints inside the range all solutions of each branch are found, with proof
//      (search.hpp);
//   2. each that lies on no sheet known so far is followed both ways (follow.hpp);
//   3. where a circle turns into ellipses and no sheet of these is known, one is entered there;
//   4. where an axis can tilt and no tilted family begins or ends there yet, one is entered and
//      followed (tilted_family.hpp);
//   5. at every checkpoint the solutions on the sheets are counted against those proven: where they
//      agree, no sheet that passes there is missing.
//
// nu and -nu are one, and with J1 = J2 so are (i) and (ii), an ellipse of (iii) and the same turned
// by a right angle.
// The work is shared by threads; what comes out does not depend on their number.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/follow.hpp"
#include "solver/search.hpp"
#include "solver/tilted_family.hpp"

namespace stationary {

struct AtlasOptions {
  double from = 0.0;  ///< range of nu, 0 <= from < to
  double to = 1.0;
  int checkpoints = 256;  ///< of each branch, in the middle of as many equal parts of the range
  std::vector<Branch> branches{Branch::i, Branch::ii, Branch::iii};
  StepOptions step;
  long max_points = 1'000'000;  ///< of each sheet
  SearchOptions search;
  bool spectrum = true;
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: end with what is there
};

struct AtlasRow {
  Member member;
  EventType event;
};

/// How a sheet was come upon.
enum class Entry {
  rest,     ///< through the rest state
  search,   ///< through a solution found at a checkpoint
  ellipse,  ///< off a circle that turns into ellipses
  tilt      ///< off a sheet whose axis can tilt
};
constexpr std::string_view entry_names[] = {"rest", "search", "ellipse", "tilt"};
constexpr std::string_view name(Entry e) { return entry_names[static_cast<int>(e)]; }

/// Where the end of a sheet lies on another.
struct Junction {
  int sheet;  ///< its number
  EventType event;
  double nu;
};

struct AtlasSheet {
  int number = 0;  ///< from 1
  Branch branch = Branch::i;
  Entry entry = Entry::rest;
  double entry_nu = 0.0;
  std::optional<TiltPlane> plane;  ///< of a tilted family: `branch` is then that it was entered at
  std::optional<Junction> parent;  ///< the sheet it leaves
  std::optional<Junction> joins;   ///< the sheet its other end lies on
  FollowReport report;
  std::vector<AtlasRow> rows;
};

/// All solutions of a branch at one nu, against the sheets.
struct Checkpoint {
  Branch branch = Branch::i;
  double nu = 0.0;
  SearchStatus status = SearchStatus::not_run;
  int proven = 0;     ///< solutions in the box searched
  int on_sheets = 0;  ///< of these, found on a sheet
  int beyond = 0;     ///< points of sheets in the box that are none of these

  /// No sheet that passes here inside the box is missing.
  bool complete() const {
    return status == SearchStatus::complete && proven == on_sheets && beyond == 0;
  }
};

/// What was come upon and not followed.
struct Remark {
  Branch branch;
  Entry entry;
  double nu;
  std::string reason;
};

struct Atlas {
  std::vector<AtlasSheet> sheets;       ///< by branch, then as they were found; tilted ones last
  std::vector<Checkpoint> checkpoints;  ///< by branch, then nu
  std::vector<Remark> remarks;
  bool interrupted = false;
};

/// Throws std::invalid_argument unless 0 <= from < to, both finite, and checkpoints > 0.
Atlas atlas(const Body& body, const Potential& potential, const AtlasOptions& options);

}  // namespace stationary
