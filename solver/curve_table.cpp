#include "solver/curve_table.hpp"

#include "solver/equilibrium_row.hpp"

namespace stationary {

void CurveSummary::add(const Member& member) {
  const double p = member.parameter;
  if (first_ != first_) first_ = p;
  last_ = p;
  if (!member.spectrum) return;
  const StabilityClass verdict = member.spectrum->verdict;
  if (!all_.empty() && all_.back().stretch.verdict == verdict) {
    all_.back().stretch.to = p;
    ++all_.back().points;
  } else {
    all_.push_back({{verdict, p, p}, 1});
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
  summary_.add(member);
  if (writer_ != nullptr) {
    fill_row(branch_, member, row_);
    row_.event = name(event);
    row_[Column::point] = static_cast<double>(point_);
    writer_->write(row_);
  }
  ++point_;
}

}  // namespace stationary
