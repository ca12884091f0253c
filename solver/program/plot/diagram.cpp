#include "solver/program/plot/diagram.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/body/motion.hpp"

namespace stationary {
namespace {

using Place = std::optional<std::size_t>;

constexpr std::array<Column, 3> nu_columns{Column::nu1, Column::nu2, Column::nu3};
constexpr std::array<std::string_view, 3> nu_symbols{"ν₁", "ν₂", "ν₃"};

[[noreturn]] void refuse(const TableReader& table, std::string found, std::string allowed) {
  throw InputError(Origin::in_file(table.name()), "", std::move(found), std::move(allowed));
}

double number(const TableReader& table, Place column) {
  return column ? table.number(*column) : std::numeric_limits<double>::quiet_NaN();
}

std::string_view text(const TableReader& table, Place column) {
  return column ? table.text(*column) : std::string_view();
}

template <std::size_t n>
std::array<Place, n> places(const TableReader& table, const std::array<Column, n>& columns) {
  std::array<Place, n> out;
  for (std::size_t k = 0; k < n; ++k) out[k] = table.column(name(columns[k]));
  return out;
}

/// The parameter of each row, and what it is called.
class ParameterReader {
 public:
  explicit ParameterReader(const TableReader& table)
      : table_(&table), nu_(places(table, nu_columns)), omega_(table.column(name(Column::omega))) {
    const std::vector<std::string>& columns = table.columns();
    const bool is_nu = columns.back() == "nu";  // of a map
    if (!is_nu && columns.back().find('.') == std::string::npos) return;
    key_ = columns.size() - 1;
    symbol_ = is_nu ? "ν" : columns.back();
  }

  double value(std::string_view branch) {
    if (key_) return table_->number(*key_);
    if (branch == two_polar_name) {
      called("ω");
      return need(omega_, Column::omega, branch);
    }
    if (const std::optional<Branch> axis = branch_from_name(branch)) {
      const auto k = static_cast<std::size_t>(*axis);
      called(nu_symbols[k]);
      return need(nu_[k], nu_columns[k], branch);
    }
    called("ν");
    std::array<double, 3> nu;
    for (std::size_t k = 0; k < nu.size(); ++k) nu[k] = need(nu_[k], nu_columns[k], branch);
    const double norm = std::hypot(nu[0], nu[1], nu[2]);
    return std::ranges::all_of(nu, [](double v) { return v <= 0.0; }) ? -norm : norm;
  }

  const std::string& symbol() const { return symbol_; }

 private:
  double need(Place column, Column c, std::string_view branch) const {
    if (column) return table_->number(*column);
    refuse(*table_,
           "found no column " + in_quotes(name(c)) + ", the parameter of " +
               (branch.empty() ? "its rows" : "branch " + in_quotes(branch)),
           "it, or a trailing column such as body.J.0");
  }

  /// Families of several axes in one table share the axis of the diagram.
  void called(std::string_view symbol) {
    constexpr std::string_view both = "ν, ω";
    if (symbol_.empty()) {
      symbol_ = symbol;
    } else if (symbol_ != symbol && symbol_ != both) {
      symbol_ = symbol_ == "ω" || symbol == "ω" ? both : "ν";
    }
  }

  const TableReader* table_;
  Place key_;
  std::array<Place, 3> nu_;
  Place omega_;
  std::string symbol_;
};

std::optional<StabilityClass> verdict(const TableReader& table, Place column) {
  const std::string_view found = text(table, column);
  if (found.empty()) return std::nullopt;
  const auto at = std::ranges::find(stability_names, found);
  if (at == std::end(stability_names))
    throw table.fault(*column, "stable, elliptic, unstable, oscillatory or marginal");
  return static_cast<StabilityClass>(at - std::begin(stability_names));
}

}  // namespace

bool DiagramPoint::has_spectrum() const {
  return std::isfinite(growth) ||
         std::ranges::any_of(frequency, [](double f) { return std::isfinite(f); });
}

Diagram read_diagram(TableReader& table) {
  std::array<Column, mode_count> frequency_columns;
  for (int k = 0; k < mode_count; ++k)
    frequency_columns[static_cast<std::size_t>(k)] = mode_column(k, ModePart::im);
  const auto stretch = places(table, stretch_columns);
  const auto frequency = places(table, frequency_columns);
  const Place branch = table.column(name(Column::branch));
  const Place sheet = table.column(name(Column::sheet));
  const Place event = table.column(name(Column::event));
  const Place stability = table.column(name(Column::stability));
  const Place growth = table.column(name(Column::growth));
  if (std::ranges::none_of(stretch, [](Place p) { return p.has_value(); }))
    refuse(table, "found none of the columns lambda, mu, rho", "at least one of them");

  Diagram out;
  ParameterReader parameter(table);
  std::string piece_branch;
  std::string piece_sheet;
  while (table.next()) {
    const std::string_view row_branch = text(table, branch);
    const std::string_view row_sheet = text(table, sheet);
    if (out.points.empty() || row_branch != piece_branch || row_sheet != piece_sheet) {
      out.pieces.push_back(out.points.size());
      piece_branch = row_branch;
      piece_sheet = row_sheet;
    }
    DiagramPoint point;
    point.parameter = parameter.value(row_branch);
    for (std::size_t k = 0; k < stretch.size(); ++k) {
      point.stretch[k] = number(table, stretch[k]);
      out.has_stretch[k] |= std::isfinite(point.stretch[k]);
    }
    for (std::size_t k = 0; k < frequency.size(); ++k)
      point.frequency[k] = number(table, frequency[k]);
    if (frequency.back()) {
      // At nu = 0 the lowest mode, the spin's own, is missing: the others keep their lines.
      const auto end =
          std::ranges::find_if(point.frequency, [](double f) { return std::isnan(f); });
      std::rotate(point.frequency.begin(), end, point.frequency.end());
    }
    point.growth = number(table, growth);
    point.verdict = verdict(table, stability);
    const std::string_view row_event = text(table, event);
    point.event = !row_event.empty();
    if (point.event) out.events.push_back({std::string(row_event), out.points.size()});
    out.has_classes |= point.verdict.has_value();
    out.has_spectrum |= point.has_spectrum();
    out.points.push_back(point);
  }
  const auto drawable = [](const DiagramPoint& p) {
    return std::isfinite(p.parameter) &&
           std::ranges::any_of(p.stretch, [](double s) { return std::isfinite(s); });
  };
  if (out.points.empty()) refuse(table, "found no rows", "a table with at least one");
  if (std::ranges::none_of(out.points, drawable)) {
    refuse(table, "found no row with both " + parameter.symbol() + " and a stretch",
           "a table with at least one");
  }
  out.parameter = parameter.symbol();
  return out;
}

}  // namespace stationary
