// Every sheet of a body's steady rotations over a range of nu, connected to rest or not: about its
// material axes, about axes tilted between two of them (of an isotropic body), and about oblique ones
// (of an anisotropic body, or with gravity):
//
//   1. at checkpoints inside the range all motions of each kind are found, with proof (search.hpp,
//      anisotropic_search.hpp);
//   2. each that lies on no sheet known so far is followed both ways (follow_sheet.hpp);
//   3. where a sheet lets others go (a circle turns into ellipses, an ellipse or an axis away from
//      the material axes) and none of these is known, one is entered there;
//   4. isotropic V: where an axis can tilt and no tilted family begins or ends there yet, one is
//      entered and followed (tilted_family.hpp); then those through tilted motions found at
//      checkpoints that lie on none of these;
//   5. at every checkpoint the motions on the sheets are counted against those proven: where they
//      agree, no sheet that passes there is missing;
//   6. where asked, the curves of each kind are covered (solver/tube) after step 2, and step 2 is gone
//      on with: the range falls into intervals of nu with one number of motions each, and the middle
//      of every such interval is a checkpoint too; and into others in which the class of each is one.
//
// nu and -nu are one, and with J1 = J2 and an isotropic V so are (i) and (ii), an ellipse of (iii)
// and the same turned by a right angle; with an even V S and its mirror image are.
// The work is shared by threads; what comes out does not depend on their number.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/body/circle.hpp"
#include "solver/atlas/sheet_kind.hpp"
#include "solver/family/follow_sheet.hpp"
#include "solver/family/tilted_family.hpp"
#include "solver/search/search.hpp"

namespace stationary {

struct AtlasOptions {
  double from = 0.0;  ///< range of nu, 0 <= from < to
  double to = 1.0;
  /// Of each kind of motion, in the middle of as many equal parts of the range. A search takes
  /// microseconds to milliseconds; of an anisotropic body tenths of a second to seconds.
  int checkpoints = 256;
  std::vector<Branch> branches{Branch::i, Branch::ii, Branch::iii};
  bool oblique = true;    ///< its oblique motions too, where it may have any
  bool tilted = true;     ///< likewise those tilted in a plane, of an isotropic V
  bool complete = false;  ///< for every nu, not at checkpoints alone
  StepOptions step;
  double unit = 1.0;            ///< ContinuationOptions::unit
  long max_points = 1'000'000;  ///< of each sheet
  SearchOptions search;
  bool spectrum = true;
  int threads = 1;
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: end with what is there
  bool stopped() const { return stop != nullptr && stop->load(std::memory_order_relaxed); }
  /// Called after each search with the fraction done of them, by one thread at a time.
  std::function<void(double)> progress = {};
  /// For going on where an atlas was interrupted. Searches are numbered, the checkpoints of one kind
  /// of motion after those of another: what was found before, if it is known, and what is found now.
  /// Both called by several threads.
  std::function<std::optional<SearchResult>(std::size_t)> known_search = {};
  std::function<void(std::size_t, const SearchResult&)> searched = {};
};

struct AtlasRow {
  Member member;
  EventType event;
  /// The class on the curve between this row and the last, where neither has_class_of_curve().
  std::optional<StabilityClass> before = std::nullopt;
};

/// How a sheet was come upon.
enum class Entry {
  rest,      ///< through the rest state
  search,    ///< through a solution found at a checkpoint
  ellipse,   ///< off a circle that turns into ellipses
  shear,     ///< off a sheet of (iii) whose ellipse can turn away from the material axes
  oblique,   ///< off a sheet of (i), (ii) whose axis can
  tilt,      ///< off a sheet whose axis can tilt
  numerical  ///< through one found by Newton's method where the search at a checkpoint is undecided
};
constexpr std::string_view entry_names[] = {"rest",    "search", "ellipse",  "shear",
                                            "oblique", "tilt",   "numerical"};
constexpr std::string_view name(Entry e) { return entry_names[static_cast<int>(e)]; }

/// The motion at a fraction of the way along a sheet from one of its rows to the next; nothing where it
/// is not found.
using SheetArc = std::function<std::optional<Member>(const Member&, const Member&, double)>;

/// Where the end of a sheet lies on another.
struct Junction {
  int sheet;  ///< its number
  EventType event;
  double nu;
};

struct AtlasSheet : SheetKind {
  int number = 0;  ///< from 1
  Entry entry = Entry::rest;
  double entry_nu = 0.0;
  std::optional<Junction> parent;  ///< the sheet it leaves
  std::optional<Junction> joins;   ///< the sheet its other end lies on
  FollowReport report;
  std::vector<AtlasRow> rows;
  SheetArc arc;  ///< between its rows
  /// Of an ellipse in this circle's plane and the same turned by a right angle it stands for both.
  Circle mirror = Circle::none;

