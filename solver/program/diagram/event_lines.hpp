// What a figure in the plane of two parameters shows of a table of `curve`: its curves as lines, and the
// special points on them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "solver/event_curve/event_curve.hpp"
#include "solver/program/table/table_reader.hpp"

namespace stationary {

struct EventLine {
  struct Special {
    SpecialPoint type;
    std::array<double, 2> at;
  };
  std::string event;
  std::vector<std::array<double, 2>> points;
  std::vector<Special> special;
};

/// Both parameters, whatever other tools have added or moved; empty: it is no table of `curve`.
std::vector<std::string> curve_parameters(const std::vector<std::string>& columns);

/// x, y: the parameters on the axes. Throws InputError where the table's are others, and for cells
/// that are none.
std::vector<EventLine> read_event_lines(TableReader& table, std::string_view x, std::string_view y);

}  // namespace stationary
