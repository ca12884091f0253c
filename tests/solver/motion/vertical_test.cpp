// Vertical branches (J1 = J2, branch (iii)): neo-hookean has its ellipses at J nu^2 = mu only, with
// d = exp(mu/lambda) and any t; biot at J nu^2 = 2 mu, with t = 2 (mu + lambda)/lambda and any d.
#include <gtest/gtest.h>

#include "solver/atlas/atlas.hpp"
#include "solver/motion/vertical_branch.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/bodies/whole_body.hpp"
#include "tests/support/followed.hpp"

namespace stationary::testing {
namespace {

constexpr double J = 1.3;
constexpr double J3 = 0.6;

Problem body_of(std::string_view model, std::array<double, 2> coefficients) {
  return {Body(J, J, J3), make_potential(model, coefficients), Branch::iii};
}

Followed from(const Problem& problem, const Stretch& q, double nu) {
  return followed(axis_family(problem, {.nu = 0.0, .parameter = {}}), q, nu, range(0.0, 2.0));
}

/// One nu, no fold, and what the branch has instead of it; the invariant holds within the bound.
template <class Invariant>
void expect_vertical(const Followed& sheet, double nu, const Invariant& invariant, double exact) {
  EXPECT_TRUE(sheet.report.vertical);
  EXPECT_EQ(sheet.rows.front().event, EventType::ellipse) << sheet.text();
  ASSERT_GT(sheet.rows.size(), 10U);
  for (const auto& [member, event] : sheet.rows) {
    EXPECT_NEAR(member.nu, nu, 4e-16);
    EXPECT_NE(event, EventType::fold_nu);
    EXPECT_NE(event, EventType::unexplained);
    EXPECT_NE(event, EventType::stalled);
    EXPECT_LE(std::abs(invariant(member.q) / exact - 1.0), 2.0 * member.error_bound)
        << member.q.xi << " " << member.q.zeta;
    EXPECT_LE(member.error_bound, 1e-6);  // where it meets the circle two curves cross
    EXPECT_LE(member.residual, 1e-13);
    ASSERT_TRUE(member.spectrum);
  }
}

TEST(VerticalBranch, NeoHookean) {
  const double mu = 0.8;
  const double lambda = 2.0;
  const double nu = std::sqrt(mu / J);
  const double d = std::exp(mu / lambda);
  const Problem problem = body_of("neo-hookean", {mu, lambda});
  const double rho = std::cbrt(1.0 / 3.0);
  const Followed sheet = from(problem, {0.0, 1.5, d / 1.5, rho}, nu);
  ASSERT_EQ(sheet.report.failure, "");
  expect_vertical(
      sheet, nu, [](const Stretch& q) { return q.xi * q.zeta; }, d);
  EXPECT_EQ(sheet.rows.back().event, EventType::escape);
  // I_1 = I_3 where J xi^2 = J3 rho^2 or, xi and zeta being exchangeable, J zeta^2 = J3 rho^2.
  const auto tilts = sheet.events({EventType::tilt});
  ASSERT_EQ(tilts.size(), 1U) << sheet.text();
  EXPECT_NEAR(tilts[0].member.q.zeta, rho * std::sqrt(J3 / J), 1e-12);
}

TEST(VerticalBranch, Biot) {
  const double mu = 0.7;
  const double lambda = 1.1;
  const double nu = std::sqrt(2.0 * mu / J);
  const double t = 2.0 * (mu + lambda) / lambda;
  const Problem problem = body_of("biot", {mu, lambda});
  const Followed sheet = from(problem, {0.0, 0.7 * t, 0.3 * t, std::cbrt(1.0 / 3.0)}, nu);
  ASSERT_EQ(sheet.report.failure, "");
  expect_vertical(
      sheet, nu, [](const Stretch& q) { return q.xi + q.zeta; }, t);
  EXPECT_EQ(sheet.rows.back().event, EventType::collapse);
}

/// Ellipses of other potentials, at their own nu, are no vertical branch.
TEST(VerticalBranch, NotWhereEllipsesDependOnNu) {
  const Problem problem = body_of("hencky", {1.0, 3.0});
  AtlasOptions options;
  options.to = 1.4;
  options.checkpoints = 16;
  const Atlas all = atlas(problem.body(), problem.potential(), options);
  int ellipses = 0;
  for (const AtlasSheet& sheet : all.sheets) {
    ellipses += sheet.entry == Entry::ellipse || sheet.parent;
    EXPECT_FALSE(sheet.report.vertical);
  }
  EXPECT_GT(ellipses, 0);
}

/// W_t = mu t leaves t free where the volume is held too; what d is then the thickness decides as well.
TEST(VerticalBranch, OfAHeldVolume) {
  const AnyThickness<> thickness{ReciprocalQuadratic<>{1.0, 3.0}};
  const auto of = [&](const AnyPlane<>& plane) {
    return Problem(Body(J, J, J3), held(plane, thickness), Branch::iii);
  };
  const Problem problem = of(AnyPlane<>{NeoHookean<>{1.0, 2.0}});
  const double nu = std::sqrt(1.0 / J);
  ASSERT_TRUE(vertical_condition(problem, nu));
  EXPECT_FALSE(vertical_condition(problem, nu * (1.0 + 1e-9)));
  EXPECT_FALSE(vertical_condition(of(AnyPlane<>{Biot<>{1.0, 2.0}}), std::sqrt(2.0 / J)));
  EXPECT_EQ(solve(problem, nu).status, SolveStatus::not_isolated);
}

/// The atlas enters it off the circle and finds the tilted family that ends on it.
TEST(VerticalBranch, InTheAtlas) {
  const Problem problem = body_of("neo-hookean", {0.8, 2.0});
  AtlasOptions options;
  options.to = 1.2;
  options.checkpoints = 16;
  const Atlas all = atlas(problem.body(), problem.potential(), options);
  const auto vertical = std::ranges::find_if(
      all.sheets, [](const AtlasSheet& sheet) { return sheet.report.vertical; });
  ASSERT_NE(vertical, all.sheets.end());
  EXPECT_EQ(vertical->entry, Entry::ellipse);
  ASSERT_TRUE(vertical->parent);
  EXPECT_EQ(vertical->parent->event, EventType::ellipse);
  EXPECT_TRUE(std::ranges::any_of(all.sheets, [&](const AtlasSheet& sheet) {
    return sheet.plane && sheet.joins && sheet.joins->sheet == vertical->number;
  }));
}

}  // namespace
}  // namespace stationary::testing
