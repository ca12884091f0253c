// Normal forms against closed forms, one of which changes its sign, and against the side at which
// continuation finds the motions.
#include "solver/family/normal_form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "solver/proof/certify.hpp"
#include "tests/support/followed.hpp"
#include "tests/support/random_problem.hpp"

namespace stationary::testing {
namespace {

Member member_at(const Body& body, const Stretch& q, double nu) {
  Member out;
  out.body = body;
  out.q = q;
  out.nu = out.parameter = nu;
  out.error_bound = 1e-15;
  return out;
}

/// hencky: F_vvvv = -16 mu, F_vv. K^-1 F_vv. = 16 mu^2/lambda at the event.
TEST(NormalForm, OfThePitchforkOfHenckyChangesItsSign) {
  const double mu = 1.3;
  const Body body(1.0, 1.0, 0.5);
  int signs = 0;
  for (const double lambda : {3.0, 0.7, -0.5, -0.9}) {
    const double u = 0.5 * mu / (mu + lambda);
    const double nu = std::sqrt(mu) * std::exp(-u);
    const double r = std::exp(u);
    const Problem problem(body, make_potential("hencky", {mu, lambda}), Branch::iii);
    const auto form = normal_form(problem, {}, Circle::xi_zeta, EventType::ellipse,
                                  member_at(body, {0.0, r, r, std::cbrt(1.0 / 3.0)}, nu));
    ASSERT_TRUE(form) << lambda;
    const double expected = -16.0 * mu - 48.0 * mu * mu / lambda;
    EXPECT_LE(std::abs(form->coefficient - expected), form->error) << lambda;
    EXPECT_LE(form->error, 1e-11 * std::abs(expected)) << lambda;
    signs += expected > 0.0 ? 1 : -1;
  }
  EXPECT_EQ(signs, 0);
}

/// hencky (i): with n = 1/sqrt(1 + (lambda/own)^2) along ln zeta, F_vvv = -4 J2 nu^2 zeta^2 n^3.
TEST(NormalForm, OfTheFoldOfHencky) {
  const double mu = 1.1;
  const double lambda = 0.8;
  const double own = 2.0 * mu + lambda;
  const Body plate(1.0, 1.7, 0.6);
  const double pull = 2.0 * mu * (mu + lambda) / own;  // J2 nu^2 zeta^2
  const double nu = std::sqrt(pull / (plate.J2 * std::numbers::e));
  const Stretch q{0.0, std::exp(-0.5 * lambda / own), std::exp(0.5), 0.9};
  const Problem problem(plate, make_potential("hencky", {mu, lambda}), Branch::i);
  const auto form =
      normal_form(problem, {}, Circle::none, EventType::fold_nu, member_at(plate, q, nu));
  ASSERT_TRUE(form);
  const double n = 1.0 / std::hypot(1.0, lambda / own);
  const double expected = -4.0 * pull * n * n * n;
  EXPECT_LE(std::abs(form->coefficient - expected), form->error);
  EXPECT_LE(form->error, 1e-10);
  EXPECT_EQ(form->side, EventSide::before);
}

/// The sheets at a fold are where the rows beside it are.
TEST(NormalForm, OfFoldsIsOnTheSideThatContinuationFinds) {
  std::map<EventSide, int> compared;
  support::Random random(20);
  for (int k = 0; k < 200; ++k) {
    const Posed made = random_problem(random, 1.0);
    const SolveOptions how;
    const double nu = 0.3 * std::abs(made.nu);
    if (solve(made.problem, nu, how).status != SolveStatus::solved) continue;
    const Followed sheet = followed(made.problem, nu, range(0.0, 6.0, 1e-6), false, how);
    for (std::size_t row = 1; row + 1 < sheet.rows.size(); ++row) {
      if (sheet.rows[row].event != EventType::fold_nu) continue;
      const Member& at = sheet.rows[row].member;
      const Circle circle = mirror_symmetric(made.problem, at.nu) && at.q.xi == at.q.zeta
                                ? Circle::xi_zeta
                                : Circle::none;
      const auto form = normal_form(made.problem, {}, circle, EventType::fold_nu, at);
      ASSERT_TRUE(form) << k;
      const double before = sheet.rows[row - 1].member.nu - at.nu;
      const double after = sheet.rows[row + 1].member.nu - at.nu;
      ASSERT_GT(before * after, 0.0) << k;
      EXPECT_EQ(form->side, after > 0.0 ? EventSide::after : EventSide::before) << k;
      ++compared[form->side];
    }
  }
  EXPECT_GE(compared[EventSide::before] + compared[EventSide::after], 10);
}

/// What is degenerate, or no event with a normal form, has none.
TEST(NormalForm, IsNotToldOfAVerticalBranch) {
  const Body body(1.0, 1.0, 0.5);
  const Problem problem(body, make_potential("neo-hookean", {1.0, 2.0}), Branch::iii);
  const double r = std::exp(0.25);  // lambda ln r^2 = mu
  const Member at = member_at(body, {0.0, r, r, std::cbrt(1.0 / 3.0)}, 1.0);
  EXPECT_FALSE(normal_form(problem, {}, Circle::xi_zeta, EventType::ellipse, at));
  EXPECT_FALSE(normal_form(problem, {}, Circle::xi_zeta, EventType::krein_pass, at));
}

}  // namespace
}  // namespace stationary::testing
