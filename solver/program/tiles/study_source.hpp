// The table that a study runs over: a column for each key of the case that its rows set, and columns
// whose names begin with "_", which are carried through.
//
//   _material,potential.plane.mu,potential.plane.lambda
//   steel,0.82,1.21
//
// An empty cell leaves the case's own value. A cell is what stands after --set KEY=; of a key that takes
// a text it is that text, quoted or not, and True and False are true and false.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/table/cell_table.hpp"
#include "solver/program/table/table_reader.hpp"

namespace stationary::cli {

/// A cell of a key's column as a value of TOML, one that is not empty.
std::string toml_value(const std::string& key, const std::string& cell);

/// Whether all of a cell is a number.
bool is_number(std::string_view cell);

class StudySource {
 public:
  /// CSV or HDF5. Throws InputError: no such table, no rows, a column that names no key of a case.
  explicit StudySource(const std::string& path);
  /// Of a table at hand; path: what messages call it.
  StudySource(TableReader table, std::string path);

  const std::string& path() const { return path_; }
  std::size_t rows() const { return rows_.size(); }
  /// Numbers where every cell is one or empty.
  const std::vector<CellColumn>& columns() const { return columns_; }
  bool has_column(std::string_view key) const;
  /// Whether a cell of the key is this text.
  bool has(std::string_view key, std::string_view cell) const;

  /// What row k sets, each at its place in the table.
  std::vector<Override> overrides(std::size_t k) const;
  /// Its cells as they were, as CSV.
  std::string cells(std::size_t k) const;
  /// All of it, to be told from another.
  std::string text() const;

 private:
  struct Cell {
    std::string text;
    Origin place;
  };

  std::string path_;
  std::vector<std::string> names_;
  std::vector<CellColumn> columns_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace stationary::cli
