#include "solver/cli/table_output.hpp"

#include <filesystem>

#include "solver/cli/output_file.hpp"
#include "solver/input_error.hpp"

namespace stationary::cli {
namespace fs = std::filesystem;

TableOutput::TableOutput(const std::string& path, const std::string& case_path) : path_(path) {
  if (path == "-") return;
  const fs::path metadata = metadata_path(path);
  for (const fs::path& target : {fs::path(path), metadata})
    refuse_to_replace(path, target, case_path, "the case file");
  open_output(file_, path);
  if (!file_->is_regular()) return;  // nothing stands beside a device
  try {
    metadata_file_.emplace(metadata);
  } catch (const UnwritableFile& reason) {
    refuse_output(
        path, "cannot write " + printable(metadata.string()) + " beside it: " + reason.what(), {});
  }
}

std::string TableOutput::file_to_write() const {
  if (!file_ || !file_->is_regular())
    refuse_output(path_, "found no regular file, which HDF5 needs", {});
  return file_->path().string();
}

void TableOutput::commit(const Metadata& metadata) {
  if (metadata_file_) metadata_file_->write(metadata_json(metadata));
  if (file_) file_->commit();
  if (metadata_file_) metadata_file_->commit();
}

}  // namespace stationary::cli
