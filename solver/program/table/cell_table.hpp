// A table whose columns are known by name only: texts of any length beside numbers. Its rows come as
// lines of CSV, so that whoever makes them may keep them; what is written is these lines, or the same
// as HDF5 (column_file.hpp; texts as strings of one length).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/table/table.hpp"

namespace stationary {

struct CellColumn {
  std::string name;
  CellKind kind;
};

/// A cell as CSV has it: in quotes where it needs them.
std::string csv_cell(std::string_view text);

/// The header's line, with its end.
std::string csv_header(const std::vector<CellColumn>& columns);

/// The cells of rows as CSV has them, a line without its end.
class RowCells {
 public:
  explicit RowCells(const std::vector<Column>& columns) : writer_(text_, columns) {
    writer_.flush();  // the header
  }
  std::string of(const TableRow& row) {
    text_.bytes.clear();
    writer_.write(row);
    writer_.flush();
    text_.bytes.pop_back();
    return text_.bytes;
  }

 private:
  struct Text final : ByteSink {
    void write(std::string_view more) override { bytes += more; }
    std::string bytes;
  };
  Text text_;
  TableWriter writer_;
};

/// Rows by name, streamed as CSV.
class CellTable {
 public:
  /// sink: nullptr where the lines are kept, for finish().
  CellTable(ByteSink* sink, std::vector<CellColumn> columns);

  /// Whole lines, each with its end.
  void write(std::string_view lines);
  std::size_t rows() const { return rows_; }
  const TableChecksum& checksum() const { return checksum_; }
  const std::vector<CellColumn>& columns() const { return columns_; }
  /// As CSV, where it has no sink.
  const std::string& kept() const { return kept_; }
  /// Of lines that were kept: all of it as HDF5, created at path. Throws std::runtime_error.
  void finish(const std::string& path, const std::string& metadata) const;

 private:
  ByteSink* sink_;
  std::vector<CellColumn> columns_;
  std::string kept_;
  std::size_t rows_ = 0;
  TableChecksum checksum_;
};

}  // namespace stationary
