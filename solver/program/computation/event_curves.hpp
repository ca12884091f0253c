// `curve`: every event of the asked type on the case's family in the first parameter, at the case's
// own value of the second, starts a curve in both (solver/event_curve). Events that a curve passes
// again start none of their own.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "solver/event_curve/event_curve.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/program/session/run.hpp"
#include "solver/program/table/table.hpp"
#include "solver/proof/event_enclosure.hpp"
#include "solver/solve/solve.hpp"

namespace stationary::cli {

struct EventCurves {
  /// Of the family's start; anything but solved: there is no family to look for events on.
  SolveStatus status = SolveStatus::not_run;
  bool only_in_box = false;  ///< as of a Start
  std::string message;
  std::vector<EventCurve> curves;
  /// Why events on the family start no curve.
  std::vector<std::string> failures;
  bool interrupted = false;
};

/// Throws InputError where the case has no [curve], or none of its event or in its numbers.
void require_curve(const Case& input);

/// Throws InputError where the case's own value of the second parameter is out of the range.
void require_second_in_range(const Case& input);

/// Both hold of the case, here and below.
EventCurves event_curves(const Case& input, bool spectrum, const Run& run);

/// The curve through a motion that is such an event, at the case's own values of both parameters.
EventCurves event_curve_of_row(const Case& input, const Stretch& q, bool spectrum, const Run& run);

/// The values of both parameters, of a ratio those of the ratio.
std::array<double, 2> curve_place(const Case& input, const EventCurvePoint& point);

/// A point as a row: event, branch, both parameters, and the common columns that are wanted.
TableRow curve_row(const Case& input, const EventCurvePoint& point, const ColumnSet& wanted);

/// That the event is there, and no other near it: proven, or why not. Its bound goes into the row.
EventEnclosure prove_curve_row(const Case& input, const EventCurvePoint& point, TableRow& row);

}  // namespace stationary::cli
