// A file that is either there in full or not at all: written under a temporary name in the same
// directory, renamed at commit(), removed if that is never reached. Until then it is locked
// (file_lock.hpp): what a killed process left of the same file is not, and the next one removes it.
//
// What exists and is no regular file (a device, a pipe) is written directly; a link is followed. So is
// what an open descriptor's name (/dev/stdout, /dev/fd/3) stands for, a file too, from where it is.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "solver/program/table/table.hpp"

namespace stationary {

/// The target cannot be written; known before anything was. what() is the reason alone.
class UnwritableFile : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// N of /dev/fd/N, and of /dev/stdout and the like; nothing of other names.
std::optional<int> named_descriptor(const std::filesystem::path& path);

/// Whether a file of its own is or will be there: no device, pipe or descriptor.
bool is_regular_target(const std::filesystem::path& path);

class AtomicFile : public ByteSink {
 public:
  /// Opens the temporary file. Throws UnwritableFile.
  explicit AtomicFile(const std::filesystem::path& target);
  ~AtomicFile() override;

  /// Throws std::runtime_error naming the target, for instance on a full disk.
  void write(std::string_view bytes) override;
  /// to_disk: it survives a machine that loses its power.
  void commit(bool to_disk = false);

  /// The file written to until commit(), for a library that opens it by name.
  const std::filesystem::path& path() const { return is_regular() ? temporary_ : target_; }

  bool is_regular() const { return !temporary_.empty(); }

 private:
  [[noreturn]] void fail(std::string_view doing, int reason) const;

  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< empty: written directly, or committed
  int descriptor_ = -1;
};

/// Standard output; what is written is there at once.
class StandardOutput : public ByteSink {
 public:
  void write(std::string_view bytes) override;
};

/// All of a file; nothing of what cannot be read, as a directory.
std::optional<std::string> bytes_of_file(const std::filesystem::path& path);

/// x.meta.json beside x.csv.
std::filesystem::path metadata_path(const std::filesystem::path& table);

}  // namespace stationary
