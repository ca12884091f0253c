#include "solver/program/table/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <system_error>
#include <unordered_set>
#include <utility>

namespace stationary {
namespace {

std::unique_ptr<std::istream> opened(const std::string& path) {
  const auto refuse = [&](std::string_view reason) {
    throw InputError(Origin::in_file(path), "", fmt::format("cannot read it: {}", reason),
                     "a table (CSV or HDF5)");
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse("it is a directory");
  errno = 0;
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*file) refuse(errno != 0 ? std::strerror(errno) : "it cannot be opened");
  return file;
}

}  // namespace

TableReader::TableReader(const std::string& path) : TableReader(opened(path), path) {}

TableReader::TableReader(std::unique_ptr<std::istream> stream, std::string name)
    : stream_(std::move(stream)), name_(std::move(name)) {
  read_header();
}

std::optional<std::size_t> TableReader::column(std::string_view name) const {
  const auto at = std::ranges::find(columns_, name);
  if (at == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(at - columns_.begin());
}

void TableReader::read_header() {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // spreadsheets put one there
  if (!read_record())
    throw InputError(Origin::in_file(name_), "", "found an empty file", "a table with a header");
  if (record_.starts_with(byte_order_mark)) record_.erase(0, byte_order_mark.size());
  split_record();
  std::unordered_set<std::string_view> names;  // there may be many
  for (const Cell& cell : cells_) {
    if (cell.text.empty()) refuse(cell.begin, "found a column without a name", "a header");
    if (!names.insert(cell.text).second)
      refuse(cell.begin, "found the column " + in_quotes(cell.text) + " twice", "each once");
    columns_.emplace_back(cell.text);
  }
}

bool TableReader::next() {
  if (!read_record()) return false;
  split_record();
  if (cells_.size() != columns_.size()) {
    refuse(0, fmt::format("found {} cell{}", cells_.size(), cells_.size() == 1 ? "" : "s"),
           fmt::format("{}, as in the header", columns_.size()));
  }
  return true;
}

/// A line, and those after it while a quoted cell is open.
bool TableReader::read_record() {
  line_ = lines_read_ + 1;
  record_.clear();
  std::string more;
  bool open = false;
  while (std::getline(*stream_, more)) {
    ++lines_read_;
    if (open) record_ += '\n';
    record_ += more;
    if (std::ranges::count(more, '"') % 2 != 0) open = !open;
    if (open) continue;
    if (record_.ends_with('\r')) record_.pop_back();
    return true;
  }
  if (stream_->bad())
    throw InputError(Origin::in_file(name_), "", "reading it failed", "a readable file");
  if (open) refuse(0, "found a quoted cell without its end", "a closing quote");
  return false;
}

void TableReader::split_record() {
  cells_.clear();
  char* const text = record_.data();
  const std::size_t size = record_.size();
  std::size_t at = 0;
  while (true) {
    const std::size_t begin = at;
    if (at < size && text[at] == '"') {
      // Doubled quotes are one: what follows moves forward within the cell.
      std::size_t out = begin;
      for (++at; text[at] != '"' || (at + 1 < size && text[at + 1] == '"'); ++at) {
        if (text[at] == '"') ++at;
        text[out++] = text[at];
      }
      ++at;
      if (at < size && text[at] != ',')
        refuse(at, "found text after a quoted cell", "a comma or the end of the line");
      cells_.push_back({{text + begin, out - begin}, begin});
    } else {
      at = std::min(record_.find(',', at), size);
      const std::string_view cell(text + begin, at - begin);
      if (const auto quote = cell.find('"'); quote != std::string_view::npos)
        refuse(begin + quote, "found a quote within a cell", "the whole cell in quotes");
      cells_.push_back({cell, begin});
    }
    if (at == size) return;
    ++at;
  }
}

double TableReader::number(std::size_t column) const {
  const std::string_view cell = text(column);
  if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  const char* const end = cell.data() + cell.size();
  const auto [read_to, error] = std::from_chars(cell.data(), end, value);
  if (error != std::errc() || read_to != end) throw fault(column, "a number or an empty cell");
  return value;
}

InputError TableReader::fault(std::size_t column, std::string allowed) const {
  const Cell& cell = cells_[column];
  return {place(cell.begin), columns_[column], "found " + in_quotes(cell.text), std::move(allowed)};
}

void TableReader::refuse(std::size_t at, std::string found, std::string allowed) const {
  throw InputError(place(at), "", std::move(found), std::move(allowed));
}

/// The record's first line, and how far from its start: exact where no cell spans lines.
Origin TableReader::place(std::size_t at) const {
  return Origin::in_file(name_, line_, static_cast<int>(at) + 1);
}

void require_drawable(const TableReader& table) {
  const auto has = [&](std::string_view name) { return table.column(name).has_value(); };
  const std::string_view command = has("study_row")                      ? "study"
                                   : has("complete_fraction")            ? "atlas --grid"
                                   : has("uncertainty") && has("number") ? "sensitivity"
                                                                         : "";
  if (command.empty()) return;
  throw InputError(Origin::in_file(table.name()), "", "found a table of " + std::string(command),
                   "tables of solve, continue, atlas, map or curve");
}

}  // namespace stationary
