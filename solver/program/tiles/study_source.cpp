#include "solver/program/tiles/study_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "solver/program/case/case_schema.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/text/nearest_name.hpp"
#include "solver/program/text/utf8.hpp"

namespace stationary::cli {
namespace {

bool takes_text(std::string_view key, std::string_view cell) {
  const CaseKey* known = find_case_key(key);
  if (known != nullptr) return known->type == KeyType::text;
  if (!key.starts_with("potential.")) return false;
  // Of a domain's conditions a cell may have one, or a list of them.
  return key.ends_with(".model") || key.ends_with(".expression") ||
         (key.ends_with(".domain") && !cell.starts_with('['));
}

/// Cells go into tables of CSV, which are text, and of HDF5, whose names and texts a NUL ends.
void require_text(const Origin& origin, const std::string& key, std::string_view text) {
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t length = character_length(text.substr(k));
    if (length == 0 || text[k] == '\0')
      throw InputError(origin, printable(key),
                       length == 0 ? "found bytes that are no UTF-8" : "found a NUL byte",
                       "text in UTF-8", "a spreadsheet may save it as CSV in UTF-8");
    k += length;
  }
}

void require_name(const std::string& path, const std::string& name) {
  require_text(Origin::in_file(path, 1, 1), name, name);
  if (name.find_first_of("\r\n") != std::string::npos)
    throw InputError(Origin::in_file(path, 1, 1), printable(name),
                     "found a column's name of two lines", "names of one line each");
  if (name.starts_with('_')) return;
  const auto refuse = [&](std::string found, std::string allowed, std::string remedy = {}) {
    throw InputError(Origin::in_file(path, 1, 1), printable(name), std::move(found),
                     std::move(allowed), std::move(remedy));
  };
  if (name.starts_with("output."))
    refuse("found a column that would give its rows other columns",
           "a key that may differ from row to row", "give it with --set, for all rows");
  if (name == "continuation.start_row")
    refuse("found a column of starts", "a key of the case itself",
           "a study follows each row from its own start");
  if (may_be_set(name)) return;
  std::vector<std::string_view> known;
  for (const CaseKey& key : case_keys()) known.push_back(key.path);
  refuse("found a column that names no key of a case",
         "dotted keys such as motion.nu, or names that begin with \"_\"",
         did_you_mean(nearest_name(name == "nu" ? "motion.nu" : std::string_view(name), known)));
}

/// A column's key would replace what an earlier one has set: body.J after body.J.1.
void require_apart(const std::string& path, const std::vector<std::string>& names) {
  for (std::size_t k = 0; k < names.size(); ++k)
    for (std::size_t before = 0; before < k; ++before)
      if (names[before].starts_with(names[k] + '.'))
        throw InputError(Origin::in_file(path, 1, 1), printable(names[k]),
                         "found a column that replaces what " + in_quotes(names[before]) + " sets",
                         "each number in one column");
}

}  // namespace

std::string toml_value(const std::string& key, const std::string& cell) {
  if (cell == "True") return "true";
  if (cell == "False") return "false";
  if (!takes_text(key, cell) || cell.front() == '"' || cell.front() == '\'') return cell;
  std::string out = "\"";
  for (const char c : cell) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  out += '"';
  return out;
}

bool is_number(std::string_view cell) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc() && end == cell.data() + cell.size();
}

StudySource::StudySource(const std::string& path) : StudySource(open_table(path), path) {}

StudySource::StudySource(TableReader table, std::string path) : path_(std::move(path)) {
  names_ = table.columns();
  for (const std::string& name : names_) require_name(path_, name);
  require_apart(path_, names_);
  std::size_t kept = 0;
  while (table.next()) {
    std::vector<Cell>& row = rows_.emplace_back();
    for (std::size_t k = 0; k < names_.size(); ++k) {
      row.push_back({std::string(table.text(k)), table.fault(k, {}).origin()});
      require_text(row.back().place, names_[k], row.back().text);
    }
    if (!table.is_empty_line()) kept = rows_.size();
  }
  // Empty lines at the end are no rows; of several columns they would have too few.
  if (names_.size() == 1) rows_.resize(kept);
  if (rows_.empty())
    throw InputError(Origin::in_file(path_), "", "found no rows", "a header and a row at least");
  for (std::size_t k = 0; k < names_.size(); ++k) {
    const bool numbers = std::ranges::all_of(rows_, [k](const std::vector<Cell>& row) {
      return row[k].text.empty() || is_number(row[k].text);
    });
    columns_.push_back({names_[k], numbers ? CellKind::number : CellKind::text});
  }
}

bool StudySource::has_column(std::string_view key) const {
  return std::ranges::find(names_, key) != names_.end();
}

bool StudySource::has(std::string_view key, std::string_view cell) const {
  const auto at = std::ranges::find(names_, key);
  if (at == names_.end()) return false;
  const auto column = static_cast<std::size_t>(at - names_.begin());
  return std::ranges::any_of(rows_, [&](const auto& row) {
    const std::string& text = row[column].text;
    return text == cell ||
           toml_value(names_[column], text.empty() ? " " : text) == '"' + std::string(cell) + '"';
  });
}

std::vector<Override> StudySource::overrides(std::size_t k) const {
  std::vector<Override> out;
  for (std::size_t c = 0; c < names_.size(); ++c) {
    const Cell& cell = rows_[k][c];
    if (names_[c].starts_with('_') || cell.text.empty()) continue;
    out.push_back({names_[c] + "=" + toml_value(names_[c], cell.text), cell.place});
  }
  return out;
}

std::string StudySource::cells(std::size_t k) const {
  std::string out;
  for (std::size_t c = 0; c < names_.size(); ++c) {
    if (c > 0) out += ',';
    out += csv_cell(rows_[k][c].text);
  }
  return out;
}

std::string StudySource::text() const {
  std::string out = csv_header(columns());
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const std::string line = cells(k);
    out += (line.empty() ? "\"\"" : line) + '\n';
  }
  return out;
}

}  // namespace stationary::cli
