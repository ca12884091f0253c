// Where a command's table goes: a file with its metadata beside it, or standard output. A file is
// CSV or HDF5 by its suffix; a device or a pipe takes CSV.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "solver/program/rows/metadata.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "solver/program/table/cell_table.hpp"
#include "solver/program/table/column_file.hpp"

namespace stationary::cli {

class TableOutput {
 public:
  /// path as after -o; "-" is standard output. Throws InputError for another suffix, if it cannot
  /// be written, or if it would replace the case file.
  TableOutput(const std::string& path, const std::string& case_path);

  /// What its rows go to. parameters: headers of the trailing columns; rows: how many are expected,
  /// where that is known.
  RowSink& open(const std::vector<Column>& columns, const std::vector<std::string>& parameters = {},
                std::optional<std::size_t> rows = std::nullopt);
  /// The same of a table with columns of any name.
  CellTable& open(std::vector<CellColumn> columns);
  /// Writes what is left and puts both files in place; before this nothing is. rows and checksum of
  /// the metadata are the table's.
  void commit(Metadata metadata);

 private:
  StandardOutput standard_output_;
  std::optional<AtomicFile> file_;
  std::optional<AtomicFile> metadata_file_;
  bool as_columns_ = false;  ///< HDF5
  std::optional<TableWriter> text_;
  std::optional<ColumnFileWriter> binary_;
  std::optional<CellTable> cells_;
};

}  // namespace stationary::cli
