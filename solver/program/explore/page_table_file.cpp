// read_page_table() of a file, CSV or HDF5, with what is beside it. Apart from the rest, for pages, which have no files.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "solver/program/explore/page_table.hpp"
#include "solver/program/rows/metadata_reading.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "solver/program/table/cell_table.hpp"
#include "solver/program/table/column_file.hpp"

namespace stationary {
namespace {

using Json = nlohmann::ordered_json;

/// The program's own columns that a header begins with.
std::vector<Column> known_columns(std::span<const std::string> header) {
  std::vector<Column> out;
  for (const std::string& each : header) {
    const auto known = find_column(each);
    if (!known) break;
    out.push_back(*known);
  }
  return out;
}

/// A row of such columns and the parameters after them; valid as long as the reader's.
TableRow row_of(const TableReader& table, std::span<const Column> columns, std::size_t parameters) {
  TableRow out;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (cell_kind(columns[k]) == CellKind::text)
      set_text(out, columns[k], table.text(k));
    else
      out[columns[k]] = table.number(k);
  }
  if (parameters > 0) out.parameter = table.number(columns.size());
  if (parameters > 1) out.second_parameter = table.number(columns.size() + 1);
  return out;
}

std::string line_of(const TableReader& table) {
  std::string out;
  for (std::size_t k = 0; k < table.columns().size(); ++k) {
    if (k > 0) out += ',';
    out += csv_cell(table.text(k));
  }
  return out + '\n';
}

/// Whether a table has this checksum: of its rows' values or, where `curve` wrote it, of their lines.
bool has_checksum(const std::string& path, const PageTable& page, const std::string& checksum) {
  TableReader table = open_table(path);
  const std::vector<Column> columns = known_columns(table.columns());
  const std::size_t parameters = page.parameters.size();
  const bool is_rows = parameters <= 2 && columns.size() + parameters == table.columns().size();
  TableChecksum of_values;
  TableChecksum of_lines;
  while (table.next()) {
    if (is_rows) of_values.add(row_of(table, columns, parameters), columns, parameters);
    of_lines.add(line_of(table));
  }
  return (is_rows && of_values.text() == checksum) || of_lines.text() == checksum;
}

/// Why metadata cannot be read, as the JSON reader has it, without the name of its error.
std::string reason(const Json::exception& error) {
  const std::string_view text = error.what();
  const std::size_t name = text.find("] ");
  return printable(std::string(name == std::string_view::npos ? text : text.substr(name + 2)));
}

/// The first part of metadata that a page reads and that is not as the schema has it
/// (metadata.schema.json); empty: none.
std::string wrong_part(const Json& metadata) {
  using Test = bool (Json::*)() const noexcept;
  const auto wrong = [](const Json& of, const char* key, Test test, bool required) {
    const auto at = of.find(key);
    return at == of.end() ? required : !((*at).*test)();
  };
  for (const char* const key : {"command", "message"})
    if (wrong(metadata, key, &Json::is_string, false)) return key;
  const auto nullable_object = [](const Json& of, const char* key) {
    const auto at = of.find(key);
    return at == of.end() || at->is_null() || at->is_object();
  };
  if (!nullable_object(metadata, "case")) return "case";
  const struct {
    const char* name;
    std::vector<const char*> texts;
    std::vector<const char*> numbers;
  } lists[] = {{"events", {"event"}, {"parameter"}},
               {"segments", {}, {"sheet", "segment"}},
               {"classes", {"branch", "status"}, {"from", "to"}},
               {"skipped", {}, {}}};
  for (const auto& [name, texts, numbers] : lists) {
    if (wrong(metadata, name, &Json::is_array, false)) return name;
    for (const Json& each : metadata.value(name, Json::array())) {
      const auto is = [&](Test test) {
        return [&each, &wrong, test](const char* key) { return wrong(each, key, test, true); };
      };
      if (!each.is_object() || !nullable_object(each, "sheets") ||
          std::ranges::any_of(texts, is(&Json::is_string)) ||
          std::ranges::any_of(numbers, is(&Json::is_number)))
        return name;
    }
  }
  return {};
}

/// What is wrong with metadata of a table; empty: nothing.
std::string fault_of(const std::string& metadata, const std::string& path, const PageTable& page) {
  try {
    if (nests_too_deep(metadata)) return "cannot be read: it nests more deeply than metadata do";
    const Json found = Json::parse(metadata);
    if (!found.is_object()) return "cannot be read: it is no JSON object";
    if (!is_of_table(metadata, page.rows))
      return fmt::format("is not of this table: it is of {} rows, and {} has {}",
                         found.at("rows").dump(), printable(path), page.rows);
    if (const std::string part = wrong_part(found); !part.empty())
      return fmt::format("cannot be read: its {} is not as the program writes it", part);
    const auto checksum = found.find("checksum");
    if (checksum == found.end() || !checksum->is_string()) return {};
    if (has_checksum(path, page, checksum->get<std::string>())) return {};
    return fmt::format("is not of this table: its checksum is not that of the rows of {}",
                       printable(path));
  } catch (const Json::exception& error) {
    return "cannot be read: " + reason(error);
  }
}

/// Metadata of a table, from within it or beside it, where they are its own.
void take_metadata(const std::string& path, PageTable& page) {
  const bool within = is_column_file(path) && !column_file_metadata(path).empty();
  const std::string name = within ? path : metadata_path(path).string();
  std::error_code unknown;
  if (!within && !std::filesystem::exists(name, unknown)) return;
  std::string fault;
  errno = 0;
  if (!std::filesystem::is_regular_file(name, unknown)) {
    fault = "cannot be read: it is no file";
  } else if (!std::ifstream(name)) {
    fault = "cannot be read: " + std::generic_category().message(errno);
  } else {
    page.metadata = table_metadata(path);
    fault = fault_of(page.metadata, path, page);
  }
  if (fault.empty()) return;
  page.metadata.clear();
  page.warning = fmt::format("{}{} {}; the page is made without it",
                             within ? "what describes the table in " : "", printable(name), fault);
}

}  // namespace

PageTable read_page_table(const std::string& path, const std::optional<std::string>& title) {
  TableReader table = open_table(path);
  PageTable out = read_page_table(table);
  take_metadata(path, out);
  if (const std::string of_case = case_title(out.metadata); !of_case.empty()) out.title = of_case;
  if (title) out.title = *title;
  return out;
}

}  // namespace stationary
