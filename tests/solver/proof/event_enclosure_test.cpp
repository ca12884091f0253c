// Proofs of where events lie: against 25-digit values, closed forms, and the located events of
// random families; what is no event near by is refused.
#include "solver/proof/event_enclosure.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numbers>

#include "solver/proof/event_system.hpp"
#include "solver/solve/stability.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"
#include "tests/support/reference_table.hpp"

namespace stationary::testing {
namespace {

using support::Real50;
using support::ReferenceRow;

bool holds(const Interval& x, const Real50& exact) {
  return x.bounded() && Real50(x.lo) <= exact && exact <= Real50(x.hi);
}
double relative_width(const Interval& x) { return x.width() / x.magnitude(); }

/// The type by its name in a table.
EventType event_named(std::string_view text) {
  const auto* const at = std::ranges::find(event_names, text);
  return static_cast<EventType>(at - std::begin(event_names));
}

Member member_at(const ReferenceRow& row, const Problem& problem) {
  Member out;
  out.body = problem.body();
  out.parameter = out.nu = row.number<double>("nu");
  out.q = {0.0, row.number<double>("xi"), row.number<double>("zeta"), row.number<double>("rho")};
  Equilibrium at;
  at.q = out.q;
  at.nu = angular_velocity(problem.branch(), out.nu);
  at.status = SolveStatus::solved;
  at.error_bound = 1e-14;
  out.spectrum = stability(problem, at);
  return out;
}

TEST(EventEnclosure, HoldsTheReferenceDigits) {
  int proven = 0;
  for (const ReferenceRow& row : support::reference_table("events.csv")) {
    const Problem problem(row.body(), row.potential(), row.branch());
    const EventType type = event_named(row.text("event"));
    const EventEnclosure found =
        enclose_event(problem, {}, Circle::none, type, member_at(row, problem));
    ASSERT_TRUE(found.proven) << row.where() << ": " << found.reason;
    EXPECT_TRUE(holds(found.parameter, row.number<Real50>("nu"))) << row.where();
    EXPECT_TRUE(holds(found.q.xi, row.number<Real50>("xi"))) << row.where();
    EXPECT_TRUE(holds(found.q.zeta, row.number<Real50>("zeta"))) << row.where();
    EXPECT_TRUE(holds(found.q.rho, row.number<Real50>("rho"))) << row.where();
    EXPECT_LE(relative_width(found.parameter), 1e-12) << row.where();
    EXPECT_LE(found.error_bound, 1e-11) << row.where();
    ++proven;
  }
  EXPECT_EQ(proven, 12);
}

/// hencky (i): zeta = sqrt e, nu^2 = 2 mu (mu + lambda)/[(2 mu + lambda) e J2].
TEST(EventEnclosure, FoldOfHencky) {
  const Body body(1.0, 1.5, 0.75);
  const Problem problem(body, make_potential("hencky", {1.25, 0.5}), Branch::i);
  const Real50 mu("1.25");
  const Real50 lambda("0.5");
  const Real50 e = exp(Real50(1));
  const Real50 nu = sqrt(2 * mu * (mu + lambda) / ((2 * mu + lambda) * e * Real50("1.5")));
  const double near = support::nearest(nu) * (1.0 - 1e-9);
  const Equilibrium start = solve(problem, near);
  ASSERT_EQ(start.status, SolveStatus::solved) << start.message;
  Member at;
  at.body = body;
  at.parameter = at.nu = near;
  at.q = start.q;
  const EventEnclosure found =
      enclose_event(problem, {}, Circle::none, EventType::fold_nu, at, Inputs::doubles);
  ASSERT_TRUE(found.proven) << found.reason;
  EXPECT_TRUE(holds(found.parameter, nu));
  EXPECT_TRUE(holds(found.q.zeta, sqrt(e)));
  EXPECT_LE(relative_width(found.parameter), 1e-13);
}

/// On the circle of hencky, u = ln xi: K_aa = 0 where J nu^2 e^(2u) = mu, 2 (mu + lambda) u = mu.
TEST(EventEnclosure, CircleToEllipseOfHencky) {
  const Body body(1.0, 1.0, 0.5);
  const Problem problem(body, make_potential("hencky", {1.0, 3.0}), Branch::iii);
  const Real50 u = Real50(1) / 8;
  const Real50 nu = exp(-u);
  Member at;
  at.body = body;
  at.parameter = at.nu = support::nearest(nu) + 1e-7;
  const double xi = support::nearest(Real50(exp(u))) - 1e-6;
  at.q = {0.0, xi, xi, std::cbrt(1.0 / 3.0)};
  const EventEnclosure found =
      enclose_event(problem, {}, Circle::xi_zeta, EventType::ellipse, at, Inputs::doubles);
  ASSERT_TRUE(found.proven) << found.reason;
  EXPECT_TRUE(holds(found.parameter, nu));
  EXPECT_TRUE(holds(found.q.xi, Real50(exp(u))));
  EXPECT_TRUE(holds(found.q.zeta, Real50(exp(u))));
}

/// In another parameter: reciprocal-determinant tilts in (i) where J1 xi^2 = J3 rho^2, closed forms
/// of both; c = xi^4 A1^(3/2) A2^(-1/2) then.
TEST(EventEnclosure, TiltInACoefficient) {
  const Body body(1.0, 1.5, 0.5);
  const double nu = 0.5;
  const Real50 A2 = 2 - Real50(1.5) / 4;
  const Real50 rho = cbrt(Real50(1) / (3 - Real50(0.5) / 4));
  const Real50 xi = sqrt(Real50(0.5)) * rho;
  const Real50 c = pow(xi, 4) * pow(Real50(2), Real50(1.5)) / sqrt(A2);
  const Real50 zeta = xi * sqrt(Real50(2) / A2);
  Member at;
  at.body = body;
  at.nu = nu;
  at.parameter = support::nearest(c);
  at.q = {0.0, support::nearest(xi), support::nearest(zeta), support::nearest(rho)};
  const Problem problem(body, make_potential("reciprocal-determinant", {at.parameter, 2.0}),
                        Branch::i);
  const EventEnclosure found = enclose_event(problem, {FamilyParameter::Kind::plane, 0},
                                             Circle::none, EventType::tilt, at, Inputs::doubles);
  ASSERT_TRUE(found.proven) << found.reason;
  EXPECT_TRUE(holds(found.parameter, c));
  EXPECT_TRUE(holds(found.q.rho, rho));
}

TEST(EventEnclosure, NoEventNearByIsNoProof) {
  for (const ReferenceRow& row : support::reference_table("events.csv")) {
    const Problem problem(row.body(), row.potential(), row.branch());
    Member away = member_at(row, problem);
    away.q.xi *= 1.01;
    away.q.zeta *= 0.995;
    away.parameter *= 1.01;
    const EventEnclosure found =
        enclose_event(problem, {}, Circle::none, event_named(row.text("event")), away);
    EXPECT_FALSE(found.proven) << row.where();
    EXPECT_FALSE(found.reason.empty()) << row.where();
  }
}

/// Every kind of event of 150 random families: what the search located is proven, next to it.
TEST(EventEnclosure, LocatedEventsOfRandomFamilies) {
  support::Random random(20261121);
  std::map<EventType, int> proven;
  std::map<EventType, int> refused;
  std::string refusals;
  for (int k = 0; k < 150; ++k) {
    Posed posed = random_problem(random, 1.0);
    if (k % 5 == 0) {  // circles and ellipses
      const Body& body = posed.problem.body();
      posed.problem = Problem(Body(body.J1, body.J1, body.J3), posed.problem.potential(),
                              posed.problem.branch());
    }
    const Equilibrium rest = solve(posed.problem, 0.0);
    if (rest.status != SolveStatus::solved) continue;
    FollowOptions options = range(0.0, 3.0, 1e-6);
    options.max_points = 400;
    const Followed sheet =
        followed(axis_family(posed.problem, {.nu = 0.0, .parameter = {}}), rest.q, 0.0, options);
    for (const auto& [member, type] : sheet.events()) {
      if (!has_enclosure(type)) continue;
      const Circle circle =
          mirror_symmetric(posed.problem, member.nu) && member.q.xi == member.q.zeta
              ? Circle::xi_zeta
              : Circle::none;
      const EventEnclosure found = enclose_event(posed.problem, {}, circle, type, member);
      if (!found.proven) {
        ++refused[type];
        refusals += posed.text + ": " + std::string(name(type)) + " at " +
                    std::to_string(member.nu) + ": " + found.reason + "\n";
        continue;
      }
      ++proven[type];
      const double off = (found.parameter - Interval(member.nu)).mignitude();
      EXPECT_LE(off, 1e-9 * std::abs(member.nu)) << posed.text << " " << name(type);
      EXPECT_LE(found.error_bound, 4.0 * member.error_bound + 1e-11) << posed.text << name(type);
    }
  }
  int all = 0;
  int none = 0;
  for (const auto& [type, count] : proven) all += count;
  for (const auto& [type, count] : refused) none += count;
  for (const EventType type : {EventType::tilt, EventType::inertia_exchange, EventType::krein_pass,
                               EventType::fold_nu, EventType::fold_momentum})
    EXPECT_GT(proven[type], 0) << name(type);
  EXPECT_LE(none, all / 50) << refusals;
}

/// |P/P'| of the modes of a motion, each in the equation of its block.
template <bool circle>
double farthest_root(const Problem& problem, const Equilibrium& at, const Spectrum& spectrum) {
  using Equations = EventEquations<circle, true, DoubleDouble>;
  const double nu = at.nu.norm();
  const EventSetting setting{problem.body(),
                             problem.potential(),
                             problem.branch(),
                             nu,
                             {},
                             circle ? Circle::xi_zeta : Circle::none,
                             Inputs::doubles};
  double farthest = 0.0;
  for (int k = 0; k < spectrum.modes; ++k) {
    const Mode& mode = spectrum.mode[static_cast<std::size_t>(k)];
    if (mode.lambda_im != 0.0 || mode.forced_zero) continue;
    EventFunction function;
    function.kind = EventFunction::Kind::collision;
    function.first = mode.block;
    typename Equations::Unknowns y;
    std::size_t n = 0;
    y[n++] = at.q.xi;
    if (!circle) y[n++] = at.q.zeta;
    y[n++] = at.q.rho;
    y[n++] = nu;
    y[n] = mode.lambda_re;
    const auto values =
        Equations(setting, function).values(y, [](double value, FamilyParameter::Kind, int) {
          return DoubleDouble(value);
        });
    farthest = std::max(farthest, std::abs(double(values[n - 1]) / double(values[n])));
  }
  return farthest;
}

/// What an event's proof says of Lambda it says of the spectrum's: with and without a thickness that
/// is coupled, of a held volume too.
TEST(EventEnclosure, EachLambdaIsAZeroOfItsBlocksEquation) {
  std::vector<Potential> potentials{make_potential("hencky", {1.0, 0.6}),
                                    make_potential("neo-hookean-3d", {1.0, 0.6})};
  BodyModel<> held;
  held.elastic.plane = AnyPlane<>{potentials[0].plane()};
  held.elastic.thickness = AnyThickness<>{potentials[0].thickness()};
  held.volume = 1.2;
  potentials.emplace_back(held);
  int motions = 0;
  int circles = 0;
  for (const Potential& potential : potentials) {
    for (const Body& body : {Body(1.0, 1.4, 0.7), Body(1.0, 1.0, 0.7)}) {
      for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
        const Problem problem(body, potential, branch);
        const Equilibrium at = solve(problem, 0.4);
        ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
        const Spectrum spectrum = stability(problem, at);
        const bool circle = branch == Branch::iii && body.symmetric();
        motions += 1;
        circles += circle;
        const double off = circle ? farthest_root<true>(problem, at, spectrum)
                                  : farthest_root<false>(problem, at, spectrum);
        EXPECT_LT(off, 1e-11) << motions << " " << name(branch);
      }
    }
  }
  EXPECT_EQ(motions, 18);
  EXPECT_EQ(circles, 3);
}

}  // namespace
}  // namespace stationary::testing
