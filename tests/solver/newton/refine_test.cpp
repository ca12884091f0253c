// The last correction: rounds correctly from wherever Newton leaves it, knows when one step is not
// enough, and never calls an unfinished one converged.
#include "solver/newton/refine.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies/models.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/closed_forms.hpp"
#include "tests/support/numbers/high_precision.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

using namespace testing;

/// f(system, x) for the problem's reduced system; x gets q's entries.
template <class F>
void with_system(const Posed& posed, const Stretch& q, F&& f) {
  const auto rates = posed.problem.rates(two_product(posed.nu, posed.nu));
  posed.problem.potential().visit_parts([&](const auto& model) {
    if constexpr (requires { model.plane; }) {
      using Plane = std::decay_t<decltype(model.plane)>;
      f(PlanarSystem<Plane>{model.plane, rates}, ReducedVector<2>(q.xi, q.zeta));
    } else {
      f(CoupledSystem<std::decay_t<decltype(model)>>{model, rates},
        ReducedVector<3>(q.xi, q.zeta, q.rho));
    }
  });
}

TEST(Refine, RoundsCorrectlyFromPerturbedStarts) {
  support::Random random(31);
  int tried = 0;
  for (int k = 0; k < 300; ++k) {
    const Posed posed = random_problem(random, k % 2 == 0 ? 1.0 : 6.0);
    const Equilibrium solution = solve(posed.problem, posed.nu);
    if (solution.status != SolveStatus::solved || solution.error_bound > 1e-14) continue;
    const auto exact = reference_solution(posed.problem, posed.nu, solution.q);
    const double exact_x[3] = {exact[0].convert_to<double>(), exact[1].convert_to<double>(),
                               exact[2].convert_to<double>()};
    for (const double size : {1e-12, 1e-8, 1e-5, 1e-4}) {
      with_system(posed, solution.q, [&](const auto& system, auto x) {
        for (Eigen::Index i = 0; i < x.size(); ++i) x[i] *= 1.0 + size * random.uniform(-1.0, 1.0);
        const Refined refined = refine(system, x);
        ASSERT_TRUE(refined.converged) << posed.text << " from " << size;
        ++tried;
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          const auto wide = exact[static_cast<std::size_t>(i)];
          const double error = abs((x[i] - wide) / wide).template convert_to<double>();
          EXPECT_LE(error, 0x1p-53 + 0x1p-56) << posed.text << " from " << size;
          EXPECT_LE(error, refined.error_bound) << posed.text;
          EXPECT_NEAR(x[i], exact_x[i], 0x1p-52 * exact_x[i]) << posed.text;
        }
      });
    }
  }
  EXPECT_GE(tried, 600);
}

TEST(Refine, FirstCorrectionIsTheStartsError) {
  const PlanarSystem<Biot<>> system{{1.0, 0.5}, {0.3, 0.2, 0.0}};
  ReducedVector<2> solution(1.0, 1.0);
  ASSERT_TRUE(refine(system, solution).converged);
  for (const double size : {1e-3, 1e-5, 1e-7}) {
    ReducedVector<2> x(solution[0] * std::exp(size), solution[1]);
    const Refined refined = refine(system, x);
    EXPECT_NEAR(refined.first_correction, size, 10.0 * size * size);
    EXPECT_EQ(x, solution);
  }
}

