// Proofs of where the events of kinds other than isotropic spins lie: located ones of random
// families, tilts to 50 digits, what two modes do on both sides of where they meet.
#include <gtest/gtest.h>

#include <array>
#include <boost/math/constants/constants.hpp>
#include <map>
#include <optional>
#include <string>

#include "solver/family/anisotropic_family.hpp"
#include "solver/family/oriented_events.hpp"
#include "solver/kind/kind.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"
#include "tests/support/numbers/high_precision.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace testing;

struct Counted {
  std::map<EventType, int> proven;
  int compared = 0;  ///< events on both sides of which the modes were looked at
  int refused = 0;
  std::string refusals;

  int all() const {
    int out = 0;
    for (const auto& [type, count] : proven) out += count;
    return out;
  }
};

/// Whether a Lambda is complex; nothing where the motion near a member is not found again.
std::optional<bool> quadruple(const Kind& kind, const Member& near) {
  const Equilibrium at = kind.solve(without_search(near.q));
  if (at.status != SolveStatus::solved) return std::nullopt;
  const auto spectrum = kind.spectrum(at);
  if (!spectrum) return std::nullopt;
  return std::any_of(spectrum->mode.begin(), spectrum->mode.begin() + spectrum->modes,
                     [](const Mode& mode) { return mode.lambda_im > 0.0; });
}

/// kind_at(p): the kind with that value of the parameter.
template <class KindAt>
void prove_events(const Followed& sheet, const FamilyParameter& parameter, const KindAt& kind_at,
                  const std::string& text, Counted& out) {
  for (const auto& [member, type] : sheet.events()) {
    const double p = member.parameter;
    if (p == 0.0) continue;
    const auto found = kind_at(p)->enclose_event(parameter, type, member);
    if (!found || !found->proven) {
      ++out.refused;
      out.refusals += text + ": " + std::string(name(type)) + " at " + std::to_string(p) + ": " +
                      (found ? found->reason : "no equations") + "\n";
      continue;
    }
    ++out.proven[type];
    EXPECT_LE((found->parameter - Interval(p)).mignitude(), 1e-9 * std::abs(p))
        << text << " " << name(type);
    EXPECT_LE(found->parameter.width(), 1e-8 * std::abs(p)) << text << " " << name(type);
    EXPECT_LE(found->error_bound, 4.0 * member.error_bound + 1e-8) << text << " " << name(type);
    if (type != EventType::hamiltonian_hopf && type != EventType::real_collision) continue;
    constexpr double aside = 1e-7;
    const auto before = quadruple(*kind_at(p * (1.0 - aside)), member);
    const auto after = quadruple(*kind_at(p * (1.0 + aside)), member);
    if (!before || !after) continue;
    ++out.compared;
    EXPECT_NE(*before, *after) << text << " " << name(type) << " at " << p;
  }
}

FollowOptions loosely(double from, double to) {
  FollowOptions out = range(from, to, 1e-6);
  out.max_points = 300;
  return out;
}

void expect_nearly_all(const std::map<std::string, Counted>& counted, int least) {
  for (const auto& [of, count] : counted) {
    EXPECT_GE(count.all(), least) << of;
    EXPECT_LE(count.refused, count.all() / 20) << count.refusals;
  }
}

TEST(EventEnclosureOfKinds, LocatedInNuOfAnisotropicFamilies) {
  support::Random random(20261126);
  std::map<std::string, Counted> counted;
  for (int k = 0; k < 40; ++k) {
    const OrientedBody at = random_oriented_body(random, k);
    const auto take = [&](const std::string& of, const auto& motion_at) {
      const auto kind_at = [&](double nu) {
        return kind_of(at.body, at.potential(), motion_at(nu));
      };
      const auto kind = kind_at(at.nu);
      const Equilibrium start = kind->solve(without_search());
      if (start.status != SolveStatus::solved) return;
      const Followed sheet =
          followed(kind->family({}, {}, start.q), start.q, at.nu, loosely(1e-3, 3.0));
      prove_events(sheet, {}, kind_at, at.text + ", " + of, counted[of]);
    };
    take("iii", [](double nu) -> Motion { return AxisRotation{Branch::iii, nu}; });
    for (const Branch near : {Branch::i, Branch::ii}) {
      if (at.V.shear_free())
        take("straight", [near](double nu) -> Motion { return AxisRotation{near, nu}; });
      take("oblique", [near](double nu) -> Motion { return ObliqueRotation{nu, near}; });
    }
  }
  EXPECT_EQ(counted.size(), 3U);
  expect_nearly_all(counted, 40);
  for (const EventType type :
       {EventType::fold_nu, EventType::fold_momentum, EventType::tilt, EventType::inertia_exchange,
        EventType::shear, EventType::oblique, EventType::krein_pass}) {
    int all = 0;
    for (auto& [of, count] : counted) all += count.proven[type];
    EXPECT_GT(all, 0) << name(type);
  }
}

