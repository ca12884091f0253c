// Where the axis of a spin can tilt: at the event's nu the reduced energy, least in all but the angle s
// to the spin's own axis, is a s^4/24 + O(s^6) above that of the spin. a is the coefficient.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <utility>

#include "lib/balance/balance.hpp"
#include "solver/kind/kind.hpp"
#include "solver/normal_form/normal_form.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"

namespace stationary::testing {
namespace {

/// V - nu.I nu/2 where it is stationary in q at this nu; q: near that, and there afterwards.
double stationary_energy(const Kind& kind, const Vector3<double>& nu, Stretch& q) {
  const Matrix4<double> C = centrifugal_matrix(kind.body(), nu);
  for (int step = 0; step < 50; ++step) {
    const auto V = kind.potential().derivatives(q);
    const Vector4<double> g = V.gradient - C * q.vector();
    const Vector4<double> by = (V.hessian - C).fullPivLu().solve(g);
    q = {q.alpha - by[0], q.xi - by[1], q.zeta - by[2], q.rho - by[3]};
    if (by.norm() < 1e-14) break;
  }
  return kind.potential().value(q) - 0.5 * q.vector().dot(C * q.vector());
}

/// At a located tilt, from the axis n towards v; n may turn in the plane of axes 1 and 2 where it is
/// no material one.
class Tilting {
 public:
  Tilting(const Kind& kind, const Member& at, const Vector3<double>& v)
      : kind_(kind), at_(at), n_(at.angular_velocity.normalized()), v_(v) {}

  /// NaN where the two of the fourth order do not agree: the series has no use at these angles.
  double coefficient() const {
    // Without what is of the orders s^2 and s^4.
    const double wide = over_fourth(0.04);
    const double middle = over_fourth(0.02);
    const double narrow = over_fourth(0.01);
    const double first = (4.0 * middle - wide) / 3.0;
    const double second = (4.0 * narrow - middle) / 3.0;
    if (std::abs(second - first) > 0.01 * std::abs(second)) return std::nan("");
    return (16.0 * second - first) / 15.0;
  }

 private:
  Vector3<double> axis(double s, double turn) const {
    Vector3<double> n = n_;
    if (v_[2] == 1.0)
      n = {std::cos(turn) * n_[0] - std::sin(turn) * n_[1],
           std::cos(turn) * n_[1] + std::sin(turn) * n_[0], 0.0};
    return std::abs(at_.nu) * (std::cos(s) * n + std::sin(s) * v_);
  }
  double energy(double s, double turn) const {
    Stretch q = at_.q;
    return stationary_energy(kind_, axis(s, turn), q);
  }
  /// The energy's derivative by `turn`.
  double slope(double s, double turn) const {
    Stretch q = at_.q;
    const Vector3<double> nu = axis(s, turn);
    stationary_energy(kind_, nu, q);
    const Vector3<double> turned(-nu[1], nu[0], 0.0);
    return -turned.dot(locked_inertia(kind_.body(), q) * nu);
  }
  double least(double s) const {
    if (v_[2] != 1.0) return energy(s, 0.0);
    double turn = 0.0;
    double last = 1e-3;
    double before = slope(s, last);
    for (int step = 0; step < 20 && turn != last; ++step) {  // its zero, by the secant
      const double here = slope(s, turn);
      if (here == before) break;
      const double next = turn - here * (turn - last) / (here - before);
      last = std::exchange(turn, next);
      before = here;
    }
    return energy(s, turn);
  }
  double over_fourth(double s) const { return 24.0 * (least(s) - least(0.0)) / std::pow(s, 4); }

