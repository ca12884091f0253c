// The tilted family followed: its slopes, what every row satisfies, where it begins and ends.
#include <gtest/gtest.h>

#include "lib/balance/tilted_balance.hpp"
#include "solver/solve/tilted_equilibrium.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;

const Body usual(1.0, 1.7, 0.6);

Potential make(std::string_view model, double first, double second) {
  const double plane[] = {first, second};
  const double axial[] = {1.0, 3.0};
  return {Potential::planar(model, plane), Potential::thickness("reciprocal-quadratic", axial)};
}
Potential coupled() {
  const double coefficients[] = {1.0, 2.0};
  return Potential(Potential::coupled("neo-hookean-3d", coefficients));
}

Body exchanged(const Body& J) { return {J.J2, J.J1, J.J3}; }
Stretch exchanged(const Stretch& q) { return {0.0, q.zeta, q.xi, q.rho}; }
TiltPlane other(TiltPlane plane) {
  return plane == TiltPlane::one_three ? TiltPlane::two_three : TiltPlane::one_three;
}

struct Given {
  std::string name;
  Body body;
  Potential potential;
  TiltPlane plane;
  double nu;  ///< of a member
};

std::vector<Given> given() {
  using enum TiltPlane;
  return {
      {"reciprocal_determinant", usual, make("reciprocal-determinant", 1.0, 2.0), one_three, 1.07},
      {"reciprocal_determinant_escapes", Body(1.7, 1.0, 0.6),
       make("reciprocal-determinant", 1.0, 2.0), one_three, 1.41},
      {"neo_hookean", usual, make("neo-hookean", 1.0, 2.0), two_three, 0.995},
      {"neo_hookean_3d", Body(1.0, 1.7, 1.4), coupled(), one_three, 0.0}};
}

/// The whole sheet through the tilt nearest to rest, both ways.
Followed whole(const Given& of, bool spectrum = true) {
  const Equilibrium start = solve_tilted(of.body, of.potential, {of.plane, of.nu});
  if (start.status != SolveStatus::solved) throw std::runtime_error(start.message);
  return followed(AnyFamily(tilted_family(of.body, of.potential, of.plane, spectrum)), start.q,
                  of.nu, range(0.0, 4.0));
}

TEST(TiltedFamily, SlopesAreThoseOfTheBalance) {
  for (const Given& of : given()) {
    const auto family = tilted_family(of.body, of.potential, of.plane, false);
    const double p = 0.9;
    const ReducedVector<2> x(0.7, 1.3);
    const FamilyLinearization<2> at = family->linearize(x, p);
    EXPECT_LE((at.g - family->extended_residual(x, p)).norm(), 1e-15) << of.name;
    EXPECT_EQ(at.jacobian(0, 1), at.jacobian(1, 0));
    // dG/dp is the pull's alone, so the rows' factor can be had from it.
    const CentrifugalRates<double> c = axis_rates(of.body, Branch::iii, 1.0);
    const ReducedVector<2> pull(c.xi * x[0] * x[0], c.zeta * x[1] * x[1]);
    EXPECT_NEAR(at.slope[0] / at.slope[1], pull[0] / pull[1], 1e-14);
    constexpr double h = 1e-5;
    const auto unscaled = [&](const ReducedVector<2>& y, double to) {
      const FamilyLinearization<2> there = family->linearize(y, to);
      const double per_row = 2.0 * to * c.xi * y[0] * y[0] / -there.slope[0];
      return ReducedVector<2>(per_row * there.g);
    };
    const double per_row = 2.0 * p * pull[0] / -at.slope[0];
    const ReducedVector<2> in_p = (unscaled(x, p + h) - unscaled(x, p - h)) / (2.0 * h);
    EXPECT_LE((in_p - per_row * at.slope).norm(), 1e-8 * in_p.norm()) << of.name;
    for (int k = 0; k < 2; ++k) {
      ReducedVector<2> above = x;
      ReducedVector<2> below = x;
      above[k] *= std::exp(h);
      below[k] *= std::exp(-h);
      const ReducedVector<2> column = (unscaled(above, p) - unscaled(below, p)) / (2.0 * h);
      EXPECT_LE((column - per_row * at.jacobian.col(k)).norm(), 1e-7 * column.norm()) << of.name;
    }
  }
}

