#include "solver/program/table/table.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "solver/program/table/cell_table.hpp"
#include "solver/program/text/named.hpp"

namespace stationary {
namespace {

constexpr std::size_t block_size = 1U << 16U;
constexpr std::size_t longest_text = 256;  // quoted

/// Where a row has the text of a column of texts.
constexpr std::string_view TableRow::*text_place(Column c) {
  switch (c) {
    case Column::branch:
      return &TableRow::branch;
    case Column::event:
      return &TableRow::event;
    case Column::status:
      return &TableRow::status;
    case Column::certified:
      return &TableRow::certified;
    case Column::class_certified:
      return &TableRow::class_certified;
    case Column::side:
      return &TableRow::side;
    default:
      return &TableRow::stability;
  }
}

char* append(std::string_view text, char* at) {
  // Quoted, a text may double in length; the names of this program are far shorter.
  text = text.substr(0, (longest_text - 2) / 2);
  const auto asks_for_quotes = [](char c) {
    return c == ',' || c == '"' || c == '\r' || c == '\n';
  };
  if (std::ranges::none_of(text, asks_for_quotes)) return std::copy(text.begin(), text.end(), at);
  *at++ = '"';
  for (const char c : text) {
    if (c == '"') *at++ = '"';
    *at++ = c;
  }
  *at++ = '"';
  return at;
}

constexpr std::uint8_t place_of(Column c) { return static_cast<std::uint8_t>(c); }
constexpr std::array stretches{place_of(Column::xi), place_of(Column::zeta)};
constexpr std::array growth{place_of(Column::growth)};
constexpr std::array rates{place_of(Column::nu1), place_of(Column::nu2), place_of(Column::nu3)};
/// Of each column those before it that often have the same number.
constexpr auto likely_columns = [] {
  std::array<std::span<const std::uint8_t>, column_count> out{};
  out[place_of(Column::lambda)] = out[place_of(Column::mu)] = stretches;
  for (int k = 0; k < mode_count; ++k) out[place_of(mode_column(k, ModePart::re))] = growth;
  return out;
}();

char* append_count(double value, char* at) {
  if (std::isnan(value)) return at;
  return fmt::format_to(at, FMT_COMPILE("{}"), static_cast<long>(value));
}

/// In a checksum's place where there is none.
struct NoSum {
  void add(std::string_view) {}
  void add(double) {}
};

}  // namespace

CellKind cell_kind(Column c) {
  switch (c) {
    case Column::branch:
    case Column::event:
    case Column::stability:
    case Column::status:
    case Column::certified:
    case Column::class_certified:
    case Column::side:
      return CellKind::text;
    case Column::sheet:
    case Column::point:
    case Column::negative:
    case Column::krein1:
    case Column::krein2:
    case Column::krein3:
    case Column::krein4:
    case Column::krein5:
    case Column::segment:
      return CellKind::count;
    default:
      return CellKind::number;
  }
}

std::string_view text_of(const TableRow& row, Column c) { return row.*text_place(c); }

void set_text(TableRow& row, Column c, std::string_view text) { row.*text_place(c) = text; }

std::optional<Column> find_column(std::string_view name) {
  return named<Column>(column_names, name);
}

std::vector<Column> select_columns(std::span<const Column> computed,
                                   std::span<const std::string> asked) {
  std::vector<Column> out(computed.begin(), computed.end());
  std::ranges::sort(out);
  if (!asked.empty()) {
    std::erase_if(out, [&](Column c) { return std::ranges::find(asked, name(c)) == asked.end(); });
  }
  return out;
}

void TableChecksum::add(const TableRow& row, std::span<const Column> columns,
                        std::size_t parameters) {
  for (const Column c : columns) {
    if (cell_kind(c) == CellKind::text) {
      add(text_of(row, c));
    } else {
      add(row[c]);
    }
  }
  if (parameters > 0) add(row.parameter);
  if (parameters > 1) add(row.second_parameter);
}

/// Each step is one to one in the word: a single cell that differs always shows.
void TableChecksum::add(std::uint64_t word) {
  state_ = (state_ ^ word) * 0xd6e8feb86659fd93U;
  state_ ^= state_ >> 32U;
}

void TableChecksum::add(std::string_view text) {
  for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
  add(std::uint64_t{256});
}

void TableChecksum::add(double value) {
  if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();
  if (value == 0.0) value = 0.0;  // written without its sign
  add(std::bit_cast<std::uint64_t>(value));
}

std::string TableChecksum::text() const { return fmt::format("{:016x}", state_); }

// Seven texts and the rest numbers.
const std::size_t RowFormat::longest_line =
    7 * longest_text + (column_count + 2) * RowTexts::longest;

RowFormat::RowFormat(const std::vector<Column>& columns,
                     const std::optional<std::string>& parameter,
                     const std::optional<std::string>& second)
    : columns_(columns) {
  for (const auto* trailing : {&parameter, &second})
    if (*trailing) parameters_.push_back(**trailing);
}

std::string RowFormat::header() const {
  std::vector<CellColumn> cells;
  for (const Column c : columns_) cells.push_back({std::string(name(c)), cell_kind(c)});
  for (const std::string& each : parameters_) cells.push_back({each, CellKind::number});
  return csv_header(cells);
}

template <class Sum>
char* RowFormat::summed_line(const TableRow& row, RowTexts& texts, char* at, Sum& sum) const {
  char* const begin = at;
  bool first = true;
  for (const Column c : columns_) {
    if (!std::exchange(first, false)) *at++ = ',';
    switch (cell_kind(c)) {
      case CellKind::text:
        sum.add(text_of(row, c));
        at = append(text_of(row, c), at);
        break;
      case CellKind::count:
        sum.add(row[c]);
        at = append_count(row[c], at);
        break;
      case CellKind::number:
        sum.add(row[c]);
        if (!std::isnan(row[c]))
          at = texts.append(row[c], place_of(c), likely_columns[place_of(c)], at);
    }
  }
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    if (!std::exchange(first, false)) *at++ = ',';
    const double value = k == 0 ? row.parameter : row.second_parameter;
    sum.add(value);
    if (!std::isnan(value)) at = texts.append(value, column_count + k, rates, at);
  }
  // The one column there is, empty: an empty line is none to many readers.
  if (at == begin) at = append("\"\"", at);
  *at++ = '\n';
  return at;
}

char* RowFormat::line(const TableRow& row, RowTexts& texts, char* at) const {
  NoSum none;
  return summed_line(row, texts, at, none);
}

char* RowFormat::line(const TableRow& row, RowTexts& texts, char* at, TableChecksum& sum) const {
  return summed_line(row, texts, at, sum);
}

TableWriter::TableWriter(ByteSink& sink, std::vector<Column> columns,
                         const std::optional<std::string>& parameter,
                         const std::optional<std::string>& second)
    : RowSink(std::move(columns),
              std::size_t{parameter.has_value()} + std::size_t{second.has_value()}),
      sink_(&sink),
      format_(column_list(), parameter, second),
      buffer_(block_size + RowFormat::longest_line) {
  const std::string header = format_.header();
  buffer_.resize(buffer_.size() + header.size());
  cursor_ = std::copy(header.begin(), header.end(), buffer_.data());
}

void TableWriter::put(const TableRow& row, TableChecksum& sum) {
  cursor_ = format_.line(row, texts_, cursor_, sum);
  if (cursor_ >= buffer_.data() + block_size) flush();
}

void TableWriter::flush() {
  const auto size = static_cast<std::size_t>(cursor_ - buffer_.data());
  cursor_ = buffer_.data();
  sink_->write({buffer_.data(), size});
}

}  // namespace stationary