  const Kind& kind_;
  const Member& at_;
  Vector3<double> n_;
  Vector3<double> v_;
};

/// The tilts of a followed family that were compared.
int compare_tilts(const Kind& kind, const Followed& sheet) {
  int compared = 0;
  for (std::size_t k = 1; k + 1 < sheet.rows.size(); ++k) {
    const Member& at = sheet.rows[k].member;
    if (sheet.rows[k].event != EventType::tilt) continue;
    const auto form = kind.normal_form({}, EventType::tilt, at);
    if (!form) continue;
    const Vector3<double> n = at.angular_velocity.normalized();
    const auto to = [&](const Member& row) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(locked_inertia(row.body, row.q));
      Vector3<double> v(0.0, 0.0, 1.0);
      if (std::abs(n[2]) == 1.0) {  // the one in the plane whose inertia is nearest
        double least = 1e300;
        for (int j = 0; j < 3; ++j) {
          const double away =
              std::abs(eigen.eigenvalues()[j] - n.dot(locked_inertia(row.body, row.q) * n));
          if (std::abs(eigen.eigenvectors()(2, j)) < 0.5 && away < least) {
            least = away;
            v = eigen.eigenvectors().col(j);
          }
        }
      }
      return v;
    };
    const double expected = Tilting(kind, at, to(at)).coefficient();
    if (!std::isfinite(expected)) continue;
    EXPECT_NEAR(form->coefficient, expected, 1e-3 * std::abs(expected) + 1e-5) << at.nu;
    EXPECT_LE(form->error, 1e-6 * std::abs(expected)) << at.nu;
    // F_ss = |nu|^2 (n.I n - v.I v) along the sheet, which passes the event at a rate.
    const auto stiffness = [&](std::size_t row) {
      const Member& near = sheet.rows[row].member;
      const Matrix3<double> I = locked_inertia(near.body, near.q);
      const Vector3<double> v = to(near);
      const Vector3<double> own = near.angular_velocity.normalized();
      return own.dot(I * own) - v.dot(I * v);
    };
    const double rate = (stiffness(k + 1) - stiffness(k - 1)) *
                        (sheet.rows[k + 1].member.nu - sheet.rows[k - 1].member.nu);
    EXPECT_EQ(form->side == EventSide::after, (form->coefficient > 0.0) != (rate > 0.0)) << at.nu;
    ++compared;
  }
  return compared;
}

TEST(TurningLaw, OfSpinsOfIsotropicBodies) {
  support::Random random(31);
  int compared = 0;
  for (int k = 0; k < 60; ++k) {
    const Posed posed = random_problem(random, 1.0);
    const auto kind = kind_of(posed.problem.body(), posed.problem.potential(),
                              AxisRotation{posed.problem.branch(), 0.0});
    const Equilibrium rest = kind->solve({});
    if (rest.status != SolveStatus::solved) continue;
    SCOPED_TRACE(posed.text);
    compared += compare_tilts(*kind, followed(kind->family({}, {.spectrum = false}, rest.q), rest.q,
                                              0.0, range(0.0, 2.0 * std::abs(posed.nu))));
  }
  RecordProperty("compared", compared);
  EXPECT_GE(compared, 10);
}

TEST(TurningLaw, OfSpinsAndObliqueAxesOfFibredBodies) {
  support::Random random(32);
  int spins = 0;
  int oblique = 0;
  for (int k = 0; k < 80; ++k) {
    const OrientedBody at = random_oriented_body(random, k);
    SCOPED_TRACE(at.text);
    for (const Branch branch : {Branch::i, Branch::iii}) {
      if (branch == Branch::i && !at.V.even_in_alpha()) continue;
      const auto kind = kind_of(at.body, at.potential(), AxisRotation{branch, 0.0});
      const Equilibrium rest = kind->solve(without_search());
      if (rest.status != SolveStatus::solved) continue;
      spins += compare_tilts(*kind, followed(kind->family({}, {.spectrum = false}, rest.q), rest.q,
                                             0.0, range(0.0, 1.0)));
    }
    const auto kind = kind_of(at.body, at.potential(), ObliqueRotation{at.nu, Branch::i});
    const Equilibrium start = kind->solve(without_search());
    if (start.status != SolveStatus::solved) continue;
    oblique += compare_tilts(*kind, followed(kind->family({}, {.spectrum = false}, start.q),
                                             start.q, at.nu, range(0.0, 1.0)));
  }
  RecordProperty("spins", spins);
  RecordProperty("oblique", oblique);
  EXPECT_GE(spins, 10);
  EXPECT_GE(oblique, 3);
}

/// The end of a family is the event of the sheet that it leaves.
TEST(TurningLaw, EndsOfTiltedFamiliesHaveTheFormOfTheSpin) {
  support::Random random(77);
  int compared = 0;
  for (int k = 0; k < 100; ++k) {
    const Posed posed = random_problem(random, 1.0);
    const Body& body = posed.problem.body();
    const Potential& potential = posed.problem.potential();
    for (const TiltPlane plane : {TiltPlane::one_three, TiltPlane::two_three}) {
      const double nu = std::abs(posed.nu);
      const auto kind = kind_of(body, potential, TiltedMotion{plane, nu});
      const Equilibrium start = kind->solve({});
      if (start.status != SolveStatus::solved) continue;
      const Followed sheet = followed(kind->family({}, {.spectrum = false}, start.q), start.q, nu,
                                      range(0.0, 4.0 * nu, 1e-5));
      for (const bool last : {false, true}) {
        const FollowedRow& end = last ? sheet.rows.back() : sheet.rows.front();
        if (end.event != EventType::tilt) continue;
        const auto form = kind->normal_form({}, EventType::tilt, end.member);
        if (!form) continue;
        // The family itself lies on the side that is told of.
        const Member& inside =
            last ? sheet.rows[sheet.rows.size() - 2].member : sheet.rows[1].member;
        EXPECT_EQ(form->side, inside.nu > end.member.nu ? EventSide::after : EventSide::before)
            << posed.text << " " << end.member.nu;
        ++compared;
      }
    }
  }
  RecordProperty("compared", compared);
  EXPECT_GE(compared, 10);
}

/// hencky: where ellipses leave the circle at given rates, J (omega^2 + theta'^2) e^2u = mu and
/// F_vvvv = -16 mu, F_vvu = -8 mu, F_uu = 4 (mu + lambda) (1 - 2 u), u = ln xi along (1, 1).
TEST(TurningLaw, OfEllipsesAtGivenRates) {
  const double mu = 1.0;
  const double lambda = 3.0;
  const Body round(1.25, 1.25, 0.6);
  const double theta_dot = -0.2;
  const FamilyParameter omega{FamilyParameter::Kind::nu, 0};
  const auto kind = kind_of(round, make_potential("hencky", {mu, lambda}),
                            TwoPolarMotion(TwoPolarRates<double>{0.5, theta_dot}));
  const Equilibrium start = kind->solve({});
  ASSERT_EQ(start.status, SolveStatus::solved);
  const Followed circle = followed(kind->family(omega, {}, start.q), start.q, 0.5, range(0.3, 1.1));
  const auto events = circle.events({EventType::ellipse});
  ASSERT_EQ(events.size(), 1U) << circle.text();
  const Member& at = events[0].member;
  const auto form = kind->normal_form(omega, EventType::ellipse, at);
  ASSERT_TRUE(form);
  const double u = std::log(at.q.xi);
  const double expected = -16.0 * mu - 48.0 * mu * mu / ((mu + lambda) * (1.0 - 2.0 * u));
  EXPECT_NEAR(form->coefficient, expected, form->error + 1e-13 * std::abs(expected));
  EXPECT_LE(form->error, 1e-9 * std::abs(expected));
}

}  // namespace
}  // namespace stationary::testing