/// In the angle and the stiffness of a fibre, and J3.
TEST(EventEnclosureOfKinds, LocatedInOtherNumbersOfAnisotropicFamilies) {
  using Number = FamilyParameter::Kind;
  support::Random random(20261127);
  std::map<std::string, Counted> counted;
  for (int k = 0; k < 60; ++k) {
    const OrientedBody at = random_oriented_body(random, k);
    const Fibre& fibre = at.V.fibres().front();
    const auto take = [&](const std::string& of, const FamilyParameter& parameter, double value,
                          double from, double to, const Motion& motion) {
      const int place = coefficient_place(at.V, parameter);
      const auto kind_at = [&](double p) {
        Body body = at.body;
        if (place < 0) body.J3 = p;
        return kind_of(
            body, place < 0 ? at.potential() : Potential(at.V.with_coefficient(place, p)), motion);
      };
      const auto kind = kind_at(value);
      const Equilibrium start = kind->solve(without_search());
      if (start.status != SolveStatus::solved || kind->no_family(parameter, start.q)) return;
      const Followed sheet =
          followed(kind->family(parameter, {}, start.q), start.q, value, loosely(from, to));
      prove_events(sheet, parameter, kind_at, at.text + ", " + of, counted[of]);
    };
    const double nu = 2.0 * at.nu;
    for (const Motion& motion :
         {Motion(AxisRotation{Branch::iii, nu}), Motion(AxisRotation{Branch::i, nu}),
          Motion(ObliqueRotation{nu, Branch::i})}) {
      take("degrees", {Number::fibre, 1}, fibre.degrees, fibre.degrees - 60.0, fibre.degrees + 60.0,
           motion);
      take("k", {Number::fibre, 0}, fibre.k, 0.2 * fibre.k, 5.0 * fibre.k, motion);
      take("J3", {Number::inertia, 2}, at.body.J3, 0.3 * at.body.J3, 3.0 * at.body.J3, motion);
    }
  }
  EXPECT_EQ(counted.size(), 3U);
  expect_nearly_all(counted, 8);
}

/// Ends, folds, equal inertias, and frequencies that meet.
TEST(EventEnclosureOfKinds, LocatedOfTiltedFamilies) {
  support::Random random(20261128);
  std::map<std::string, Counted> counted;
  const auto take = [&](const Body& body, const Potential& potential, TiltPlane plane, double nu,
                        const std::string& text) {
    const auto kind_at = [&](double at) {
      return kind_of(body, potential, TiltedMotion{plane, at});
    };
    const auto kind = kind_at(nu);
    const Equilibrium start = kind->solve(without_search());
    if (start.status != SolveStatus::solved) return;
    const Followed sheet = followed(kind->family({}, {}, start.q), start.q, nu, loosely(0.0, 5.0));
    prove_events(sheet, {}, kind_at, text, counted["tilted"]);
  };
  for (int k = 0; k < 120; ++k) {
    const testing::Posed posed = random_problem(random, 1.0);
    for (const TiltPlane plane : {TiltPlane::one_three, TiltPlane::two_three})
      take(posed.problem.body(), posed.problem.potential(), plane, std::abs(posed.nu), posed.text);
  }
  // A quadruple between two pairs of frequencies and two of growth.
  take(Body(2.6988437362719471, 2.6451092757639478, 1.2594877902335551),
       Potential(BiotLog<>{0.39699810771235533, 0.68100791134747052},
                 ReciprocalQuadratic<>{0.4495206176291594, 0.51373933433548802}),
       TiltPlane::one_three, 0.43762576519637031, "a short quadruple");
  expect_nearly_all(counted, 20);
  EXPECT_GT(counted["tilted"].proven[EventType::hamiltonian_hopf], 0);
  EXPECT_GT(counted["tilted"].proven[EventType::real_collision], 0);
  EXPECT_GE(counted["tilted"].compared, 10);
}

