// Where a command's table goes: a file with its metadata beside it, or standard output. A file is
// CSV or HDF5 by its suffix; a device or a pipe takes CSV.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/program/rows/metadata.hpp"
#include "solver/program/rows/table_target.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "solver/program/table/cell_table.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/table/parallel_table.hpp"

namespace stationary::cli {

class TableOutput final : public TableTarget {
 public:
  /// path as after -o; "-" is standard output. threads: that make rows into text.
  TableOutput(std::string path, std::string case_path, int threads = 1)
      : path_(std::move(path)), case_path_(std::move(case_path)), threads_(threads) {}

  /// Throws InputError for another suffix, if it cannot be written, or if it would replace the case
  /// file.
  void prepare() override;
  RowSink& open(const std::vector<Column>& columns, const std::vector<std::string>& parameters = {},
                std::optional<std::size_t> rows = std::nullopt) override;
  CellTable& open(std::vector<CellColumn> columns) override;
  /// Writes what is left and puts both files in place; before this nothing is.
  void commit(Metadata metadata) override;
  bool can_be_resumed() const override { return metadata_file_.has_value(); }
  /// The same with the metadata as texts: of the file beside it, and within HDF5 (without what
  /// depends on the run).
  void commit(const std::string& beside, const std::string& within, bool to_disk = false);

 private:
  std::string path_;
  std::string case_path_;
  int threads_;
  StandardOutput standard_output_;
  std::optional<AtomicFile> file_;
  std::optional<AtomicFile> metadata_file_;
  bool as_columns_ = false;  ///< HDF5
  std::optional<TableWriter> text_;
  std::optional<ParallelTableWriter> parallel_text_;
  std::optional<ColumnFileWriter> binary_;
  std::optional<CellTable> cells_;
};

}  // namespace stationary::cli
