// Families of anisotropic bodies followed: slopes, turns, events against their own conditions, and
// where families with alpha != 0 leave those with alpha = 0.
#include "solver/family/anisotropic_family.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "solver/family/branch_switch.hpp"
#include "solver/family/follow_sheet.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/bodies/fibred_plates.hpp"
#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;

struct Row {
  Member member;
  EventType event;
};

class Rows final : public CurveSink {
 public:
  void row(const Member& member, EventType event) override { rows.push_back({member, event}); }
  std::vector<Row> rows;

  std::vector<Member> of(EventType event) const {
    std::vector<Member> out;
    for (const Row& each : rows)
      if (each.event == event) out.push_back(each.member);
    return out;
  }
};

using ParameterKind = FamilyParameter::Kind;

AxisFamilyOptions in(ParameterKind kind, int index = 0, double nu = 0.0) {
  AxisFamilyOptions out;
  out.nu = nu;
  out.parameter = {kind, index};
  return out;
}
double degrees(double angle) { return angle * std::numbers::pi / 180.0; }
double spin_momentum(const Member& at) {
  return (locked_inertia(at.body, at.q) * at.angular_velocity).norm();
}

/// dG/dp and dG/d ln x of every family and every parameter.
template <int N>
void expect_slopes(const Family<N>& family, const ReducedVector<N>& x, double p) {
  const auto at = family.linearize(x, p);
  const double h = 1e-7;
  // Rows are divided by magnitudes that change with x and p and hold |G| itself: at a solution that
  // is a relative h of the slope.
  ASSERT_LE(at.g.cwiseAbs().maxCoeff(), 1e-13);
  for (int k = 0; k <= N; ++k) {
    ReducedVector<N> ahead = x;
    ReducedVector<N> behind = x;
    double p_ahead = p;
    double p_behind = p;
    if (k < N) {
      ahead[k] *= std::exp(h);
      behind[k] *= std::exp(-h);
    } else {
      p_ahead += h;
      p_behind -= h;
    }
    const ReducedVector<N> slope =
        (family.linearize(ahead, p_ahead).g - family.linearize(behind, p_behind).g) / (2.0 * h);
    const ReducedVector<N> expected = k < N ? ReducedVector<N>(at.jacobian.col(k)) : at.slope;
    for (int i = 0; i < N; ++i) EXPECT_NEAR(slope[i], expected[i], 2e-7) << i << " " << k;
  }
}

TEST(AnisotropicFamily, SlopesInEveryParameter) {
  const double nu = 0.4;
  const Equilibrium third = solve(Problem(plate, skew_fibres, Branch::iii), nu);
  const Equilibrium oblique = solve_oblique(plate, skew_fibres, {nu, Branch::ii});
  struct Parameter {
    ParameterKind kind;
    int index;
    double value;
  };
  for (const Parameter& each :
       {Parameter{ParameterKind::nu, 0, nu}, Parameter{ParameterKind::inertia, 0, 1.0},
        Parameter{ParameterKind::inertia, 1, 1.7}, Parameter{ParameterKind::inertia, 2, 0.6},
        Parameter{ParameterKind::plane, 0, 1.0}, Parameter{ParameterKind::plane, 1, 2.0},
        Parameter{ParameterKind::thickness, 1, 3.0}, Parameter{ParameterKind::fibre, 0, 0.4},
        Parameter{ParameterKind::fibre, 1, 30.0}}) {
    const AnyFamily family = anisotropic_family(plate, skew_fibres.anisotropic(), Branch::iii,
                                                false, in(each.kind, each.index, nu));
    const auto& four = *std::get<std::unique_ptr<Family<4>>>(family);
    expect_slopes<4>(four, four.coordinates(third.q, each.value), each.value);
    const auto five =
        oblique_family(plate, skew_fibres.anisotropic(), in(each.kind, each.index, nu), Branch::ii);
    expect_slopes<5>(*five, five->coordinates(oblique.q, each.value), each.value);
  }
}