/// Every row is a stationary motion by lib's own balance, at its vector.
TEST(TiltedFamily, EveryRowBalances) {
  for (const Given& of : given()) {
    if (of.nu == 0.0) continue;
    const Followed sheet = whole(of);
    ASSERT_GE(sheet.rows.size(), 10U) << of.name;
    for (const FollowedRow& row : sheet.rows) {
      const Member& m = row.member;
      if (row.event == EventType::escape || row.event == EventType::collapse) continue;
      const Vector3<double>& nu = m.angular_velocity;
      const BalanceCheck check = check_balance(of.body, of.potential, m.q, nu);
      EXPECT_LE(check.residual, row.event == EventType::tilt ? 1e-12 : 1e-14)
          << of.name << " " << m.nu;
      EXPECT_LE(check.compatibility, 1e-14) << of.name << " " << m.nu;
      EXPECT_NEAR(nu.norm(), m.nu, 1e-13 * m.nu) << of.name;
      EXPECT_EQ(nu[axis(in_plane_branch(other(of.plane)))], 0.0);
      ASSERT_TRUE(m.spectrum);
      EXPECT_EQ(m.spectrum->modes, 5);
    }
  }
}

/// rho is sqrt(J1/J3) xi, or so, rounded, and J are known to half a unit each.
TEST(TiltedFamily, TheBoundIsOfRhoToo) {
  for (const Given& of : given()) {
    if (of.nu == 0.0) continue;
    for (const FollowedRow& row : whole(of).rows)
      EXPECT_GE(row.member.error_bound, 0x1p-52) << of.name;
  }
}

TEST(TiltedFamily, ExchangingAxes1And2ExchangesThePlanes) {
  for (const Given& of : given()) {
    if (of.nu == 0.0) continue;
    const Followed sheet = whole(of, false);
    for (const FollowedRow& row : sheet.rows) {
      const Member& m = row.member;
      if (row.event != EventType::none) continue;
      const Equilibrium mirror = solve_tilted(exchanged(of.body), of.potential,
                                              {other(of.plane), m.nu}, {.start = exchanged(m.q)});
      ASSERT_EQ(mirror.status, SolveStatus::solved) << mirror.message;
      const Stretch q = exchanged(mirror.q);
      const double bound = m.error_bound + mirror.error_bound;
      EXPECT_NEAR(m.q.xi, q.xi, bound * q.xi) << of.name << " " << m.nu;
      EXPECT_NEAR(m.q.zeta, q.zeta, bound * q.zeta) << of.name << " " << m.nu;
      EXPECT_NEAR(m.angular_velocity[2], mirror.nu[2], 1e-9) << of.name << " " << m.nu;
    }
  }
}

/// reciprocal-determinant: from (i) to (iii), with the closed form all along.
TEST(TiltedFamily, JoinsTwoBranches) {
  const Given of = given()[0];
  const Followed sheet = whole(of);
  SCOPED_TRACE(sheet.text());
  const Member& first = sheet.rows.front().member;
  const Member& last = sheet.rows.back().member;
  EXPECT_EQ(sheet.rows.front().event, EventType::tilt);
  EXPECT_EQ(sheet.rows.back().event, EventType::tilt);
  const Member& on_i = first.angular_velocity[2] == 0.0 ? first : last;
  const Member& on_iii = &on_i == &first ? last : first;
  EXPECT_EQ(on_i.angular_velocity[2], 0.0);
  EXPECT_EQ(on_iii.angular_velocity[0], 0.0);
  const support::ReciprocalDeterminantSolution<double> closed(of.body, {1.0, 2.0}, {1.0, 3.0});
  for (const auto& [branch, end] : {std::pair(Branch::i, &on_i), std::pair(Branch::iii, &on_iii)}) {
    const auto expected = closed.on(branch, end->nu).value();
    EXPECT_NEAR(end->q.xi, expected.q.xi, 2e-14);
    // The row is the event's, whose nu is no double.
    EXPECT_NEAR(end->q.zeta, expected.q.zeta, 5e-14 * expected.q.zeta);
    EXPECT_NEAR(end->q.rho, expected.q.rho, 2e-14);
    EXPECT_NEAR(1.0 * end->q.xi * end->q.xi, 0.6 * end->q.rho * end->q.rho, 1e-15);
    EXPECT_LE(end->error_bound, 1e-11);
  }
  int compared = 0;
  for (const FollowedRow& row : sheet.rows) {
    const auto expected = closed.tilted(row.member.angular_velocity[2]);
    if (!expected) continue;
    ++compared;
    EXPECT_NEAR(row.member.q.xi, expected->q.xi, 1e-12);
    EXPECT_NEAR(row.member.q.zeta, expected->q.zeta, 1e-12 * expected->q.zeta);
    EXPECT_NEAR(row.member.angular_velocity[0], expected->nu[0], 1e-8);
  }
  EXPECT_GE(compared, 10);
}

