#include "solver/program/table/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "solver/program/table/file_lock.hpp"

namespace stationary {
namespace {

namespace fs = std::filesystem;

/// Writes all of it; 0 or errno.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ::ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0) {
      if (errno == EINTR) continue;
      return errno;
    }
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

[[noreturn]] void refuse(int reason) { throw UnwritableFile(std::strerror(reason)); }

/// Whether it is the name of a temporary file for `target`: ".TARGET.PROCESS-ATTEMPT.tmp".
bool is_temporary(const std::string& name, const std::string& target) {
  const std::string before = "." + target + ".";
  constexpr std::string_view after = ".tmp";
  if (!name.starts_with(before) || !name.ends_with(after)) return false;
  const char* const end = name.data() + name.size() - after.size();
  ::pid_t process = 0;
  int attempt = 0;
  const auto first = std::from_chars(name.data() + before.size(), end, process);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != '-') return false;
  const auto second = std::from_chars(first.ptr + 1, end, attempt);
  return second.ec == std::errc() && second.ptr == end;
}

/// Removes what killed processes left of the same target. The process in the name tells nothing of a
/// file: it may be one of another machine or container. The lock does.
void clear_leftovers(const fs::path& target) {
  std::error_code error;
  const fs::path directory = target.has_parent_path() ? target.parent_path() : fs::path(".");
  fs::directory_iterator entries(directory, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    const fs::path& path = entries->path();
    if (!is_temporary(path.filename().string(), target.filename().string())) continue;
    const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (file < 0) continue;
    if (!lock_file(file) && is_at(file, path)) ::unlink(path.c_str());
    ::close(file);
  }
}

/// Locks a new temporary file; false where another run has taken it for a leftover before. On a file
/// system without locks nobody can.
bool is_kept(int descriptor, const fs::path& path) {
  (void)lock_file(descriptor);
  return is_at(descriptor, path);
}

constexpr mode_t all_may = 0666;  // less the umask

}  // namespace

std::optional<int> named_descriptor(const fs::path& path) {
  const std::string& name = path.native();
  constexpr std::string_view streams[] = {"/dev/stdin", "/dev/stdout", "/dev/stderr"};
  for (int k = 0; k < 3; ++k)
    if (name == streams[k]) return k;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    int out = 0;
    if (!name.starts_with(folder)) continue;
    const char* const end = name.data() + name.size();
    const auto [at, error] = std::from_chars(name.data() + folder.size(), end, out);
    if (error == std::errc() && at == end && out >= 0) return out;
  }
  return std::nullopt;
}

bool is_regular_target(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return !named_descriptor(path) && (!fs::exists(status) || fs::is_regular_file(status));
}

AtomicFile::AtomicFile(const fs::path& target) : target_(target) {
  if (target.empty()) throw UnwritableFile("the name is empty");
  if (const auto open = named_descriptor(target)) {
    descriptor_ = ::fcntl(*open, F_DUPFD_CLOEXEC, 0);
    if (descriptor_ < 0) refuse(errno);
    return;
  }
  struct ::stat status {};
  const bool exists = ::stat(target.c_str(), &status) == 0;
  const bool regular = !exists || S_ISREG(status.st_mode);
  // What a link to a pipe is called (/dev/stdout) is no path.
  if (std::error_code error; regular && fs::is_symlink(target, error)) {
    const fs::path followed = fs::canonical(target, error);
    if (error) throw UnwritableFile("a link that leads nowhere");
    target_ = followed;
  }
  if (exists && S_ISDIR(status.st_mode)) throw UnwritableFile("it is a directory");
  // A rename would replace a file protected against writing.
  if (exists && ::access(target_.c_str(), W_OK) != 0) refuse(errno);
  if (!regular) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) refuse(errno);
    return;
  }
  clear_leftovers(target_);
  // A name may be one of a killed run, or of a process of another machine with the same number.
  constexpr int attempts = 100;
  for (int k = 0; k < attempts && descriptor_ < 0; ++k) {
    temporary_ = target_.parent_path() /
                 fmt::format(".{}.{}-{}.tmp", target_.filename().string(), ::getpid(), k);
    descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, all_may);
    if (descriptor_ < 0 && errno != EEXIST) refuse(errno);
    if (descriptor_ >= 0 && !is_kept(descriptor_, temporary_)) {
      ::close(descriptor_);
      descriptor_ = -1;
    }
  }
  if (descriptor_ < 0) refuse(EEXIST);
  if (exists) (void)::fchmod(descriptor_, status.st_mode & 07777U);  // no loss where it fails
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::fail(std::string_view doing, int reason) const {
  throw std::runtime_error(
      fmt::format("{} {}: {}", doing, target_.string(), std::strerror(reason)));
}

void AtomicFile::write(std::string_view bytes) {
  if (const int reason = write_all(descriptor_, bytes)) fail("writing", reason);
}

void AtomicFile::commit(bool to_disk) {
  if (to_disk && is_regular() && ::fsync(descriptor_) != 0) fail("flushing", errno);
  // What a network's file system fails at when a file is closed. The lock stays until it has its name.
  const int copy = ::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0);
  if (copy < 0 || ::close(copy) != 0) fail("closing", errno);
  if (is_regular() && ::rename(temporary_.c_str(), target_.c_str()) != 0)
    fail("renaming to", errno);
  temporary_.clear();
  ::close(descriptor_);
  descriptor_ = -1;
}

void StandardOutput::write(std::string_view bytes) {
  if (const int reason = write_all(STDOUT_FILENO, bytes))
    throw std::runtime_error(fmt::format("writing standard output: {}", std::strerror(reason)));
}

std::optional<std::string> bytes_of_file(const std::filesystem::path& path) {
  if (std::error_code none; std::filesystem::is_directory(path, none)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

fs::path metadata_path(const fs::path& table) {
  fs::path out = table;
  return out.replace_extension(".meta.json");
}

}  // namespace stationary
