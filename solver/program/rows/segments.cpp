#include "solver/program/rows/segments.hpp"

#include <algorithm>
#include <cmath>

namespace stationary {

void SegmentBuilder::extend(Open& open, double parameter) {
  auto& runs = open.runs;
  if (runs.empty()) {
    runs.push_back({parameter, parameter});
    return;
  }
  // Beside a turn the roundings of two rows may be in another order than the rows.
  const double change = parameter - runs.back()[1];
  if (!(std::abs(change) > 0x1p-48 * std::abs(parameter))) return;
  const double so_far = runs.back()[1] - runs.back()[0];
  if (so_far != 0.0 && (so_far < 0.0) != (change < 0.0)) {
    runs.push_back({runs.back()[1], parameter});
  } else {
    runs.back()[1] = parameter;
  }
}

void SegmentBuilder::begin(const SegmentBound& from, std::optional<StabilityClass> verdict) {
  all_.emplace_back();
  all_.back().segment.number = static_cast<int>(all_.size());
  all_.back().segment.verdict = verdict;
  all_.back().segment.from = from;
  extend(all_.back(), from.parameter);
}

void SegmentBuilder::turn(const SegmentBound& at, StabilityClass verdict) {
  if (events_.empty()) {
    all_.back().segment.to = last_;
    begin({EventType::none, at.parameter}, verdict);
    return;
  }
  const auto capable = std::find_if(events_.rbegin(), events_.rend(), [](const SegmentBound& each) {
    return may_change_class(each.event);
  });
  const SegmentBound bound = capable == events_.rend() ? events_.back() : *capable;
  all_.back().segment.to = bound;
  begin(bound, verdict);
}

int SegmentBuilder::row(long point, const SegmentBound& at, std::optional<StabilityClass> verdict,
                        bool voting) {
  if (all_.empty()) begin(at, std::nullopt);
  if (voting && verdict) {
    std::optional<StabilityClass>& current = all_.back().segment.verdict;
    if (!current) {
      current = verdict;
    } else if (*current != *verdict) {
      turn(at, *verdict);
    }
    events_.clear();
  } else if (at.event != EventType::none && !is_end(at.event)) {
    events_.push_back(at);
  }
  Open& open = all_.back();
  if (!open.event_class) open.event_class = verdict;
  if (open.segment.first_point < 0) open.segment.first_point = point;
  open.segment.last_point = point;
  open.segment.to = at;
  extend(open, at.parameter);
  last_ = {EventType::none, at.parameter};
  return open.segment.number;
}

void SegmentBuilder::between(StabilityClass verdict) {
  if (all_.empty()) return;
  std::optional<StabilityClass>& current = all_.back().segment.verdict;
  // Not to be told half way: it is that of the stretch before, unless an event between may have
  // changed it.
  const auto may_have_changed = [](const SegmentBound& each) {
    return may_change_class(each.event);
  };
  if (verdict == StabilityClass::marginal && current &&
      std::ranges::none_of(events_, may_have_changed))
    return;
  if (!current) {
    current = verdict;
  } else if (*current != verdict) {
    turn(last_, verdict);
  }
  events_.clear();
}

std::vector<Segment> SegmentBuilder::segments() const {
  std::vector<Segment> out;
  for (const Open& each : all_) {
    out.push_back(each.segment);
    if (!out.back().verdict) out.back().verdict = each.event_class;
    for (const auto& [from, to] : each.runs)
      out.back().ranges.push_back({std::min(from, to), std::max(from, to)});
  }
  if (std::ranges::none_of(out, [](const Segment& each) { return each.verdict.has_value(); }))
    out.clear();
  return out;
}

}  // namespace stationary
