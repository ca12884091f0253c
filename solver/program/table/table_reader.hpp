// Reads a table as table.hpp writes it, and what a spreadsheet makes of one: CSV after RFC 4180,
// one header row, LF or CRLF, quoted cells, an empty cell where nothing was computed. Numbers are
// read whatever the locale is.
//
// Rows are read one at a time and cells are looked up by the header's names:
//
//   TableReader table("x.csv");
//   const auto xi = table.column("xi");
//   while (table.next()) use(table.number(*xi));
//
// What is not such a table throws InputError with file, line and place in the line.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/text/input_error.hpp"

namespace stationary {

class TableReader {
 public:
  /// Opens the file and reads the header.
  explicit TableReader(const std::string& path);
  /// The same of a stream; name stands for the file in messages.
  TableReader(std::unique_ptr<std::istream> stream, std::string name);

  const std::string& name() const { return name_; }
  /// The header.
  const std::vector<std::string>& columns() const { return columns_; }
  std::optional<std::size_t> column(std::string_view name) const;

  /// Goes to the next row; false after the last.
  bool next();
  /// A cell of this row; valid until next().
  std::string_view text(std::size_t column) const { return cells_[column].text; }
  /// The same as a number, NaN where the cell is empty.
  double number(std::size_t column) const;
  /// Whether this row is an empty line, which an empty cell in quotes is not.
  bool is_empty_line() const { return record_.empty(); }
  /// What is wrong with a cell of this row, as an error that names its place.
  InputError fault(std::size_t column, std::string allowed) const;

 private:
  struct Cell {
    std::string_view text;
    std::size_t begin;  ///< in the record
  };

  void read_header();
  bool read_record();
  void split_record();
  [[noreturn]] void refuse(std::size_t at, std::string found, std::string allowed) const;
  Origin place(std::size_t at) const;

  std::unique_ptr<std::istream> stream_;
  std::string name_;
  std::vector<std::string> columns_;
  std::string record_;  ///< without its end; unquoted in place, so cells may be shorter than it
  std::vector<Cell> cells_;
  int line_ = 0;        ///< where the record begins
  int lines_read_ = 0;  ///< a quoted cell may hold more than one
};

/// Throws InputError of a table whose rows are no motions and no events: of study, sensitivity,
/// atlas --grid.
void require_drawable(const TableReader& table);

}  // namespace stationary