/// nu and |pi| turn at the located events and nowhere else.
TEST(AnisotropicFamily, TurnsAreWhereTheEventsSay) {
  for (const auto& near :
       {std::optional<Branch>(), std::optional(Branch::i), std::optional(Branch::ii)}) {
    Rows out;
    const FollowOptions how = range(0.0, 0.8);
    if (near) {
      const auto family =
          oblique_family(plate, skew_fibres.anisotropic(), in(ParameterKind::nu), *near);
      const Equilibrium start = solve_oblique(plate, skew_fibres, {0.3, near});
      EXPECT_EQ(follow_family<5>(*family, start.q, 0.3, how, out).failure, "");
    } else {
      const Equilibrium start = solve(Problem(plate, skew_fibres, Branch::iii), 0.3);
      const AnyFamily family = anisotropic_family(plate, skew_fibres.anisotropic(), Branch::iii,
                                                  false, in(ParameterKind::nu));
      EXPECT_EQ(follow(family, start.q, 0.3, how, out).failure, "");
    }
    ASSERT_GT(out.rows.size(), 20U);
    for (std::size_t k = 2; k < out.rows.size(); ++k) {
      const Member& a = out.rows[k - 2].member;
      const Member& b = out.rows[k - 1].member;
      const Member& c = out.rows[k].member;
      const bool momentum_turns =
          (spin_momentum(b) - spin_momentum(a)) * (spin_momentum(c) - spin_momentum(b)) < 0.0;
      const auto is = [&](EventType type) {
        return out.rows[k - 2].event == type || out.rows[k - 1].event == type ||
               out.rows[k].event == type;
      };
      if (momentum_turns) {
        EXPECT_TRUE(is(EventType::fold_momentum)) << b.parameter;
      }
      EXPECT_LE(b.residual, 1e-15);
    }
  }
}

/// A tilt of an oblique family: the inertias about its axis and about axis 3 are equal, and a pair
/// of eigenvalues passes through zero.
TEST(AnisotropicFamily, TiltOfAnObliqueAxis) {
  const auto family =
      oblique_family(plate, skew_fibres.anisotropic(), in(ParameterKind::nu), Branch::i);
  const Equilibrium start = solve_oblique(plate, skew_fibres, {0.5, Branch::i});
  Rows out;
  follow_family<5>(*family, start.q, 0.5, range(0.0, 0.77), out);
  const auto tilts = out.of(EventType::tilt);
  ASSERT_EQ(tilts.size(), 1U);
  const Vector3<double> axis = tilts[0].angular_velocity.normalized();
  const Matrix3<double> I = locked_inertia(plate, tilts[0].q);
  EXPECT_NEAR(axis.dot(I * axis), I(2, 2), 1e-10);
  double least = INFINITY;
  for (int k = 0; k < 5; ++k)
    least =
        std::min(least, std::abs(tilts[0].spectrum->mode[static_cast<std::size_t>(k)].lambda_re));
  EXPECT_LE(least, 1e-10);
}

/// A round body's axis goes with its fibre: however far that is turned, they stay at a right angle,
/// and what is seen from the fibre stays the same.
TEST(AnisotropicFamily, AnAxisTurnsWithTheFibreMoreThanOnceRound) {
  const Body body(1.0, 1.0, 0.6);
  const double nu = 0.5;
  const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, 10.0);
  const auto family =
      oblique_family(body, V.anisotropic(), in(ParameterKind::fibre, 1, nu), Branch::ii);
  const Equilibrium start = solve_oblique(body, V, {nu, Branch::ii});
  ASSERT_EQ(start.status, SolveStatus::solved) << start.message;
  Rows out;
  const FollowReport report = follow_family<5>(*family, start.q, 10.0, range(-400.0, 500.0), out);
  EXPECT_EQ(report.backward.event, EventType::limit) << report.backward.reason;
  EXPECT_EQ(report.forward.event, EventType::limit) << report.forward.reason;
  EXPECT_EQ(out.rows.front().member.parameter, -400.0);
  EXPECT_EQ(out.rows.back().member.parameter, 500.0);
  EXPECT_TRUE(report.events.empty());
  const double quarter = 0.5 * std::numbers::pi;
  const Vector3<double> before = out.rows.front().member.angular_velocity;
  double turned = std::atan2(before[1], before[0]) - quarter - degrees(-400.0);
  turned -= std::remainder(turned, 2.0 * quarter);
  for (const Row& each : out.rows) {
    const Member& at = each.member;
    const double fibre = degrees(at.parameter);
    const Vector3<double> expected{nu * std::cos(fibre + quarter + turned),
                                   nu * std::sin(fibre + quarter + turned), 0.0};
    EXPECT_LE((at.angular_velocity - expected).norm(), 1e-13) << at.parameter;
    const double difference = 0.5 * (at.q.xi - at.q.zeta);
    const double size = std::hypot(difference, at.q.alpha);
    EXPECT_NEAR(size, std::hypot(0.5 * (start.q.xi - start.q.zeta), start.q.alpha), 1e-13);
    EXPECT_NEAR(difference, size * std::cos(2.0 * fibre), 1e-13) << at.parameter;
    EXPECT_LE(at.residual, 1e-14);
  }
}

