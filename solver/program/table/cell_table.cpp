#include "solver/program/table/cell_table.hpp"

#include <utility>

namespace stationary {

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
  return out;
}

std::string csv_header(const std::vector<CellColumn>& columns) {
  std::string out;
  for (const CellColumn& each : columns) {
    if (!out.empty()) out += ',';
    out += csv_cell(each.name);
  }
  out += '\n';
  return out;
}

CellTable::CellTable(ByteSink* sink, std::vector<CellColumn> columns)
    : sink_(sink), columns_(std::move(columns)) {
  const std::string header = csv_header(columns_);
  if (sink_ != nullptr) sink_->write(header);
  kept_ = header;
}

void CellTable::write(std::string_view lines) {
  // A row at a time, so that it does not matter how many come together.
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (lines[k] == '"') quoted = !quoted;
    if (lines[k] != '\n' || quoted) continue;
    checksum_.add(lines.substr(begin, k + 1 - begin));
    begin = k + 1;
    ++rows_;
  }
  if (sink_ != nullptr) {
    sink_->write(lines);
  } else {
    kept_ += lines;
  }
}

}  // namespace stationary
