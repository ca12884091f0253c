#include "solver/program/diagram/diagram.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "lib/body/motion.hpp"
#include "lib/number/elementary.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/diagram/axis_name.hpp"
#include "solver/program/diagram/row_parameter.hpp"
#include "solver/program/text/named.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<Column, 3> stretch_columns{Column::lambda, Column::mu, Column::rho};
constexpr std::array<Column, 3> momentum_columns{Column::pi1, Column::pi2, Column::pi3};

[[noreturn]] void refuse(const TableReader& table, std::string found, std::string allowed) {
  throw InputError(Origin::in_file(table.name()), "", std::move(found), std::move(allowed));
}

double number(const TableReader& table, ColumnPlace column) {
  return column ? table.number(*column) : none;
}

std::string_view text(const TableReader& table, ColumnPlace column) {
  return column ? table.text(*column) : std::string_view();
}

bool is_number(const TableReader& table, std::string_view column) {
  if (!table.column(column)) return false;
  const auto known = find_column(column);
  return !known || cell_kind(*known) != CellKind::text;
}

std::optional<StabilityClass> verdict(const TableReader& table, ColumnPlace column) {
  const std::string_view found = text(table, column);
  if (found.empty()) return std::nullopt;
  const auto out = named<StabilityClass>(stability_names, found);
  if (!out) throw table.fault(*column, "stable, elliptic, unstable, oscillatory or marginal");
  return out;
}

/// What one table offers of a diagram.
class DiagramTable {
 public:
  DiagramTable(TableReader& table, const DiagramChoice& choice) : table_(&table) {
    std::vector<std::string> columns = choice.columns;
    if (choice.energy_momentum) {
      columns = {std::string(name(Column::energy))};
      momentum_ = places(table, momentum_columns);
      for (const auto& each : momentum_)
        if (!each)
          refuse(table, "found not all of the columns pi1, pi2, pi3",
                 "the angular momentum, for --diagram energy-momentum");
    }
    if (columns.empty()) {
      for (std::size_t k = 0; k < stretch_columns.size(); ++k)
        ordinates_[k] = table.column(name(stretch_columns[k]));
      if (std::ranges::none_of(ordinates_, [](ColumnPlace p) { return p.has_value(); }))
        refuse(table, "found none of the columns lambda, mu, rho", "at least one of them");
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (!is_number(table, columns[k])) refuse_column(columns[k]);
      ordinates_[k] = table.column(columns[k]);
    }
    for (int k = 0; k < mode_count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      frequency_[at] = table.column(name(mode_column(k, ModePart::im)));
      krein_[at] = table.column(name(mode_column(k, ModePart::krein)));
    }
  }

  DiagramPoint point(double parameter) const {
    DiagramPoint out{};
    out.parameter = parameter;
    out.abscissa = parameter;
    if (momentum_[0]) {
      out.abscissa = hypotenuse(number(*table_, momentum_[0]), number(*table_, momentum_[1]),
                                number(*table_, momentum_[2]));
    }
    for (std::size_t k = 0; k < ordinates_.size(); ++k)
      out.ordinate[k] = number(*table_, ordinates_[k]);
    for (std::size_t k = 0; k < frequency_.size(); ++k) {
      out.frequency[k] = number(*table_, frequency_[k]);
      const double sign = number(*table_, krein_[k]);
      out.krein[k] = static_cast<std::int8_t>(sign > 0.0 ? 1 : sign < 0.0 ? -1 : 0);
    }
    out.growth = number(*table_, growth_);
    out.verdict = verdict(*table_, stability_);
    return out;
  }

  std::string_view branch() const { return text(*table_, branch_); }
  std::string_view sheet() const { return text(*table_, sheet_); }
  std::string_view event() const { return text(*table_, event_); }
  bool has_krein() const { return krein_[0].has_value(); }

 private:
  [[noreturn]] void refuse_column(const std::string& asked) const {
    std::vector<std::string_view> names;
    for (const std::string& each : table_->columns())
      if (is_number(*table_, each)) names.push_back(each);
    throw InputError(Origin::of_option("--show " + asked), "",
                     "found no such column of numbers in " + printable(table_->name()),
                     "one of " + listed(names), did_you_mean(nearest_name(asked, names)));
  }

  TableReader* table_;
  std::array<ColumnPlace, most_ordinates> ordinates_{};
  std::array<ColumnPlace, 3> momentum_{};
  std::array<ColumnPlace, mode_count> frequency_{};
  std::array<ColumnPlace, mode_count> krein_{};
  ColumnPlace branch_ = table_->column(name(Column::branch));
  ColumnPlace sheet_ = table_->column(name(Column::sheet));
  ColumnPlace event_ = table_->column(name(Column::event));
  ColumnPlace stability_ = table_->column(name(Column::stability));
  ColumnPlace growth_ = table_->column(name(Column::growth));
};

/// Those of a kind that are asked for, and those there are.
class Wanted {
 public:
  Wanted(std::string option, const std::vector<std::string>& asked)
      : option_(std::move(option)), asked_(asked.begin(), asked.end()) {}

  bool takes(std::string_view name) {
    found_.emplace(name);
    return asked_.empty() || asked_.contains(std::string(name));
  }

