// Families in a number other than nu: the slopes a family gives continuation are those of its
// balance, and what is followed is what a solve finds.
#include <gtest/gtest.h>

#include <optional>

#include "tests/support/bodies/model_and_branch.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;
using ParameterKind = FamilyParameter::Kind;

/// A problem as its numbers.
struct Numbers {
  std::string_view model;
  Branch branch;
  std::array<double, 3> J{1.0, 1.7, 0.6};
  std::array<double, 2> plane{1.0, 2.0};
  std::string_view thickness = "reciprocal-quadratic";
  std::array<double, 2> axial{1.0, 3.0};
  double nu = 0.4;

  bool coupled() const { return model == "neo-hookean-3d"; }
  Problem problem() const {
    return {Body(J[0], J[1], J[2]), testing::make_potential(model, plane, thickness, axial),
            branch};
  }
  double& at(const FamilyParameter& p) {
    const auto k = static_cast<std::size_t>(p.index);
    switch (p.kind) {
      case ParameterKind::nu:
        return nu;
      case ParameterKind::inertia:
        return J[k];
      case ParameterKind::plane:
        return plane[k];
      case ParameterKind::thickness:
      case ParameterKind::shared:  // of no model here
      case ParameterKind::fibre:
        break;
    }
    return axial[k];
  }
  Numbers with(const FamilyParameter& p, double value) const {
    Numbers out = *this;
    out.at(p) = value;
    return out;
  }
  AnyFamily family(const FamilyParameter& p, bool spectrum = false) const {
    return axis_family(problem(), {.nu = nu, .parameter = p, .spectrum = spectrum});
  }
};

std::vector<FamilyParameter> parameters(const Numbers& of) {
  std::vector<FamilyParameter> out{{ParameterKind::nu, 0},      {ParameterKind::inertia, 0},
                                   {ParameterKind::inertia, 1}, {ParameterKind::inertia, 2},
                                   {ParameterKind::plane, 0},   {ParameterKind::plane, 1}};
  if (!of.coupled())
    out.insert(out.end(), {{ParameterKind::thickness, 0}, {ParameterKind::thickness, 1}});
  return out;
}

std::string text(const FamilyParameter& p) {
  constexpr const char* names[] = {"nu", "J", "plane", "thickness"};
  return std::string(names[static_cast<int>(p.kind)]) + " " + std::to_string(p.index);
}

/// df/d ln y, of an f in extended precision. The rows' common factors have kinks where two terms
/// are equal, as at a solution: a step so small that they do not show.
template <int N, class F>
ReducedVector<N> logarithmic_slope(double y, const F& f) {
  constexpr double h = 0x1p-30;
  const double above = y * (1.0 + h);
  const double below = y * (1.0 - h);
  const ReducedVector<N> change = f(above) - f(below);
  return change / std::log1p((above - below) / below);
}

class ParameterFamily : public ::testing::TestWithParam<support::ModelAndBranch> {
 protected:
  Numbers numbers() const {
    Numbers out;
    out.model = std::get<0>(GetParam());
    out.branch = std::get<1>(GetParam());
    return out;
  }
  /// J and coefficients within a factor of 3, a spin the body stands.
  Numbers random_numbers(support::Random& random) const {
    Numbers out = numbers();
    for (double* each : {&out.J[0], &out.J[1], &out.J[2], &out.plane[0], &out.plane[1],
                         &out.axial[0], &out.axial[1]})
      *each = random.log_uniform(1.0 / 3.0, 3.0);
    if (random.integer(0, 1) == 1) out.thickness = "harmonic";
    out.nu = random.sign() * random.uniform(0.05, 0.3);
    return out;
  }
};

