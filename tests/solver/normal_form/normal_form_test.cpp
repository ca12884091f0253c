// Normal forms against closed forms, one of which changes its sign, and against the side at which
// continuation finds the motions.
#include "solver/normal_form/normal_form.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>
#include <numbers>

#include "solver/proof/certify.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/followed.hpp"

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

/// I of a spin about the branch's axis.
double own_inertia(const Body& body, Branch branch, const Stretch& q) {
  const Vector3<double> m = second_moments(body, q);
  return m.sum() - m[axis(branch)];
}

/// V + |pi|^2/(2 I) in x = ln (xi, zeta, rho), about q.
class AtMomentum {
 public:
  AtMomentum(const Problem& problem, const Member& at)
      : problem_(problem),
        q_(at.q),
        momentum_(std::abs(at.nu) * own_inertia(problem.body(), problem.branch(), at.q)) {}

  struct Slopes {
    Eigen::Vector3d gradient;
    Eigen::Matrix3d hessian;
    Eigen::Vector3d inertia;  ///< dI/dx
  };
  Slopes at(const Eigen::Vector3d& x) const {
    const Stretch q{0.0, q_.xi * std::exp(x[0]), q_.zeta * std::exp(x[1]), q_.rho * std::exp(x[2])};
    const auto V = problem_.potential().derivatives(q);
    const Eigen::Vector3d stretch(q.xi, q.zeta, q.rho);
    Eigen::Vector3d moment = second_moments(problem_.body(), q);
    moment[axis(problem_.branch())] = 0.0;
    const double I = moment.sum();
    const double nu2 = std::pow(momentum_ / I, 2);
    Slopes out;
    out.inertia = 2.0 * moment;
    out.gradient = stretch.cwiseProduct(V.gradient.tail<3>()) - nu2 * moment;
    out.hessian = stretch.asDiagonal() * V.hessian.bottomRightCorner<3, 3>() * stretch.asDiagonal();
    out.hessian += 4.0 * nu2 / I * moment * moment.transpose();
    out.hessian.diagonal() += stretch.cwiseProduct(V.gradient.tail<3>()) - 2.0 * nu2 * moment;
    return out;
  }
  /// Of unit directions that keep circles, or of all; |pi| pulls to where I is larger.
  Eigen::Vector3d null_direction(const Eigen::MatrixXd& basis) const {
    const Slopes here = at(Eigen::Vector3d::Zero());
    const Eigen::MatrixXd K = basis.transpose() * here.hessian * basis;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K);
    Eigen::Index least = 0;
    eigen.eigenvalues().cwiseAbs().minCoeff(&least);
    const Eigen::Vector3d v = basis * eigen.eigenvectors().col(least);
    return v.dot(here.inertia) < 0.0 ? Eigen::Vector3d(-v) : v;
  }
  double third_derivative(const Eigen::Vector3d& v) const {
    const auto by = [&](double h) {
      return v.dot((at(h * v).hessian - at(-h * v).hessian) * v) / (2.0 * h);
    };
    return (4.0 * by(0.001) - by(0.002)) / 3.0;
  }

 private:
  const Problem& problem_;
  Stretch q_;
  double momentum_;
};

/// Against differences of the Hessian at fixed momentum, and |pi| of the rows beside.
TEST(NormalForm, OfFoldsOfTheMomentum) {
  const double side = std::sqrt(0.5);
  const Eigen::MatrixXd circles{{side, 0.0}, {side, 0.0}, {0.0, 1.0}};
  int compared = 0;
  support::Random random(21);
  for (int k = 0; k < 300; ++k) {
    const Posed made = random_problem(random, 1.0);
    const SolveOptions how;
    const double nu = 0.3 * std::abs(made.nu);
    if (solve(made.problem, nu, how).status != SolveStatus::solved) continue;
    const Followed sheet = followed(made.problem, nu, range(0.0, 6.0, 1e-6), false, how);
    for (std::size_t row = 1; row + 1 < sheet.rows.size(); ++row) {
      if (sheet.rows[row].event != EventType::fold_momentum) continue;
      const Member& at = sheet.rows[row].member;
      const bool circle = mirror_symmetric(made.problem, at.nu) && at.q.xi == at.q.zeta;
      const auto form = normal_form(made.problem, {}, circle ? Circle::xi_zeta : Circle::none,
                                    EventType::fold_momentum, at);
      ASSERT_TRUE(form) << k;
      const AtMomentum F(made.problem, at);
      const double expected =
          F.third_derivative(F.null_direction(circle ? circles : Eigen::Matrix3d::Identity()));
      EXPECT_NEAR(form->coefficient, expected, 1e-7 * (1.0 + std::abs(expected))) << k;
      EXPECT_LE(form->error, 1e-6 * (1.0 + std::abs(expected))) << k;
      const auto momentum = [&](std::size_t of) {
        const Member& member = sheet.rows[of].member;
        return std::abs(member.nu) *
               own_inertia(made.problem.body(), made.problem.branch(), member.q);
      };
      const double before = momentum(row - 1) - momentum(row);
      const double after = momentum(row + 1) - momentum(row);
      ASSERT_GT(before * after, 0.0) << k;
      EXPECT_EQ(form->side, after > 0.0 ? EventSide::after : EventSide::before) << k;
      ++compared;
    }
  }
  EXPECT_GE(compared, 10);
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
