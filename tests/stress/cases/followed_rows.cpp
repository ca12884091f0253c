#include "tests/stress/cases/followed_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "solver/family/follow_sheet.hpp"
#include "solver/proof/event_system.hpp"
#include "tests/stress/judge/hard_case.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary::stress {
namespace {

using testing::Number50;

class KeptRows final : public CurveSink {
 public:
  struct Row {
    Member member;
    EventType event;
  };
  void row(const Member& member, EventType event) override { rows.push_back({member, event}); }
  std::vector<Row> rows;
};

Ingredients stiff_body(Random& random) {
  for (;;) {
    Ingredients out = random_ingredients(random, 2.0);
    // Of those with coefficients mu and lambda.
    if (out.model.model == "reciprocal-determinant") continue;
    out.plane[1] = out.plane[0] * power_of_ten(random, -1.0, 10.0);
    if (random.integer(0, 3) == 0) out.J2 = out.J1;
    out.nu = 0.2 * escape_speed(out);
    return out;
  }
}

/// What may vanish at an event of these types.
std::vector<EventFunction> functions_of(EventType type, Branch branch) {
  if (type == EventType::fold_nu) return {{.kind = EventFunction::Kind::fold}};
  if (type == EventType::fold_momentum) return {{.kind = EventFunction::Kind::momentum}};
  if (type != EventType::tilt && type != EventType::inertia_exchange) return {};
  std::vector<EventFunction> out;
  for (const auto [a, b] : {std::array{0, 2}, std::array{1, 2}, std::array{0, 1}}) {
    const bool tilts =
        b == 2 && !(branch == Branch::i && a == 1) && !(branch == Branch::ii && a == 0);
    if (tilts == (type == EventType::tilt))
      out.push_back({.kind = EventFunction::Kind::inertia, .a = a, .b = b});
  }
  return out;
}

/// The event's own equations in 50 digits: (xi, zeta, rho, nu).
std::array<Number50, 4> event_50(const Problem& problem, const EventFunction& function,
                                 const Member& at) {
  const EventSetting setting{problem.body(), problem.potential(), problem.branch(), at.nu, {},
                             Circle::none,   Inputs::doubles};
  const EventEquations<false, false, Number50> equations(setting, function);
  const auto values = [&](const std::array<Number50, 4>& y) {
    return equations.values(y, [](double x, FamilyParameter::Kind, int) { return Number50(x); });
  };
  return testing::newton_50<4>(
      {Number50(at.q.xi), Number50(at.q.zeta), Number50(at.q.rho), Number50(at.parameter)},
      [&](const std::array<Number50, 4>& y) {
        testing::Linearized50<4> out;
        out.first = values(y);
        const Number50 h("1e-17");
        for (std::size_t k = 0; k < 4; ++k) {
          auto ahead = y;
          auto behind = y;
          ahead[k] *= 1 + h;
          behind[k] *= 1 - h;
          const auto a = values(ahead);
          const auto b = values(behind);
          for (std::size_t i = 0; i < 4; ++i) out.second[i][k] = (a[i] - b[i]) / (2 * h);
        }
        return out;
      });
}

class Judge {
 public:
  Judge(const HardCase& c, const FollowReport& report, FollowedRows& out)
      : case_(&c), report_(&report), out_(&out) {}

  void row(const KeptRows::Row& row) {
    const Member& at = row.member;
    if (at.parameter == 0.0) return;
    if (row.event == EventType::none || is_end(row.event)) {
      ++out_->rows;
      hold(testing::reference_solution(case_->problem, at.nu, at.q), row);
      return;
    }
    const auto functions = functions_of(row.event, case_->problem.branch());
    if (functions.empty() || at.q.xi == at.q.zeta) return;
    ++out_->events;
    std::optional<std::array<Number50, 4>> event;
    for (const EventFunction& function : functions) {
      const auto y = nearby(function, at);
      if (y && (!event || abs((*y)[3] - at.parameter) < abs((*event)[3] - at.parameter))) event = y;
    }
    if (!event) {
      fault(row, "is no event");
      return;
    }
    hold({(*event)[0], (*event)[1], (*event)[2]}, row);
    const auto record = std::ranges::find_if(report_->events, [&](const EventRecord& each) {
      return each.type == row.event && each.parameter == at.parameter;
    });
    if (record == report_->events.end()) {
      fault(row, "has no record");
    } else if (!(record->before <= (*event)[3] && (*event)[3] <= record->after)) {
      std::ostringstream text;
      text.precision(20);
      text << "is at " << (*event)[3] << ", outside its bracket " << record->before << " ... "
           << record->after;
      fault(row, text.str());
    }
  }

  void fault(const KeptRows::Row& row, const std::string& what) {
    std::ostringstream text;
    text.precision(17);
    text << case_->text << ": " << name(row.event) << " row at nu " << row.member.parameter << " "
         << what;
    out_->faults.push_back(text.str());
  }

 private:
  std::optional<std::array<Number50, 4>> nearby(const EventFunction& function,
                                                const Member& at) const {
    try {
      const auto y = event_50(case_->problem, function, at);
      const Number50 moved = abs(y[3] / at.parameter - 1);
      return moved < 0.01 ? std::optional(y) : std::nullopt;
    } catch (const std::runtime_error&) {  // none near by
      return std::nullopt;
    }
  }

  void hold(const std::array<Number50, 3>& exact, const KeptRows::Row& row) {
    const double error = testing::relative_error(row.member.q, exact);
    const double bound = row.member.error_bound;
    out_->worst_error_over_bound = std::max(out_->worst_error_over_bound, error / bound);
    out_->widest_bound = std::max(out_->widest_bound, bound);
    if (error <= bound) return;
    std::ostringstream text;
    text << "is off by " << error << ", bound " << bound;
    fault(row, text.str());
  }

  const HardCase* case_;
  const FollowReport* report_;
  FollowedRows* out_;
};

}  // namespace

FollowedRows followed_rows(long sheets) {
  Random random(16);
  FollowedRows out;
  while (out.sheets < sheets) {
    const Ingredients body = stiff_body(random);
    const HardCase c = body.posed();
    const Equilibrium at = solve(c.problem, c.nu, c.options);
    if (at.status != SolveStatus::solved) continue;
    ++out.sheets;
    FollowOptions how;
    how.continuation.to = 5.0 * escape_speed(body);
    how.continuation.step.tolerance = 1e-5;
    how.max_points = 400;
    KeptRows kept;
    const FollowReport report =
        follow(axis_family(c.problem, {.nu = 0.0, .parameter = {}, .spectrum = false}), at.q, c.nu,
               how, kept);
    out.ends +=
        report.forward.event == EventType::collapse || report.forward.event == EventType::escape;
    Judge judge(c, report, out);
    for (const KeptRows::Row& row : kept.rows) {
      try {
        judge.row(row);
      } catch (const std::runtime_error& error) {
        judge.fault(row, error.what());
      }
    }
  }
  return out;
}

}  // namespace stationary::stress