TEST(TiltedFamily, LeavesABranchAndEscapes) {
  const Followed sheet = whole(given()[1]);
  SCOPED_TRACE(sheet.text());
  EXPECT_EQ(sheet.rows.front().event, EventType::tilt);
  EXPECT_NEAR(sheet.rows.front().member.nu, 1.40523, 5e-6);
  EXPECT_EQ(sheet.rows.front().member.angular_velocity[2], 0.0);
  EXPECT_EQ(sheet.rows.back().event, EventType::escape);
  EXPECT_GT(sheet.rows.back().member.q.zeta, 1e3);
}

/// neo-hookean in the 2-3 plane: from the sheet of (ii) connected to rest to a sheet of (iii) that
/// is not.
TEST(TiltedFamily, EndsOnADisconnectedSheet) {
  const Given of = given()[2];
  const Followed sheet = whole(of);
  SCOPED_TRACE(sheet.text());
  const Member& first = sheet.rows.front().member;
  const Member& last = sheet.rows.back().member;
  EXPECT_EQ(sheet.rows.front().event, EventType::tilt);
  EXPECT_EQ(sheet.rows.back().event, EventType::tilt);
  const Member& on_iii = last.angular_velocity[1] == 0.0 ? last : first;
  const Member& on_ii = &on_iii == &last ? first : last;
  EXPECT_NEAR(on_ii.nu, 0.99133, 5e-6);
  EXPECT_NEAR(on_iii.angular_velocity[2], 1.0033, 5e-5);
  // A pair of pairs leaves the imaginary axis, then meets on the real one.
  const auto events = sheet.events({EventType::hamiltonian_hopf, EventType::real_collision});
  ASSERT_EQ(events.size(), 2U);
  EXPECT_NEAR(events[0].member.nu, 1.00043, 5e-6);
  EXPECT_NEAR(events[1].member.nu, 1.00297, 5e-6);
  for (const FollowedRow& row : sheet.rows) {
    if (row.event != EventType::none) continue;
    const double nu = row.member.nu;
    EXPECT_EQ(row.member.spectrum->verdict, nu < events[0].member.nu   ? StabilityClass::elliptic
                                            : nu < events[1].member.nu ? StabilityClass::oscillatory
                                                                       : StabilityClass::unstable)
        << nu;
  }
  const Problem third(of.body, of.potential, Branch::iii);
  const Equilibrium there = solve(third, on_iii.nu, {.start = on_iii.q});
  ASSERT_EQ(there.status, SolveStatus::solved);
  EXPECT_NEAR(there.q.xi, on_iii.q.xi, 1e-13 * there.q.xi);
  EXPECT_NEAR(there.q.zeta, on_iii.q.zeta, 1e-13 * there.q.zeta);
}

