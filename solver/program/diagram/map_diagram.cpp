#include "solver/program/diagram/map_diagram.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

#include "lib/number/elementary.hpp"
#include "lib/stability/spectrum.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/diagram/axis.hpp"
#include "solver/program/diagram/row_parameter.hpp"
#include "solver/program/text/named.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary {
namespace {

[[noreturn]] void refuse_map(const TableReader& table, std::string found, std::string allowed,
                             std::string remedy = {}) {
  throw InputError(Origin::in_file(table.name()), "", std::move(found), std::move(allowed),
                   std::move(remedy));
}

/// What can be shown: class and the columns of numbers.
std::vector<std::string_view> quantities(const TableReader& table) {
  std::vector<std::string_view> out;
  for (const std::string& each : table.columns()) {
    const auto column = find_column(each);
    if (column && (*column == Column::stability || cell_kind(*column) != CellKind::text) &&
        *column != Column::point)
      out.push_back(each);
  }
  return out;
}

std::string chosen(const TableReader& table, const std::optional<std::string>& asked) {
  const auto names = quantities(table);
  const auto has = [&](std::string_view name) {
    return std::ranges::find(names, name) != names.end();
  };
  if (asked) {
    if (has(*asked)) return *asked;
    throw InputError(Origin::of_option("--show " + *asked), "",
                     "found no such column in " + printable(table.name()),
                     "one of " + listed(names), did_you_mean(nearest_name(*asked, names)));
  }
  for (const std::string_view each : {"class", "growth", "lambda", "xi"})
    if (has(each)) return std::string(each);
  if (names.empty()) refuse_map(table, "found no column to show", "class, growth, lambda, ...");
  return std::string(names.front());
}

template <std::size_t n>
std::optional<std::size_t> word(const TableReader& table, std::size_t column,
                                const std::string_view (&words)[n], const std::string& allowed) {
  const std::string_view found = table.text(column);
  if (found.empty()) return std::nullopt;
  const auto out = named<std::size_t>(words, found);
  if (!out) throw table.fault(column, allowed);
  return out;
}

std::vector<double> different(std::vector<double> values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

bool evenly_spaced(const std::vector<double>& values) {
  constexpr double tolerance = 1e-6;  // of a step: rounding of numbers or of their logarithms
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double expected = values.front() + step * static_cast<double>(k);
    if (std::abs(values[k] - expected) > tolerance * step) return false;
  }
  return true;
}

MapDiagramAxis axis(const TableReader& table, const std::string& parameter,
                    const std::vector<double>& cells) {
  MapDiagramAxis out{parameter, different(cells)};
  if (out.values.size() < 2 || evenly_spaced(out.values)) return out;
  std::vector<double> logarithms;
  for (const double each : out.values) logarithms.push_back(log(each));
  if (!(out.values.front() > 0.0) || !evenly_spaced(logarithms))
    refuse_map(table, "found values of " + in_quotes(parameter) + " that are no grid's",
               "evenly spaced ones, or logarithmically");
  out.scale = AxisScale::log;
  return out;
}

std::size_t index(const MapDiagramAxis& axis, double value) {
  const auto at = std::ranges::lower_bound(axis.values, value);
  return static_cast<std::size_t>(at - axis.values.begin());
}

}  // namespace

std::vector<std::string> map_parameters(const std::vector<std::string>& columns) {
  if (std::ranges::find(columns, name(Column::status)) == columns.end()) return {};
  return parameters_among(columns);
}

MapDiagram read_map_diagram(TableReader& table, const std::optional<std::string>& quantity) {
  const std::vector<std::string> parameters = map_parameters(table.columns());
  if (parameters.size() != 2) refuse_map(table, "found no table of two parameters", "a map's");
  MapDiagram out;
  out.quantity = chosen(table, quantity);
  const std::size_t value = table.column(out.quantity).value();
  const std::size_t status = table.column(name(Column::status)).value();
  const std::size_t at_x = table.column(parameters[0]).value();
  const std::size_t at_y = table.column(parameters[1]).value();

  struct Cell {
    double value;
    std::optional<std::size_t> status;
  };
  std::vector<double> x;
  std::vector<double> y;
  std::vector<Cell> cells;
  while (table.next()) {
    Cell cell{std::numeric_limits<double>::quiet_NaN(),
              word(table, status, cell_status_names, "solved, none-exists, not-found or failed")};
    if (!out.of_class()) {
      cell.value = table.number(value);
    } else if (const auto verdict = word(table, value, stability_names,
                                         "stable, elliptic, unstable, oscillatory or marginal")) {
      cell.value = static_cast<double>(*verdict);
    }
    cells.push_back(cell);
    x.push_back(table.number(at_x));
    y.push_back(table.number(at_y));
    for (const std::size_t column : {at_x, at_y})
      if (!(std::abs(table.number(column)) <= largest_drawn))
        throw table.fault(column, "a number between -4e307 and 4e307");
  }
  if (cells.empty()) refuse_map(table, "found no rows", "a table with at least one");
  out.x = axis(table, parameters[0], x);
  out.y = axis(table, parameters[1], y);
  const std::size_t size = out.x.values.size() * out.y.values.size();
  if (size > most_map_cells) refuse_map(table, "found values that make up no grid", "a map's");
  out.values.assign(size, std::numeric_limits<double>::quiet_NaN());
  out.statuses.assign(size, std::nullopt);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::size_t place = index(out.y, y[k]) * out.x.values.size() + index(out.x, x[k]);
    out.values[place] = cells[k].value;
    if (cells[k].status) out.statuses[place] = static_cast<CellStatus>(*cells[k].status);
  }
  return out;
}

MapDiagram read_curve_diagram(const std::vector<TableReader*>& tables) {
  MapDiagram out;
  const std::vector<std::string> own = curve_parameters(tables.front()->columns());
  if (own.size() != 2) refuse_map(*tables.front(), "found no table of curve", "a table of curve");
  out.x.parameter = own[0];
  out.y.parameter = own[1];
  for (TableReader* const table : tables)
    std::ranges::move(read_event_lines(*table, own[0], own[1]), std::back_inserter(out.lines));
  std::array<std::vector<double>, 2> all;
  for (const EventLine& line : out.lines)
    for (const auto& point : line.points)
      for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) all[k].push_back(point[k]);
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    if (all[k].empty()) refuse_map(*tables.front(), "found no rows", "a curve");
    const auto [low, high] = std::ranges::minmax(all[k]);
    const double room = high > low ? 0.04 * (high - low) : std::max(0.04 * std::abs(high), 1e-6);
    const AxisRange shown = drawable({low - room, high + room}, false);
    (k == 0 ? out.x : out.y).values = {shown.low, shown.high};
  }
  return out;
}

}  // namespace stationary
