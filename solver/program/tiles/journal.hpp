// The finished tiles of a run that may be interrupted, in a file beside its table, x.csv.journal:
//
//   stationary journal 2 HASH                       of the work: the case, the version, what is asked
//   tile NUMBER BYTES MICROSECONDS CHECKSUM         then so many bytes, and a line's end
//
// A tile is appended as it ends, so a killed run keeps all but those under way. The checksum is of the
// work, the line and the bytes: what is not whole is told and left out, what stands behind it is not.
// One run at a time has the file (table/file_lock.hpp); where a run ends whole it is removed.
#pragma once

#include <chrono>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stationary::cli {

class Journal {
 public:
  /// Of the table at `table`. resume: the tiles that are there count; throws InputError about --resume
  /// where there is none, or one of other work (a hash of what decides the tiles). Else they stay until
  /// begin(). Throws InputError where another run has it, or where it cannot be locked.
  Journal(const std::string& table, const std::string& hash, bool resume);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  /// Before the first tile is added, and after all else that may be refused: where nothing is resumed
  /// the journal begins anew.
  void begin();
  /// What a person is to know of what was read, a line each: records that were not whole, or that
  /// begin() has discarded.
  const std::vector<std::string>& remarks() const { return remarks_; }
  std::size_t known() const { return known_.size(); }
  bool has(std::size_t tile) const { return known_.contains(tile); }
  /// A tile that it had when it was opened. May be called by several threads.
  std::optional<std::string> read(std::size_t tile) const;
  /// In the file when it returns, on the disk ten seconds later. By one thread at
  /// a time. Throws std::runtime_error.
  void add(std::size_t tile, std::string_view text, double seconds = 0.0);
  /// Removes the file.
  void finish();

 private:
  struct Place {
    std::size_t begin;
    std::size_t bytes;
  };
  void open(const std::string& table, bool resume);
  /// Reads what is there and cuts off an end that is not whole.
  void take_in();
  void empty();
  void append(std::string_view bytes);

  std::string path_;
  std::string hash_;
  int file_ = -1;
  std::size_t end_ = 0;
  bool begun_ = false;  ///< it is of this work, and tiles may be added
  std::map<std::size_t, Place> known_;
  std::vector<std::string> remarks_;
  std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

/// Whether a table after -o is a file that a journal may stand beside.
bool has_journal(const std::string& table);

/// Of texts, in hexadecimal.
std::string hash_of(std::initializer_list<std::string_view> texts);

}  // namespace stationary::cli