/// Two pairs of frequencies meet, go round zero as a quadruple, and are real again before the family
/// ends: in one step, which a coarse sweep takes.
TEST(TiltedFamily, AQuadrupleInsideTheLastStepIsFound) {
  const Body body(2.6988437362719471, 2.6451092757639478, 1.2594877902335551);
  const Potential potential(BiotLog<>{0.39699810771235533, 0.68100791134747052},
                            ReciprocalQuadratic<>{0.4495206176291594, 0.51373933433548802});
  const TiltedRotation motion{TiltPlane::one_three, 0.43762576519637031};
  const Equilibrium start = solve_tilted(body, potential, motion);
  ASSERT_EQ(start.status, SolveStatus::solved);
  for (const double tolerance : {1e-4, 1e-5, 1e-7, 1e-10}) {
    const Followed sheet = followed(AnyFamily(tilted_family(body, potential, motion.plane, true)),
                                    start.q, motion.nu, range(0.0, 1.3, tolerance));
    const auto found = sheet.events({EventType::hamiltonian_hopf, EventType::real_collision});
    ASSERT_EQ(found.size(), 2U) << tolerance << " " << sheet.text();
    EXPECT_NEAR(found[0].member.nu, 0.462425234071, 1e-9);
    EXPECT_NEAR(found[1].member.nu, 0.463849875713, 1e-9);
  }
}

/// Beside a quadruple of one block two other pairs of it may meet: roots of the discriminant of the
/// characteristic polynomial, in 40 digits by its own equations.
TEST(TiltedFamily, MeetingsBesideAQuadrupleAreFound) {
  const auto meetings = [](const Body& body, const Potential& potential, const Stretch& start,
                           double nu) {
    const Followed sheet =
        followed(AnyFamily(tilted_family(body, potential, TiltPlane::two_three, true)), start, nu,
                 range(0.0, 3.0));
    EXPECT_TRUE(sheet.events({EventType::unexplained}).empty()) << sheet.text();
    return sheet.events({EventType::hamiltonian_hopf, EventType::real_collision});
  };
  {
    const Potential potential(NeoHookean<>{0.1014, 0.7425}, ReciprocalQuadratic<>{0.1307, 0.4194});
    const auto found = meetings({0.4187, 0.2142, 2.457}, potential,
                                {0.0, 1.4295139160293784, 2.317228634705654, 0.6841889275500127},
                                std::hypot(0.06787062313798278, 1.0763008288654825));
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].event, EventType::hamiltonian_hopf);
    EXPECT_EQ(found[1].event, EventType::hamiltonian_hopf);
    const double nu[] = {found[0].member.nu, found[1].member.nu};
    EXPECT_NEAR(std::min(nu[0], nu[1]), 0.823813724475135081, 1e-13);
    EXPECT_NEAR(std::max(nu[0], nu[1]), 1.043130301228578278, 1e-13);
  }
  const Potential potential(Hencky<>{0.2247, 0.7601}, ReciprocalQuadratic<>{0.762, 1.571});
  const auto found = meetings({0.2065, 0.197513, 1.14}, potential,
                              {0.0, 1.819838576346734, 1.9326614342676953, 0.8044539668746563},
                              std::hypot(0.306797750215987, 1.3027359900357496));
  ASSERT_EQ(found.size(), 2U);
  for (const FollowedRow& each : found) {
    const bool real = each.event == EventType::real_collision;
    EXPECT_NEAR(each.member.nu, real ? 1.325621544058125844 : 1.343992167316744436, 1e-13);
  }
  EXPECT_NE(found[0].event, found[1].event);
}

/// nu3 falls nearly as 1/xi along an escape, and is known as well as xi is.
TEST(TiltedFamily, ASmallComponentIsNotNone) {
  const Body body(8.141, 0.5927, 7.537);
  const Potential potential(Hencky<>{0.6066, 0.78}, Harmonic<>{4.192, 0.6664});
  const double nu = std::hypot(0.7457806180784593, 3.7917614516907578e-06);
  const Followed sheet =
      followed(AnyFamily(tilted_family(body, potential, TiltPlane::one_three, true)),
               {0.0, 485209.18145259534, 6.503782716084672, 504276.384032794}, nu, range(0.0, 3.0));
  int far = 0;
  for (const FollowedRow& row : sheet.rows) {
    const Member& at = row.member;
    if (!(at.q.xi > 1e4)) continue;
    ++far;
    EXPECT_GT(at.angular_velocity[2] * at.q.xi, 1.4) << at.q.xi;
    EXPECT_LT(at.angular_velocity[2] * at.q.xi, 2.0) << at.q.xi;
    EXPECT_LT(at.residual, 1e-14);
  }
  EXPECT_GT(far, 5);
  EXPECT_EQ(tilt_share(1e-12, 1.0, 1e-12), 0.0);
  EXPECT_EQ(tilt_share(1e-12, 1.0, 1e-12, 1e-11), 1e-12);
}

