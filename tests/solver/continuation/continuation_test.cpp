// Laws of a followed sheet, over every model and branch.
#include "solver/continuation/continuation.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies/model_and_branch.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/curve_error.hpp"
#include "tests/support/followed.hpp"
#include "tests/support/numbers/high_precision.hpp"

namespace stationary {
namespace {

using namespace testing;

double distance(const Stretch& a, const Stretch& b) {
  return std::max({std::abs(std::log(a.xi / b.xi)), std::abs(std::log(a.zeta / b.zeta)),
                   std::abs(std::log(a.rho / b.rho))});
}

/// The part of the sheet from rest along which nu rises.
std::vector<FollowedRow> before_the_first_fold(const Followed& sheet) {
  std::vector<FollowedRow> out;
  for (const FollowedRow& row : sheet.rows) {
    if (row.event == EventType::fold_nu) break;
    out.push_back(row);
  }
  return out;
}

/// "fold-nu tilt ..."
std::string types(const std::vector<FollowedRow>& events) {
  std::string out;
  for (const FollowedRow& row : events) out += std::string(name(row.event)) + " ";
  return out;
}

/// Both have the same events at the same nu; scale turns the second's nu into the first's.
void expect_same_events(const std::vector<FollowedRow>& a, const std::vector<FollowedRow>& b,
                        double tolerance, const std::string& x) {
  ASSERT_EQ(types(a), types(b)) << x;
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_NEAR(a[k].member.nu, b[k].member.nu, tolerance * std::abs(a[k].member.nu))
        << x << " " << name(a[k].event);
}

struct Exchanged {
  Body operator()(const Body& b) const { return {b.J2, b.J1, b.J3}; }
};

class EveryModelTest : public ::testing::TestWithParam<support::ModelAndBranch> {
 protected:
  std::string_view model() const { return std::get<0>(GetParam()); }
  Branch branch() const { return std::get<1>(GetParam()); }
  Problem problem(const Body& body = plate, double unit = 1.0) const {
    return {body,
            make_potential(model(), {1.0 * unit, 2.0 * unit}, "reciprocal-quadratic",
                           {1.0 * unit, 3.0 * unit}),
            branch()};
  }
};

TEST_P(EveryModelTest, RowsAreStationaryEllipsoids) {
  const Problem family = problem();
  const Followed sheet = followed(family, 0.0, range(0.0, 3.0, 1e-6));
  ASSERT_GT(sheet.rows.size(), 20U);
  for (const FollowedRow& row : sheet.rows) {
    const Member& at = row.member;
    const Vector3<double> nu = angular_velocity(branch(), at.nu);
    const auto v = family.potential().derivatives(at.q);
    EXPECT_LE(check_balance(plate, v, at.q, nu).residual, 1e-14) << at.nu;
    EXPECT_LE(at.residual, 1e-14) << at.nu;
    EXPECT_EQ(at.compatibility, 0.0);
    EXPECT_EQ(at.parameter, at.nu);
    EXPECT_EQ(at.body, plate);
    EXPECT_EQ(at.q.alpha, 0.0);
    EXPECT_GE(at.error_bound, 0x1p-53);
    EXPECT_NEAR(at.energy, energy(plate, v.value, at.q, nu), 1e-14 * (1.0 + std::abs(at.energy)));
    ASSERT_TRUE(at.spectrum.has_value());
  }
  EXPECT_EQ(sheet.rows.front().event, EventType::limit);
  EXPECT_TRUE(is_end(sheet.rows.back().event));
  EXPECT_NE(sheet.rows.back().event, EventType::stalled) << sheet.report.forward.reason;
  EXPECT_EQ(sheet.report.points, static_cast<long>(sheet.rows.size()));
  for (std::size_t k = 1; k + 1 < sheet.rows.size(); ++k)
    EXPECT_FALSE(is_end(sheet.rows[k].event)) << k;
}

/// To the bounds of both: rows of the continuation are what a cold solve finds.
TEST_P(EveryModelTest, RowsAreWhatASolveFinds) {
  const Problem family = problem();
  const Followed sheet = followed(family, 0.0, range(0.0, 3.0, 1e-6), false);
  int compared = 0;
  const auto rows = before_the_first_fold(sheet);
  for (std::size_t k = 0; k < rows.size(); k += std::max<std::size_t>(1, rows.size() / 40)) {
    const Member& at = rows[k].member;
    if (!is_moderate(at.q)) continue;
    const Equilibrium cold = solve(family, at.nu);
    ASSERT_EQ(cold.status, SolveStatus::solved) << at.nu;
    ASSERT_EQ(cold.connection, Connection::rest) << at.nu;
    EXPECT_LE(distance(at.q, cold.q), 1.01 * (at.error_bound + cold.error_bound)) << at.nu;
    ++compared;
  }
  EXPECT_GE(compared, 15);
}

/// The bound, against 50 digits; events apart, whose bound is of the event itself.
TEST_P(EveryModelTest, BoundsHold) {
  const Problem family = problem();
  const Followed sheet = followed(family, 0.0, range(0.0, 3.0, 1e-4), false);
  int compared = 0;
  for (std::size_t k = 0; k < sheet.rows.size(); k += 3) {
    const Member& at = sheet.rows[k].member;
    const EventType event = sheet.rows[k].event;
    if ((event != EventType::none && !is_end(event)) || !is_moderate(at.q)) continue;
    if (at.error_bound > 1e-9) continue;
    const auto exact = reference_solution(family, at.nu, at.q);
    EXPECT_LE(relative_error(at.q, exact), at.error_bound) << at.nu;
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

/// ν to -ν: the same sheet, walked through rest.
TEST_P(EveryModelTest, IsSymmetricInTheSenseOfTheSpin) {
  const Followed sheet = followed(problem(), 0.0, range(-3.0, 3.0, 1e-5));
  std::vector<FollowedRow> back;
  std::vector<FollowedRow> ahead;
  bool passed = false;
  for (const FollowedRow& row : sheet.rows) {
    passed = passed || row.member.nu == 0.0;
    if (row.event == EventType::none || is_end(row.event)) continue;
    (passed ? ahead : back).push_back(row);
  }
  EXPECT_TRUE(passed) << "the start is a row";
  std::ranges::reverse(back);
  for (FollowedRow& row : back) row.member.nu *= -1.0;
  expect_same_events(ahead, back, 1e-13, std::string(model()));
  EXPECT_EQ(sheet.rows.front().event, sheet.rows.back().event);
}

/// J -> sJ, V -> sV: the same shapes at the same nu.
TEST_P(EveryModelTest, UnitsOfMassDoNotMatter) {
  const Followed one = followed(problem(), 0.0, range(0.0, 3.0, 1e-6));
  for (const double s : {1e-6, 0.3, 7e5}) {
    const Body scaled(s * plate.J1, s * plate.J2, s * plate.J3);
    const Followed other = followed(problem(scaled, s), 0.0, range(0.0, 3.0, 1e-6));
    expect_same_events(one.events(), other.events(), 1e-13, std::string(model()));
    for (std::size_t k = 0; k < std::min(one.events().size(), other.events().size()); ++k) {
      const FollowedRow a = one.events()[k];
      const FollowedRow b = other.events()[k];
      EXPECT_LE(distance(a.member.q, b.member.q),
                2.0 * (a.member.error_bound + b.member.error_bound));
    }
  }
}

/// Axes 1 and 2 exchanged: (i) is (ii), (iii) is itself with xi and zeta exchanged.
TEST_P(EveryModelTest, ExchangeOfTheAxes) {
  const Branch other = branch() == Branch::i    ? Branch::ii
                       : branch() == Branch::ii ? Branch::i
                                                : Branch::iii;
  const Followed one = followed(problem(), 0.0, range(0.0, 3.0, 1e-6));
  const Problem exchanged(Exchanged()(plate), make_potential(model(), {1.0, 2.0}), other);
  const Followed two = followed(exchanged, 0.0, range(0.0, 3.0, 1e-6));
  expect_same_events(one.events(), two.events(), 1e-13, std::string(model()));
  EXPECT_EQ(one.rows.back().event, two.rows.back().event);
}

/// Large steps and small ones meet the same events, however many of them are in one step.
TEST_P(EveryModelTest, EventsDoNotDependOnTheSteps) {
  FollowOptions coarse = range(0.0, 3.0, 1e-3);
  coarse.continuation.step.first = 0.5;
  const Followed large = followed(problem(), 0.0, coarse);
  const Followed small = followed(problem(), 0.0, range(0.0, 3.0, 1e-10));
  EXPECT_LT(3 * large.rows.size(), small.rows.size());
  expect_same_events(small.events(), large.events(), 1e-11, std::string(model()));
}

/// From the last moderate row back to the start, the same events in reverse.
TEST_P(EveryModelTest, ThereAndBack) {
  const Problem family = problem();
  const AnyFamily any = axis_family(family, {});
  const Equilibrium rest = solve(family, 0.0);
  FollowOptions options = range(0.0, 3.0, 1e-6);
  options.continuation.max_stretch = 20.0;
  options.continuation.min_stretch = 0.05;
  const Followed there = followed(any, rest.q, 0.0, options);
  const Member last = there.rows.back().member;
  options.continuation.max_stretch = 40.0;  // of the start itself
  options.continuation.min_stretch = 0.025;
  const Followed back = followed(any, last.q, last.nu, options);
  // Which end is rest depends on the slope of nu where the way back begins.
  const bool first = back.rows.front().member.nu == 0.0;
  const Member home = (first ? back.rows.front() : back.rows.back()).member;
  EXPECT_EQ(home.nu, 0.0);
  EXPECT_LE(distance(home.q, rest.q), 1e-14);
  auto events = back.events();
  if (!first) std::ranges::reverse(events);
  if (events.size() > there.events().size()) events.resize(there.events().size());
  expect_same_events(there.events(), events, 1e-13, std::string(model()));
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModelTest,
                         ::testing::Combine(::testing::ValuesIn(all_models()),
                                            ::testing::Values(Branch::i, Branch::ii, Branch::iii)),
                         support::model_and_branch);

/// Random bodies and coefficients: nothing stalls, every row satisfies the balance, and large steps
/// find what small ones do.
TEST(Continuation, RandomFamilies) {
  support::Random random(321);
  for (int k = 0; k < 3000; ++k) {
    const Posed posed = random_problem(random, 2.0);
    const double to = 2.0 * std::abs(posed.nu);
    const Followed small = followed(posed.problem, 0.0, range(0.0, to, 1e-9));
    EXPECT_TRUE(small.report.forward.event != EventType::stalled)
        << posed.text << ": " << small.report.forward.reason << "; " << small.text();
    for (const FollowedRow& row : small.rows) EXPECT_LE(row.member.residual, 1e-14) << posed.text;
    FollowOptions coarse = range(0.0, to, k % 2 == 0 ? 1e-3 : 1.0);
    coarse.continuation.step.first = 0.5;
    const Followed large = followed(posed.problem, 0.0, coarse);
    const auto resolved = [](std::vector<FollowedRow> events) {
      std::erase_if(events, [](const FollowedRow& e) { return !is_moderate(e.member.q); });
      return events;
    };
    expect_same_events(resolved(small.events()), resolved(large.events()), 1e-10,
                       posed.text + small.text() + " | " + large.text());
  }
}

TEST(Continuation, FollowsReciprocalDeterminantAlongItsClosedForm) {
  support::Random random(322);
  for (int k = 0; k < 60; ++k) {
    const Body body = random.body();
    const ReciprocalDeterminant<> plane{random.log_uniform(0.1, 10.0),
                                        random.log_uniform(0.1, 10.0)};
    const ReciprocalQuadratic<> thickness{random.log_uniform(0.1, 10.0),
                                          random.log_uniform(0.1, 10.0)};
    const auto branch = static_cast<Branch>(k % 3);
    const support::ReciprocalDeterminantSolution<Number50> exact(
        body, {Number50(plane.c), Number50(plane.k)},
        {Number50(thickness.a), Number50(thickness.b)});
    const double limit = exact.limit(branch).convert_to<double>();
    const Problem problem(body, {plane, thickness}, branch);
    const Followed sheet = followed(problem, 0.0, range(-1.5 * limit, 1.5 * limit, 1e-4), false);
    EXPECT_EQ(sheet.rows.front().event, sheet.rows.back().event);
    EXPECT_EQ(sheet.rows.back().event, EventType::escape) << sheet.report.forward.reason;
    for (const FollowedRow& row : sheet.rows) {
      const Member& at = row.member;
      const auto solution = exact.on(branch, Number50(at.nu));
      if (!solution) {  // beyond the limit by rounding
        EXPECT_NEAR(std::abs(at.nu), limit, 1e-12 * std::abs(limit));
        continue;
      }
      const auto& q = solution->q;
      // An event's row is the event, whose nu is no double.
      if (at.error_bound < 0.1 && (row.event == EventType::none || is_end(row.event))) {
        EXPECT_LE(relative_error(at.q, {q.xi, q.zeta, q.rho}), at.error_bound) << at.nu << limit;
      }
    }
    EXPECT_TRUE(sheet.events({EventType::fold_nu, EventType::fold_momentum}).empty())
        << sheet.text();
  }
}

TEST_P(EveryModelTest, TheTableIsTheCurveToTheTolerance) {
  const Problem family = problem();
  const AnyFamily any = axis_family(family, {.nu = 0.0, .parameter = {}, .spectrum = false});
  for (const double tolerance : {1e-3, 1e-5, 1e-8, 1e-10}) {
    const FollowOptions options = range(0.0, 3.0, tolerance);
    const Followed sheet = followed(family, 0.0, options, false);
    const double error =
        std::visit([&](const auto& f) { return interpolation_error(*f, sheet.rows, 3.0); }, any);
    EXPECT_LE(error, tolerance);
    EXPECT_GE(error, 1e-3 * tolerance) << "far too many rows";
  }
}

/// Points as tolerance^(-1/4).
TEST_P(EveryModelTest, NumberOfPoints) {
  double last = 0.0;
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    const Followed sheet = followed(problem(), 0.0, range(0.0, 3.0, tolerance), false);
    const double points = static_cast<double>(std::ranges::count_if(
        sheet.rows, [](const FollowedRow& row) { return is_moderate(row.member.q); }));
    if (last > 0.0) {
      EXPECT_GT(points / last, std::sqrt(10.0) / 1.5) << tolerance;
      EXPECT_LT(points / last, std::sqrt(10.0) * 1.5) << tolerance;
    }
    last = points;
    const ContinuationCounts& counts = sheet.report.counts;
    EXPECT_LE(counts.rejected, 10 + counts.steps / 10) << tolerance;
    EXPECT_LE(counts.linearizations, 4 * (counts.steps + counts.rejected) + 10);
  }
}

/// Symmetric bodies, where the circle's symmetry must not be lost.
TEST(Continuation, CirclesStayCircles) {
  for (const std::string_view model : all_models()) {
    const Problem problem(Body(1.1, 1.1, 0.6), make_potential(model, {1.0, 2.0}), Branch::iii);
    for (const double tolerance : {1e-3, 1e-8}) {
      const Followed sheet = followed(problem, 0.0, range(-3.0, 3.0, tolerance));
      EXPECT_TRUE(is_end(sheet.rows.back().event));
      EXPECT_NE(sheet.rows.back().event, EventType::stalled)
          << model << ": " << sheet.report.forward.reason;
      for (const FollowedRow& row : sheet.rows) {
        EXPECT_EQ(row.member.q.xi, row.member.q.zeta) << model;
        EXPECT_LE(row.member.residual, 1e-14) << model;
      }
    }
  }
}

}  // namespace
}  // namespace stationary