template <int N>
void expect_slopes(const Family<N>& family, const Stretch& q, double p, const Numbers& of,
                   const std::string& message) {
  constexpr double tolerance = 1e-8;
  const ReducedVector<N> x = unknowns<N>(q);
  const FamilyLinearization<N> at = family.linearize(x, p);
  EXPECT_LE(family.extended_residual(x, p).cwiseAbs().maxCoeff(), 1e-15) << message;
  EXPECT_LE(at.g.cwiseAbs().maxCoeff(), 1e-14) << message;
  const ReducedVector<N> slope =
      logarithmic_slope<N>(p, [&](double to) { return family.extended_residual(x, to); });
  EXPECT_LE((p * at.slope - slope).cwiseAbs().maxCoeff(), tolerance)
      << message << ": " << (p * at.slope).transpose() << " and " << slope.transpose();
  for (int k = 0; k < N; ++k) {
    const ReducedVector<N> column = logarithmic_slope<N>(x[k], [&](double to) {
      ReducedVector<N> y = x;
      y[k] = to;
      return family.extended_residual(y, p);
    });
    EXPECT_LE((at.jacobian.col(k) - column).cwiseAbs().maxCoeff(), tolerance) << message << k;
  }
  // Along nu: of the family in nu at the same place, whose rows have the same factors.
  const AnyFamily in_nu = of.family({});
  if (const auto* same = std::get_if<std::unique_ptr<Family<N>>>(&in_nu)) {
    const FamilyLinearization<N> along = (*same)->linearize(x, of.nu);
    EXPECT_LE((at.nu_slope - along.slope).cwiseAbs().maxCoeff(), 1e-13) << message;
    EXPECT_EQ(along.slope, along.nu_slope) << message;
  }
}

/// Corrected from beside q: the slopes that come with it, where they do, are those there.
template <int N>
bool expect_slopes_of_correction(const Family<N>& family, const Stretch& q, double p, double beside,
                                 const std::string& message) {
  ReducedVector<N> x = unknowns<N>(q);
  for (int k = 0; k < N; ++k) x[k] *= 1.0 + (k % 2 == 0 ? beside : -beside);
  ReducedVector<N> plain = x;
  ReducedVector<N> tail;
  std::optional<FamilySlopes<N>> slopes;
  EXPECT_TRUE(family.refine_with_slopes(x, tail, p, slopes).converged) << message;
  (void)family.refine_at(plain, tail, p);
  EXPECT_EQ(x, plain) << message;
  if (!slopes) return false;
  const FamilyLinearization<N> there = family.linearize(x, p);
  constexpr double same = 64.0 * Family<N>::slopes_agree;
  EXPECT_LE((slopes->jacobian - there.jacobian).cwiseAbs().maxCoeff(), same) << message;
  EXPECT_LE((slopes->slope - there.slope).cwiseAbs().maxCoeff(),
            same * there.slope.cwiseAbs().maxCoeff())
      << message;
  EXPECT_LE((slopes->nu_slope - there.nu_slope).cwiseAbs().maxCoeff(),
            same * there.nu_slope.cwiseAbs().maxCoeff())
      << message;
  return true;
}

TEST_P(ParameterFamily, ACorrectionHasTheSlopesOfWhereItEnds) {
  support::Random random(337);
  int had = 0;
  for (int k = 0; k < 40; ++k) {
    const Numbers of = random_numbers(random);
    const Equilibrium solved = solve(of.problem(), of.nu);
    if (solved.status != SolveStatus::solved) continue;
    const AnyFamily in_nu = of.family({});
    std::visit(
        [&](const auto& own) {
          constexpr int N = std::decay_t<decltype(*own)>::dimension;
          if constexpr (N <= 3) {
            for (const double beside : {1e-15, 1e-5}) {
              had +=
                  expect_slopes_of_correction<N>(*own, solved.q, of.nu, beside, std::to_string(k));
            }
          }
        },
        in_nu);
  }
  EXPECT_GE(had, 15);
}

TEST_P(ParameterFamily, SlopesAreThoseOfTheBalance) {
  support::Random random(331);
  int checked = 0;
  for (int k = 0; k < 40; ++k) {
    Numbers of = random_numbers(random);
    const Equilibrium solved = solve(of.problem(), of.nu);
    if (solved.status != SolveStatus::solved) continue;
    ++checked;
    for (const FamilyParameter& p : parameters(of)) {
      std::visit(
          [&](const auto& family) { expect_slopes(*family, solved.q, of.at(p), of, text(p)); },
          of.family(p));
    }
  }
  EXPECT_GE(checked, 30);
}