/// Where alpha is 0 only at rest the inertias are the same functions there as beside it.
TEST(AnisotropicFamily, NoEventIsMadeOfARestStateWithoutShear) {
  const Body body(1.0, 1.3, 2.8);
  const Potential V = fibred(BiotLog<>{1.0, 0.6}, 0.4, 85.0);
  const Equilibrium rest = solve(Problem(body, V, Branch::iii), 0.0);
  Rows out;
  follow(anisotropic_family(body, V.anisotropic(), Branch::iii, false, in(ParameterKind::nu)),
         rest.q, 0.0, range(0.0, 0.2), out);
  EXPECT_EQ(out.rows.front().member.q.alpha, 0.0);
  EXPECT_NE(out.rows.back().member.q.alpha, 0.0);
  EXPECT_TRUE(out.of(EventType::tilt).empty());
}

/// kappa (I1 - I2) - h^2 omega^2 in (i), K_alpha,alpha in (iii), from solutions at given nu.
double turn_at(const Problem& problem, double nu) {
  const Body& body = problem.body();
  const Stretch q = solve(problem, nu, without_search()).q;
  const double V_aa = problem.potential().derivatives(q).hessian(0, 0);
  if (problem.branch() == Branch::iii) return V_aa - (body.J1 + body.J2) * nu * nu;
  const Matrix3<double> I = locked_inertia(body, q);
  const double h = body.J1 * q.xi + body.J2 * q.zeta;
  return (V_aa - body.J1 * nu * nu) * (I(0, 0) - I(1, 1)) - h * h * nu * nu;
}

