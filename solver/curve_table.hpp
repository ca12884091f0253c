// A followed curve as rows of a table, and in short: where its stability changes.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/equilibrium_row.hpp"
#include "solver/event_enclosure.hpp"
#include "solver/follow.hpp"
#include "solver/problem.hpp"
#include "solver/table.hpp"

namespace stationary {

/// Stretches of one class along a curve.
class CurveSummary {
 public:
  struct Stretch {
    StabilityClass verdict;
    double from;
    double to;
  };

  void add(double parameter, std::optional<StabilityClass> verdict);
  double first_parameter() const { return first_; }
  double last_parameter() const { return last_; }
  /// Single points (an event's own class) are left out.
  std::vector<Stretch> stretches() const;

 private:
  struct Counted {
    Stretch stretch;
    long points;
  };
  std::vector<Counted> all_;
  double first_ = std::numeric_limits<double>::quiet_NaN();
  double last_ = std::numeric_limits<double>::quiet_NaN();
};

/// How many rows are proven.
struct CurveProofs {
  long rows = 0;
  long proven = 0;
  double first_gap = std::numeric_limits<double>::quiet_NaN();  ///< parameter of one that is not
  std::string reason;                                           ///< why that one is not
};

class CurveTable final : public CurveSink {
 public:
  /// Rows of sheet `sheet` from point `point` on; branch: a name that outlives this; writer may be
  /// null: then only the summary is made.
  CurveTable(std::string_view branch, RowSink* writer, int sheet = 1, long point = 0)
      : branch_(branch), writer_(writer), point_(point) {
    row_[Column::sheet] = sheet;
  }

  /// Proves every row (prove_row()), and of an event's row that the event is there
  /// (event_enclosure.hpp); problem_at(p) is the problem at the parameter p.
  void prove(std::function<Problem(double)> problem_at, const FamilyParameter& parameter) {
    problem_at_ = std::move(problem_at);
    parameter_ = parameter;
  }
  /// prove_row() of a member whose row is filled.
  using Prover = std::function<RowProof(const Member&, const Equilibrium&, TableRow&)>;
  /// Proves every row of a family whose events have no enclosures.
  void prove(Prover prover) { prover_ = std::move(prover); }
  /// Adds the enclosures of the events of the rows so far.
  void add_enclosures(std::vector<EventRecord>& events) const;

  void row(const Member& member, EventType event) override;
  /// A row that was in a table already, with this table's sheet and next point.
  void again(TableRow row);
  const CurveSummary& summary() const { return summary_; }
  const CurveProofs& proofs() const { return proofs_; }

 private:
  struct ProvenEvent {
    EventType type;
    double parameter;
    Interval enclosure;
  };

  bool proves() const { return problem_at_ || prover_; }
  RowProof prove(const Member& member, EventType event);
  void count_proof(bool proven, double parameter, const std::string& reason);
  double parameter_of(const TableRow& row) const;

  std::string_view branch_;
  RowSink* writer_;
  long point_;
  TableRow row_;
  CurveSummary summary_;
  std::function<Problem(double)> problem_at_;  ///< empty, and prover_ too: nothing is proven
  FamilyParameter parameter_;
  Prover prover_;
  CurveProofs proofs_;
  std::vector<ProvenEvent> events_;
};

}  // namespace stationary
