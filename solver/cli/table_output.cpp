#include "solver/cli/table_output.hpp"

#include <filesystem>
#include <system_error>

#include "solver/input_error.hpp"

namespace stationary::cli {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const std::string& found,
                         const std::string& remedy) {
  throw InputError(Origin::of_option("-o " + path), "", found, "a file that can be written",
                   remedy);
}

}  // namespace

TableOutput::TableOutput(const std::string& path, const std::string& case_path) {
  if (path == "-") return;
  const fs::path metadata = metadata_path(path);
  for (const fs::path& target : {fs::path(path), metadata}) {
    std::error_code error;
    if (fs::equivalent(target, case_path, error))
      refuse(path, printable(target.string()) + " is the case file", "choose another name");
  }
  try {
    file_.emplace(path);
  } catch (const UnwritableFile& reason) {
    refuse(path, std::string("cannot write it: ") + reason.what(),
           "check the directory and its permissions");
  }
  if (!file_->is_regular()) return;  // nothing stands beside a device
  try {
    metadata_file_.emplace(metadata);
  } catch (const UnwritableFile& reason) {
    refuse(path, "cannot write " + printable(metadata.string()) + " beside it: " + reason.what(),
           {});
  }
}

void TableOutput::commit(const Metadata& metadata) {
  if (metadata_file_) metadata_file_->write(metadata_json(metadata));
  if (file_) file_->commit();
  if (metadata_file_) metadata_file_->commit();
}

}  // namespace stationary::cli
