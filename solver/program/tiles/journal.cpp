#include "solver/program/tiles/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "solver/program/table/atomic_file.hpp"
#include "solver/program/table/file_lock.hpp"
#include "solver/program/table/table.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace {

constexpr std::string_view title = "stationary journal 2 ";
/// Without the number of its format.
constexpr std::string_view kind = title.substr(0, title.find('2'));
/// A disk is slower than a map that is worth no journal.
constexpr std::chrono::seconds flush_every(10);
constexpr std::string_view mark = "tile ";

[[noreturn]] void refuse(std::string found, std::string remedy) {
  throw InputError(Origin::of_option("--resume"), "", std::move(found),
                   "-o FILE, a table that this command was interrupted in", std::move(remedy));
}

/// A file's bytes in memory while it lives.
class Mapped {
 public:
  Mapped(int file, std::size_t size) : size_(size) {
    if (size > 0) at_ = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (at_ == MAP_FAILED) throw std::runtime_error(std::strerror(errno));
  }
  Mapped(const Mapped&) = delete;
  Mapped& operator=(const Mapped&) = delete;
  ~Mapped() {
    if (size_ > 0) ::munmap(at_, size_);
  }
  std::string_view text() const { return {static_cast<const char*>(at_), size_}; }

 private:
  std::size_t size_;
  void* at_ = nullptr;
};

/// CRC-32 of the work, a record's line before it, and its bytes.
std::string checksum(std::string_view hash, std::string_view line, std::string_view bytes) {
  uLong out = 0;
  for (const std::string_view each : {hash, line, bytes})
    out = crc32_z(out, reinterpret_cast<const Bytef*>(each.data()), each.size());
  return fmt::format("{:08x}", out);
}

/// "tile NUMBER BYTES MICROSECONDS CHECKSUM".
struct Head {
  std::size_t tile = 0;
  std::size_t bytes = 0;
  std::string_view line;  ///< up to the checksum
  std::string_view checksum;
};
std::optional<Head> head(std::string_view text) {
  if (!text.starts_with(mark)) return std::nullopt;
  Head out;
  std::size_t micros = 0;
  const char* at = text.data() + mark.size();
  const char* const end = text.data() + text.size();
  for (std::size_t* number : {&out.tile, &out.bytes, &micros}) {
    const auto read = std::from_chars(at, end, *number);
    if (read.ec != std::errc() || read.ptr == end || *read.ptr != ' ') return std::nullopt;
    at = read.ptr + 1;
  }
  out.line = text.substr(0, static_cast<std::size_t>(at - text.data()));
  out.checksum = text.substr(out.line.size());
  return out;
}

/// A whole record of the work.
struct Record {
  std::size_t tile = 0;
  std::size_t begin = 0;  ///< of its bytes
  std::size_t bytes = 0;
};
std::optional<Record> record_at(std::string_view text, std::size_t at, std::string_view hash) {
  const std::size_t end = text.find('\n', at);
  if (end == std::string_view::npos) return std::nullopt;
  const auto found = head(text.substr(at, end - at));
  if (!found || text.size() - (end + 1) <= found->bytes) return std::nullopt;
  if (text[end + 1 + found->bytes] != '\n') return std::nullopt;
  if (checksum(hash, found->line, text.substr(end + 1, found->bytes)) != found->checksum)
    return std::nullopt;
  return Record{found->tile, end + 1, found->bytes};
}

std::string first_line(std::string_view hash) { return fmt::format("{}{}\n", title, hash); }

/// How many a journal of this work has before the first that is not whole.
std::size_t records(std::string_view text, std::string_view hash) {
  const std::string first = first_line(hash);
  if (!text.starts_with(first)) return 0;
  std::size_t out = 0;
  for (std::size_t at = first.size(); const auto found = record_at(text, at, hash); ++out)
    at = found->begin + found->bytes + 1;
  return out;
}

}  // namespace

bool has_journal(const std::string& table) {
  return !table.empty() && table != "-" && is_regular_target(table);
}

std::string hash_of(std::initializer_list<std::string_view> texts) {
  TableChecksum out;
  for (const std::string_view each : texts) out.add(each);
  return out.text();
}

Journal::Journal(const std::string& table, const std::string& hash, bool resume)
    : path_(table + ".journal"), hash_(hash) {
  if (resume && (table.empty() || table == "-")) refuse("found no file", "name the table after -o");
  try {
    open(table, resume);
    if (resume) take_in();
  } catch (...) {
    if (file_ >= 0) ::close(file_);
    throw;
  }
}

Journal::~Journal() {
  if (file_ < 0) return;
  if (!begun_ && end_ == 0) ::unlink(path_.c_str());  // before the lock goes
  ::close(file_);
}

void Journal::begin() {
  if (begun_) return;
  if (const std::size_t lost = records(Mapped(file_, end_).text(), hash_); lost > 0)
    remarks_.push_back(
        fmt::format("{}: {} finished tiles of this work are discarded; --resume would have gone on "
                    "with them",
                    printable(path_), lost));
  empty();
}

