// Every row of the reference tables, computed independently to 25 digits, is a stationary motion of
// this library: in 50 digits to the digits printed, in doubles to a few units in the last place.
#include <gtest/gtest.h>

#include <set>

#include "lib/balance/balance.hpp"
#include "lib/balance/balance_in_momenta.hpp"
#include "lib/balance/two_polar.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/reference_table.hpp"

namespace stationary {
namespace {

using namespace support;

/// (a) and (b) in 50 digits, relative to the largest term; the table's digits decide `allowed`.
void expect_stationary_in_wide_numbers(const ReferenceRow& row, const Real50& allowed) {
  const Body body = row.scaled_body();
  const auto q = row.stretch<Real50>();
  const auto nu = row.nu<Real50>();
  row.with_scaled_model<Real50>([&](const auto& model) {
    const auto v = potential_derivatives<2>(model, q);
    const Matrix4<Real50> terms = v.hessian * q.vector().asDiagonal();
    const Real50 scale = terms.cwiseAbs().maxCoeff();
    EXPECT_TRUE(all_agree<Vector4<Real50>>(row.where(), Vector4<Real50>::Zero(),
                                           balance_residual(body, model, q, nu), allowed * scale));
    const auto momenta = steady_momenta(body, q, nu);
    EXPECT_TRUE(all_agree<Vector4<Real50>>(row.where(), Vector4<Real50>::Zero(),
                                           momentum_balance_residual(body, model, q, momenta),
                                           allowed * scale));
    const Vector3<Real50> pi = momenta.template head<3>();
    EXPECT_TRUE(all_agree<Vector3<Real50>>(row.where(), Vector3<Real50>::Zero(),
                                           compatibility_residual(body, q, nu),
                                           allowed * pi.norm() * nu.norm()));
  });
}

void expect_stationary_in_doubles(const ReferenceRow& row) {
  const auto check =
      check_balance(row.body(), row.potential(), row.stretch<double>(), row.nu<double>());
  EXPECT_LE(check.residual, 8 * 0x1p-53) << row.where();
  EXPECT_LE(check.compatibility, 8 * 0x1p-53) << row.where();
}

class EquilibriaTest : public ::testing::TestWithParam<const char*> {};

TEST_P(EquilibriaTest, BalanceIn50Digits) {
  const auto rows = reference_table(GetParam());
  ASSERT_FALSE(rows.empty());
  for (const auto& row : rows) expect_stationary_in_wide_numbers(row, Real50("1e-22"));
}

TEST_P(EquilibriaTest, BalanceInDoubles) {
  for (const auto& row : reference_table(GetParam())) expect_stationary_in_doubles(row);
}

INSTANTIATE_TEST_SUITE_P(Tables, EquilibriaTest,
                         ::testing::Values("equilibria.csv", "equilibria_extreme.csv",
                                           "tilted.csv"),
                         [](const auto& info) {
                           const std::string name = info.param;
                           return name.substr(0, name.find('.'));
                         });

TEST(ReferenceTable, EventsAreStationaryMotions) {
  for (const auto& row : reference_table("events.csv"))
    expect_stationary_in_wide_numbers(row, Real50("1e-18"));
}

TEST(ReferenceTable, CoversEveryPlanarModel) {
  std::set<std::string> models;
  std::set<std::string> branches;
  for (const auto& row : reference_table("equilibria.csv")) {
    models.insert(row.text("model"));
    branches.insert(row.text("branch"));
  }
  EXPECT_EQ(models.size(), std::variant_size_v<PlanarPotential>);
  EXPECT_EQ(branches, (std::set<std::string>{"i", "ii", "iii"}));
}

TEST(ReferenceTable, TwoPolarStates) {
  const auto rows = reference_table("two_polar.csv");
  ASSERT_FALSE(rows.empty());
  for (const auto& row : rows) {
    const double J = row.scaled_inertia("J");
    const Vector3<Real50> x{row.number<Real50>("lambda"), row.number<Real50>("mu"),
                            row.number<Real50>("rho")};
    const auto omega = row.input<Real50>("omega");
    const auto theta_dot = row.input<Real50>("theta_dot");
    row.with_scaled_model<Real50>([&](const auto& model) {
      const auto jacobian = two_polar_jacobian(J, model, x, omega, theta_dot);
      const Matrix3<Real50> terms = jacobian * x.asDiagonal();
      const Real50 allowed = Real50("1e-22") * terms.cwiseAbs().maxCoeff();
      EXPECT_TRUE(all_agree<Vector3<Real50>>(row.where(), Vector3<Real50>::Zero(),
                                             two_polar_residual(J, model, x, omega, theta_dot),
                                             allowed));
      EXPECT_TRUE(all_agree<Vector3<Real50>>(
          row.where(), Vector3<Real50>::Zero(),
          two_polar_momentum_residual(J, model, x, two_polar_momenta(J, x, omega, theta_dot)),
          allowed));
    });
  }
}

TEST(ReferenceTable, NotesWhatIsMissing) {
  const auto rows = reference_table("tilted.csv");
  EXPECT_THROW(rows.front().text("branch"), std::out_of_range);
  EXPECT_THROW(reference_table("nothing.csv"), std::runtime_error);
}

}  // namespace
}  // namespace stationary
