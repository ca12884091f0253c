// A sheet followed and kept: its rows, the events among them, and how it ended.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "solver/family/follow_sheet.hpp"
#include "solver/solve/solve.hpp"

namespace stationary::testing {

struct FollowedRow {
  Member member;
  EventType event;
};

struct Followed {
  std::vector<FollowedRow> rows;
  FollowReport report;

  /// Rows of these types, in order.
  std::vector<FollowedRow> events(std::initializer_list<EventType> types) const {
    std::vector<FollowedRow> out;
    for (const FollowedRow& row : rows)
      if (std::ranges::find(types, row.event) != types.end()) out.push_back(row);
    return out;
  }
  /// All events but the ends.
  std::vector<FollowedRow> events() const {
    std::vector<FollowedRow> out;
    for (const FollowedRow& row : rows)
      if (row.event != EventType::none && !is_end(row.event)) out.push_back(row);
    return out;
  }
  /// "tilt 0.747941 fold-nu ...", for messages.
  std::string text() const {
    std::string out;
    for (const FollowedRow& row : rows) {
      if (row.event == EventType::none) continue;
      out += std::string(name(row.event)) + " " + std::to_string(row.member.parameter) + "; ";
    }
    return out;
  }
};

class Kept final : public CurveSink {
 public:
  void row(const Member& member, EventType event) override { rows.push_back({member, event}); }
  std::vector<FollowedRow> rows;
};

/// From a solution at p, through a family made once.
inline Followed followed(const AnyFamily& family, const Stretch& q, double p,
                         const FollowOptions& options) {
  Kept kept;
  Followed out;
  out.report = follow(family, q, p, options, kept);
  out.rows = std::move(kept.rows);
  return out;
}

inline FollowOptions range(double from, double to, double tolerance = 1e-8) {
  FollowOptions out;
  out.continuation.from = from;
  out.continuation.to = to;
  out.continuation.step.tolerance = tolerance;
  return out;
}

/// Along nu from a solution at nu: of the start given, or of the rest state's sheet.
inline Followed followed(const Problem& problem, double nu, const FollowOptions& options,
                         bool spectrum = true, const SolveOptions& start = {}) {
  const Equilibrium at = solve(problem, nu, start);
  if (at.status != SolveStatus::solved) throw std::runtime_error("not solved: " + at.message);
  return followed(axis_family(problem, {.nu = 0.0, .parameter = {}, .spectrum = spectrum}), at.q,
                  nu, options);
}

}  // namespace stationary::testing
