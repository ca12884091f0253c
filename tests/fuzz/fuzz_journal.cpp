// Any bytes as the journal that --resume goes on with: what it takes for finished is read back, told
// from the rest, and more is added behind it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "solver/program/text/input_error.hpp"
#include "solver/program/tiles/journal.hpp"

namespace {

using namespace stationary;

/// A folder of its own, in memory where the system has one there.
class Folder {
 public:
  Folder() {
    const std::filesystem::path shared = "/dev/shm";
    std::string name =
        ((std::filesystem::exists(shared) ? shared : std::filesystem::temp_directory_path()) /
         "journal-XXXXXX")
            .string();
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string table() const { return path_ + "/x.csv"; }

 private:
  std::string path_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Folder folder;
  const std::string table = folder.table();
  const std::string journal = table + ".journal";
  std::ofstream(journal, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  constexpr std::size_t tiles = 64;
  try {
    std::size_t known = 0;
    {
      cli::Journal resumed(table, "0123456789abcdef", true);
      known = resumed.known();
      std::size_t kept = 0;
      for (std::size_t k = 0; k < tiles; ++k) kept += resumed.read(k).has_value();
      if (kept > known) std::abort();
      if (resumed.has(tiles)) return 0;
      resumed.add(tiles, "a row\n");
    }
    const cli::Journal again(table, "0123456789abcdef", true);
    if (again.known() != known + 1 || again.read(tiles) != "a row\n") std::abort();
  } catch (const InputError&) {
  } catch (const std::runtime_error&) {
  }
  return 0;
}
