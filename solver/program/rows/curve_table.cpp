#include "solver/program/rows/curve_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "solver/program/text/named.hpp"

namespace stationary {

void CurveTable::place(EventType event, double parameter, bool voting,
                       std::optional<StabilityClass> verdict) {
  if (point_ == 0) first_parameter_ = parameter;
  last_parameter_ = parameter;
  last_votes_ = voting;
  row_[Column::segment] = segments_.row(point_, {event, parameter}, verdict, voting);
  row_[Column::point] = static_cast<double>(point_);
  if (event != EventType::none)
    events_.push_back({event, parameter, point_, std::nullopt, std::nullopt});
}

void CurveTable::convert(FollowReport& report) const {
  if (unit_ == 1.0) return;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (EventRecord& each : report.events) {
    each.parameter /= unit_;
    const bool ascending = each.before <= each.after;
    each.before = std::nextafter(each.before / unit_, ascending ? -infinity : infinity);
    each.after = std::nextafter(each.after / unit_, ascending ? infinity : -infinity);
  }
}

void CurveTable::row(const Member& member, EventType event) {
  place(event, member.parameter / unit_, has_class_of_curve(event, member),
        member.spectrum ? std::optional(member.spectrum->verdict) : std::nullopt);
  if (writer_ != nullptr) fill_row(branch_, member, writer_->columns(), row_);
  if (proves()) {
    const RowProof proof = prove(member, event);
    count_proof(proof.proven, member.parameter / unit_, proof.reason);
    if (event == EventType::none && member.spectrum && !proof.class_proven)
      count_class(member.parameter / unit_);
  }
  if (writer_ != nullptr) {
    tell_normal_form(member, event);
    tell_in(coordinates_, writer_->columns(), row_);
    row_.event = name(event);
    row_.parameter /= unit_;
    writer_->write(row_);
  }
  ++point_;
}

void CurveTable::tell_normal_form(const Member& member, EventType event) {
  row_[Column::criticality] = std::numeric_limits<double>::quiet_NaN();
  row_.side = {};
  if (event == EventType::none || !kind_of_event_) return;
  const auto form = kind_of_event_(member.parameter)->normal_form(parameter_, event, member);
  if (!form) return;
  row_[Column::criticality] = form->coefficient;
  row_.side = name(form->side);
  events_.back().criticality_error = form->error;
}

RowProof CurveTable::prove(const Member& member, EventType event) {
  const std::unique_ptr<Kind> kind = kind_at_(member.parameter);
  RowProof out = prove_row(*kind, equilibrium_of(member), member.spectrum, row_);
  const auto proof = prove_event(*kind, parameter_, event, member, row_);
  if (!proof) return out;
  // The row says more than that its stretches are in equilibrium, and at a fold less.
  out.proven = proof->proven;
  out.reason = std::string(name(event)) + ": " + proof->reason;
  if (proof->proven) events_.back().enclosure = proof->parameter / Interval(unit_);
  return out;
}

void CurveTable::complete(std::vector<EventRecord>& events) const {
  auto row = events_.begin();
  for (EventRecord& each : events) {
    if (each.status == EventStatus::unresolved) continue;
    const auto at = std::find_if(row, events_.end(), [&](const EventRow& candidate) {
      return candidate.type == each.type && candidate.parameter == each.parameter;
    });
    if (at == events_.end()) continue;
    each.point = at->point;
    if (at->enclosure) each.enclosure = at->enclosure;
    if (at->criticality_error) each.criticality_error = at->criticality_error;
    row = std::next(at);
  }
}

SheetRecord CurveTable::record(const FollowReport& report) const {
  SheetRecord out;
  out.sheet = static_cast<int>(row_[Column::sheet]);
  out.events = report.events;
  out.segments = segments_.segments();
  out.first = {report.backward.event, first_parameter_, report.backward.reason};
  out.last = {report.forward.event, last_parameter_, report.forward.reason};
  return out;
}

void CurveTable::again(TableRow row, std::optional<StabilityClass> verdict, bool at_rest) {
  const EventType type = named<EventType>(event_names, row.event).value();
  const double parameter = parameter_of(row);
  const bool in_nu = std::isnan(row.parameter);
  const bool voting = has_class_of_curve(type, in_nu ? parameter == 0.0 : at_rest);
  if (verdict && !voting && !last_votes_ && point_ > 0) segments_.between(*verdict);
  // Where the table has no column for it, a row that votes has the class of its segment.
  auto own = named<StabilityClass>(stability_names, row.stability);
  if (!own && voting) own = verdict;
  place(type, parameter, voting, own);
  if (proves()) {
    count_proof(row.certified != proof_word(false), parameter, "as it was in the table");
    if (type == EventType::none && row.class_certified == proof_word(false)) count_class(parameter);
  }
  for (const Column c : {Column::sheet, Column::point, Column::segment}) row[c] = row_[c];
  if (writer_ != nullptr) writer_->write(row);
  ++point_;
}

void CurveTable::count_proof(bool proven, double parameter, const std::string& reason) {
  if (!proven && proofs_.proven == proofs_.rows) {
    proofs_.first_gap = parameter;
    proofs_.reason = reason;
  }
  ++proofs_.rows;
  proofs_.proven += proven;
}

void CurveTable::count_class(double parameter) {
  if (proofs_.open_classes++ == 0) proofs_.first_open_class = parameter;
}

void CurveProofs::add(const CurveProofs& more) {
  if (proven == rows) {
    first_gap = more.first_gap;
    reason = more.reason;
  }
  if (open_classes == 0) first_open_class = more.first_open_class;
  rows += more.rows;
  proven += more.proven;
  open_classes += more.open_classes;
}

std::string CurveProofs::gap_text(std::string_view parameter) const {
  std::string out;
  if (proven != rows)
    out = fmt::format("{} of {} rows are not proven, the first of them at {} = {:.12g}: {}",
                      rows - proven, rows, parameter, first_gap, reason);
  if (open_classes > 0)
    out +=
        fmt::format("{}the class of {} row{} that {} no event is not proven, first at {} = {:.12g}",
                    out.empty() ? "" : "; ", open_classes, open_classes == 1 ? "" : "s",
                    open_classes == 1 ? "is" : "are", parameter, first_open_class);
  return out;
}

double CurveTable::parameter_of(const TableRow& row) const {
  return std::isnan(row.parameter) ? spin(branch_, row) : row.parameter;
}

std::vector<std::string_view> missing_to_resume(const std::vector<Column>& columns,
                                                const std::optional<std::string>& parameter,
                                                std::string_view branch) {
  std::vector<Column> needed{Column::event, Column::xi, Column::zeta, Column::rho};
  if (!parameter) {
    constexpr Column nu[] = {Column::nu1, Column::nu2, Column::nu3};
    if (const auto about = branch_from_name(branch)) {
      needed.push_back(nu[axis(*about)]);
    } else {
      needed.insert(needed.end(), std::begin(nu), std::end(nu));
    }
  }
  std::vector<std::string_view> out;
  for (const Column c : needed)
    if (std::ranges::find(columns, c) == columns.end()) out.push_back(name(c));
  return out;
}

}  // namespace stationary
