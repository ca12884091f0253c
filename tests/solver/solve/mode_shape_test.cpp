// Shapes of modes against the motion in space (tests/support/placement.hpp): the displacement of
// Phi satisfies its linearized equations, made by differences in 50 digits, which know nothing of
// leaves, momenta or pencils.
#include "solver/solve/mode_shape.hpp"

#include <gtest/gtest.h>

#include <Eigen/SVD>
#include <algorithm>
#include <complex>

#include "solver/solve/two_polar_equilibrium.hpp"
#include "tests/support/bodies/models.hpp"
#include "tests/support/bodies/motions.hpp"
#include "tests/support/numbers/wide_spectrum.hpp"
#include "tests/support/placement.hpp"

namespace stationary {
namespace {

using namespace testing;

using Complex = std::complex<double>;
using Wide = Eigen::Matrix<Number50, Eigen::Dynamic, Eigen::Dynamic>;

/// Of every mode that moves by itself; the second of a quadruple is the one that decays.
std::vector<Complex> exponents(const Spectrum& spectrum) {
  std::vector<Complex> out;
  for (const Mode& m : modes(spectrum)) {
    if (m.re == 0.0 && m.im == 0.0) continue;
    const Complex s(m.re, m.im);
    out.push_back(m.re > 0.0 && m.im > 0.0 && !out.empty() && out.back() == s ? -std::conj(s) : s);
  }
  return out;
}

/// |A x - s x| over |A| |x|, x = (X, s X) of the displacement of (Phi1, Phi2, rho).
double misfit(const Wide& A, const ModeShape& shape) {
  Wide re(14, 1);
  Wide im(14, 1);
  const auto& D = shape.displacement;
  const std::array<Complex, 7> X{D(0, 0), D(1, 0), D(2, 0), D(0, 1), D(1, 1), D(2, 1), D(2, 2)};
  for (Eigen::Index k = 0; k < 7; ++k) {
    const Complex x = X[static_cast<std::size_t>(k)];
    const Complex v = shape.s * x;
    re(k) = x.real();
    im(k) = x.imag();
    re(7 + k) = v.real();
    im(7 + k) = v.imag();
  }
  const Number50 a = shape.s.real();
  const Number50 b = shape.s.imag();
  const Wide off_re = A * re - a * re + b * im;
  const Wide off_im = A * im - b * re - a * im;
  const Number50 off = sqrt(Number50(off_re.squaredNorm() + off_im.squaredNorm()));
  const Number50 size = A.norm() * sqrt(Number50(re.squaredNorm() + im.squaredNorm()));
  return Number50(off / size).convert_to<double>();
}

Matrix3<double> matrix_of(const Stretch& q) {
  Matrix3<double> out;
  out << q.xi, q.alpha, 0.0, q.alpha, q.zeta, 0.0, 0.0, 0.0, q.rho;
  return out;
}

void expect_normalized(const ModeShape& shape, const Stretch& q) {
  const Matrix3<double> inverse = matrix_of(q).inverse();
  EXPECT_NEAR((shape.displacement.real() * inverse).norm(), 1.0, 1e-14);
  EXPECT_NEAR(
      (shape.displacement.real() * inverse).cwiseProduct(shape.displacement.imag() * inverse).sum(),
      0.0, 1e-14);
  EXPECT_LE((shape.displacement.imag() * inverse).norm(), 1.0 + 1e-14);
}

TEST(ModeShape, SatisfiesTheLinearizedMotionInSpace) {
  support::Random random(911);
  int growing = 0;
  for (std::size_t k = 0; k < potential_names().size(); ++k) {
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      for (const bool symmetric : {false, true}) {
        const SolvedMotion motion = random_motion(random, potential_names()[k], branch, symmetric);
        const auto wide = wide_motion(motion).state;
        const Body& body = motion.problem.body();
        const Potential& V = motion.problem.potential();
        // At J1 = J2 also from axes in the material that are turned, where alpha is not 0.
        for (const double theta : symmetric ? std::vector{0.0, 0.7} : std::vector{0.0}) {
          const Number50 c = cos(Number50(theta));
          const Number50 s = sin(Number50(theta));
          const BasicStretch<Number50> q{(wide.xi - wide.zeta) * s * c,
                                         wide.xi * c * c + wide.zeta * s * s,
                                         wide.xi * s * s + wide.zeta * c * c, wide.rho};
          const auto n = angular_velocity(motion.problem.branch(), Number50(motion.nu()));
          const Vector3<Number50> nu(n[0] * c - n[1] * s, n[0] * s + n[1] * c, n[2]);
          const auto number = [](const Number50& x) { return x.convert_to<double>(); };
          const Stretch rounded{number(q.alpha), number(q.xi), number(q.zeta), number(q.rho)};
          Wide A;
          V.visit_parts([&](const auto& model) {
            A = placement_matrix(body, support::widen<Number50>(model), q, nu);
          });
          const std::vector<Complex> exponent = exponents(motion.blocks());
          const auto shapes =
              mode_shapes(body, V, rounded,
                          Vector3<double>(number(nu[0]), number(nu[1]), number(nu[2])), exponent);
          ASSERT_EQ(shapes.size(), exponent.size());
          for (const ModeShape& shape : shapes) {
            EXPECT_LE(misfit(A, shape), 1e-12)
                << motion.text << "theta " << theta << " s " << shape.s;
            EXPECT_LE(shape.residual, 1e-12)
                << motion.text << "theta " << theta << " s " << shape.s;
            expect_normalized(shape, rounded);
            growing += shape.s.real() > 0.0;
          }
        }
      }
    }
  }
  EXPECT_GE(growing, 5);
}

TEST(ModeShape, OfATwoPolarMotion) {
  const double plane[] = {0.9, 2.1};
  const double thickness[] = {1.1, 1.5};
  const Potential V(Potential::planar("saint-venant-kirchhoff", plane),
                    Potential::thickness("reciprocal-quadratic", thickness));
  const Body round(0.8, 0.8, 2.3);
  for (const TwoPolarRates<double> rates :
       {TwoPolarRates<double>{1.2, -0.35}, {-0.35, 1.2}, {-1.2, 0.35}}) {
    const Equilibrium at = solve_two_polar(round, V, rates);
    ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
    ASSERT_FALSE(at.circle) << rates.omega << " " << rates.theta_dot;
    const BasicStretch<Number50> q{0, at.q.xi, at.q.zeta, at.q.rho};
    Wide A;
    V.visit_parts([&](const auto& model) {
      A = placement_matrix(round, support::widen<Number50>(model), q,
                           Vector3<Number50>(0, 0, Number50(at.two_polar->rates.omega)),
                           Number50(at.two_polar->rates.theta_dot));
    });
    const auto shapes = mode_shapes(round, V, at.q, at.two_polar->rates,
                                    exponents(two_polar_stability(round, V, at)));
    EXPECT_EQ(shapes.size(), 4U);
    for (const ModeShape& shape : shapes) {
      EXPECT_LE(misfit(A, shape), 1e-12) << rates.omega << " " << rates.theta_dot << " " << shape.s;
      EXPECT_LE(shape.residual, 1e-12) << shape.s;
      expect_normalized(shape, at.q);
    }
  }
}

TEST(ModeShape, EqualModesHaveShapesOfTheirOwn) {
  // At rest, J1 = J2: shear along the axes and across them have one frequency.
  const double plane[] = {1.0, 2.0};
  const double thickness[] = {1.0, 3.0};
  const Potential V(Potential::planar("hencky", plane),
                    Potential::thickness("reciprocal-quadratic", thickness));
  const Problem problem(Body(1.0, 1.0, 1.5), V, Branch::iii);
  const Equilibrium at = solve(problem, 0.0);
  ASSERT_EQ(at.status, SolveStatus::solved);
  const std::vector<Complex> exponent = exponents(stability(problem, at));
  ASSERT_EQ(exponent.size(), 4U);
  const auto shapes = mode_shapes(problem.body(), V, at.q, Vector3<double>::Zero(), exponent);
  Eigen::Matrix<Complex, 9, 4> all;
  for (Eigen::Index k = 0; k < 4; ++k)
    all.col(k) = shapes[static_cast<std::size_t>(k)].displacement.reshaped();
  const Eigen::JacobiSVD<Eigen::Matrix<Complex, 9, 4>> svd(all);
  EXPECT_GT(svd.singularValues()[3], 0.3);
  EXPECT_TRUE(std::abs(exponent[0] - exponent[1]) < 1e-12 ||
              std::abs(exponent[1] - exponent[2]) < 1e-12 ||
              std::abs(exponent[2] - exponent[3]) < 1e-12);
}

TEST(ModeShape, OfAHeldVolumeKeepsIt) {
  const double plane[] = {1.0, 2.0};
  for (const auto& [body, branch, nu] : {std::tuple(Body(1.0, 1.3, 0.7), Branch::i, 0.6),
                                         std::tuple(Body(1.0, 1.3, 0.7), Branch::iii, 0.5),
                                         std::tuple(Body(1.0, 1.0, 0.7), Branch::iii, 0.0)}) {
    BodyModel<> model;
    model.elastic.plane = AnyPlane<>{Potential::planar("hencky", plane)};
    model.volume = 1.1;
    model.J = {body.J1, body.J2, body.J3};
    const Potential V(model);
    const Problem problem(body, V, branch);
    const Equilibrium at = solve(problem, nu);
    ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
    const auto exponent = exponents(stability(problem, at));
    const auto shapes = mode_shapes(body, V, at.q, at.nu, exponent);
    EXPECT_EQ(shapes.size(), nu == 0.0 ? 3U : 4U);
    const Matrix3<double> inverse = matrix_of(at.q).inverse();
    for (const ModeShape& shape : shapes) {
      EXPECT_LE(shape.residual, 1e-13);
      EXPECT_LE(std::abs((shape.displacement * inverse.cast<Complex>()).trace()), 1e-13);
      EXPECT_GT((shape.displacement.real() * inverse).norm(), 0.9);
    }
  }
}

TEST(ModeShape, WhatIsNoEigenvalueIsToldByItsResidual) {
  const SolvedMotion at =
      motion(Body(1.0, 1.7, 0.6), {"reciprocal-determinant", "reciprocal-quadratic"}, {1.0, 2.0},
             {1.0, 3.0}, Branch::i, 0.5);
  std::vector<Complex> exponent = exponents(at.blocks());
  for (Complex& s : exponent) s *= 1.01;
  for (const ModeShape& shape :
       mode_shapes(at.problem.body(), at.problem.potential(), at.at.q, at.at.nu, exponent))
    EXPECT_GT(shape.residual, 1e-6) << shape.s;
}

}  // namespace
}  // namespace stationary
