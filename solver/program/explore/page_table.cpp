#include "solver/program/explore/page_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <utility>

#include "lib/stability/spectrum.hpp"
#include "solver/program/table/table.hpp"

namespace stationary {
namespace {

/// A dotted key of a case, a ratio of two, or nu.
bool is_parameter(const std::string& column) {
  constexpr std::string_view letters =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  return column == "nu" || (column.find('.') != std::string::npos &&
                            column.find_first_not_of(letters) == std::string::npos);
}

bool is_number(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [read_to, error] = std::from_chars(text.data(), end, value);
  return text.empty() || (error == std::errc() && read_to == end);
}

/// What a column's cells must be; of other people's columns that is seen from the cells.
enum class Rule { number, sheet, verdict, word, open };

Rule rule_of(const std::string& column) {
  if (is_parameter(column)) return Rule::number;
  const auto known = find_column(column);
  if (!known) return Rule::open;
  if (*known == Column::stability) return Rule::verdict;
  if (*known == Column::sheet) return Rule::sheet;
  return cell_kind(*known) == CellKind::text ? Rule::word : Rule::number;
}

void require_sheet(const TableReader& table, std::size_t column) {
  if (table.text(column).empty()) return;
  const double sheet = table.number(column);
  constexpr double most = 2147483647.0;
  if (!(sheet >= 1.0 && sheet <= most) || sheet != std::floor(sheet))
    throw table.fault(column, "a whole number from 1 on");
}

void check(const TableReader& table, std::size_t column, Rule rule) {
  const std::string_view cell = table.text(column);
  if (rule == Rule::number) static_cast<void>(table.number(column));
  if (rule == Rule::sheet) require_sheet(table, column);
  if (rule == Rule::verdict && !cell.empty() &&
      std::ranges::find(stability_names, cell) == std::end(stability_names))
    throw table.fault(column, "stable, elliptic, unstable, oscillatory or marginal");
}

std::string joined(const std::vector<std::string>& cells) {
  std::string out;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) out += ',';
    out += cell;
  }
  return out;
}

/// Whether a column is a number of motions: a page has it as an axis.
bool is_of_motions(const std::string& column) {
  if (is_parameter(column)) return true;
  const auto known = find_column(column);
  return known && cell_kind(*known) == CellKind::number;
}

}  // namespace

PageTable read_page_table(TableReader& table) {
  require_drawable(table);
  if (std::ranges::none_of(table.columns(), is_of_motions))
    throw InputError(Origin::in_file(table.name()), "",
                     "found no column of numbers that tells of motions",
                     "tables of solve, continue, atlas, map or curve");
  PageTable out;
  out.file = std::filesystem::path(table.name()).filename().string();
  out.title = out.file;
  std::vector<Rule> rules;
  for (const std::string& column : table.columns()) {
    rules.push_back(rule_of(column));
    if (is_parameter(column)) out.parameters.push_back(column);
    const bool numbers = rules.back() == Rule::number || rules.back() == Rule::sheet;
    out.columns.push_back({column, numbers, {}, {}});
  }
  while (table.next()) {
    for (std::size_t k = 0; k < rules.size(); ++k) {
      check(table, k, rules[k]);
      PageColumn& column = out.columns[k];
      if (!column.is_number) {
        column.words.emplace_back(table.text(k));
        continue;
      }
      if (out.rows > 0) column.numbers += ',';
      column.numbers += table.text(k);
    }
    ++out.rows;
  }
  if (out.rows == 0)
    throw InputError(Origin::in_file(table.name()), "", "found no rows",
                     "a table with at least one");
  for (std::size_t k = 0; k < rules.size(); ++k) {
    PageColumn& column = out.columns[k];
    if (rules[k] != Rule::open || !std::ranges::all_of(column.words, is_number)) continue;
    column.is_number = true;
    column.numbers = joined(column.words);
    column.words.clear();
  }
  return out;
}

}  // namespace stationary
