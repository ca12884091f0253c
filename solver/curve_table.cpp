#include "solver/curve_table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

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
  if (writer_ != nullptr) fill_row(branch_, member, writer_->columns(), row_);
  if (proves()) {
    const RowProof proof = prove(member, event);
    count_proof(proof.proven, member.parameter, proof.reason);
  }
  if (writer_ != nullptr) {
    row_.event = name(event);
    row_[Column::point] = static_cast<double>(point_);
    writer_->write(row_);
  }
  ++point_;
}

RowProof CurveTable::prove(const Member& member, EventType event) {
  Equilibrium at;
  at.q = member.q;
  at.nu = member.angular_velocity;
  if (prover_) return prover_(member, at, row_);
  const Problem problem = problem_at_(member.parameter);
  RowProof out = prove_row(problem, at, member.spectrum, row_);
  if (!has_enclosure(event)) return out;
  // The row says more than that its stretches are in equilibrium, and at a fold less.
  const bool circle = event == EventType::ellipse ||
                      (mirror_symmetric(problem, member.nu) && member.q.xi == member.q.zeta);
  const EventEnclosure proof = enclose_event(problem, parameter_, circle, event, member);
  out.proven = proof.proven;
  out.reason = std::string(name(event)) + ": " + proof.reason;
  row_.certified = proof_word(proof.proven, out.assuming);
  row_[Column::error_bound] = proof.proven ? proof.error_bound : member.error_bound;
  if (proof.proven) events_.push_back({event, member.parameter, proof.parameter});
  return out;
}

void CurveTable::add_enclosures(std::vector<EventRecord>& events) const {
  for (const ProvenEvent& proven : events_) {
    const auto at = std::ranges::find_if(events, [&](const EventRecord& each) {
      return each.type == proven.type && each.parameter == proven.parameter;
    });
    if (at != events.end()) at->enclosure = proven.enclosure;
  }
}

void CurveTable::again(TableRow row) {
  const auto verdict = std::ranges::find(stability_names, row.stability);
  summary_.add(
      parameter_of(row),
      verdict == std::end(stability_names)
          ? std::nullopt
          : std::optional(static_cast<StabilityClass>(verdict - std::begin(stability_names))));
  if (proves())
    count_proof(row.certified != proof_word(false), parameter_of(row), "as it was in the table");
  row[Column::sheet] = row_[Column::sheet];
  row[Column::point] = static_cast<double>(point_++);
  if (writer_ != nullptr) writer_->write(row);
}

void CurveTable::count_proof(bool proven, double parameter, const std::string& reason) {
  if (!proven && proofs_.proven == proofs_.rows) {
    proofs_.first_gap = parameter;
    proofs_.reason = reason;
  }
  ++proofs_.rows;
  proofs_.proven += proven;
}

double CurveTable::parameter_of(const TableRow& row) const {
  return std::isnan(row.parameter) ? spin(branch_, row) : row.parameter;
}

}  // namespace stationary
