// A followed curve as rows of a table, and what is to be told of the whole: its segments of one
// class, where its events stand, how it ended.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/family/follow_sheet.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/rows/segments.hpp"
#include "solver/program/table/table.hpp"

namespace stationary {

/// An end of a sheet in its table.
struct EndRecord {
  EventType event = EventType::none;  ///< none: not followed to its end
  double parameter = std::numeric_limits<double>::quiet_NaN();
  std::string reason;
};

/// A sheet beside its rows.
struct SheetRecord {
  int sheet = 1;
  std::vector<EventRecord> events;
  std::vector<Segment> segments;
  EndRecord first;
  EndRecord last;
};

/// A segment as metadata tell it: its class, of the rows from the first to the last point.
struct RecordedSegment {
  std::optional<StabilityClass> verdict;
  long first_point = -1;  ///< -1: no row lies in it
  long last_point = -1;
};

/// How many rows are proven, and of how many that are no events the class is not.
struct CurveProofs {
  long rows = 0;
  long proven = 0;
  double first_gap = std::numeric_limits<double>::quiet_NaN();  ///< parameter of one that is not
  std::string reason;                                           ///< why that one is not
  long open_classes = 0;
  double first_open_class = std::numeric_limits<double>::quiet_NaN();

  void add(const CurveProofs& more);
  /// What is not proven though it was asked for; empty if all is. parameter: its name.
  std::string gap_text(std::string_view parameter) const;
};

class CurveTable final : public CurveSink {
 public:
  /// Rows of sheet `sheet`; branch: a name that outlives this; writer may be null: then there is
  /// only what is told of the whole.
  CurveTable(std::string_view branch, RowSink* writer, int sheet = 1)
      : branch_(branch), writer_(writer) {
    row_[Column::sheet] = sheet;
  }

  /// Proves every row (prove_row()), and of an event's row that the event is there, where it has
  /// equations of its own (Kind::enclose_event()); kind_at(p) is the kind at the parameter p.
  using KindAt = std::function<std::unique_ptr<Kind>(double)>;
  void prove(KindAt kind_at, const FamilyParameter& parameter) {
    kind_at_ = std::move(kind_at);
    parameter_ = parameter;
  }
  /// Tells of every event how the motions begin that begin there (Kind::normal_form()).
  void tell_normal_forms(KindAt kind_at, const FamilyParameter& parameter) {
    kind_of_event_ = std::move(kind_at);
    parameter_ = parameter;
  }
  /// The table's parameter is the family's over this (a ratio's second number).
  void in_units_of(double unit) { unit_ = unit; }
  /// What was told of following the family, in the table's parameter.
  void convert(FollowReport& report) const;
  /// Those of the rows' stretches.
  void in_coordinates(const MaterialCoordinates& coordinates) { coordinates_ = coordinates; }
  void row(const Member& member, EventType event) override;
  void between(StabilityClass verdict) override { segments_.between(verdict); }
  /// A row that was in a table already, with this table's sheet and next point; verdict: the class
  /// of its segment there; at_rest: ResumedTable::at_rest.
  void again(TableRow row, std::optional<StabilityClass> verdict, bool at_rest);
  /// Adds to the events of the rows so far their rows and enclosures.
  void complete(std::vector<EventRecord>& events) const;
  /// Of the rows so far; report: what was told of following them, its events completed.
  SheetRecord record(const FollowReport& report) const;
  const CurveProofs& proofs() const { return proofs_; }

 private:
  struct EventRow {
    EventType type;
    double parameter;
    long point;
    std::optional<Interval> enclosure;
    std::optional<double> criticality_error;
  };

  bool proves() const { return bool(kind_at_); }
  RowProof prove(const Member& member, EventType event);
  void tell_normal_form(const Member& member, EventType event);
  void count_proof(bool proven, double parameter, const std::string& reason);
  void count_class(double parameter);
  double parameter_of(const TableRow& row) const;
  /// A row's place among the segments and the events; verdict: its own class.
  void place(EventType event, double parameter, bool voting, std::optional<StabilityClass> verdict);

  std::string_view branch_;
  RowSink* writer_;
  double unit_ = 1.0;
  MaterialCoordinates coordinates_;
  long point_ = 0;
  TableRow row_;
  SegmentBuilder segments_;
  double first_parameter_ = std::numeric_limits<double>::quiet_NaN();
  double last_parameter_ = std::numeric_limits<double>::quiet_NaN();
  bool last_votes_ = false;
  KindAt kind_at_;        ///< empty: nothing is proven
  KindAt kind_of_event_;  ///< empty: nothing is told
  FamilyParameter parameter_;
  CurveProofs proofs_;
  std::vector<EventRow> events_;
};

/// Of what a table needs to be gone on with, the columns that it has not.
std::vector<std::string_view> missing_to_resume(const std::vector<Column>& columns,
                                                const std::optional<std::string>& parameter,
                                                std::string_view branch);

}  // namespace stationary
