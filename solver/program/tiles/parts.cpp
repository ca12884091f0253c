#include "solver/program/tiles/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <system_error>

#include "solver/program/rows/metadata_reading.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "solver/program/table/cell_table.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/table/row_pack.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace {

[[noreturn]] void refuse(const std::string& path, std::string found, std::string remedy = {}) {
  throw InputError(Origin::of_option("--merge " + path), "", std::move(found),
                   "every part of one run with --part K/N", std::move(remedy));
}

std::string bytes_of(const std::string& path) {
  std::optional<std::string> out = bytes_of_file(path);
  if (!out) refuse(path, "cannot read " + printable(path));
  return std::move(*out);
}

PartTable read_part_table(const std::string& path, std::string_view command) {
  if (std::error_code none; !std::filesystem::is_regular_file(path, none))
    refuse(path, "cannot read " + printable(path));
  const bool columnar = is_column_file(path);
  const std::string beside = columnar ? path : metadata_path(path).string();
  const std::string text = columnar ? column_file_metadata(path) : bytes_of(beside);
  if (const std::string other = other_program(text, STATIONARY_VERSION); !other.empty())
    refuse(path, fmt::format("found {} to be {}", printable(beside), other),
           "make all parts with this version");
  auto metadata = part_metadata(text);
  if (!metadata)
    refuse(path, printable(beside) + " does not say which part it is of",
           "a part is what --part K/N wrote, with its .meta.json beside it");
  if (metadata->command != command)
    refuse(path, fmt::format("found a part of the command {}", in_quotes(metadata->command)),
           fmt::format("these are to be parts of {}", in_quotes(command)));
  if (metadata->status != "done")
    refuse(path, "found that it was interrupted", "go on with it by --resume first");
  return {path, std::move(*metadata)};
}

std::string told(const PartTable& part) {
  return fmt::format("{} (part {}/{})", printable(part.path), part.metadata.part.number,
                     part.metadata.part.of);
}

/// A study's messages name its files, so a table of theirs has one spelling of each.
void require_spelling(const PartTable& part, std::string_view what, const std::string& path,
                      const std::string& of_first) {
  if (path != of_first)
    refuse(part.path,
           fmt::format("found {} {} beside {}", what, in_quotes(path), in_quotes(of_first)),
           "spell it alike in all parts: the messages of a study name it");
}

/// Nothing where the word is none of its column's.
std::optional<std::string_view> word_of(const std::vector<std::string_view>& words,
                                        std::string_view text) {
  const auto at = std::ranges::find(words, text);
  return at == words.end() ? std::nullopt : std::optional(*at);
}

}  // namespace

std::vector<PartTable> read_parts(const std::vector<std::string>& paths, std::string_view command) {
  std::vector<PartTable> out;
  for (const std::string& path : paths) out.push_back(read_part_table(path, command));
  for (const PartTable& each : out) {
    const PartTable& first = out.front();
    if (each.metadata.part.of != first.metadata.part.of)
      refuse(each.path, fmt::format("found {} beside {}", told(each), told(first)));
    if (each.metadata.case_text != first.metadata.case_text)
      refuse(each.path, fmt::format("found another case than that of {}", told(first)));
    if (each.metadata.study && first.metadata.study) {
      require_spelling(each, "CASE", each.metadata.case_file, first.metadata.case_file);
      require_spelling(each, "--over", each.metadata.study->over, first.metadata.study->over);
    }
    if (each.metadata.part.work != first.metadata.part.work)
      refuse(each.path,
             fmt::format("found other options, input or version than of {}", told(first)));
  }
  std::ranges::stable_sort(out, {},
                           [](const PartTable& each) { return each.metadata.part.number; });
  for (std::size_t k = 0; k < out.size(); ++k) {
    const std::size_t number = out[k].metadata.part.number;
    if (k > 0 && number == out[k - 1].metadata.part.number)
      refuse(out[k].path,
             fmt::format("found {} twice: {} too", told(out[k]), printable(out[k - 1].path)));
  }
  for (std::size_t k = 0; k < out.front().metadata.part.of; ++k)
    if (k >= out.size() || out[k].metadata.part.number != k + 1)
      refuse(out.front().path,
             fmt::format("found no part {}/{}", k + 1, out.front().metadata.part.of));
  return out;
}