/// f of the rows turns exactly where they have an event of that type.
template <class F>
void expect_turns(const Followed& sheet, EventType type, const F& f) {
  const auto& rows = sheet.rows;
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
    const double before = f(rows[k].member) - f(rows[k - 1].member);
    const double after = f(rows[k + 1].member) - f(rows[k].member);
    const double least = 1e-9 * f(rows[k].member);
    if (std::abs(before) < least || std::abs(after) < least) continue;
    const bool event =
        rows[k - 1].event == type || rows[k].event == type || rows[k + 1].event == type;
    if (before * after < 0.0) {
      EXPECT_TRUE(event) << name(type) << " at " << rows[k].member.nu;
    } else {
      EXPECT_NE(rows[k].event, type) << rows[k].member.nu;
    }
  }
}

/// Families of random bodies and every model: rows that balance, ends that are ends.
TEST(TiltedFamily, RandomFamiliesFromEndToEnd) {
  support::Random random(77);
  int families = 0;
  int ends = 0;
  int exact = 0;
  int turns = 0;
  int growths = 0;
  for (int k = 0; k < 250; ++k) {
    const Posed posed = random_problem(random, 1.0);
    const Body& body = posed.problem.body();
    const Potential& potential = posed.problem.potential();
    const auto plane = random.integer(0, 1) == 0 ? TiltPlane::one_three : TiltPlane::two_three;
    const double nu = std::abs(posed.nu);
    const Equilibrium start = solve_tilted(body, potential, {plane, nu});
    if (start.status != SolveStatus::solved) continue;
    ++families;
    SCOPED_TRACE(posed.text + " plane " + std::string(name(plane)) + " " + std::to_string(nu));
    const Followed sheet = followed(AnyFamily(tilted_family(body, potential, plane, true)), start.q,
                                    nu, range(0.0, 4.0 * nu, 1e-5));
    SCOPED_TRACE(sheet.text());
    for (const FollowedRow& row : sheet.rows) {
      const Member& m = row.member;
      ASSERT_TRUE(m.angular_velocity.allFinite()) << m.nu;
      EXPECT_LE(check_balance(body, potential, m.q, m.angular_velocity).residual, 1e-12) << m.nu;
      EXPECT_LE(m.compatibility, 1e-13) << m.nu;
      // Of a round body growth may begin with no other sign of it.
      if (row.event != EventType::unexplained) continue;
      ++growths;
      EXPECT_TRUE(body.symmetric()) << m.nu;
    }
    expect_turns(sheet, EventType::fold_nu, [](const Member& m) { return m.nu; });
    expect_turns(sheet, EventType::fold_momentum, [&](const Member& m) {
      return (locked_inertia(body, m.q) * m.angular_velocity).norm();
    });
    turns += static_cast<int>(sheet.events({EventType::fold_nu, EventType::fold_momentum}).size());
    for (const FollowedRow* end : {&sheet.rows.front(), &sheet.rows.back()}) {
      EXPECT_NE(end->event, EventType::stalled)
          << sheet.report.backward.reason << sheet.report.forward.reason;
      if (end->event != EventType::tilt) continue;
      ++ends;
      // One component left; at stretches of 1e6 a double of |nu| leaves some of another.
      const Vector3<double> nu = end->member.angular_velocity;
      EXPECT_GE(nu.maxCoeff(), nu.sum() - 1e-5 * nu.norm());
      EXPECT_LE(end->member.error_bound, 1e-6);
      exact += (nu.array() == 0.0).count() == 2;
    }
  }
  RecordProperty("families", families);
  RecordProperty("ends", ends);
  RecordProperty("turns", turns);
  EXPECT_GE(families, 10);
  EXPECT_GE(growths, 2);
  EXPECT_GE(ends, families);
  EXPECT_GE(exact, ends - 2);
}

