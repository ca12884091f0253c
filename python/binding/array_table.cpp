#include "python/binding/array_table.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include "solver/program/session/table_output.hpp"
#include "solver/program/table/column_file.hpp"

namespace stationary::python {
namespace {

constexpr std::size_t longest_word = 32;
constexpr std::size_t character = sizeof(std::uint32_t);  // NumPy's UCS-4

bool is_whole(Column c) { return c == Column::sheet || c == Column::point; }

/// Characters of the longest word.
std::size_t width(Column c) {
  std::size_t out = 1;
  for (const std::string_view word : column_words(c)) out = std::max(out, word.size());
  return std::min(out, longest_word);
}

template <class T>
void store(std::byte* at, T value) {
  std::memcpy(at, &value, sizeof value);
}

template <class T>
T load(const std::byte* at) {
  T out;
  std::memcpy(&out, at, sizeof out);
  return out;
}

/// The row's texts while it is written again.
struct Texts {
  std::array<std::array<char, longest_word>, column_count> of;

  std::string_view read(const std::byte* at, Column c, std::size_t most) {
    auto& text = of[static_cast<std::size_t>(c)];
    std::size_t size = 0;
    for (; size < most; ++size) {
      const auto letter = load<std::uint32_t>(at + character * size);
      if (letter == 0) break;
      text[size] = static_cast<char>(letter);
    }
    return {text.data(), size};
  }
};

class TextSink final : public ByteSink {
 public:
  void write(std::string_view bytes) override { text += bytes; }
  std::string text;
};

}  // namespace

class ArrayTable::Sink final : public RowSink {
 public:
  Sink(ArrayTable& table, const std::vector<Column>& columns, std::size_t parameters)
      : RowSink(columns, parameters), table_(table) {}

 private:
  void put(const TableRow& row, TableChecksum& sum) override {
    add_cells(row, sum);
    table_.put(row);
  }

  ArrayTable& table_;
};

RowSink& ArrayTable::open(const std::vector<Column>& columns,
                          const std::vector<std::string>& parameters,
                          std::optional<std::size_t> rows) {
  columns_ = columns;
  parameters_ = parameters;
  expected_ = rows;
  constexpr std::size_t alignment = alignof(double);
  std::size_t end = 0;
  const auto add = [&](std::string name, std::string format, std::size_t size,
                       std::optional<Column> column) {
    fields_.push_back({std::move(name), std::move(format), end, size / character, column});
    end += (size + alignment - 1) / alignment * alignment;
  };
  for (const Column c : columns) {
    if (cell_kind(c) == CellKind::text) {
      add(std::string(name(c)), "U" + std::to_string(width(c)), character * width(c), c);
    } else {
      add(std::string(name(c)), is_whole(c) ? "i8" : "f8", sizeof(double), c);
    }
  }
  for (const std::string& parameter : parameters) add(parameter, "f8", sizeof(double), {});
  record_size_ = std::max(end, alignment);
  records_.reserve(record_size_ * rows.value_or(0));
  sink_ = std::make_shared<Sink>(*this, columns, parameters.size());
  return *sink_;
}

CellTable& ArrayTable::open(std::vector<CellColumn> columns) {
  return cells_.emplace(nullptr, std::move(columns));
}

void ArrayTable::put(const TableRow& row) {
  const std::size_t begin = records_.size();
  records_.resize(begin + record_size_);  // zeros
  std::size_t trailing = 0;
  for (const RecordField& field : fields_) {
    std::byte* const at = records_.data() + begin + field.offset;
    if (!field.column) {
      store(at, trailing++ == 0 ? row.parameter : row.second_parameter);
    } else if (const Column c = *field.column; cell_kind(c) == CellKind::text) {
      const std::string_view text = text_of(row, c);
      for (std::size_t k = 0; k < std::min(text.size(), field.width); ++k)
        store(at + character * k, static_cast<std::uint32_t>(text[k]));
    } else if (is_whole(c)) {
      store(at, static_cast<std::int64_t>(row[c]));
    } else {
      store(at, row[c]);
    }
  }
}

void ArrayTable::commit(Metadata metadata) {
  if (stop_ != nullptr && *stop_) return;
  metadata.rows = cells_ ? cells_->rows() : sink_->rows();
  metadata.checksum = (cells_ ? cells_->checksum() : sink_->checksum()).text();
  metadata_ = metadata_json(metadata);
  lasting_metadata_ = metadata_json(metadata, /*of_the_run=*/false);
  complete_ = true;
}

ArrayTable::Contents ArrayTable::contents() const {
  Contents out{{}, parameters_, expected_, {}, {}, metadata_, lasting_metadata_, complete_};
  for (const Column c : columns_) out.columns.emplace_back(name(c));
  if (cells_) {
    for (const CellColumn& each : cells_->columns())
      out.cell_columns.emplace_back(each.name, static_cast<int>(each.kind));
    out.bytes = cells_->kept();
  } else {
    out.bytes.assign(reinterpret_cast<const char*>(records_.data()), records_.size());
  }
  return out;
}

void ArrayTable::restore(const Contents& of) {
  if (!of.cell_columns.empty()) {
    std::vector<CellColumn> columns;
    for (const auto& [name, kind] : of.cell_columns)
      columns.push_back({name, static_cast<CellKind>(kind)});
    const std::size_t header = csv_header(columns).size();
    open(std::move(columns)).write(std::string_view(of.bytes).substr(header));
  } else if (!of.columns.empty() || !of.parameters.empty()) {
    std::vector<Column> columns;
    for (const std::string& each : of.columns) columns.push_back(find_column(each).value());
    open(columns, of.parameters, of.expected);
    const auto* const begin = reinterpret_cast<const std::byte*>(of.bytes.data());
    records_.assign(begin, begin + of.bytes.size());
  }
  metadata_ = of.metadata;
  lasting_metadata_ = of.lasting_metadata;
  complete_ = of.complete;
}

void ArrayTable::write(RowSink& sink) const {
  Texts texts;
  TableRow row;
  for (std::size_t begin = 0; begin < records_.size(); begin += record_size_) {
    std::size_t trailing = 0;
    for (const RecordField& field : fields_) {
      const std::byte* const at = records_.data() + begin + field.offset;
      if (!field.column) {
        (trailing++ == 0 ? row.parameter : row.second_parameter) = load<double>(at);
      } else if (const Column c = *field.column; cell_kind(c) == CellKind::text) {
        set_text(row, c, texts.read(at, c, field.width));
      } else {
        row[c] = is_whole(c) ? static_cast<double>(load<std::int64_t>(at)) : load<double>(at);
      }
    }
    sink.write(row);
  }
}

void ArrayTable::write(const std::string& path, const std::string& case_path) const {
  cli::TableOutput output(path, case_path);
  output.prepare();
  if (cells_) {
    const std::string_view lines = cells_->kept();
    const std::size_t header = csv_header(cells_->columns()).size();
    output.open(cells_->columns()).write(lines.substr(header));
  } else {
    write(output.open(columns_, parameters_, expected_));
  }
  output.commit(metadata_, lasting_metadata_);
}

std::string ArrayTable::csv() const {
  if (cells_) return cells_->kept();
  TextSink out;
  const auto header = [&](std::size_t k) {
    return k < parameters_.size() ? std::optional(parameters_[k]) : std::nullopt;
  };
  TableWriter writer(out, columns_, header(0), header(1));
  write(writer);
  writer.flush();
  return std::move(out.text);
}

}  // namespace stationary::python
