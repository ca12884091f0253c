// Rows of a table (table.hpp) as bytes of one length each, for a journal or another process, and back:
//
//   texts     a byte: the number of the word among those of its column (column_file.hpp)
//   counts    32-bit integers, missing_count where nothing was computed
//   numbers   64-bit floating point, and so the trailing parameters
//
// The bytes are those of this machine: a journal is read where it was written.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/table/table.hpp"

namespace stationary {

class RowPack {
 public:
  /// parameters: how many trailing columns there are, at most 2.
  RowPack(const std::vector<Column>& columns, std::size_t parameters);

  std::size_t row_size() const { return row_size_; }
  void add(const TableRow& row, std::string& out) const;
  /// The row that row_size() bytes are of. Its other cells are as they were.
  void read(const char* bytes, TableRow& row) const;

 private:
  struct Part {
    Column column;
    CellKind kind;
    std::vector<std::string_view> words;  ///< of a text
  };
  std::vector<Part> parts_;
  std::size_t parameters_;
  std::size_t row_size_;
};

}  // namespace stationary