/// A parameter the balance does not know moves nothing.
TEST_P(ParameterFamily, WhatTheBalanceDoesNotKnowMovesNothing) {
  Numbers of = numbers();
  const int idle = of.branch == Branch::i ? 0 : of.branch == Branch::ii ? 1 : 2;
  const FamilyParameter own{ParameterKind::inertia,
                            idle};  // J about the spin's own material direction
  const Equilibrium solved = solve(of.problem(), of.nu);
  ASSERT_EQ(solved.status, SolveStatus::solved);
  const Followed sheet = followed(of.family(own), solved.q, of.at(own),
                                  range(0.5 * of.at(own), 2.0 * of.at(own), 1e-6));
  for (const FollowedRow& row : sheet.rows) {
    EXPECT_EQ(row.member.q.xi, solved.q.xi);
    EXPECT_EQ(row.member.q.zeta, solved.q.zeta);
    EXPECT_EQ(row.member.q.rho, solved.q.rho);
  }
}

TEST_P(ParameterFamily, RowsAreWhatASolveFinds) {
  Numbers of = numbers();
  const Equilibrium start = solve(of.problem(), of.nu);
  ASSERT_EQ(start.status, SolveStatus::solved);
  for (const FamilyParameter& p : parameters(of)) {
    const double own = of.at(p);
    const Followed sheet = followed(of.family(p), start.q, own, range(0.75 * own, 1.3 * own, 1e-5));
    ASSERT_GE(sheet.rows.size(), 4U) << text(p);
    EXPECT_EQ(sheet.rows.front().event, EventType::limit) << text(p);
    EXPECT_EQ(sheet.rows.back().event, EventType::limit) << text(p);
    EXPECT_EQ(sheet.rows.front().member.parameter, 0.75 * own) << text(p);
    EXPECT_EQ(sheet.rows.back().member.parameter, 1.3 * own) << text(p);
    for (std::size_t k = 0; k < sheet.rows.size(); k += 1 + sheet.rows.size() / 12) {
      const Member& at = sheet.rows[k].member;
      const Numbers there = of.with(p, at.parameter);
      const Equilibrium cold = solve(there.problem(), there.nu);
      ASSERT_EQ(cold.status, SolveStatus::solved) << text(p);
      EXPECT_EQ(at.nu, there.nu);
      EXPECT_EQ(at.body, there.problem().body());
      EXPECT_LE(at.residual, 1e-14);
      const double bound = 1.01 * (at.error_bound + cold.error_bound);
      EXPECT_NEAR(at.q.xi, cold.q.xi, bound * cold.q.xi) << text(p) << " = " << at.parameter;
      EXPECT_NEAR(at.q.zeta, cold.q.zeta, bound * cold.q.zeta) << text(p) << " = " << at.parameter;
      EXPECT_NEAR(at.q.rho, cold.q.rho, bound * cold.q.rho) << text(p) << " = " << at.parameter;
    }
  }
}

/// J1 through J2: in (iii) the ellipse changes its long axis, as a circle at J1 = J2.
TEST_P(ParameterFamily, ThroughTheRoundBody) {
  Numbers of = numbers();
  const FamilyParameter first{ParameterKind::inertia, 0};
  const Equilibrium start = solve(of.problem(), of.nu);
  ASSERT_EQ(start.status, SolveStatus::solved);
  const Followed sheet = followed(of.family(first), start.q, 1.0, range(1.0, 2.5, 1e-5));
  EXPECT_EQ(sheet.rows.back().member.parameter, 2.5) << sheet.text();
  const Member& end = sheet.rows.back().member;
  const Numbers there = of.with(first, 2.5);
  const Equilibrium cold = solve(there.problem(), there.nu);
  EXPECT_NEAR(end.q.xi, cold.q.xi, 1e-14 * cold.q.xi);
  EXPECT_NEAR(end.q.zeta, cold.q.zeta, 1e-14 * cold.q.zeta);
  if (of.branch != Branch::iii) return;
  EXPECT_LT(start.q.xi, start.q.zeta);
  EXPECT_GT(end.q.xi, end.q.zeta);
  for (const FollowedRow& row : sheet.rows) {
    const double J1 = row.member.parameter;
    EXPECT_GE((J1 - 1.7) * (row.member.q.xi - row.member.q.zeta), -1e-15) << J1;
  }
}

