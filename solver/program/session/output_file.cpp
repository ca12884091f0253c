#include "solver/program/session/output_file.hpp"

#include <fmt/format.h>

#include <system_error>

#include "solver/program/table/column_file.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::cli {

void refuse_output(const std::string& path, const std::string& found, const std::string& remedy,
                   std::string_view option) {
  throw InputError(Origin::of_option(std::string(option) + ' ' + path), "", found,
                   "a file that can be written", remedy);
}

void refuse_to_replace(const std::string& path, const std::filesystem::path& target,
                       const std::string& input, std::string_view what) {
  std::error_code error;
  if (std::filesystem::equivalent(target, input, error))
    refuse_output(path, fmt::format("{} is {}", printable(target.string()), what),
                  "choose another name");
}

void refuse_to_share(std::string_view option, const std::string& path,
                     const std::vector<std::filesystem::path>& others) {
  // Neither need exist yet.
  const auto place = [](const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
  };
  for (const std::filesystem::path& other : others)
    if (place(path) == place(other))
      refuse_output(path, fmt::format("{} is written by -o", printable(other.string())),
                    "choose another name", option);
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
