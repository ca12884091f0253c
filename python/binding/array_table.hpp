// A table in memory, in the layout of a NumPy structured array: one record a row, the CSV's columns
// in their order.
//
//   texts    as Unicode strings of the longest word's length, empty where nothing was computed
//   sheet, point   64-bit integers
//   numbers, and the counts that may be missing   doubles, NaN where nothing was computed
//
// A table with columns of any name (cell_table.hpp) is kept as its lines (cell_array.hpp).
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/program/rows/table_target.hpp"

namespace stationary::python {

struct RecordField {
  std::string name;
  std::string format;  ///< NumPy's
  std::size_t offset;
  std::size_t width;             ///< of a text, in characters
  std::optional<Column> column;  ///< none: a trailing parameter
};

class ArrayTable final : public TableTarget {
 public:
  /// Nothing is kept of a computation that was told to end.
  void keep_unless(const std::atomic<bool>& stop) { stop_ = &stop; }

  void prepare() override {}
  RowSink& open(const std::vector<Column>& columns, const std::vector<std::string>& parameters = {},
                std::optional<std::size_t> rows = std::nullopt) override;
  CellTable& open(std::vector<CellColumn> columns) override;
  void commit(Metadata metadata) override;

  /// Whether there is a table: a computation that fails has none.
  bool complete() const { return complete_; }
  /// The lines, of a table that has no records; else null.
  const CellTable* cells() const { return cells_ ? &*cells_ : nullptr; }
  const std::vector<RecordField>& fields() const { return fields_; }
  std::size_t record_size() const { return record_size_; }
  std::size_t rows() const { return records_.size() / record_size_; }
  /// Of all rows, one after the other.
  const std::byte* records() const { return records_.data(); }
  /// The text of x.meta.json.
  const std::string& metadata() const { return metadata_; }

  /// All of it, as another process takes it: columns and cell_columns by name, one of them empty.
  struct Contents {
    std::vector<std::string> columns;
    std::vector<std::string> parameters;
    std::optional<std::size_t> expected;
    std::vector<std::pair<std::string, int>> cell_columns;  ///< with their kinds
    std::string bytes;                                      ///< records, or lines
    std::string metadata;
    std::string lasting_metadata;
    bool complete;
  };
  Contents contents() const;
  void restore(const Contents& of);

  /// As the program writes it, with the metadata beside. Throws InputError where it cannot, or would
  /// replace the case file.
  void write(const std::string& path, const std::string& case_path) const;
  /// The rows alone.
  void write(RowSink& sink) const;
  /// As CSV.
  std::string csv() const;

 private:
  class Sink;
  void put(const TableRow& row);

  std::vector<Column> columns_;
  std::vector<std::string> parameters_;
  std::optional<std::size_t> expected_;
  std::vector<RecordField> fields_;
  std::size_t record_size_ = 1;
  std::vector<std::byte> records_;
  std::shared_ptr<Sink> sink_;
  std::optional<CellTable> cells_;
  const std::atomic<bool>* stop_ = nullptr;
  bool complete_ = false;
  std::string metadata_;
  std::string lasting_metadata_;  ///< without what depends on the run
};

}  // namespace stationary::python