void Journal::empty() {
  if (::ftruncate(file_, 0) != 0)
    throw std::runtime_error(fmt::format("emptying {}: {}", path_, std::strerror(errno)));
  end_ = 0;
  append(first_line(hash_));
  begun_ = true;
}

void Journal::open(const std::string& table, bool resume) {
  constexpr mode_t all_may = 0666;  // less the umask
  for (;;) {
    file_ = ::open(path_.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | (resume ? 0 : O_CREAT), all_may);
    if (file_ < 0 && resume && errno == ENOENT)
      refuse("found no " + printable(path_), "a run that ended whole leaves none");
    if (file_ < 0)
      throw InputError(
          Origin::of_option("-o " + table), "",
          fmt::format("cannot write {} beside it: {}", printable(path_), std::strerror(errno)),
          "a place for its journal");
    if (const auto reason = lock_file(file_))
      throw InputError(Origin::of_option("-o " + table), "",
                       fmt::format("cannot have {}: {}", printable(path_), *reason),
                       "a journal that this run alone writes");
    // The run that had it may have removed it between the two.
    struct ::stat mine {};
    if (is_at(file_, path_) && ::fstat(file_, &mine) == 0) {
      end_ = static_cast<std::size_t>(mine.st_size);
      // A file of another's is not emptied.
      const Mapped mapped(file_, end_);
      if (!resume && !kind.starts_with(mapped.text().substr(0, kind.size())))
        throw InputError(Origin::of_option("-o " + table), "",
                         fmt::format("found {}, which is no journal", printable(path_)),
                         "a place for its journal", "choose another name, or remove that file");
      return;
    }
    ::close(file_);
    file_ = -1;
  }
}

void Journal::take_in() {
  const Mapped mapped(file_, end_);
  const std::string_view text = mapped.text();
  const std::string first = first_line(hash_);
  if (first.starts_with(text)) return empty();  // nothing was finished
  const bool titled = text.starts_with(first);
  std::size_t at = titled ? first.size() : 0;
  std::size_t whole = titled ? at : 0;  // up to here every byte is accounted for
  while (at < text.size()) {
    if (const auto found = record_at(text, at, hash_)) {
      if (whole < at)
        remarks_.push_back(
            fmt::format("{}: bytes {} to {} are damaged; what was there is computed again",
                        printable(path_), whole, at));
      known_[found->tile] = {found->begin, found->bytes};
      whole = at = found->begin + found->bytes + 1;
      continue;
    }
    at = std::min(text.find(mark, at + 1), text.size());
  }
  if (!titled && known_.empty())
    refuse(printable(path_) + " is of another case, table, version or other options",
           "run it without --resume");
  begun_ = true;
  if (whole == text.size()) return;
  remarks_.push_back(
      fmt::format("{}: its last {} bytes are no whole record; that tile is computed again",
                  printable(path_), text.size() - whole));
  if (::ftruncate(file_, static_cast<off_t>(whole)) != 0)
    throw std::runtime_error(fmt::format("cutting {}: {}", path_, std::strerror(errno)));
  end_ = whole;
}

std::optional<std::string> Journal::read(std::size_t tile) const {
  const auto at = known_.find(tile);
  if (at == known_.end()) return std::nullopt;
  std::string out(at->second.bytes, '\0');
  for (std::size_t done = 0; done < out.size();) {
    const ssize_t count = ::pread(file_, out.data() + done, out.size() - done,
                                  static_cast<off_t>(at->second.begin + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      throw std::runtime_error(
          fmt::format("reading {}: {}", path_, count < 0 ? std::strerror(errno) : "it was cut"));
    done += static_cast<std::size_t>(count);
  }
  return out;
}

void Journal::add(std::size_t tile, std::string_view text, double seconds) {
  const std::string line =
      fmt::format("{}{} {} {} ", mark, tile, text.size(), static_cast<std::int64_t>(1e6 * seconds));
  std::string record;
  record.reserve(line.size() + text.size() + 16);
  record.append(line).append(checksum(hash_, line, text)).append(1, '\n').append(text) += '\n';
  append(record);
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < flush_every) return;
  flushed_ = now;
  if (::fdatasync(file_) != 0)
    throw std::runtime_error(fmt::format("flushing {}: {}", path_, std::strerror(errno)));
}

void Journal::append(std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const std::string reason = std::strerror(errno);
      // Whole records stay; a resumed run cuts off the rest where this cannot.
      (void)!::ftruncate(file_, static_cast<off_t>(end_));
      throw std::runtime_error(fmt::format("writing {}: {}", path_, reason));
    }
    done += static_cast<std::size_t>(count);
  }
  end_ += bytes.size();
}

void Journal::finish() {
  ::unlink(path_.c_str());  // before the lock goes
  ::close(file_);
  file_ = -1;
}

}  // namespace stationary::cli
