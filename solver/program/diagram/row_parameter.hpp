// The parameter of each row of a table, and what it is called.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/table/table.hpp"
#include "solver/program/table/table_reader.hpp"

namespace stationary {

using ColumnPlace = std::optional<std::size_t>;

template <std::size_t n>
std::array<ColumnPlace, n> places(const TableReader& table, const std::array<Column, n>& columns) {
  std::array<ColumnPlace, n> out;
  for (std::size_t k = 0; k < n; ++k) out[k] = table.column(name(columns[k]));
  return out;
}

/// Whether a column is of a number of the case by its name, wherever it stands: a key that may be set, a ratio
/// of two, or nu.
bool is_parameter(std::string_view column);
/// Those of these columns, in their order.
std::vector<std::string> parameters_among(const std::vector<std::string>& columns);

class RowParameter {
 public:
  explicit RowParameter(const TableReader& table);

  /// Of this row, of that branch. Throws InputError where the table has none.
  double value(std::string_view branch) const;
  /// As an axis is named; of no branch, of the first.
  std::string symbol(std::string_view branch) const;

 private:
  double need(ColumnPlace column, Column c, std::string_view branch) const;

  const TableReader* table_;
  std::optional<std::size_t> key_;
  std::array<ColumnPlace, 3> nu_;
  ColumnPlace omega_;
};

}  // namespace stationary
