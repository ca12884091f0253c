// Normal forms where motions leave a spin of an anisotropic body: at one nu the energy of those that
// leave, less that of those that stay, is -a s^4/24 + O(s^6), s the amplitude.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "solver/atlas/atlas.hpp"
#include "solver/family/anisotropic_family.hpp"
#include "solver/motion/oriented_stability.hpp"
#include "solver/normal_form/normal_form.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "tests/support/atlas_text.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/followed.hpp"

namespace stationary::testing {
namespace {

/// V - nu.I nu/2.
double reduced_energy(const Problem& problem, const Stretch& q, const Vector3<double>& nu) {
  const Body& body = problem.body();
  const double a = q.alpha;
  const double m1 = body.J1 * q.xi * q.xi + body.J2 * a * a;
  const double m2 = body.J1 * a * a + body.J2 * q.zeta * q.zeta;
  const double m12 = (body.J1 * q.xi + body.J2 * q.zeta) * a;
  const double m3 = body.J3 * q.rho * q.rho;
  const double spin = (m2 + m3) * nu[0] * nu[0] + (m1 + m3) * nu[1] * nu[1] +
                      (m1 + m2) * nu[2] * nu[2] - 2.0 * m12 * nu[0] * nu[1];
  return potential_derivatives<1>(problem.potential().anisotropic().model(), q).value - 0.5 * spin;
}

struct Left {
  double amplitude;
  double coefficient;  ///< -24 (F - F of those that stay)/s^4
};

/// Of the rows of the sheet that leaves `from` at the event, of small amplitudes.
template <class Amplitude>
std::vector<Left> left_rows(const Problem& problem, const AtlasSheet& sheet, const Stretch& event,
                            const Amplitude& amplitude) {
  std::vector<Left> out;
  for (const AtlasRow& row : sheet.rows) {
    const double s = std::abs(amplitude(row.member));
    if (s < 0.02 || s > 0.12) continue;
    const double nu = std::abs(row.member.nu);
    const Equilibrium stays = solve(problem, nu, without_search(event));
    if (stays.status != SolveStatus::solved || stays.q.alpha != 0.0) continue;
    const double gain = reduced_energy(problem, row.member.q, row.member.angular_velocity) -
                        reduced_energy(problem, stays.q, stays.nu);
    out.push_back({s, -24.0 * gain / std::pow(s, 4)});
  }
  std::ranges::sort(out, {}, &Left::amplitude);
  return out;
}

/// The coefficients in s^2 at 0.
void expect_coefficient(const std::vector<Left>& rows, const NormalForm& form) {
  ASSERT_GE(rows.size(), 2U);
  const Left& a = rows.front();
  const Left& b = rows.back();
  ASSERT_GT(b.amplitude, 1.3 * a.amplitude);
  const double a2 = a.amplitude * a.amplitude;
  const double b2 = b.amplitude * b.amplitude;
  const double expected = (a.coefficient * b2 - b.coefficient * a2) / (b2 - a2);
  EXPECT_NEAR(form.coefficient, expected, 0.01 * std::abs(expected));
  EXPECT_LE(form.error, 1e-9 * std::abs(expected));
}

struct Leaving {
  const AtlasSheet* from;
  const AtlasSheet* sheet;
  const Member* event;
};

Leaving leaving(const Atlas& found, EventType type) {
  Leaving out{};
  for (const AtlasSheet& sheet : found.sheets) {
    if (!sheet.parent || sheet.parent->event != type) continue;
    out.sheet = &sheet;
    out.from = &found.sheets[static_cast<std::size_t>(sheet.parent->sheet - 1)];
  }
  if (out.sheet == nullptr) return out;
  for (const AtlasRow& row : out.from->rows)
    if (row.event == type && std::abs(row.member.nu - out.sheet->parent->nu) < 1e-9)
      out.event = &row.member;
  return out;
}

void expect_side(const Leaving& at, const NormalForm& form) {
  double nu = 0.0;
  for (const AtlasRow& row : at.sheet->rows)
    if (row.event == EventType::none &&
        (nu == 0.0 || std::abs(row.member.nu - at.event->nu) < std::abs(nu - at.event->nu)))
      nu = row.member.nu;
  EXPECT_EQ(form.side, nu > at.event->nu ? EventSide::after : EventSide::before);
}

AtlasOptions atlas_range(double from, double to, Branch branch) {
  AtlasOptions out;
  out.from = from;
  out.to = to;
  out.checkpoints = 2;
  out.step.tolerance = 1e-10;
  out.branches = {branch};
  out.oblique = false;
  return out;
}

TEST(OrientedNormalForm, OfAnEllipseThatTurnsAway) {
  const Problem problem({1.0, 1.2, 0.6}, fibred(Hencky<>{1.0, 0.6}, 0.05, 90.0), Branch::iii);
  const Atlas found =
      atlas(problem.body(), problem.potential(), atlas_range(0.5, 0.75, Branch::iii));
  const Leaving at = leaving(found, EventType::shear);
  ASSERT_NE(at.event, nullptr) << text_of(found);
  const auto form = normal_form(problem, {}, Circle::none, EventType::shear, *at.event);
  ASSERT_TRUE(form);
  expect_side(at, *form);
  expect_coefficient(
      left_rows(problem, *at.sheet, at.event->q,
                [](const Member& each) {
                  return std::atanh(each.q.alpha / std::sqrt(each.q.xi * each.q.zeta));
                }),
      *form);
}

TEST(OrientedNormalForm, OfAnAxisThatLeavesItsOwn) {
  const Problem problem({1.0, 1.7, 0.6}, fibred(NeoHookean<>{1.0, 2.0}, 0.4, 0.0), Branch::i);
  AtlasOptions how = atlas_range(0.7, 0.76, Branch::i);
  how.oblique = true;
  const Atlas found = atlas(problem.body(), problem.potential(), how);
  const Leaving at = leaving(found, EventType::oblique);
  ASSERT_NE(at.event, nullptr) << text_of(found);
  const auto form = normal_form(problem, {}, Circle::none, EventType::oblique, *at.event);
  ASSERT_TRUE(form);
  expect_side(at, *form);
  expect_coefficient(left_rows(problem, *at.sheet, at.event->q,
                               [](const Member& each) {
                                 const Vector3<double> nu = each.angular_velocity;
                                 return std::atan2(std::abs(nu[1]), std::abs(nu[0]));
                               }),
                     *form);
}

/// Of a fibre that hardly pulls it is the isotropic body's.
TEST(OrientedNormalForm, OfAFoldAgreesWithThatOfAnIsotropicBody) {
  const Hencky<> plane{1.1, 0.8};
  const Body body(1.0, 1.7, 0.6);
  const ReciprocalQuadratic<> thickness{1.0, 3.0};
  const double pull = 2.0 * 1.1 * 1.9 / 3.0;  // J2 nu^2 zeta^2 at the fold of (i)
  Member at;
  at.body = body;
  at.q = {0.0, std::exp(-0.4 / 3.0), std::exp(0.5), std::cbrt(1.0 / 3.0)};
  at.nu = at.parameter = std::sqrt(pull / (body.J2 * std::exp(1.0)));
  at.error_bound = 1e-14;
  const Problem isotropic(body, Potential(plane, thickness), Branch::i);
  const Problem fibred(body, testing::fibred(plane, 1e-13, 0.0), Branch::i);
  const auto expected = normal_form(isotropic, {}, Circle::none, EventType::fold_nu, at);
  const auto form = normal_form(fibred, {}, Circle::none, EventType::fold_nu, at);
  ASSERT_TRUE(expected && form);
  EXPECT_NEAR(form->coefficient, expected->coefficient, 1e-9);
  EXPECT_EQ(form->side, expected->side);
}

/// A skew fibre: alpha is not 0 on any sheet.
TEST(OrientedNormalForm, IsNotToldOfAPotentialThatIsNotEven) {
  const Problem skew({1.0, 1.7, 0.6}, fibred(NeoHookean<>{1.0, 2.0}, 0.4, 30.0), Branch::iii);
  Member at;
  at.body = skew.body();
  at.q = {0.0, 1.1, 1.2, 0.9};
  at.nu = at.parameter = 0.5;
  at.error_bound = 1e-15;
  EXPECT_FALSE(normal_form(skew, {}, Circle::none, EventType::shear, at));
}

/// Makes a model, and keeps the coefficient at one place.
struct Reading {
  int place;
  mutable int next = 0;
  mutable double value = 0.0;