TEST(Refine, OneStepFromAGoodStartTwoNearAFold) {
  const Hencky<> model{1.1, 0.8};
  const support::HenckyFold<double> fold(1.7, 1.1, 0.8);
  const auto steps_below = [&](double gap, double size, Refined* refined) {
    const double rate = 1.7 * fold.nu_squared * (1.0 - gap);
    const PlanarSystem<Hencky<>> system{model, {0.0, rate, 0.0}};
    ReducedVector<2> x(fold.xi * (1.0 + 0.1 * std::sqrt(gap)), fold.zeta * (1.0 - std::sqrt(gap)));
    EXPECT_TRUE(refine(system, x).converged) << gap;
    x[1] *= 1.0 + size;
    *refined = refine(system, x);
    EXPECT_TRUE(refined->converged) << gap;
    return refined->steps;
  };
  // The same error of the start, 2^-29: far below what one step leaves at a regular point.
  Refined far;
  Refined near;
  EXPECT_EQ(steps_below(0.3, 0x1p-31, &far), 1);
  EXPECT_GE(steps_below(1e-10, 0x1p-31, &near), 2);
  EXPECT_LT(far.error_bound, 1e-14);
  EXPECT_GT(near.error_bound, 1e-13);
}

TEST(Refine, SingularJacobianLeavesXAsItIs) {
  // Both Jacobians vanish there in exact arithmetic and in double; the residuals do not.
  const ThicknessSystem<Harmonic<>> axial{{1.0, 1.0}, 0.5};
  ReducedVector<1> rho(1.0);
  ASSERT_EQ(axial.linearize(rho).jacobian(0, 0), 0.0);
  ASSERT_NE(axial.linearize(rho).g[0], 0.0);
  EXPECT_FALSE(refine(axial, rho).converged);
  EXPECT_EQ(rho[0], 1.0);

  const PlanarSystem<Biot<>> planar{{1.0, 0.0}, {1.0, 0.0, 0.0}};
  ReducedVector<2> x(1.0, 1.0);
  const auto jacobian = planar.linearize(x).jacobian;
  ASSERT_EQ(jacobian(0, 0), 0.0);
  ASSERT_EQ(jacobian(0, 1), 0.0);
  ASSERT_NE(planar.linearize(x).g[0], 0.0);
  const Refined refined = refine(planar, x);
  EXPECT_FALSE(refined.converged);
  EXPECT_EQ(refined.steps, 0);
  EXPECT_TRUE(std::isnan(refined.error_bound));
  EXPECT_EQ(x, ReducedVector<2>(1.0, 1.0));
}

/// Far out on a polynomial of d: singular to rounding, and the columns of the inverse cancel in
/// what they make of the residual.
struct NearlySingular {
  static constexpr int dimension = 2;
  double diagonal = 1.6566827054078875e+21;
  double beside = 1.6566827054078873e+21;
  double residual = 4.1416700297242096e+20;

  ReducedVector<2> extended_residual(const ReducedVector<2>&) const { return {residual, residual}; }
  Linearized<2> linearize(const ReducedVector<2>& x) const {
    return {extended_residual(x), {{diagonal, beside, diagonal}}, diagonal};
  }
  ReducedVector<2> input_sensitivity(const ReducedVector<2>&) const { return {0.0, 0.0}; }
};

TEST(Refine, ACorrectionLostInTheInverseIsNoConvergence) {
  const NearlySingular system;
  ReducedVector<2> x(354.0, 357.0);
  ASSERT_EQ((system.linearize(x).jacobian.inverse() * system.extended_residual(x)).norm(), 0.0);
  EXPECT_FALSE(refine(system, x).converged);
  EXPECT_EQ(x, ReducedVector<2>(354.0, 357.0));
}

TEST(Refine, ResidualNotFiniteLeavesXAsItIs) {
  const PlanarSystem<NeoHookean<>> system{{1.0, 0.5}, {0.1, 0.1, 0.0}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const ReducedVector<2>& start : {ReducedVector<2>(nan, 1.0), ReducedVector<2>(1.0, nan),
                                        ReducedVector<2>(-1.0, 1.0), ReducedVector<2>(0.0, 1.0)}) {
    ReducedVector<2> x = start;
    const Refined refined = refine(system, x);
    EXPECT_FALSE(refined.converged);
    EXPECT_EQ(refined.steps, 0);
    EXPECT_TRUE(x[0] == start[0] || std::isnan(start[0]));
    EXPECT_TRUE(x[1] == start[1] || std::isnan(start[1]));
  }
}

