// A kind of motion that the library does not have, stated here by its equations alone: a spin about
// axis 1 with xi held at h (a rod between two plates). It gets its solve, its search, its
// certificate and its continuation with events, and all of them meet closed forms:
//
//   (2 mu + lambda) v + lambda ln h = J2 nu^2 zeta^2,  v = ln zeta    Hencky's plane
//   (b - J3 nu^2) rho^3 = a                                          reciprocal-quadratic thickness
#include "solver/kind/stated_kind.hpp"

#include <gtest/gtest.h>

#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;

struct HeldSpin {
  static constexpr int dimension = 2;
  Body body{1.0, 1.7, 0.6};
  double h = 0.9;
  double mu = 1.0, lambda = 2.0, a = 1.0, b = 30.0;

  template <class T, class Number>
  std::array<T, 2> balance(const std::array<T, 2>& x, const T& p, const Number& number) const {
    const Hencky<T> plane{number(mu), number(lambda)};
    const ReciprocalQuadratic<T> thickness{number(a), number(b)};
    const T square_nu = square(p);
    const auto in_plane =
        plane.log_balance(number(h), x[0], T(0.0), T(number(body.J2) * square_nu));
    return {in_plane.g_zeta, thickness.log_balance(x[1], T(number(body.J3) * square_nu)).g_rho};
  }
  template <class T>
  T spin_inertia(const std::array<T, 2>& x) const {
    return body.J2 * square(x[0]) + body.J3 * square(x[1]);
  }
  ReducedVector<2> unknowns(const Stretch& q) const { return {q.zeta, q.rho}; }
  Member member(const ReducedVector<2>& x, double p) const {
    Member out;
    out.body = body;
    out.q = {0.0, h, x[0], x[1]};
    out.angular_velocity = {p, 0.0, 0.0};
    return out;
  }
  Branch branch() const { return Branch::i; }

  /// nu^2 at a given zeta.
  double square_nu(double zeta) const {
    return ((2.0 * mu + lambda) * std::log(zeta) + lambda * std::log(h)) / (body.J2 * zeta * zeta);
  }
  double rho(double square_nu) const { return std::cbrt(a / (b - body.J3 * square_nu)); }
  double zeta_at_rest() const { return std::pow(h, -lambda / (2.0 * mu + lambda)); }
  double zeta_at_fold() const { return zeta_at_rest() * std::exp(0.5); }
  Stretch rest() const { return {0.0, h, zeta_at_rest(), rho(0.0)}; }
};

double relative(double x, double exact) { return std::abs(x / exact - 1.0); }

TEST(StatedKind, IsSolvedSearchedAndCertified) {
  const HeldSpin kind;
  for (const double zeta : {1.1, 1.3, 1.5, 2.5, 8.0}) {
    const double nu = std::sqrt(kind.square_nu(zeta));
    const SearchResult all = search_stated(kind, nu);
    ASSERT_EQ(all.status, SearchStatus::complete);
    ASSERT_EQ(all.solutions.size(), 2U) << "two on one sheet below its fold";
    int met = 0;
    for (const Equilibrium& each : all.solutions) {
      EXPECT_EQ(each.status, SolveStatus::solved);
      const Certificate proof = certify_stated(kind, nu, each);
      EXPECT_TRUE(proof.proven) << proof.reason;
      const double error = relative(each.q.rho, kind.rho(nu * nu));
      EXPECT_LE(error, proof.error_bound + 4e-16);
      if (relative(each.q.zeta, zeta) > 1e-6) continue;
      ++met;
      const Equilibrium one = solve_stated(kind, nu, {0.0, kind.h, 1.05 * zeta, 1.1 * each.q.rho});
      ASSERT_EQ(one.status, SolveStatus::solved) << one.message;
      // nu was rounded: near the fold zeta moves more than it.
      EXPECT_LE(relative(one.q.zeta, zeta), 2.0 * one.error_bound + 4e-16);
      EXPECT_LE(relative(one.q.zeta, each.q.zeta), one.error_bound + proof.error_bound);
      Equilibrium fake = one;
      fake.q.zeta *= 1.0 + 1e-9;
      EXPECT_FALSE(certify_stated(kind, nu, fake).proven);
    }
    EXPECT_EQ(met, 1);
  }
  const double beyond = 1.001 * std::sqrt(kind.square_nu(kind.zeta_at_fold()));
  const SearchResult none = search_stated(kind, beyond);
  EXPECT_EQ(none.status, SearchStatus::complete);
  EXPECT_TRUE(none.solutions.empty());
}

TEST(StatedKind, IsFollowedThroughItsTiltAndItsFoldToItsEnd) {
  HeldSpin kind;
  // The locked inertias of axes 1 and 3 are equal at rho = h sqrt(J1/J3), half way to the fold.
  const double fold = kind.square_nu(kind.zeta_at_fold());
  const double tilt = 0.5 * fold;
  kind.a = (kind.b - kind.body.J3 * tilt) * std::pow(kind.h * std::sqrt(1.0 / 0.6), 3);
  const Followed sheet = followed(AnyFamily(std::make_unique<StatedFamily<HeldSpin>>(kind)),
                                  kind.rest(), 0.0, range(0.0, 10.0));
  ASSERT_TRUE(sheet.report.failure.empty()) << sheet.report.failure;
  int tilts = 0;
  int folds = 0;
  for (const auto& [member, event] : sheet.rows) {
    const double exact = kind.square_nu(member.q.zeta);
    EXPECT_NEAR(member.nu * member.nu, exact, 1e-13);
    EXPECT_LE(relative(member.q.rho, kind.rho(member.nu * member.nu)), 4e-15);
    if (event == EventType::fold_nu) {
      ++folds;
      EXPECT_LE(relative(member.nu * member.nu, fold), 1e-15);
      EXPECT_LE(relative(member.q.zeta, kind.zeta_at_fold()), 1e-7);
    }
    if (event == EventType::tilt) {
      ++tilts;
      EXPECT_LE(relative(member.nu * member.nu, tilt), 1e-13);
    }
  }
  EXPECT_EQ(folds, 1) << sheet.text();
  EXPECT_EQ(tilts, 2);  // nu comes by the same value on its way back
  EXPECT_EQ(sheet.rows.back().event, EventType::escape) << "zeta grows without bound, nu to 0";
}

}  // namespace
}  // namespace stationary
