#include "solver/program/table/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <system_error>

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

/// The process that made a temporary file of this name for `target`; none of any other name.
std::optional<::pid_t> maker(const std::string& name, const std::string& target) {
  const std::string before = "." + target + ".";
  constexpr std::string_view after = ".tmp";
  if (!name.starts_with(before) || !name.ends_with(after)) return std::nullopt;
  const char* const end = name.data() + name.size() - after.size();
  ::pid_t process = 0;
  int attempt = 0;
  const auto first = std::from_chars(name.data() + before.size(), end, process);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != '-') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, attempt);
  if (second.ec != std::errc() || second.ptr != end || process <= 0) return std::nullopt;
  return process;
}

/// Removes what killed processes left of the same target.
void clear_leftovers(const fs::path& target) {
  std::error_code error;
  const fs::path directory = target.has_parent_path() ? target.parent_path() : fs::path(".");
  fs::directory_iterator entries(directory, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    const auto process = maker(entries->path().filename().string(), target.filename().string());
    if (process && ::kill(*process, 0) != 0 && errno == ESRCH) {
      std::error_code ignored;
      fs::remove(entries->path(), ignored);
    }
  }
}

constexpr mode_t all_may = 0666;  // less the umask

}  // namespace

AtomicFile::AtomicFile(const fs::path& target) : target_(target) {
  if (target.empty()) throw UnwritableFile("the name is empty");
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
  // The process id alone may repeat one of a killed run, so names are tried until one is new.
  constexpr int attempts = 100;
  for (int k = 0; k < attempts && descriptor_ < 0; ++k) {
    temporary_ = target_.parent_path() /
                 fmt::format(".{}.{}-{}.tmp", target_.filename().string(), ::getpid(), k);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, all_may);
    if (descriptor_ < 0 && errno != EEXIST) refuse(errno);
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
  const int descriptor = descriptor_;
  descriptor_ = -1;
  if (::close(descriptor) != 0) fail("closing", errno);
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("renaming to", errno);
  temporary_.clear();
}

void StandardOutput::write(std::string_view bytes) {
  if (const int reason = write_all(STDOUT_FILENO, bytes))
    throw std::runtime_error(fmt::format("writing standard output: {}", std::strerror(reason)));
}

fs::path metadata_path(const fs::path& table) {
  fs::path out = table;
  return out.replace_extension(".meta.json");
}

}  // namespace stationary
