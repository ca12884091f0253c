// In the place of column_file.cpp, column_file_reader.cpp and cell_table_file.cpp where the program is built without
// HDF5: such files are refused.
#include <stdexcept>

#include "solver/program/table/cell_table.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary {
namespace {

[[noreturn]] void refuse_to_write() { throw std::runtime_error(std::string(no_hdf5)); }

[[noreturn]] void refuse_to_read(const std::string& path) {
  throw InputError(Origin::in_file(path), "", "found an HDF5 file; " + std::string(no_hdf5), "CSV");
}

}  // namespace

std::string hdf5_version() { return {}; }

bool is_tables_file(const std::string& path) {
  if (is_column_file(path)) refuse_to_read(path);
  return false;
}

std::unique_ptr<std::istream> column_file_table(const std::string& path,
                                                std::span<const std::string>) {
  refuse_to_read(path);
}

std::string column_file_metadata(const std::string& path) { refuse_to_read(path); }

struct ColumnFileWriter::Data {};
ColumnFileWriter::ColumnFileWriter(const std::string&, const std::vector<Column>& columns,
                                   const std::vector<std::string>& parameters,
                                   std::optional<std::size_t>)
    : RowSink(columns, parameters.size()) {
  refuse_to_write();
}
ColumnFileWriter::~ColumnFileWriter() = default;
void ColumnFileWriter::finish(const std::string&) { refuse_to_write(); }
void ColumnFileWriter::put(const TableRow&, TableChecksum&) { refuse_to_write(); }

struct TablesFile::Data {};
TablesFile::TablesFile(const std::string&) { refuse_to_write(); }
TablesFile::~TablesFile() = default;
std::unique_ptr<ColumnFileWriter> TablesFile::table(const std::string&, const std::vector<Column>&,
                                                    std::size_t) {
  refuse_to_write();
}
void TablesFile::finish(const std::string&) { refuse_to_write(); }

struct TablesReader::Data {};
TablesReader::TablesReader(const std::string& path) { refuse_to_read(path); }
TablesReader::~TablesReader() = default;
std::unique_ptr<std::istream> TablesReader::table(const std::string& name) const {
  refuse_to_read(name);
}

void CellTable::finish(const std::string&, const std::string&) const { refuse_to_write(); }

}  // namespace stationary
