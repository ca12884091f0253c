#include "python/binding/cell_array.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string_view>
#include <vector>

#include "solver/program/table/table_reader.hpp"

namespace stationary::python {
namespace py = pybind11;

namespace {

/// Numbers that no row lacks: of a study its row's, of curves of events the curve's and the point's.
bool is_whole(std::string_view name, bool of_study) {
  return of_study ? name == "study_row" : name == "curve" || name == "point";
}

template <class T>
py::array array(const std::vector<double>& values) {
  py::array_t<T> out(static_cast<py::ssize_t>(values.size()));
  std::ranges::transform(values, out.mutable_data(), [](double v) { return static_cast<T>(v); });
  return out;
}

/// A column while it is read.
struct Cells {
  CellColumn column;
  py::list texts;
  std::vector<double> numbers;

  void add(const TableReader& row, std::size_t k) {
    if (column.kind == CellKind::text) {
      const std::string_view cell = row.text(k);
      texts.append(py::str(cell.data(), cell.size()));
    } else {
      numbers.push_back(row.number(k));
    }
  }
  py::array array(bool of_study) const {
    if (column.kind == CellKind::text)
      return py::module_::import("numpy").attr("array")(texts, py::arg("dtype") = "U");
    if (is_whole(column.name, of_study)) return python::array<std::int64_t>(numbers);
    return python::array<double>(numbers);
  }
};

}  // namespace

py::array cell_array(const CellTable& table) {
  std::vector<Cells> cells;
  for (const CellColumn& each : table.columns()) cells.emplace_back().column = each;
  TableReader reader(std::make_unique<std::istringstream>(table.kept()), "the table");
  while (reader.next())
    for (std::size_t k = 0; k < cells.size(); ++k) cells[k].add(reader, k);
  py::list fields;
  std::vector<py::array> columns;
  for (const Cells& each : cells) {
    columns.push_back(each.array(cells.front().column.name == "study_row"));
    fields.append(py::make_tuple(each.column.name, columns.back().dtype()));
  }
  py::array out(py::dtype::from_args(fields), static_cast<py::ssize_t>(table.rows()));
  for (std::size_t k = 0; k < cells.size(); ++k)
    out.attr("__setitem__")(cells[k].column.name, columns[k]);
  return out;
}

}  // namespace stationary::python