/// There and back along a parameter: the start again.
TEST_P(ParameterFamily, ThereAndBack) {
  Numbers of = numbers();
  const Equilibrium start = solve(of.problem(), of.nu);
  for (const FamilyParameter& p : parameters(of)) {
    const double own = of.at(p);
    const AnyFamily family = of.family(p);
    const Followed there = followed(family, start.q, own, range(own, 1.3 * own, 1e-6));
    const Member& end = there.rows.back().member;
    const Followed back = followed(family, end.q, end.parameter, range(own, 1.3 * own, 1e-6));
    const Member& home = back.rows.front().member;
    EXPECT_EQ(home.parameter, own) << text(p);
    EXPECT_NEAR(home.q.xi, start.q.xi, 1e-15 * start.q.xi) << text(p);
    EXPECT_NEAR(home.q.zeta, start.q.zeta, 1e-15 * start.q.zeta) << text(p);
    EXPECT_NEAR(home.q.rho, start.q.rho, 1e-15 * start.q.rho) << text(p);
  }
}

/// At the tilt a pair goes through zero, back the way it came: the pair of the other signature it
/// passes, it passes twice, and the second time as one of its own signature.
TEST(ParameterFamilies, APassAndATiltInOneStep) {
  Numbers of{.model = "biot-log", .branch = Branch::iii};
  of.J = {1.0, 1.0, 0.6};
  of.plane = {1.0, 4.0};
  of.nu = 1.1;
  const Equilibrium start = solve(of.problem(), of.nu);
  const AnyFamily family = of.family({ParameterKind::inertia, 2}, true);
  for (const double first : {1e-3, 0.01, 0.03, 0.1, 0.2, 0.3, 0.5}) {
    FollowOptions options = range(0.05, 6.0);
    options.continuation.step.first = first;
    const auto events = followed(family, start.q, 0.6, options).events();
    ASSERT_EQ(events.size(), 2U) << first;
    EXPECT_EQ(events[0].event, EventType::krein_pass);
    EXPECT_NEAR(events[0].member.parameter, 2.5535218895908, 1e-10);
    EXPECT_EQ(events[1].event, EventType::tilt);
    EXPECT_NEAR(events[1].member.parameter, 2.8492756064502, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, ParameterFamily,
                         ::testing::Combine(::testing::ValuesIn(all_models()),
                                            ::testing::Values(Branch::i, Branch::ii, Branch::iii)),
                         support::model_and_branch);

/// A coefficient that plane and thickness share: both change, and each row has its own slope.
TEST(SharedCoefficient, IsOneOfBothParts) {
  Numbers numbers{.model = "neo-hookean", .branch = Branch::i};
  numbers.axial = {numbers.plane[0], 3.0};
  const Problem problem = numbers.problem();
  const Equilibrium at = solve(problem, numbers.nu);
  const auto slope = [&](ParameterKind kind, double p) {
    const AnyFamily family = numbers.family({kind, 0});
    const auto& each = *std::get<std::unique_ptr<Family<3>>>(family);
    return each.linearize(unknowns<3>(at.q), p).slope;
  };
  const double p = numbers.plane[0];
  const ReducedVector<3> both = slope(ParameterKind::shared, p);
  EXPECT_EQ(both,
            ReducedVector<3>(slope(ParameterKind::plane, p) + slope(ParameterKind::thickness, p)));
  EXPECT_NE(both[0], 0.0);
  EXPECT_NE(both[2], 0.0);
  Numbers changed = numbers;
  changed.plane[0] = changed.axial[0] = 1.25;
  const Equilibrium expected = solve(changed.problem(), numbers.nu);
  const AnyFamily family = numbers.family({ParameterKind::shared, 0});
  const auto& shared = *std::get<std::unique_ptr<Family<3>>>(family);
  ReducedVector<3> x = unknowns<3>(expected.q);
  ReducedVector<3> tail;
  ASSERT_TRUE(shared.refine_at(x, tail, 1.25).converged);
  EXPECT_EQ(x, unknowns<3>(expected.q));
}

}  // namespace
}  // namespace stationary