  /// What it ends at; none where following was stopped there, whatever the row is beside.
  EventType first_event() const;
  EventType last_event() const;
};

/// All motions of a kind at one nu, against the sheets.
struct Checkpoint : SheetKind {
  double nu = 0.0;
  SearchStatus status = SearchStatus::not_run;
  int proven = 0;     ///< solutions in the box searched
  int unproven = 0;   ///< others that Newton's method found in what is undecided
  int on_sheets = 0;  ///< of these, found on a sheet
  int beyond = 0;     ///< points of sheets in the box that are none of these

  /// No sheet that passes here inside the box is missing.
  bool complete() const {
    return status == SearchStatus::complete && proven == on_sheets && beyond == 0;
  }
};

/// What is known of motions outside the box, for the nu of an interval.
enum class Beyond {
  excluded,         ///< proven: there are none, with stretches between 10^-50 and 10^50
  not_examined,     ///< or in vain
  sheet_listed,     ///< at some of these nu a sheet of the atlas is there; others are not examined
  sheet_leaves_box  ///< at one of these nu a sheet passes a side of the box
};
constexpr std::string_view beyond_names[] = {"excluded", "not-examined", "sheet-listed",
                                             "sheet-leaves-box"};
constexpr std::string_view name(Beyond b) { return beyond_names[static_cast<int>(b)]; }

/// A part of the range of nu, and what is known of it for every nu.
struct CompleteInterval {
  double from = 0.0;
  double to = 0.0;
  bool proven = false;
  int sheets = 0;           ///< where proven, of those in the box: motions at every nu between
  std::string_view reason;  ///< why not, where not proven; a literal
  Beyond beyond = Beyond::not_examined;

  /// Not proven for no other reason than that a sheet leaves the box.
  bool leaves_box() const { return !proven && beyond == Beyond::sheet_leaves_box; }
};

/// A part of the range, and the classes of all motions in the box for every nu between.
struct ClassInterval {
  double from = 0.0;
  double to = 0.0;
  bool proven = false;
  std::array<int, std::size(stability_names)> sheets = {};  ///< where proven, of each class
  std::string_view reason;             ///< why not, where not proven; a literal
  std::vector<EventType> events = {};  ///< of the sheets listed, where not proven: each type once
  Beyond beyond = Beyond::not_examined;
};

/// Of one kind of motion, all of the range.
struct Completeness : SheetKind {
  std::vector<CompleteInterval> intervals;  ///< ascending, each beginning where the last ends
  std::vector<ClassInterval> classes;       ///< likewise, not cut; empty without spectra
  long boxes = 0;                           ///< examined
  long class_arcs = 0;                      ///< whose class was asked for
  long tubes = 0;                           ///< proven pieces of curves

  /// The intervals, without the cuts between proven ones that differ in `beyond` alone: of a joined one that
  /// is what is known of all of it.
  std::vector<CompleteInterval> joined() const;

  /// Of the intervals that are not proven, all together.
  double unproven_length() const;
  double unproven_class_length() const;
};

/// What was come upon and not followed, or is not looked for.
struct Remark : SheetKind {
  std::optional<Entry> entry;  ///< none: of the whole kind of motion
  double nu;
  std::string reason;
};

struct Atlas {
  /// By branch, then as they were found; then oblique ones, tilted ones last.
  std::vector<AtlasSheet> sheets;
  std::vector<Checkpoint> checkpoints;  ///< by branch, then nu
  std::vector<Remark> remarks;
  std::vector<Completeness> completeness;  ///< where asked for, by branch
  bool interrupted = false;
};

/// Throws std::invalid_argument unless 0 <= from < to, both finite, and checkpoints > 0.
Atlas atlas(const Body& body, const Potential& potential, const AtlasOptions& options);

}  // namespace stationary
