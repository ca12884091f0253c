// Any text as what --resume reads: metadata (JSON), an empty line, a table; a text without an empty
// line is a table alone. Its columns are whatever its header names.
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/metadata_reading.hpp"
#include "solver/program/rows/resume_table.hpp"
#include "solver/program/table/table_reader.hpp"

namespace {

using namespace stationary;

/// A file without a name, which has a path all the same; one for all inputs.
class Scratch {
 public:
  Scratch() : descriptor_(::memfd_create("table", 0)) {
    if (descriptor_ < 0) std::abort();
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { ::close(descriptor_); }

  std::string holding(std::string_view text) const {
    if (::ftruncate(descriptor_, 0) != 0 ||
        ::pwrite(descriptor_, text.data(), text.size(), 0) != static_cast<::ssize_t>(text.size()))
      std::abort();
    return "/proc/self/fd/" + std::to_string(descriptor_);
  }

 private:
  int descriptor_;
};

void read_metadata(std::string_view text) {
  static const Case input = read_case(STATIONARY_CASES "/disc.toml");
  (void)is_of_case(text, input);
  (void)curve_record(text);
  (void)case_title(text);
}

void read_table(std::string_view text) {
  static const Scratch scratch;
  const std::string path = scratch.holding(text);
  std::vector<Column> columns;
  std::optional<std::string> parameter;
  const std::vector<std::string> header = TableReader(path).columns();
  for (const std::string& name : header) {
    if (const auto column = find_column(name)) {
      columns.push_back(*column);
    } else {
      parameter = name;
    }
  }
  for (const std::string_view branch : {"i", "tilted"})
    (void)read_resumed(path, columns, parameter, branch);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t gap = text.find("\n\n");
  if (gap != std::string_view::npos) read_metadata(text.substr(0, gap));
  try {
    read_table(gap == std::string_view::npos ? text : text.substr(gap + 2));
  } catch (const stationary::InputError&) {
  }
  return 0;
}
