// A curve in segments of one class, bounded by located events and by the ends of the sheet:
//
//   rows      e e e T e e H o o o F o o L      (e elliptic, o oscillatory)
//   segment   1 1 1 1 1 1 1 2 2 2 2 2 2 2      an event's row belongs to the segment that it ends
//
// The rows of events, ends and rest, where the leaf is another, have no say in what class a segment
// is of; between two of them the class half way is asked for. Where the class changes between two rows and no event is known between them, one segment
// goes to the one row and the next begins at the other.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "lib/stability/spectrum.hpp"
#include "solver/motion/event.hpp"

namespace stationary {

struct SegmentBound {
  EventType event = EventType::none;
  double parameter = 0.0;
};

struct Segment {
  int number = 0;                         ///< from 1 on each sheet
  std::optional<StabilityClass> verdict;  ///< none: no spectrum was computed
  long first_point = -1;                  ///< rows; -1: none lies in it
  long last_point = -1;
  SegmentBound from;
  SegmentBound to;
  /// What it covers of the parameter, ascending, for each run in one direction.
  std::vector<std::array<double, 2>> ranges;
};

/// Takes the rows of one sheet in order.
class SegmentBuilder {
 public:
  /// The number of the row's segment. voting: the row's class is that of the curve beside it.
  int row(long point, const SegmentBound& at, std::optional<StabilityClass> verdict, bool voting);
  /// The class between the last row and the next, neither of which votes; marginal: not to be told.
  void between(StabilityClass verdict);
  /// Empty where no row had a class.
  std::vector<Segment> segments() const;

 private:
  struct Open {
    Segment segment;
    std::vector<std::array<double, 2>> runs;  ///< from, to
    std::optional<StabilityClass> event_class;
  };
  void begin(const SegmentBound& from, std::optional<StabilityClass> verdict);
  /// Ends the last segment where the class has changed, and begins the next.
  void turn(const SegmentBound& at, StabilityClass verdict);
  static void extend(Open& open, double parameter);

  std::vector<Open> all_;
  std::vector<SegmentBound> events_;  ///< since a class was last known
  SegmentBound last_;
};

}  // namespace stationary
