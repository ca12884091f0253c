// Where a command's table goes: a file with its metadata beside it, or standard output.
#pragma once

#include <optional>
#include <string>

#include "solver/atomic_file.hpp"
#include "solver/metadata.hpp"

namespace stationary::cli {

class TableOutput {
 public:
  /// path as after -o; "-" is standard output. Throws InputError if it cannot be written, or if it
  /// would replace the case file.
  TableOutput(const std::string& path, const std::string& case_path);

  ByteSink& sink() { return file_ ? static_cast<ByteSink&>(*file_) : standard_output_; }
  /// For a library that writes a file by its name: the one that commit() puts in place. Throws
  /// InputError where there is none (standard output, a device).
  std::string file_to_write() const;
  /// Puts both files in place; before this nothing is.
  void commit(const Metadata& metadata);

 private:
  std::string path_;
  StandardOutput standard_output_;
  std::optional<AtomicFile> file_;
  std::optional<AtomicFile> metadata_file_;
};

}  // namespace stationary::cli
