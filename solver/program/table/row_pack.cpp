#include "solver/program/table/row_pack.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "solver/program/table/column_file.hpp"

namespace stationary {
namespace {

std::size_t size_of(CellKind kind) {
  switch (kind) {
    case CellKind::text:
      return sizeof(std::uint8_t);
    case CellKind::count:
      return sizeof(std::int32_t);
    default:
      return sizeof(double);
  }
}

template <class T>
void put(char*& at, T value) {
  std::memcpy(at, &value, sizeof value);
  at += sizeof value;
}

template <class T>
T take(const char*& at) {
  T out;
  std::memcpy(&out, at, sizeof out);
  at += sizeof out;
  return out;
}

}  // namespace

RowPack::RowPack(const std::vector<Column>& columns, std::size_t parameters)
    : parameters_(parameters), row_size_(parameters * sizeof(double)) {
  for (const Column c : columns) {
    const CellKind kind = cell_kind(c);
    parts_.push_back({c, kind, {}});
    if (kind == CellKind::text) parts_.back().words = column_words(c);
    row_size_ += size_of(kind);
  }
}

void RowPack::add(const TableRow& row, std::string& out) const {
  const std::size_t begin = out.size();
  out.resize(begin + row_size_);
  char* at = out.data() + begin;
  for (const Part& part : parts_) {
    if (part.kind == CellKind::text) {
      const auto word = std::ranges::find(part.words, text_of(row, part.column));
      put(at, static_cast<std::uint8_t>(word == part.words.end() ? 0 : word - part.words.begin()));
    } else if (part.kind == CellKind::count) {
      const double value = row[part.column];
      put(at, std::isnan(value) ? missing_count : static_cast<std::int32_t>(value));
    } else {
      put(at, row[part.column]);
    }
  }
  if (parameters_ > 0) put(at, row.parameter);
  if (parameters_ > 1) put(at, row.second_parameter);
}

void RowPack::read(const char* bytes, TableRow& row) const {
  for (const Part& part : parts_) {
    if (part.kind == CellKind::text) {
      const auto word = take<std::uint8_t>(bytes);
      set_text(row, part.column, word < part.words.size() ? part.words[word] : std::string_view());
    } else if (part.kind == CellKind::count) {
      const auto value = take<std::int32_t>(bytes);
      row[part.column] = value == missing_count ? std::numeric_limits<double>::quiet_NaN()
                                                : static_cast<double>(value);
    } else {
      row[part.column] = take<double>(bytes);
    }
  }
  if (parameters_ > 0) row.parameter = take<double>(bytes);
  if (parameters_ > 1) row.second_parameter = take<double>(bytes);
}

}  // namespace stationary
