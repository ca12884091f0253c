// Runs the program as a user would: arguments in, exit code and both streams out.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace stationary::testing {

/// Of a command line.
using Words = std::vector<std::string>;

struct Outcome {
  int code = -1;  ///< exit code, or 128 + signal
  std::string out;
  std::string err;
};

/// How the child is to differ from a plain run.
struct RunOptions {
  int pending_signal = 0;                   ///< blocked and pending when the program starts
  int other_pending_signal = 0;             ///< likewise
  int kill_after_ms = -1;                   ///< SIGKILL after so long
  std::string interrupt_once_written = {};  ///< SIGINT when its temporary file holds something
  std::string standard_output = {};         ///< a file instead of a captured stream
  std::string directory = {};               ///< to run in
  long file_size_limit = -1;                ///< of each file it writes, in bytes
  std::vector<std::string> program =
      {};  ///< another one, by a path or a name, and its first arguments
  std::vector<std::string> environment = {};  ///< NAME=VALUE, beside what there is
};

/// A program under test: of the build that the variable of the environment names, else of the one that
/// compiled the tests.
const char* program_of(const char* variable, const char* compiled);
inline const char* program_path() { return program_of("STATIONARY_PROGRAM", STATIONARY_PROGRAM); }

Outcome run_program(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// A directory of its own, gone with the object.
class TemporaryDirectory {
 public:
  TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;
  ~TemporaryDirectory();

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }
  /// Writes a file in it and returns its path.
  std::string file(const std::string& name, const std::string& text) const;
  /// Names of what is in it, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

std::string text_of(const std::string& path);
std::vector<std::string> lines_of(const std::string& text);

/// A case of cases/, by its file's name.
inline std::string shipped(const std::string& name) {
  return std::string(STATIONARY_CASES "/") + name;
}

/// A valid case; the text the malformed ones are made of.
extern const char* const good_case;

}  // namespace stationary::testing