  void check() const {
    for (const std::string& each : asked_) {
      if (found_.contains(each)) continue;
      const std::vector<std::string_view> names(found_.begin(), found_.end());
      throw InputError(Origin::of_option("--" + option_ + " " + each), "",
                       "found no such " + option_, "one of " + listed(names));
    }
  }

 private:
  std::string option_;
  std::set<std::string> asked_;
  std::set<std::string> found_;
};

/// Adds the rows of table after table to a diagram.
class DiagramReader {
 public:
  DiagramReader(const DiagramChoice& choice, bool several)
      : choice_(choice),
        several_(several),
        sheets_("sheet", choice.sheets),
        branches_("branch", choice.branches) {
    out_.of_energy_and_momentum = choice.energy_momentum;
    out_.columns = choice.columns;
    if (choice.energy_momentum) out_.columns = {std::string(name(Column::energy))};
    if (out_.columns.empty())
      for (const Column c : stretch_columns) out_.columns.emplace_back(name(c));
  }

  void add(TableReader& table) {
    const DiagramTable source(table, choice_);
    RowParameter parameter(table);
    const std::string letters = table_letters(out_.tables.size());
    const std::size_t first_piece = out_.pieces.size();
    out_.tables.push_back(table.name());
    bool rows = false;
    bool taken = false;
    bool drawable = false;
    std::string before;  // branch and sheet of the row before
    while (table.next()) {
      rows = true;
      const std::string branch(source.branch());
      const std::string sheet(source.sheet());
      const double value = parameter.value(branch);
      if (!branches_.takes(branch) || !sheets_.takes(sheet)) {
        before.clear();
        continue;
      }
      taken = true;
      const std::string now = branch + '\n' + sheet;
      if (out_.pieces.size() == first_piece || now != before) {
        const std::size_t at = out_.points.size();
        out_.pieces.push_back({at, at, place_of(table, branch, parameter.symbol(branch)), sheet});
        before = now;
      }
      add_row(source, value);
      const DiagramPoint& point = out_.points.back();
      drawable |= std::isfinite(point.abscissa) &&
                  std::ranges::any_of(point.ordinate, [](double s) { return std::isfinite(s); });
    }
    if (!rows) refuse(table, "found no rows", "a table with at least one");
    if (taken && !drawable) {
      const bool stretches = choice_.columns.empty() && !choice_.energy_momentum;
      refuse(table,
             "found no row with both " + out_.branches[out_.pieces.back().branch].parameter +
                 " and " + (stretches ? "a stretch" : printable(out_.columns.front())),
             "a table with at least one");
    }
    out_.has_krein |= source.has_krein();
    if (!several_) return;
    const bool one = out_.pieces.size() == first_piece + 1;
    for (std::size_t k = first_piece; k < out_.pieces.size(); ++k)
      out_.pieces[k].label = one ? letters : letters + out_.pieces[k].label;
  }

  Diagram take() {
    sheets_.check();
    branches_.check();
    if (out_.points.empty()) {
      throw InputError(Origin::of_option("--sheet"), "", "found no row of such a sheet and branch",
                       "a sheet of the branch");
    }
    return std::move(out_);
  }

 private:
  void add_row(const DiagramTable& source, double value) {
    DiagramPoint point = source.point(value);
    const std::string_view event = source.event();
    point.event = !event.empty();
    if (point.event) out_.events.push_back({std::string(event), out_.points.size()});
    out_.has_spectrum |= point.has_spectrum();
    out_.points.push_back(point);
    out_.pieces.back().end = out_.points.size();
  }

  std::size_t place_of(const TableReader& table, const std::string& branch,
                       const std::string& symbol) {
    const auto at = std::ranges::find(out_.branches, branch, &DiagramBranch::name);
    if (at == out_.branches.end()) {
      out_.branches.push_back({branch, symbol});
      return out_.branches.size() - 1;
    }
    if (at->parameter != symbol && !choice_.energy_momentum)
      refuse(table, "found the parameter " + in_quotes(symbol),
             at->parameter + ", as in the table before: tables of one parameter");
    return static_cast<std::size_t>(at - out_.branches.begin());
  }

  const DiagramChoice& choice_;
  bool several_;
  Wanted sheets_;
  Wanted branches_;
  Diagram out_;
};

}  // namespace

bool DiagramPoint::has_spectrum() const {
  return std::isfinite(growth) ||
         std::ranges::any_of(frequency, [](double f) { return std::isfinite(f); });
}

bool Diagram::of_stretches() const {
  return columns.size() == stretch_columns.size() && columns.front() == name(Column::lambda) &&
         columns[1] == name(Column::mu) && columns[2] == name(Column::rho);
}

std::string table_letters(std::size_t table) {
  constexpr std::size_t alphabet = 26;
  const std::string last(1, static_cast<char>('a' + static_cast<int>(table % alphabet)));
  return table < alphabet ? last : table_letters(table / alphabet - 1) + last;
}

Diagram read_diagram(const std::vector<TableReader*>& tables, const DiagramChoice& choice) {
  DiagramReader reader(choice, tables.size() > 1);
  for (TableReader* table : tables) {
    require_drawable(*table);
    reader.add(*table);
  }
  return reader.take();
}

}  // namespace stationary
