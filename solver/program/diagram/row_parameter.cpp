#include "solver/program/diagram/row_parameter.hpp"

#include <algorithm>
#include <cmath>

#include "lib/body/motion.hpp"
#include "lib/number/elementary.hpp"
#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/diagram/axis_name.hpp"

namespace stationary {
namespace {

constexpr std::array<Column, 3> nu_columns{Column::nu1, Column::nu2, Column::nu3};

}  // namespace

bool is_parameter(std::string_view column) {
  const auto [first, second] = parts_of(column);
  const auto is_number = [](std::string_view key) { return key == "nu" || is_number_of_case(key); };
  return is_number(first) && (second.empty() || is_number(second));
}

std::vector<std::string> parameters_among(const std::vector<std::string>& columns) {
  std::vector<std::string> out;
  for (const std::string& each : columns)
    if (is_parameter(each)) out.push_back(each);
  return out;
}

RowParameter::RowParameter(const TableReader& table)
    : table_(&table), nu_(places(table, nu_columns)), omega_(table.column(name(Column::omega))) {
  if (const auto own = parameters_among(table.columns()); !own.empty())
    key_ = table.column(own.back());
}

double RowParameter::value(std::string_view branch) const {
  if (key_) return table_->number(*key_);
  if (has_rates(branch)) return need(omega_, Column::omega, branch);
  if (const std::optional<Branch> axis = branch_from_name(branch)) {
    const auto k = static_cast<std::size_t>(*axis);
    return need(nu_[k], nu_columns[k], branch);
  }
  std::array<double, 3> nu;
  for (std::size_t k = 0; k < nu.size(); ++k) nu[k] = need(nu_[k], nu_columns[k], branch);
  const double norm = hypotenuse(nu[0], nu[1], nu[2]);
  return std::ranges::all_of(nu, [](double v) { return v <= 0.0; }) ? -norm : norm;
}

std::string RowParameter::symbol(std::string_view branch) const {
  if (key_) return axis_name(table_->columns()[*key_]);
  if (has_rates(branch)) return axis_name(name(Column::omega));
  if (const std::optional<Branch> axis = branch_from_name(branch))
    return axis_name(name(nu_columns[static_cast<std::size_t>(*axis)]));
  return "ν";
}

double RowParameter::need(ColumnPlace column, Column c, std::string_view branch) const {
  if (column) return table_->number(*column);
  throw InputError(Origin::in_file(table_->name()), "",
                   "found no column " + in_quotes(name(c)) + ", the parameter of " +
                       (branch.empty() ? "its rows" : "branch " + in_quotes(branch)),
                   "it, or a column such as body.J.0");
}

}  // namespace stationary
