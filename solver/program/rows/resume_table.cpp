#include "solver/program/rows/resume_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "lib/stability/spectrum.hpp"
#include "solver/normal_form/normal_form.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "solver/program/table/column_file.hpp"
#include "solver/program/table/table_reader.hpp"

namespace stationary {
namespace {

constexpr std::string_view remedy =
    "--resume goes on with what `continue` wrote of the same case and columns";

/// The name as it stands in a list of names, which outlives the row; an empty cell says nothing.
template <std::size_t size>
std::string_view kept(const TableReader& table, std::size_t column,
                      const std::string_view (&names)[size]) {
  if (table.text(column).empty()) return {};
  const auto at = std::ranges::find(names, table.text(column));
  if (at == std::end(names)) throw table.fault(column, "a name `continue` writes");
  return *at;
}

constexpr std::string_view side_words[] = {name(EventSide::before), name(EventSide::after)};

TableRow read_row(const TableReader& table, const std::vector<Column>& columns, bool trailing,
                  std::string_view branch) {
  TableRow row;
  row.branch = branch;
  std::size_t k = 0;
  for (const Column c : columns) {
    switch (c) {
      case Column::branch:
        if (table.text(k) != row.branch) throw table.fault(k, "the case's branch");
        break;
      case Column::event:
        row.event = kept(table, k, event_names);
        break;
      case Column::stability:
        row.stability = kept(table, k, stability_names);
        break;
      case Column::certified:
        row.certified = kept(table, k, proof_words);
        break;
      case Column::class_certified:
        row.class_certified = kept(table, k, proof_words);
        break;
      case Column::side:
        row.side = kept(table, k, side_words);
        break;
      default:
        row[c] = table.number(k);
    }
    ++k;
  }
  if (trailing) row.parameter = table.number(k);
  return row;
}

CurvePlace place(const TableRow& row, bool trailing, std::string_view branch) {
  const double alpha = std::isnan(row[Column::alpha]) ? 0.0 : row[Column::alpha];
  return {{alpha, row[Column::xi], row[Column::zeta], row[Column::rho]},
          trailing ? row.parameter : spin(branch, row),
          {row[Column::nu1], row[Column::nu2], row[Column::nu3]}};
}

bool is_place(const CurvePlace& at) {
  return at.q.xi > 0.0 && at.q.zeta > 0.0 && at.q.rho > 0.0 && std::isfinite(at.p);
}

/// Whether the last row is there to its end: a cut number would still be one.
bool ends_a_line(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return file.seekg(-1, std::ios::end) && file.get() == '\n';
}

}  // namespace

ResumedTable read_resumed(const std::string& path, const std::vector<Column>& columns,
                          const std::optional<std::string>& parameter, std::string_view branch,
                          bool goes_on) {
  const bool columnar = is_column_file(path);
  TableReader table = open_table(path);
  std::vector<std::string> expected;
  for (const Column c : columns) expected.emplace_back(name(c));
  if (parameter) expected.push_back(*parameter);
  if (table.columns() != expected) {
    throw InputError(Origin::in_file(path), "", "found other columns than this case's",
                     "the table to go on with", std::string(remedy));
  }
  if (!columnar && !ends_a_line(path)) {
    throw InputError(Origin::in_file(path), "", "found its last line cut short", "a whole table",
                     std::string(remedy));
  }
  ResumedTable out;
  while (table.next()) out.rows.push_back(read_row(table, columns, parameter.has_value(), branch));
  if (const auto missing = missing_to_resume(columns, parameter, branch); !missing.empty())
    throw InputError(Origin::in_file(path), "",
                     fmt::format("found no column {}", fmt::join(missing, ", ")),
                     "a table that its rows can be gone on from",
                     "output.columns must have event, xi, zeta, rho and the parameter");
  if (out.rows.empty())
    throw InputError(Origin::in_file(path), "", "found no rows", "a row at least",
                     std::string(remedy));
  for (const TableRow* row : {&out.rows.front(), &out.rows.back()})
    if (!is_place(place(*row, !!parameter, branch)))
      throw InputError(Origin::in_file(path), "", "found a row without its stretches or parameter",
                       "numbers in the first row and the last", std::string(remedy));
  const auto open = [&](const TableRow& end, const TableRow& neighbour, int direction) {
    OpenEnd at{place(end, !!parameter, branch), std::nullopt, direction};
    if (out.rows.size() > 1) at.neighbour = place(neighbour, !!parameter, branch);
    return at;
  };
  if (out.rows.front().event.empty()) {
    out.first = open(out.rows.front(), out.rows[std::min<std::size_t>(1, out.rows.size() - 1)], -1);
  }
  if (out.rows.back().event.empty() || (out.rows.size() == 1 && goes_on)) {
    out.last = open(out.rows.back(),
                    out.rows[out.rows.size() - std::min<std::size_t>(2, out.rows.size())], +1);
  }
  return out;
}

}  // namespace stationary