void require_case(const std::vector<PartTable>& parts, const Metadata& whole) {
  if (parts.front().metadata.case_text != case_text(whole))
    refuse(parts.front().path, "found parts of another case",
           "merge with the case file and the --set that the parts were made with");
}

void require_work(const std::vector<PartTable>& parts, const std::string& hash) {
  if (parts.front().metadata.part.work != hash)
    refuse(parts.front().path, "found parts of another case, table, version or other options",
           "merge with the options that the parts were made with");
}

std::vector<std::pair<std::string, long>> added_counts(const std::vector<PartTable>& parts) {
  std::vector<std::pair<std::string, long>> out;
  for (const PartTable& part : parts) {
    for (const auto& [name, count] : part.metadata.counts) {
      const auto at = std::ranges::find(out, name, [](const auto& each) { return each.first; });
      if (at == out.end()) {
        out.emplace_back(name, count);
      } else {
        at->second += count;
      }
    }
  }
  return out;
}

void require_whole(const PartTable& part, std::size_t rows, const TableChecksum& checksum) {
  if (rows != part.metadata.rows)
    refuse(part.path, fmt::format("found {} rows, {} by its metadata", rows, part.metadata.rows));
  if (checksum.text() != part.metadata.checksum)
    refuse(part.path,
           "found that it was changed since it was written (its checksum is in the "
           "metadata)");
}

void read_table(TableReader& table, const std::vector<Column>& columns,
                const std::vector<std::string>& parameters,
                const std::function<void(const TableRow&)>& take) {
  std::vector<std::string> expected;
  std::vector<std::vector<std::string_view>> words;
  for (const Column c : columns) {
    expected.emplace_back(name(c));
    words.push_back(cell_kind(c) == CellKind::text ? column_words(c)
                                                   : std::vector<std::string_view>());
  }
  expected.insert(expected.end(), parameters.begin(), parameters.end());
  if (table.columns() != expected) refuse(table.name(), "found other columns than this case's");
  TableRow row;
  while (table.next()) {
    std::size_t k = 0;
    for (const Column c : columns) {
      if (cell_kind(c) == CellKind::text) {
        const auto word = word_of(words[k], table.text(k));
        if (!word) throw table.fault(k, "a word that this program writes");
        set_text(row, c, *word);
      } else {
        row[c] = table.number(k);
      }
      ++k;
    }
    if (!parameters.empty()) row.parameter = table.number(k);
    if (parameters.size() > 1) row.second_parameter = table.number(k + 1);
    take(row);
  }
}

void read_rows(const std::vector<PartTable>& parts, const std::vector<Column>& columns,
               const std::vector<std::string>& parameters,
               const std::function<void(const TableRow&)>& take) {
  for (const PartTable& part : parts) {
    TableReader table = open_table(part.path);
    TableChecksum checksum;
    std::size_t rows = 0;
    read_table(table, columns, parameters, [&](const TableRow& row) {
      checksum.add(row, columns, parameters.size());
      ++rows;
      take(row);
    });
    require_whole(part, rows, checksum);
  }
}

PartLines read_lines(const std::vector<PartTable>& parts) {
  PartLines out;
  for (const PartTable& part : parts) {
    std::string text;
    if (is_column_file(part.path)) {
      const auto table = column_file_table(part.path, {});
      text = {std::istreambuf_iterator<char>(*table), {}};
    } else {
      text = bytes_of(part.path);
    }
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string header = text.substr(0, end);
    if (!out.header.empty() && header != out.header)
      refuse(part.path, fmt::format("found other columns than in {}", told(parts.front())));
    out.header = header;
    CellTable rows(nullptr, {});
    rows.write(std::string_view(text).substr(end));
    require_whole(part, rows.rows(), rows.checksum());
    out.lines.append(text, end);
  }
  return out;
}

}  // namespace stationary::cli