/// Of a held volume, an axis in no plane: both ends, on tilted families.
TEST(EventEnclosureOfKinds, LocatedOfAnAxisInNoPlane) {
  BodyModel<> model;
  model.elastic.plane = AnyPlane<>{Biot<>{1.0, 8.0}};
  model.elastic.thickness = AnyThickness<>{ReciprocalQuadratic<>{1.0, 3.0}};
  model.volume = 1.0;
  const Potential potential(model);
  const auto kind_at = [&](double nu) {
    return kind_of(Body(1.0, 1.7, 0.6), potential, SpatialRotation{nu});
  };
  const auto kind = kind_at(2.41);
  const Equilibrium start = kind->solve({});
  ASSERT_EQ(start.status, SolveStatus::solved) << start.message;
  const Followed sheet = followed(kind->family({}, {}, start.q), start.q, 2.41, range(2.2, 2.8));
  Counted counted;
  prove_events(sheet, {}, kind_at, "no plane", counted);
  EXPECT_EQ(counted.proven[EventType::shear], 2) << counted.refusals;
}

struct AsReal50 {
  support::Real50 operator()(double c) const { return c; }
  Direction<support::Real50> direction(double degrees) const {
    const support::Real50 angle =
        degrees * boost::math::constants::pi<support::Real50>() / support::Real50(180);
    return {cos(angle), sin(angle)};
  }
};

/// Where an oblique family begins, about axis 1 and, axes 1 and 2 exchanged, about axis 2: its end is the event of
/// the sheet it leaves, and both are proven.
TEST(EventEnclosureOfKinds, WhereAnObliqueFamilyLeavesAnAxis) {
  for (const Branch branch : {Branch::i, Branch::ii}) {
    const bool first = branch == Branch::i;
    const Body body(first ? plate.J1 : plate.J2, first ? plate.J2 : plate.J1, plate.J3);
    const Potential V = fibred(NeoHookean<>{1.0, 2.0}, 0.4, first ? 0.0 : 90.0);
    const auto straight = kind_of(body, V, AxisRotation{branch, 0.5});
    const Equilibrium start = straight->solve(without_search());
    ASSERT_EQ(start.status, SolveStatus::solved) << start.message;
    const Followed sheet =
        followed(straight->family({}, {}, start.q), start.q, 0.5, range(0.4, 0.76));
    const auto leaves = sheet.events({EventType::oblique});
    ASSERT_EQ(leaves.size(), 1U) << sheet.text();
    const Member& event = leaves.front().member;
    const auto on_axis = kind_of(body, V, AxisRotation{branch, event.nu})
                             ->enclose_event({}, EventType::oblique, event);
    ASSERT_TRUE(on_axis && on_axis->proven) << on_axis->reason;

    const auto kind = kind_of(body, V, ObliqueRotation{0.76, branch});
    const Equilibrium off = kind->solve(without_search());
    ASSERT_EQ(off.status, SolveStatus::solved) << off.message;
    const Followed family = followed(kind->family({}, {}, off.q), off.q, 0.76, range(0.7, 0.78));
    const auto ends = family.events({EventType::oblique});
    ASSERT_EQ(ends.size(), 1U) << family.text();
    const auto end = kind_of(body, V, ObliqueRotation{event.nu, branch})
                         ->enclose_event({}, EventType::oblique, ends.front().member);
    ASSERT_TRUE(end && end->proven) << end->reason;
    EXPECT_FALSE(end->parameter.apart_from(on_axis->parameter));
    EXPECT_LE(end->parameter.width(), 1e-12);
  }
}