TEST(Refine, FarStartIsRefusedNotIterated) {
  const PlanarSystem<NeoHookean<>> system{{1.0, 0.5}, {0.1, 0.1, 0.0}};
  ReducedVector<2> x(30.0, 0.02);
  const Refined refined = refine(system, x);
  EXPECT_FALSE(refined.converged);
}

TEST(Refine, StepLimitIsNoConvergence) {
  const PlanarSystem<NeoHookean<>> system{{1.0, 0.5}, {0.1, 0.2, 0.0}};
  ReducedVector<2> x(1.2, 0.9);
  const Refined stopped = refine(system, x, 1);
  EXPECT_FALSE(stopped.converged);
  EXPECT_EQ(stopped.steps, 1);
  EXPECT_TRUE(std::isnan(stopped.error_bound));
}

TEST(Refine, WithoutBoundTheSameAnswer) {
  support::Random random(32);
  for (int k = 0; k < 50; ++k) {
    const Posed posed = random_problem(random, 1.0);
    const Equilibrium solution = solve(posed.problem, posed.nu);
    if (solution.status != SolveStatus::solved) continue;
    with_system(posed, solution.q, [&](const auto& system, auto x) {
      x[0] *= 1.0 + 1e-7;
      auto y = x;
      const Refined with = refine<true>(system, x);
      const Refined without = refine<false>(system, y);
      EXPECT_EQ(x, y) << posed.text;
      EXPECT_EQ(with.steps, without.steps);
      EXPECT_EQ(with.converged, without.converged);
      EXPECT_TRUE(std::isnan(without.error_bound));
    });
  }
}

TEST(Moved, IsXTimesTheExponential) {
  support::Random random(33);
  for (int k = 0; k < 1000; ++k) {
    const double d = random.sign() * random.log_uniform(1e-18, 0.5);
    const ReducedVector<1> out = moved<1>(ReducedVector<1>(1.7), ReducedVector<1>(2.0 * d), 0.5);
    const double expected = (Number50(1.7) * exp(Number50(d))).convert_to<double>();
    // The series leaves d^3/6 below 2^-13: 2^-41, and 2^-53 from |d| < 2^-17 on.
    const double allowed = std::abs(d) < 0x1p-13 ? std::abs(d * d * d) : 0.0;
    EXPECT_NEAR(out[0], expected, (4 * 0x1p-53 + allowed) * expected) << d;
  }
}

TEST(WithCurvature, SolvesItsEquation) {
  support::Random random(34);
  for (int k = 0; k < 1000; ++k) {
    const double b = random.log_uniform(1e-16, 1e-2);
    const double kappa = random.log_uniform(1.0, 0.24 / b);
    const double e = with_curvature(b, kappa);
    EXPECT_NEAR(e, b + kappa * e * e, 1e-14 * e) << b << " " << kappa;
    EXPECT_GE(e, b);
  }
}

TEST(WithCurvature, Limits) {
  EXPECT_EQ(with_curvature(1e-16, 0.0), 1e-16);
  EXPECT_NEAR(with_curvature(1e-16, 1.0), 1e-16, 1e-30);
  // At and beyond the fold never less than the double root 1/(2 kappa), and growing with b.
  double last = 0.0;
  for (const double b : {0.2, 0.24, 0.2499999, 0.25, 0.2500001, 0.3, 1.0, 100.0}) {
    const double e = with_curvature(b, 1.0);
    EXPECT_GT(e, last) << b;
    last = e;
    if (b >= 0.25) {
      EXPECT_GE(e, 0.5);
    }
  }
  EXPECT_GT(with_curvature(1e-16, 1e17), 0.5e-17);
  EXPECT_TRUE(std::isnan(with_curvature(std::numeric_limits<double>::quiet_NaN(), 1.0)));
  EXPECT_TRUE(std::isnan(with_curvature(1.0, std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace stationary
