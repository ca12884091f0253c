// One sheet of a family, followed from a point both ways and handed on in the order of the curve:
// first the part against the parameter, from its end to the start (held back until that end is
// known), then the part along it, as it is computed.
//
// The rows at the two ends carry the event that ends the sheet; where the run was interrupted or
// the number of points is used up the last row carries none, and resume() goes on from there.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/number/interval.hpp"
#include "solver/continuation/continuation.hpp"
#include "solver/family/axis_family.hpp"

namespace stationary {

/// Whether the class of a row is that of the curve beside it: at events and ends, and at rest, where the
/// leaf is another, it may not be.
inline bool has_class_of_curve(EventType event, bool at_rest) {
  return event == EventType::none && !at_rest;
}
inline bool has_class_of_curve(EventType event, const Member& member) {
  return has_class_of_curve(event, member.nu == 0.0 && !member.two_polar);
}

/// Takes the rows of a sheet in order.
class CurveSink {
 public:
  CurveSink() = default;
  CurveSink(const CurveSink&) = delete;
  CurveSink& operator=(const CurveSink&) = delete;
  virtual ~CurveSink() = default;
  virtual void row(const Member& member, EventType event) = 0;
  /// The class on the curve between the last row and the next, where neither has_class_of_curve().
  virtual void between(StabilityClass) {}
};

struct FollowOptions {
  ContinuationOptions continuation;
  EventSet events;              ///< those to be found, all by default
  bool from_event = false;      ///< the start is one, and is to be among them
  long max_points = 1'000'000;  ///< no step from there on; events in the last one come on top
  const std::atomic<bool>* stop = nullptr;  ///< becomes true: end at the point reached
  /// Called every few hundred points with the parameter and the number of points so far.
  std::function<void(double, long)> progress;
};

struct EventRecord {
  EventType type;
  double parameter;  ///< unresolved: the bracket's middle
  double before;     ///< bracket
  double after;
  EventStatus status;
  std::optional<Interval> enclosure = std::nullopt;        ///< proven (event_enclosure.hpp)
  std::optional<long> point = std::nullopt;                ///< its row; none of an unresolved one
  std::optional<double> criticality_error = std::nullopt;  ///< where it has a NormalForm
};

struct FollowReport {
  std::string failure;  ///< why the start is no point of a curve; empty if it is
  SheetEnd backward;    ///< against the parameter at the start
  SheetEnd forward;
  std::vector<EventRecord> events;  ///< in the order of the rows
  ContinuationCounts counts;
  long points = 0;
  bool vertical = false;  ///< one and the same parameter on all of the sheet
  bool interrupted = false;
  bool out_of_points = false;  ///< stopped by max_points
};

struct CurvePlace {
  Stretch q;
  double p;
  /// As it is written, where it is known: S says the axis but for its sign.
  Vector3<double> angular_velocity =
      Vector3<double>::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// An end of a sheet still to be followed.
struct OpenEnd {
  CurvePlace at;
  std::optional<CurvePlace> neighbour;  ///< the row before it on the curve: away from that
  int direction = 1;                    ///< along or against the parameter, where there is none
};

/// Keeps rows that are computed from the end of a table backwards, to be given on in reverse.
class HeldBack final : public CurveSink {
 public:
  void row(const Member& member, EventType event) override { rows_.push_back({member, event, {}}); }
  void between(StabilityClass verdict) override {
    (rows_.empty() ? before_ : rows_.back().between) = verdict;
  }
  void give(CurveSink& sink) const;
  bool empty() const { return rows_.empty(); }

 private:
  struct Row {
    Member member;
    EventType event;
    std::optional<StabilityClass> between;  ///< this row and the one computed after it
  };
  std::vector<Row> rows_;
  std::optional<StabilityClass> before_;  ///< what these go on from and the first
};

/// From a solved q at p.
FollowReport follow(const AnyFamily& family, const Stretch& q, double p,
                    const FollowOptions& options, CurveSink& sink);

/// The same of a family by reference.
template <int N>
FollowReport follow_family(const Family<N>& family, const Stretch& q, double p,
                           const FollowOptions& options, CurveSink& sink);

/// On from the end of a table: the rows after it, in that order (report: `forward`).
FollowReport resume(const AnyFamily& family, const OpenEnd& end, const FollowOptions& options,
                    CurveSink& sink);

}  // namespace stationary
