// The formulas of the shipped cases: what their authors wrote down by hand, in 50 digits; each
// derivative as a slope there; doubles and extended numbers against it, and the solved motion.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <ostream>
#include <string>

#include "lib/balance/balance.hpp"
#include "lib/material/models/coefficients.hpp"
#include "lib/material/potential.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/solve/solve.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/slope.hpp"

namespace stationary {
namespace {

using namespace support;

using Stretch50 = BasicStretch<Real50>;

/// What the case file says, once more.
struct Plane50 {
  Real50 t, d, I1, lambda, mu_;

  explicit Plane50(const Stretch50& q)
      : t(q.xi + q.zeta),
        d(q.xi * q.zeta - q.alpha * q.alpha),
        I1(q.xi * q.xi + q.zeta * q.zeta + 2 * q.alpha * q.alpha),
        lambda((t + sqrt(Real50(t * t - 4 * d))) / 2),
        mu_(d / lambda) {}
};

Real50 squared(const Real50& x) { return x * x; }

Real50 harmonic(const Real50& rho) { return Real50(3.0) / 2 * squared(rho - 1); }

Real50 ogden(const Stretch50& q) {
  const Plane50 s(q);
  const Real50 m1(0.8), a1(1.3), m2(0.05), a2(5.0), k(1.5);
  return m1 / a1 * (pow(s.lambda, a1) + pow(s.mu_, a1) - 2) +
         m2 / a2 * (pow(s.lambda, a2) + pow(s.mu_, a2) - 2) - (m1 + m2) * log(s.d) +
         k / 2 * squared(log(s.d)) + harmonic(q.rho);
}
Real50 mooney_rivlin(const Stretch50& q) {
  const Plane50 s(q);
  const Real50 c1(0.5), c2(0.1), k(2.0);
  const Real50 l = log(Real50(s.d * q.rho));
  return c1 * (s.I1 + q.rho * q.rho - 3) + c2 * (s.d * s.d + q.rho * q.rho * s.I1 - 3) -
         2 * (c1 + 2 * c2) * l + k / 2 * l * l;
}
Real50 double_well(const Stretch50& q) {
  const Plane50 s(q);
  return (s.I1 - 2 * s.d) / 2 + 2 * squared(s.d - 1) * squared(s.d - 2) + harmonic(q.rho);
}
/// Of its plane only the built-in model.
Real50 two_wells(const Stretch50& q) {
  const Real50 e11 = (q.xi * q.xi + q.alpha * q.alpha - 1) / 2;
  const Real50 e22 = (q.zeta * q.zeta + q.alpha * q.alpha - 1) / 2;
  const Real50 e12 = q.alpha * (q.xi + q.zeta) / 2;
  return e11 * e11 + e22 * e22 + 2 * e12 * e12 + squared(e11 + e22) / 2 +
         4 * squared(Real50((q.rho - Real50(0.8)) * (q.rho - Real50(1.4))));
}

struct Shipped {
  const char* name;
  Real50 (*value)(const Stretch50&);
};

void PrintTo(const Shipped& shipped, std::ostream* out) { *out << shipped.name; }

Case case_of(const Shipped& shipped) {
  return read_case(std::string(STATIONARY_CASES "/") + shipped.name + ".toml");
}

/// Value, gradient and Hessian with coefficients and states in S.
template <class S>
PotentialDerivatives<S> derivatives_in(const Potential& potential, const BasicStretch<S>& q) {
  const auto wide = [](double c) { return S(c); };
  return potential.visit_parts([&](const auto& model) -> PotentialDerivatives<S> {
    if constexpr (requires { model.plane; }) {
      const auto plane = with_coefficients(model.plane, wide);
      const auto thickness = with_coefficients(model.thickness, wide);
      const Separable<std::decay_t<decltype(plane)>, std::decay_t<decltype(thickness)>> both{
          plane, thickness};
      return potential_derivatives<2>(both, q);
    } else {
      return potential_derivatives<2>(with_coefficients(model, wide), q);
    }
  });
}

template <class S>
BasicStretch<S> stretch_in(const Stretch& q) {
  return {S(q.alpha), S(q.xi), S(q.zeta), S(q.rho)};
}

class CaseExpression : public ::testing::TestWithParam<Shipped> {};

TEST_P(CaseExpression, DerivativesAreSlopesAndEveryNumberTypeAgrees) {
  const Potential V = case_of(GetParam()).potential;
  Random random(2718);
  for (int trial = 0; trial < 60; ++trial) {
    Stretch q{0.0, random.uniform(0.5, 2.0), random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)};
    if (trial % 4 != 0) q.alpha = random.uniform(-0.4, 0.4) * std::sqrt(q.xi * q.zeta);
    const Stretch50 wide = stretch_in<Real50>(q);
    const auto expected = derivatives_in(V, wide);
    const std::string place = at(q);
    ASSERT_TRUE(agrees(place, GetParam().value(wide), expected.value, Real50("1e-46")));
    Vector4<Real50> w;
    for (int i = 0; i < 4; ++i) w[i] = random.uniform(-1.0, 1.0);
    const auto along = [&](const Real50& h) {
      return Stretch50::from(Vector4<Real50>(wide.vector() + h * w));
    };
    ASSERT_TRUE(is_slope(
        place, [&](const Real50& h) { return GetParam().value(along(h)); },
        Real50(expected.gradient.dot(w))));
    ASSERT_TRUE(is_slope(
        place, [&](const Real50& h) { return derivatives_in(V, along(h)).gradient; },
        Vector4<Real50>(expected.hessian * w)));
    const auto plain = V.derivatives(q);
    const auto extended = derivatives_in(V, stretch_in<DoubleDouble>(q));
    for (int i = 0; i < 4; ++i) {
      EXPECT_TRUE(agrees(place, nearest(expected.gradient[i]), plain.gradient[i], 1e-13));
      EXPECT_TRUE(agrees(place, expected.gradient[i], exact<Real50>(extended.gradient[i]),
                         Real50("1e-27")));
      for (int j = 0; j < 4; ++j) {
        EXPECT_TRUE(agrees(place, nearest(expected.hessian(i, j)), plain.hessian(i, j), 1e-12));
        EXPECT_TRUE(agrees(place, expected.hessian(i, j), exact<Real50>(extended.hessian(i, j)),
                           Real50("1e-26")));
      }
    }
  }
}

/// The case's own motion, and its error bound, against Newton in 50 digits.
TEST_P(CaseExpression, TheMotionIsThatOfFiftyDigits) {
  const Case input = case_of(GetParam());
  const Problem problem = input.problem();
  const double nu = std::get<AxisRotation>(input.motion).nu;
  const Equilibrium found = solve(problem, nu);
  ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
  const Vector3<Real50> spin = angular_velocity(problem.branch(), Real50(nu));
  const Matrix4<Real50> C = centrifugal_matrix(input.body, spin);
  Vector4<Real50> q = stretch_in<Real50>(found.q).vector();
  for (int step = 0; step < 6; ++step) {
    const auto V = derivatives_in(input.potential, Stretch50::from(q));
    const Matrix4<Real50> slope = V.hessian - C;
    q -= slope.inverse() * (V.gradient - C * q);
  }
  EXPECT_LE(found.error_bound, 1e-14);
  EXPECT_EQ(q[0], 0);
  const double solved[3] = {found.q.xi, found.q.zeta, found.q.rho};
  for (int k = 0; k < 3; ++k) {
    const Real50 expected = q[k + 1];
    const double error = std::abs(nearest(Real50((Real50(solved[k]) - expected) / expected)));
    EXPECT_LE(error, found.error_bound);
    EXPECT_EQ(solved[k], nearest(expected));
  }
}

INSTANTIATE_TEST_SUITE_P(All, CaseExpression,
                         ::testing::Values(Shipped{"ogden", ogden},
                                           Shipped{"mooney_rivlin", mooney_rivlin},
                                           Shipped{"double_well", double_well},
                                           Shipped{"two_wells", two_wells}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace stationary
