// The file named after -o: refused with a reason before anything is computed, or opened.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/table/atomic_file.hpp"

namespace stationary::cli {

/// Throws InputError about "-o path", or another option; remedy may be empty.
[[noreturn]] void refuse_output(const std::string& path, const std::string& found,
                                const std::string& remedy, std::string_view option = "-o");

/// Refuses a target, of those "-o path", or another option, implies, that is the input; what says what that is.
void refuse_to_replace(const std::string& path, const std::filesystem::path& target,
                       const std::string& input, std::string_view what,
                       std::string_view option = "-o");

/// Refuses an image, a page or a script that would replace a table it is made of, or that table's metadata.
void refuse_to_replace_source(std::string_view option, const std::string& path,
                              const std::string& table);

/// Refuses a table after -o that is the table of an input, or that would replace its metadata: x.h5 and
/// x.csv have the same x.meta.json.
void refuse_to_replace_table(const std::string& path, const std::string& input,
                             std::string_view what);

/// Refuses a table after -o whose metadata would replace those of another table that was interrupted.
void refuse_to_forget(const std::string& path);

/// Refuses the file of an option that is one of those that -o writes.
void refuse_to_share(std::string_view option, const std::string& path,
                     const std::vector<std::filesystem::path>& others);

/// Refuses a table whose name says neither CSV nor HDF5.
void require_table_suffix(const std::string& path, std::string_view option = "-o");

/// Refuses a target of HDF5 where the program was built without.
void require_hdf5_for(const std::string& path, std::string_view option = "-o");

/// Opens it, or refuses.
void open_output(std::optional<AtomicFile>& file, const std::string& path,
                 std::string_view option = "-o");

}  // namespace stationary::cli
