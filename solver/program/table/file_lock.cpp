#include "solver/program/table/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace stationary {
namespace {

/// Options of mounts whose locks other machines do not see: NFS', Lustre's, CIFS' and GlusterFS'.
constexpr std::string_view local[] = {"nolock",     "local_lock=all", "local_lock=posix",
                                      "localflock", "nobrl",          "noflock"};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> out;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, at);) out.push_back(word);
  return out;
}

}  // namespace

std::optional<std::string> only_local_locks(std::string_view mounts, std::string_view device) {
  std::istringstream lines{std::string(mounts)};
  for (std::string line; std::getline(lines, line);) {
    // "36 35 98:0 /mnt1 /mnt2 rw,noatime master:1 - nfs server:/export rw,nolock"
    const std::vector<std::string> words = split(line, ' ');
    const auto dash = std::ranges::find(words, "-");
    if (words.size() < 6 || words[2] != device || words.end() - dash < 4) continue;
    for (const std::string& options : {words[5], dash[3]})
      for (const std::string& each : split(options, ','))
        if (std::ranges::find(local, each) != std::end(local))
          return fmt::format(
              "its file system ({}, mounted {}) has no locks that other machines see", dash[1],
              each);
  }
  return std::nullopt;
}

std::optional<std::string> lock_file(int descriptor) {
  struct ::flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (::fcntl(descriptor, F_OFD_SETLK, &whole) != 0) {
    if (errno == EAGAIN || errno == EACCES) return "another run is writing it";
    return fmt::format("its file system has no locks ({})", std::strerror(errno));
  }
  struct ::stat status {};
  if (::fstat(descriptor, &status) != 0) return std::nullopt;
  std::ifstream file("/proc/self/mountinfo");
  const std::string mounts{std::istreambuf_iterator<char>(file), {}};
  return only_local_locks(mounts, fmt::format("{}:{}", major(status.st_dev), minor(status.st_dev)));
}

bool is_at(int descriptor, const std::string& path) {
  struct ::stat open {};
  struct ::stat there {};
  return ::fstat(descriptor, &open) == 0 && ::stat(path.c_str(), &there) == 0 &&
         open.st_ino == there.st_ino && open.st_dev == there.st_dev;
}

}  // namespace stationary
