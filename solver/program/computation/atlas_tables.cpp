#include "solver/program/computation/atlas_tables.hpp"

#include <filesystem>

#include "solver/program/session/output_file.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace {

TableRow unpacked(const RowPack& pack, std::string_view bytes) {
  TableRow out;
  pack.read(bytes.data(), out);
  return out;
}

}  // namespace

AtlasTables::AtlasTables(const std::string& path, const std::string& case_path,
                         const std::vector<Column>& columns)
    : columns_(columns) {
  if (path.empty()) return;
  const std::string suffix = std::filesystem::path(path).extension().string();
  if (!is_column_file_extension(suffix))
    refuse_output(path, "found the suffix " + in_quotes(suffix), "HDF5: .h5 or .hdf5", "--tables");
  require_hdf5_for(path, "--tables");
  refuse_to_replace(path, path, case_path, "the case file");
  open_output(file_, path, "--tables");
  tables_.emplace(file_->path().string());
}

void AtlasTables::add(std::size_t cell, const RowPack& pack, std::string_view rows) {
  if (!tables_) return;
  std::vector<TableRow> each;
  for (; !rows.empty(); rows.remove_prefix(pack.row_size())) each.push_back(unpacked(pack, rows));
  add(cell, each);
}

void AtlasTables::add(std::size_t cell, const std::vector<TableRow>& rows) {
  if (!tables_) return;
  const auto table = tables_->table(std::to_string(cell + 1), columns_, rows.size());
  for (const TableRow& each : rows) table->write(each);
  rows_ += rows.size();
  checksum_.add(table->checksum().text());
  table->finish({});
}

void AtlasTables::commit(Metadata metadata) {
  if (!tables_) return;
  metadata.rows = rows_;
  metadata.checksum = checksum_.text();
  tables_->finish(metadata_json(metadata, /*of_the_run=*/false));
  file_->commit();
}

void merge_tables(const std::vector<PartTable>& parts, const std::vector<std::string>& paths,
                  const std::vector<Column>& columns, AtlasTables& out) {
  const std::vector<PartTable> files = read_parts(paths, "atlas");
  const PartRecord& one = files.front().metadata.part;
  if (one.of != parts.front().metadata.part.of || one.work != parts.front().metadata.part.work)
    throw InputError(Origin::of_option("--merge " + files.front().path), "",
                     "found tables of other parts than " + parts.front().path,
                     "what --part K/N wrote after -o and --tables, of one run");
  for (std::size_t k = 0; k < files.size(); ++k) {
    const TablesReader file(files[k].path);
    const std::size_t first = parts[k].metadata.part.first_row;
    std::size_t rows = 0;
    TableChecksum checksum;
    for (std::size_t cell = first; cell < first + parts[k].metadata.rows; ++cell) {
      TableReader table(file.table(std::to_string(cell + 1)), files[k].path);
      std::vector<TableRow> read;
      TableChecksum of_table;
      read_table(table, columns, {}, [&](const TableRow& row) {
        of_table.add(row, columns, 0);
        read.push_back(row);
      });
      checksum.add(of_table.text());
      rows += read.size();
      out.add(cell, read);
    }
    require_whole(files[k], rows, checksum);
  }
}

}  // namespace stationary::cli
