#include "solver/program/session/table_output.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "solver/program/session/output_file.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace fs = std::filesystem;

namespace {

/// Seconds of work after which a journal goes only when the table is on the disk.
constexpr double worth_a_flush = 10.0;

/// In HDF5 a name is a path: "a/b" is the dataset b in the group a, which is then no dataset.
void require_paths(const std::string& path, const std::vector<CellColumn>& columns) {
  const auto refuse = [&](const std::string& found) {
    throw InputError(Origin::of_option("-o " + path), "", found,
                     "names that HDF5 takes as paths of datasets",
                     "write CSV: a name that ends in .csv");
  };
  for (const CellColumn& each : columns) {
    const std::string within = '/' + each.name + '/';
    for (const char* part : {"//", "/./", "/../"})
      if (within.find(part) != std::string::npos)
        refuse("found the column " + in_quotes(each.name));
    for (const CellColumn& other : columns)
      if (other.name.starts_with(each.name + '/'))
        refuse(fmt::format("found the columns {} and {}", in_quotes(each.name),
                           in_quotes(other.name)));
  }
}

}  // namespace

void TableOutput::prepare() {
  const std::string& path = path_;
  if (path == "-") return;
  const bool regular = is_regular_target(path);
  if (regular) require_table_suffix(path);
  const fs::path metadata = metadata_path(path);
  for (const fs::path& target : {fs::path(path), metadata})
    refuse_to_replace(path, target, case_path_, "the case file");
  if (regular) refuse_to_forget(path);
  open_output(file_, path);
  if (!file_->is_regular()) return;  // nothing stands beside a device
  as_columns_ = is_column_file_extension(fs::path(path).extension().string());
  try {
    metadata_file_.emplace(metadata);
  } catch (const UnwritableFile& reason) {
    refuse_output(
        path, "cannot write " + printable(metadata.string()) + " beside it: " + reason.what(), {});
  }
}

RowSink& TableOutput::open(const std::vector<Column>& columns,
                           const std::vector<std::string>& parameters,
                           std::optional<std::size_t> rows) {
  if (as_columns_) return binary_.emplace(file_->path().string(), columns, parameters, rows);
  const auto header = [&](std::size_t k) {
    return k < parameters.size() ? std::optional(parameters[k]) : std::nullopt;
  };
  ByteSink& sink = file_ ? static_cast<ByteSink&>(*file_) : standard_output_;
  if (threads_ > 1) return parallel_text_.emplace(sink, columns, header(0), header(1), threads_);
  return text_.emplace(sink, columns, header(0), header(1));
}

CellTable& TableOutput::open(std::vector<CellColumn> columns) {
  if (as_columns_) require_paths(path_, columns);
  ByteSink& sink = file_ ? static_cast<ByteSink&>(*file_) : standard_output_;
  return cells_.emplace(as_columns_ ? nullptr : &sink, std::move(columns));
}

void TableOutput::commit(Metadata metadata) {
  const auto describe = [&metadata](const auto& table) {
    metadata.rows = table.rows();
    metadata.checksum = table.checksum().text();
  };
  if (text_) describe(*text_);
  if (parallel_text_) describe(*parallel_text_);
  if (binary_) describe(*binary_);
  if (cells_) describe(*cells_);
  commit(metadata_json(metadata),
         as_columns_ ? metadata_json(metadata, /*of_the_run=*/false) : std::string(),
         metadata.tiles && metadata.seconds > worth_a_flush);
}

void TableOutput::commit(const std::string& beside, const std::string& within, bool to_disk) {
  if (text_) text_->flush();
  if (parallel_text_) parallel_text_->flush();
  if (binary_) binary_->finish(within);
  if (cells_ && as_columns_) cells_->finish(file_->path().string(), within);
  if (metadata_file_) metadata_file_->write(beside);
  if (file_) file_->commit(to_disk);
  if (metadata_file_) metadata_file_->commit(to_disk);
}

}  // namespace stationary::cli