double bisected(const Problem& problem, double low, double high) {
  const bool negative = turn_at(problem, low) < 0.0;
  for (int k = 0; k < 50; ++k) {
    const double middle = 0.5 * (low + high);
    ((turn_at(problem, middle) < 0.0) == negative ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void follow_straight(const Problem& problem, double to, Rows& out) {
  const Equilibrium start = solve(problem, 0.3);
  follow(axis_family(problem, in(ParameterKind::nu)), start.q, 0.3, range(0.0, to), out);
}

TEST(AnisotropicFamily, ObliqueEventAndTheFamilyThatLeavesThere) {
  Rows sheet;
  const Problem first_axis(plate, fibres_along, Branch::i);
  follow_straight(first_axis, 0.76, sheet);
  const auto events = sheet.of(EventType::oblique);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_NEAR(events[0].parameter, bisected(first_axis, 0.6, 0.759), 1e-12);
  const auto family =
      oblique_family(plate, fibres_along.anisotropic(), in(ParameterKind::nu), Branch::i);
  const auto start = leave_straight(*family, events[0], Branch::i);
  ASSERT_TRUE(start);
  EXPECT_NE(start->q.alpha, 0.0);
  EXPECT_LE(start->residual, 1e-15);
  Rows out;
  const FollowReport report =
      follow_family<5>(*family, start->q, start->parameter, range(0.7, 0.78), out);
  // One end is the event, at the same place.
  const bool first = out.rows.front().event == EventType::oblique;
  const Row& end = first ? out.rows.front() : out.rows.back();
  ASSERT_EQ(end.event, EventType::oblique) << report.backward.reason << report.forward.reason;
  EXPECT_NEAR(end.member.parameter, events[0].parameter, 1e-12);
  EXPECT_NEAR(end.member.q.zeta, events[0].q.zeta, 1e-10);
  EXPECT_EQ(end.member.q.alpha, 0.0);
  for (const Row& each : out.rows) {
    if (&each == &end) continue;
    EXPECT_GT(std::abs(each.member.q.alpha), 1e-6);
    EXPECT_LE(each.member.residual, 1e-14);
  }
  // From rest to nu: through the event.
  const double nu = 0.76;
  const Equilibrium at = solve_oblique(plate, fibres_along, {nu, Branch::i}, without_search());
  ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
  EXPECT_NE(at.message.find("leaves axis 1 at |nu| = 0.7405"), std::string::npos) << at.message;
}

TEST(AnisotropicFamily, ShearEventAndTheFamilyThatLeavesThere) {
  const Problem problem(turning_plate, fibres_across, Branch::iii);
  Rows sheet;
  follow_straight(problem, 0.75, sheet);
  const auto events = sheet.of(EventType::shear);
  ASSERT_EQ(events.size(), 1U);
  const double nu_event = events[0].parameter;
  EXPECT_NEAR(nu_event, bisected(problem, 0.7, 0.745), 1e-12);
  // Motions with alpha != 0 nearby, a pair of mirror images, by Newton from sheared starts.
  Stretch start = events[0].q;
  start.alpha = 0.1 * std::sqrt(start.xi * start.zeta);
  Equilibrium at;
  for (const double nu : {nu_event + 1e-3, nu_event - 1e-3}) {
    at = solve(problem, nu, without_search(start));
    if (at.status == SolveStatus::solved && std::abs(at.q.alpha) > 1e-3) break;
  }
  ASSERT_GT(std::abs(at.q.alpha), 1e-3) << at.message;
  Stretch mirrored = at.q;
  mirrored.alpha = -mirrored.alpha;
  EXPECT_EQ(solve(problem, at.nu[2], without_search(mirrored)).q.alpha, -at.q.alpha);
  Rows out;
  follow(axis_family(problem, in(ParameterKind::nu), true), at.q, at.nu[2], range(0.6, 0.8), out);
  const bool first = out.rows.front().event == EventType::shear;
  const Row& end = first ? out.rows.front() : out.rows.back();
  ASSERT_EQ(end.event, EventType::shear);
  EXPECT_NEAR(end.member.parameter, nu_event, 1e-12);
  EXPECT_NEAR(end.member.q.xi, events[0].q.xi, 1e-11);
  for (const Row& each : out.rows) EXPECT_LE(each.member.residual, 1e-14);
}

/// Every point is what a solve at its angle gives.
TEST(AnisotropicFamily, FollowedInTheAngleOfTheFibre) {
  const AxisFamilyOptions options = in(ParameterKind::fibre, 1, 0.5);
  const Equilibrium start = solve(Problem(plate, skew_fibres, Branch::iii), 0.5);
  Rows out;
  follow(anisotropic_family(plate, skew_fibres.anisotropic(), Branch::iii, false, options), start.q,
         30.0, range(-10.0, 100.0), out);
  ASSERT_EQ(out.rows.front().event, EventType::limit);
  ASSERT_EQ(out.rows.back().event, EventType::limit);
  for (const Row& each : out.rows) {
    const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, each.member.parameter);
    const Equilibrium at = solve(Problem(plate, V, Branch::iii), 0.5);
    EXPECT_NEAR(at.q.alpha, each.member.q.alpha, 1e-14) << each.member.parameter;
    EXPECT_NEAR(at.q.zeta, each.member.q.zeta, 1e-14) << each.member.parameter;
  }
}

}  // namespace
}  // namespace stationary