  double operator()(double c) const {
    if (next++ == place) value = c;
    return c;
  }
  Direction<double> direction(double degrees) const {
    (*this)(degrees);
    return {1.0, 0.0};
  }
};

/// Of a coefficient among all of the potential's.
int place_of(const AnisotropicPotential& V, const FamilyParameter& parameter) {
  const bool of_fibre = parameter.kind == FamilyParameter::Kind::fibre;
  return parameter.index + (of_fibre ? V.fibre_place() : 0);
}

/// A body with one of its numbers at another value.
Problem changed(const Problem& problem, const FamilyParameter& parameter, double value) {
  const Body& J = problem.body();
  if (parameter.kind == FamilyParameter::Kind::inertia) {
    double own[] = {J.J1, J.J2, J.J3};
    own[parameter.index] = value;
    return {Body(own[0], own[1], own[2]), problem.potential(), problem.branch()};
  }
  const AnisotropicPotential& V = problem.potential().anisotropic();
  const int place = place_of(V, parameter);
  return {J, Potential(V.with_coefficient(place, value)), problem.branch()};
}
double value_of(const Problem& problem, const FamilyParameter& parameter) {
  const Body& J = problem.body();
  if (parameter.kind == FamilyParameter::Kind::inertia)
    return parameter.index == 0 ? J.J1 : parameter.index == 1 ? J.J2 : J.J3;
  const AnisotropicPotential& V = problem.potential().anisotropic();
  const Reading at{place_of(V, parameter)};
  V.model(at);
  return at.value;
}

/// The motions that leave are the same whatever parameter comes to the event; they are on that side
/// of it on which the sheet that stays is no minimum along them.
TEST(OrientedNormalForm, TheSideIsThatOfTheStiffnessInEveryParameter) {
  using Kind = FamilyParameter::Kind;
  support::Random random(279);
  int compared = 0;
  for (int kind = 0; kind < 240; ++kind) {
    const OrientedBody at = random_oriented_body(random, kind);
    if (!at.V.even_in_alpha() || at.V.fibres().empty()) continue;
    const Problem problem = at.problem(Branch::iii);
    const Equilibrium rest = solve(problem, 0.0, without_search());
    if (rest.status != SolveStatus::solved || rest.q.alpha != 0.0) continue;
    const AnyFamily family =
        anisotropic_family(at.body, at.V, Branch::iii, false, {.parameter = {}, .spectrum = false});
    const Followed sheet = followed(family, rest.q, 0.0, testing::range(0.0, 2.0));
    for (const FollowedRow& row : sheet.events({EventType::shear})) {
      const Member& event = row.member;
      const auto turn = [&](const Problem& near, double nu) {
        const Equilibrium found = solve(near, nu, without_search(event.q));
        if (found.status != SolveStatus::solved || found.q.alpha != 0.0)
          return std::numeric_limits<double>::quiet_NaN();
        const double V_aa = near.potential().derivatives(found.q).hessian(0, 0);
        return turn_of(near.body(), Branch::iii, V_aa, found.q, nu).value;
      };
      constexpr double h = 1e-4;
      const double by_nu =
          turn(problem, event.nu * (1.0 + h)) - turn(problem, event.nu * (1.0 - h));
      const auto in_nu = normal_form(problem, {}, Circle::none, EventType::shear, event);
      if (!in_nu || !(std::abs(by_nu) > 1e-6)) continue;
      std::vector<FamilyParameter> parameters{{Kind::inertia, 0}, {Kind::inertia, 1},
                                              {Kind::inertia, 2}, {Kind::plane, 0},
                                              {Kind::plane, 1},   {Kind::fibre, 0}};
      for (const FamilyParameter& parameter : parameters) {
        Member same = event;
        same.parameter = value_of(problem, parameter);
        const double by_parameter =
            turn(changed(problem, parameter, same.parameter * (1.0 + h)), event.nu) -
            turn(changed(problem, parameter, same.parameter * (1.0 - h)), event.nu);
        const auto form = normal_form(problem, parameter, Circle::none, EventType::shear, same);
        if (!form || !(std::abs(by_parameter) > 1e-7)) continue;
        EXPECT_EQ(form->side == in_nu->side, (by_parameter > 0.0) == (by_nu > 0.0))
            << at.text << ", parameter " << static_cast<int>(parameter.kind) << parameter.index;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 60);
}

}  // namespace
}  // namespace stationary::testing
