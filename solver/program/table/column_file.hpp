// A table (table.hpp) as an HDF5 file: one dataset a column, all of one length, in the order in
// which they were created; the parameters' columns under their dotted keys. h5py, h5dump and MATLAB
// read it.
//
//   numbers   64-bit floating point, NaN where nothing was computed
//   counts    32-bit integers, missing_count where nothing was computed
//   texts     enumerations of 8 bits, by the words of the column; "" where nothing was computed
//
// Attributes of the file: "columns" (their names in order) and "metadata" (the text of the
// .meta.json). Of numbers that were read from a table (cell_table.hpp) and are not spelled there as this
// program spells them, the dataset's attribute "spelling" has the texts, a line each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/table/table.hpp"
#include "solver/program/table/table_reader.hpp"

namespace stationary {

constexpr std::int32_t missing_count = INT32_MIN;
constexpr const char* spelling_attribute = "spelling";

/// The words a column of texts may hold; "" is one of all of them. Throws std::invalid_argument for
/// one without words of its own.
std::vector<std::string_view> column_words(Column c);

/// .h5 or .hdf5, with the dot.
bool is_column_file_extension(std::string_view extension);

/// Which HDF5 this program has, "1.10.8"; empty where it was built without: then nothing of what
/// follows but is_column_file() does anything but throw.
std::string hdf5_version();
constexpr std::string_view no_hdf5 = "this program was built without HDF5";

class ColumnFileWriter final : public RowSink {
 public:
  /// Creates the file, or empties it; rows: how many are expected where that is known, for the
  /// datasets' layout.
  /// Throws std::runtime_error where it cannot, here and below; std::invalid_argument for a column
  /// of texts without words of its own.
  ColumnFileWriter(const std::string& path, const std::vector<Column>& columns,
                   const std::vector<std::string>& parameters,
                   std::optional<std::size_t> rows = std::nullopt);
  ~ColumnFileWriter() override;

  /// Writes what is left and the metadata, and closes. Without it the file is not complete.
  void finish(const std::string& metadata);

 private:
  friend class TablesFile;
  struct Data;
  ColumnFileWriter(Data data, const std::vector<Column>& columns,
                   const std::vector<std::string>& parameters, std::optional<std::size_t> rows);
  void put(const TableRow& row, TableChecksum& sum) override;

  std::unique_ptr<Data> data_;
};

/// An HDF5 file of several tables, a group each, which has the datasets and attributes that a file of one
/// table has.
class TablesFile {
 public:
  /// Creates the file. Throws std::runtime_error, here and below.
  explicit TablesFile(const std::string& path);
  ~TablesFile();

  /// An empty table of this name, finished before the next is begun.
  std::unique_ptr<ColumnFileWriter> table(const std::string& name,
                                          const std::vector<Column>& columns, std::size_t rows);
  void finish(const std::string& metadata);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Whether a file begins with HDF5's signature; false where it cannot be read, and of a pipe, whose
/// beginning can be read only once.
bool is_column_file(const std::string& path);

/// Those of the wanted columns that the file has (all of its columns if none is named), as CSV for
/// TableReader. Throws InputError where it is no file of ColumnFileWriter's.
std::unique_ptr<std::istream> column_file_table(const std::string& path,
                                                std::span<const std::string> wanted);

/// A table of HDF5 or of CSV, whichever the file is. Throws InputError.
TableReader open_table(const std::string& path);

/// The metadata of a table: its own, or those of the file beside it; empty where there are none.
std::string table_metadata(const std::string& path);

/// Whether a file is one of TablesFile's.
bool is_tables_file(const std::string& path);

/// The tables of such a file, by their names.
class TablesReader {
 public:
  /// Throws InputError, here and below.
  explicit TablesReader(const std::string& path);
  ~TablesReader();

  /// As CSV, for TableReader.
  std::unique_ptr<std::istream> table(const std::string& name) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Its metadata; empty where it has none, or is no such file.
std::string column_file_metadata(const std::string& path);

}  // namespace stationary
