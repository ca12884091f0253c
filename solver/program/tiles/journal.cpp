#include "solver/program/tiles/journal.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "solver/program/table/table.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace {

constexpr std::string_view title = "stationary journal 1 ";

[[noreturn]] void refuse(std::string found, std::string remedy) {
  throw InputError(Origin::of_option("--resume"), "", std::move(found),
                   "-o FILE, a table that this command was interrupted in", std::move(remedy));
}

/// A line from a place on, without its end; the place moves behind it. Nothing where it is cut short.
std::optional<std::string_view> line(std::string_view text, std::size_t& at) {
  const std::size_t end = text.find('\n', at);
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view out = text.substr(at, end - at);
  at = end + 1;
  return out;
}

/// "TILE BYTES CHECKSUM".
struct Head {
  std::size_t tile = 0;
  std::size_t bytes = 0;
  std::string_view checksum;
};
std::optional<Head> head(std::string_view text) {
  Head out;
  const char* const end = text.data() + text.size();
  const auto tile = std::from_chars(text.data(), end, out.tile);
  if (tile.ec != std::errc() || tile.ptr == end || *tile.ptr != ' ') return std::nullopt;
  const auto bytes = std::from_chars(tile.ptr + 1, end, out.bytes);
  if (bytes.ec != std::errc() || bytes.ptr == end || *bytes.ptr != ' ') return std::nullopt;
  out.checksum = {bytes.ptr + 1, static_cast<std::size_t>(end - bytes.ptr - 1)};
  return out;
}

}  // namespace

bool has_journal(const std::string& table) {
  if (table.empty() || table == "-") return false;
  std::error_code ignored;
  const auto status = std::filesystem::status(table, ignored);
  return !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
}

std::string hash_of(std::initializer_list<std::string_view> texts) {
  TableChecksum out;
  for (const std::string_view each : texts) out.add(each);
  return out.text();
}

Journal::Journal(const std::string& table, const std::string& hash, bool resume)
    : path_(table + ".journal") {
  if (resume) {
    if (table.empty() || table == "-") refuse("found no file", "name the table after -o");
    std::filesystem::resize_file(path_, read(hash));
  }
  file_.reset(std::fopen(path_.c_str(), resume ? "ab" : "wb"));
  if (!file_)
    throw InputError(
        Origin::of_option("-o " + table), "",
        fmt::format("cannot write {} beside it: {}", printable(path_), std::strerror(errno)),
        "a place for its journal");
  if (!resume) append(std::string(title) + hash + '\n');
}

std::size_t Journal::read(const std::string& hash) {
  std::ifstream file(path_, std::ios::binary);
  if (!file) refuse("found no " + printable(path_), "a run that ended whole leaves none");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::size_t at = 0;
  const auto first = line(text, at);
  if (!first || *first != std::string(title) + hash)
    refuse(printable(path_) + " is of another case, table, version or other options",
           "run it without --resume");
  std::size_t whole = at;
  while (const auto next = line(text, at)) {
    const auto record = head(*next);
    if (!record || text.size() - at < record->bytes + 1) break;
    const std::string_view tile = std::string_view(text).substr(at, record->bytes);
    if (hash_of({tile}) != record->checksum || text[at + record->bytes] != '\n') break;
    known_[record->tile] = tile;
    whole = at += record->bytes + 1;
  }
  return whole;
}

std::optional<std::string> Journal::known(std::size_t tile) const {
  const auto at = known_.find(tile);
  return at == known_.end() ? std::nullopt : std::optional(at->second);
}

void Journal::add(std::size_t tile, std::string_view text) {
  append(fmt::format("{} {} {}\n{}\n", tile, text.size(), hash_of({text}), text));
}

void Journal::append(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() ||
      std::fflush(file_.get()) != 0)
    throw std::runtime_error(fmt::format("writing {}: {}", path_, std::strerror(errno)));
}

void Journal::finish() {
  file_.reset();
  std::filesystem::remove(path_);
}

}  // namespace stationary::cli
