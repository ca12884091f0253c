#include "solver/curve_table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "solver/equilibrium_row.hpp"

namespace stationary {

void CurveSummary::add(double parameter, std::optional<StabilityClass> verdict) {
  if (std::isnan(first_)) first_ = parameter;
  last_ = parameter;
  if (!verdict) return;
  if (!all_.empty() && all_.back().stretch.verdict == *verdict) {
    all_.back().stretch.to = parameter;
    ++all_.back().points;
  } else {
    all_.push_back({{*verdict, parameter, parameter}, 1});
  }
}

std::vector<CurveSummary::Stretch> CurveSummary::stretches() const {
  std::vector<Stretch> out;
  for (const auto& [stretch, points] : all_) {
    if (points == 1 && all_.size() > 1) continue;
    if (!out.empty() && out.back().verdict == stretch.verdict) {
      out.back().to = stretch.to;
    } else {
      out.push_back(stretch);
    }
  }
  return out;
}

void CurveTable::row(const Member& member, EventType event) {
  summary_.add(member.parameter,
               member.spectrum ? std::optional(member.spectrum->verdict) : std::nullopt);
  if (writer_ != nullptr) {
    fill_row(branch_, member, row_);
    row_.event = name(event);
    row_[Column::point] = static_cast<double>(point_);
    writer_->write(row_);
  }
  ++point_;
}

void CurveTable::again(TableRow row) {
  const auto verdict = std::ranges::find(stability_names, row.stability);
  summary_.add(
      parameter_of(row),
      verdict == std::end(stability_names)
          ? std::nullopt
          : std::optional(static_cast<StabilityClass>(verdict - std::begin(stability_names))));
  row[Column::sheet] = row_[Column::sheet];
  row[Column::point] = static_cast<double>(point_++);
  if (writer_ != nullptr) writer_->write(row);
}

double CurveTable::parameter_of(const TableRow& row) const {
  constexpr Column nu[] = {Column::nu1, Column::nu2, Column::nu3};
  return std::isnan(row.parameter) ? row[nu[axis(branch_)]] : row.parameter;
}

}  // namespace stationary