/// About axis 3 with alpha != 0, in the numbers themselves: V_q = C q and I33 = the smaller of the
/// plane's inertias, by Newton's method with differences for slopes.
TEST(EventEnclosureOfKinds, HoldsATiltTo50Digits) {
  using support::Real50;
  const Body body(1.0, 1.7, 0.9);
  const AnisotropicPotential V(NeoHookean<>{1.0, 2.0}, ReciprocalQuadratic<>{1.0, 3.0},
                               {{0.4, 30.0}});
  const auto kind_at = [&](double nu) {
    return kind_of(body, Potential(V), AxisRotation{Branch::iii, nu});
  };
  const auto kind = kind_at(0.2);
  const Equilibrium start = kind->solve(without_search());
  ASSERT_EQ(start.status, SolveStatus::solved) << start.message;
  const Followed sheet = followed(kind->family({}, {}, start.q), start.q, 0.2, range(0.0, 2.0));
  const auto tilts = sheet.events({EventType::tilt});
  ASSERT_FALSE(tilts.empty()) << sheet.text();
  const Member& at = tilts.front().member;
  const auto found = kind_at(at.nu)->enclose_event({}, EventType::tilt, at);
  ASSERT_TRUE(found && found->proven);

  const auto model = V.model(AsReal50());
  const Inertia3<Real50> J{body.J1, body.J2, body.J3};
  using Unknowns = std::array<Real50, 5>;  // alpha, xi, zeta, rho, nu
  const auto equations = [&](const Unknowns& x) {
    const BasicStretch<Real50> q{x[0], x[1], x[2], x[3]};
    const auto force = potential_derivatives<1>(model, q).gradient;
    const Matrix4<Real50> C =
        centrifugal_matrix(J, axis_products<Real50>(Branch::iii, x[4] * x[4]));
    Unknowns out;
    for (int i = 0; i < 4; ++i) {
      out[static_cast<std::size_t>(i)] = force[i];
      for (int j = 0; j < 4; ++j) out[static_cast<std::size_t>(i)] -= C(i, j) * q.vector()[j];
    }
    const Matrix3<Real50> I = locked_inertia(J, q);
    const Real50 half = (I(0, 0) - I(1, 1)) / 2;
    const Real50 radius = sqrt(half * half + I(0, 1) * I(0, 1));
    const Real50 mean = (I(0, 0) + I(1, 1)) / 2;
    const bool smaller = abs(I(2, 2) - mean + radius) < abs(I(2, 2) - mean - radius);
    out[4] = I(2, 2) - mean + (smaller ? radius : Real50(-radius));
    return out;
  };
  Unknowns x{at.q.alpha, at.q.xi, at.q.zeta, at.q.rho, at.nu};
  for (int step = 0; step < 12; ++step) {
    const Real50 h("1e-20");
    std::array<std::array<Real50, 5>, 5> slopes;
    for (std::size_t j = 0; j < 5; ++j) {
      Unknowns ahead = x;
      Unknowns behind = x;
      ahead[j] += h;
      behind[j] -= h;
      const Unknowns up = equations(ahead);
      const Unknowns down = equations(behind);
      for (std::size_t i = 0; i < 5; ++i) slopes[i][j] = (up[i] - down[i]) / (2 * h);
    }
    const Unknowns change = solved<5>(slopes, equations(x));
    for (std::size_t i = 0; i < 5; ++i) x[i] -= change[i];
  }
  for (const Real50& rest : equations(x)) ASSERT_LT(abs(rest), Real50("1e-35"));
  const auto holds = [](const Interval& held, const Real50& exact) {
    return Real50(held.lo) <= exact && exact <= Real50(held.hi);
  };
  EXPECT_TRUE(holds(found->q.alpha, x[0])) << x[0];
  EXPECT_TRUE(holds(found->q.xi, x[1])) << x[1];
  EXPECT_TRUE(holds(found->q.zeta, x[2])) << x[2];
  EXPECT_TRUE(holds(found->q.rho, x[3])) << x[3];
  EXPECT_TRUE(holds(found->parameter, x[4])) << x[4];
  EXPECT_LE(found->parameter.width(), 1e-12);
}

}  // namespace
}  // namespace stationary
