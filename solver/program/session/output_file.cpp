#include "solver/program/session/output_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <system_error>

#include "solver/program/rows/metadata_reading.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace fs = std::filesystem;

void refuse_output(const std::string& path, const std::string& found, const std::string& remedy,
                   std::string_view option) {
  throw InputError(Origin::of_option(std::string(option) + ' ' + path), "", found,
                   "a file that can be written", remedy);
}

void refuse_to_replace(const std::string& path, const fs::path& target, const std::string& input,
                       std::string_view what, std::string_view option) {
  std::error_code error;
  if (fs::equivalent(target, input, error))
    refuse_output(path, fmt::format("{} is {}", printable(target.string()), what),
                  "choose another name", option);
}

void refuse_to_replace_source(std::string_view option, const std::string& path,
                              const std::string& table) {
  refuse_to_replace(path, path, table, "the table", option);
  refuse_to_replace(path, path, metadata_path(table).string(), "the metadata of the table", option);
}

void refuse_to_replace_table(const std::string& path, const std::string& input,
                             std::string_view what) {
  for (const fs::path& target : {fs::path(path), metadata_path(path)})
    refuse_to_replace(path, target, input, what);
  refuse_to_replace(path, metadata_path(path), metadata_path(input),
                    fmt::format("the metadata of {}, {}", printable(input), what));
}

void refuse_to_forget(const std::string& path) {
  const fs::path metadata = metadata_path(path);
  if (std::error_code none; !fs::is_regular_file(metadata, none)) return;
  std::ifstream file(metadata, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!is_to_be_gone_on_with(text)) return;
  // They are of the table that was written last.
  fs::path owner;
  fs::file_time_type last;
  for (const char* const suffix : {"", ".csv", ".h5", ".hdf5"}) {
    std::error_code none;
    const fs::path table = fs::path(path).replace_extension(suffix);
    // One of many tables has no metadata beside it.
    if (!fs::is_regular_file(table, none) || is_tables_file(table.string())) continue;
    const fs::file_time_type time = fs::last_write_time(table, none);
    if (none || (!owner.empty() && time <= last)) continue;
    owner = table;
    last = time;
  }
  if (owner.empty() || owner == path) return;
  refuse_output(path,
                fmt::format("{} is that of {}, which is not whole yet",
                            printable(metadata.string()), printable(owner.string())),
                "choose another name, or go on with that table by --resume, or remove it");
}

void refuse_to_share(std::string_view option, const std::string& path,
                     const std::vector<fs::path>& others) {
  // Neither need exist yet.
  const auto place = [](const fs::path& file) {
    std::error_code error;
    return fs::weakly_canonical(fs::absolute(file, error), error);
  };
  for (const fs::path& other : others)
    if (place(path) == place(other))
      refuse_output(path, fmt::format("{} is written by -o", printable(other.string())),
                    "choose another name", option);
}

void require_table_suffix(const std::string& path, std::string_view option) {
  const std::string suffix = fs::path(path).extension().string();
  if (suffix.empty() || suffix == ".csv") return;
  if (is_column_file_extension(suffix)) return require_hdf5_for(path, option);
  throw InputError(Origin::of_option(std::string(option) + ' ' + path), "",
                   "found the suffix " + in_quotes(suffix),
                   ".csv or none for CSV, .h5 or .hdf5 for HDF5");
}

void require_hdf5_for(const std::string& path, std::string_view option) {
  if (hdf5_version().empty())
    refuse_output(path, std::string(no_hdf5), "write CSV: a name that ends in .csv", option);
}

void open_output(std::optional<AtomicFile>& file, const std::string& path,
                 std::string_view option) {
  try {
    file.emplace(path);
  } catch (const UnwritableFile& reason) {
    refuse_output(path, std::string("cannot write it: ") + reason.what(),
                  "check the directory and its permissions", option);
  }
}

}  // namespace stationary::cli
