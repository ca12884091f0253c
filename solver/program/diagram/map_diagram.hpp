// What a heat map shows of a table of `map` over two parameters: one of its columns, or the class,
// over the grid, where there is no solution to show, and curves of events on top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/program/case/case_grid.hpp"
#include "solver/program/diagram/event_lines.hpp"
#include "solver/program/table/table.hpp"
#include "solver/program/table/table_reader.hpp"

namespace stationary {

/// One of the grid's parameters: evenly spaced values, or logarithms of them.
struct MapDiagramAxis {
  std::string parameter;
  std::vector<double> values;  ///< ascending
  AxisScale scale = AxisScale::linear;
};

struct MapDiagram {
  MapDiagramAxis x;
  MapDiagramAxis y;
  std::string quantity;  ///< the column's name
  /// Row by row of y, x fastest: the quantity, of a class its index in stability_names; NaN where
  /// it is not computed.
  std::vector<double> values;
  std::vector<std::optional<CellStatus>> statuses;  ///< none: no such row (interrupted)
  std::vector<EventLine> lines;                     ///< on top of the cells

  bool has_cells() const { return !values.empty(); }

  bool of_class() const { return quantity == "class"; }
};

/// Its parameters, of which a map has one or two, wherever they stand; none: it is no map's table.
std::vector<std::string> map_parameters(const std::vector<std::string>& columns);

/// quantity: a column of numbers, or class; default: class, growth, lambda, xi, the first that is
/// there. Throws InputError: no such column, cells that are none, values that make up no grid.
MapDiagram read_map_diagram(TableReader& table, const std::optional<std::string>& quantity);

/// Of tables of `curve` alone, all in the parameters of the first: no cells, and axes that hold the
/// lines. Throws InputError as read_event_lines() does.
MapDiagram read_curve_diagram(const std::vector<TableReader*>& tables);

}  // namespace stationary