/// The bound of an event's stretches holds what half a unit in the last place of every number does
/// to each of the three, rho among them, which the inertias tie to another: of stiff bodies it is
/// rho that they move most.
TEST(TiltedFamily, TheBoundOfATiltHoldsRhoToo) {
  using enum TiltPlane;
  using Numbers = std::array<double, 7>;  // J, the plane's two, the thickness' two
  struct Given {
    std::string_view plane_model;
    std::string_view thickness_model;
    TiltPlane plane;
    double nu;
    Numbers numbers;
  };
  const Given given[] = {{"hencky",
                          "reciprocal-quadratic",
                          one_three,
                          1.0,
                          {2.038, 0.6041, 2.952, 9.712, 12.77, 0.3429, 1.252}},
                         {"saint-venant-kirchhoff",
                          "harmonic",
                          one_three,
                          1.0,
                          {0.5466, 1.044, 1.908, 1.953, 0.1404, 0.454, 0.4436}},
                         {"reciprocal-determinant",
                          "harmonic",
                          two_three,
                          0.3,
                          {1.529, 1.365, 2.59, 0.4257, 1.419, 0.1459, 0.3267}},
                         {"biot",
                          "reciprocal-quadratic",
                          two_three,
                          1.0,
                          {0.3177, 1.217, 0.1394, 1.948, 29.96, 8.444, 0.3667}}};
  int rho_most = 0;
  for (const Given& of : given) {
    const auto potential = [&](const Numbers& own) {
      const double plane[] = {own[3], own[4]};
      const double axial[] = {own[5], own[6]};
      return Potential(Potential::planar(of.plane_model, plane),
                       Potential::thickness(of.thickness_model, axial));
    };
    const auto body = [](const Numbers& own) { return Body(own[0], own[1], own[2]); };
    const auto family = [&](const Numbers& own) {
      return tilted_family(body(own), potential(own), of.plane, false);
    };
    const Equilibrium start =
        solve_tilted(body(of.numbers), potential(of.numbers), {of.plane, of.nu});
    ASSERT_EQ(start.status, SolveStatus::solved) << start.message;
    const Followed sheet = followed(AnyFamily(family(of.numbers)), start.q, of.nu, range(0.0, 6.0));
    int tilts = 0;
    for (const FollowedRow& row : sheet.rows) {
      if (row.event != EventType::tilt) continue;
      const auto at = [&](const Numbers& own) {
        const auto found = family(own)->event_at(EventType::tilt, Circle::none, row.member);
        if (!found) throw std::runtime_error("no tilt beside one");
        const double xi = double(found->x[0]);
        const double zeta = double(found->x[1]);
        return Vector3<double>(std::log(xi), std::log(zeta),
                               std::log(tilted_thickness(body(own), of.plane, xi, zeta)));
      };
      Vector3<double> moves = Vector3<double>::Zero();
      constexpr double h = 1e-5;
      for (std::size_t k = 0; k < of.numbers.size(); ++k) {
        Numbers ahead = of.numbers;
        Numbers behind = of.numbers;
        ahead[k] *= 1.0 + h;
        behind[k] *= 1.0 - h;
        moves += ((at(ahead) - at(behind)) / (2.0 * h)).cwiseAbs();
      }
      const auto event = family(of.numbers)->event_at(EventType::tilt, Circle::none, row.member);
      ASSERT_TRUE(event);
      EXPECT_LE(0x1p-53 * moves.maxCoeff(), event->error_bound * (1.0 + 1e-6)) << of.plane_model;
      rho_most += moves[2] > 1.1 * std::max(moves[0], moves[1]) ? 1 : 0;
      ++tilts;
    }
    EXPECT_GT(tilts, 0) << of.plane_model;
  }
  EXPECT_GE(rho_most, 3);
}

}  // namespace
}  // namespace stationary
