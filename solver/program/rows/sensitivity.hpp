// How a motion, its modes and the place of an event move with the numbers of the case: slopes of the
// solved motion, each by difference quotients (difference_quotient.hpp) of solves beside it, whatever
// kind of motion it is.
#pragma once

#include <atomic>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/motion/event.hpp"
#include "solver/motion/family.hpp"
#include "solver/newton/difference_quotient.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/table/table.hpp"

namespace stationary {

/// A number of the case, and the slopes by it of what was asked for, in that order.
struct NumberSlopes {
  std::string number;
  double value;
  Slopes of;
};

/// Columns of a motion that have slopes, of those a table has.
std::vector<Column> sloped_columns(std::span<const Column> columns);

/// The motion of the row, a solution of `at`; of its columns. A number whose neighbours have no
/// solution has NaN.
std::vector<NumberSlopes> motion_slopes(const FamilyParameters& at, const TableRow& row,
                                        std::span<const std::string> numbers,
                                        std::span<const Column> columns,
                                        const std::atomic<bool>* stop);

/// An event of the family of `at` in a parameter: first the slope of the parameter's value there,
/// then of its columns. The parameter is none of the numbers. NaN too where a number breaks what the
/// event is the end of (J1 of a circle), and where the event has no equations of its own.
std::vector<NumberSlopes> event_slopes(const FamilyParameters& at, const std::string& parameter,
                                       const Member& event, EventType type,
                                       std::span<const std::string> numbers,
                                       std::span<const Column> columns,
                                       const std::atomic<bool>* stop);

/// Of independent numbers with these standard uncertainties: that of each slope's function,
/// sqrt(sum (slope u)^2), to first order. NaN where a slope is not known.
std::vector<double> combined_uncertainty(std::span<const NumberSlopes> slopes,
                                         std::span<const double> uncertainty);

}  // namespace stationary
