// The finished tiles of a run that may be interrupted, in a file beside its table, x.csv.journal:
//
//   stationary journal 1 HASH                  of the work: the case, the version, what is asked
//   TILE BYTES CHECKSUM                        then so many bytes, and a line's end
//
// A tile is appended as it ends, so a killed run keeps all but those under way; a record cut short is
// left out. Where the run ends whole the file is removed.
#pragma once

#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace stationary::cli {

class Journal {
 public:
  /// Of the table at `table`. resume: the tiles that are there count; throws InputError about --resume
  /// where there is none, or one of other work (a hash of what decides the tiles). Else it begins anew.
  Journal(const std::string& table, const std::string& hash, bool resume);

  std::optional<std::string> known(std::size_t tile) const;
  std::size_t known() const { return known_.size(); }
  /// On the disk when it returns. Throws std::runtime_error.
  void add(std::size_t tile, std::string_view text);
  /// Removes the file.
  void finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  /// Reads what is there; how many bytes of it are whole.
  std::size_t read(const std::string& hash);
  void append(std::string_view bytes);

  std::string path_;
  std::map<std::size_t, std::string> known_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// Whether a table after -o is a file that a journal may stand beside.
bool has_journal(const std::string& table);

/// Of texts, in hexadecimal.
std::string hash_of(std::initializer_list<std::string_view> texts);

}  // namespace stationary::cli
