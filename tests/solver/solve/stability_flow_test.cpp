// Spectra against motion in time, reduced and in space (tests/support/flows.hpp): what the flow
// conserves, and how it carries small disturbances.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <complex>

#include "tests/support/bodies/motions.hpp"
#include "tests/support/flows.hpp"

namespace stationary {
namespace {

using namespace testing;

using Complex = std::complex<double>;

const PotentialName reciprocal{"reciprocal-determinant", "reciprocal-quadratic"};

Vector11<double> point(const SolvedMotion& motion) {
  return steady_point(motion.problem.body(), motion.at.q, motion.at.nu);
}

/// A motion nearby that is not steady.
Vector11<double> disturbed(const SolvedMotion& motion, support::Random& random, double size) {
  return point(motion) + size * random.direction<11>();
}

template <class F>
void over_motions(std::uint64_t seed, bool symmetric, const F& f) {
  support::Random random(seed);
  for (const PotentialName& potential : potential_names()) {
    for (const Branch branch : branches) {
      const SolvedMotion motion = random_motion(random, potential, branch, symmetric);
      f(motion, flows(motion.problem.body(), motion.problem.potential()), random);
    }
  }
}

TEST(Flow, SteadyMotionsStandStill) {
  over_motions(701, false, [](const SolvedMotion& motion, const Flows& flow, support::Random&) {
    const Body& body = motion.problem.body();
    const Vector11<double> z = point(motion);
    const Spectrum spectrum = motion.blocks();
    constexpr double time = 3.0;
    const double allowed = 1e-11 * std::exp(spectrum.growth * time) * (1.0 + z.norm());
    EXPECT_LE((integrated<11>(flow.reduced, z, time) - z).norm(), allowed) << motion.text;
    // In space: the same S, turned by -nu t.
    const Vector14d x = integrated<14>(flow.in_space, placed_state(body, z), time);
    const Polar at = polar(x);
    EXPECT_LE((at.q.vector() - motion.at.q.vector()).norm(), allowed) << motion.text;
    const double angle = -motion.nu() * time;
    Vector3<double> axis_vector = Vector3<double>::Zero();
    axis_vector[axis(motion.problem.branch())] = 1.0;
    const Matrix3<double> turned = Eigen::AngleAxisd(angle, axis_vector).toRotationMatrix();
    EXPECT_LE((at.L - turned).norm(), allowed) << motion.text;
  });
}

TEST(Flow, ConservesEnergyAndMomentum) {
  over_motions(
      702, false, [](const SolvedMotion& motion, const Flows& flow, support::Random& random) {
        const Vector11<double> z = disturbed(motion, random, 0.02);
        const Vector11<double> later = integrated<11>(flow.reduced, z, 3.0);
        EXPECT_NEAR(flow.energy(later), flow.energy(z), 1e-10 * (1.0 + std::abs(flow.energy(z))))
            << motion.text;
        EXPECT_NEAR(later.head<3>().norm(), z.head<3>().norm(), 1e-11 * (1.0 + z.head<3>().norm()))
            << motion.text;
        EXPECT_GT((later - z).norm(), 1e-4) << motion.text;  // it moved
      });
}

/// The circle criterion of spectrum.cpp and general_spectrum.cpp rests on P and its sign against
/// |pi|.
TEST(Flow, ConservesMaterialMomentumAtEqualInertias) {
  double worst_unequal = 0.0;
  for (const bool symmetric : {true, false}) {
    over_motions(703, symmetric,
                 [&](const SolvedMotion& motion, const Flows& flow, support::Random& random) {
                   const Vector11<double> z = disturbed(motion, random, 0.05);
                   const Vector11<double> later = integrated<11>(flow.reduced, z, 3.0);
                   const double change = std::abs(material_momentum(later) - material_momentum(z));
                   if (symmetric) {
                     EXPECT_LE(change, 1e-10 * (1.0 + z.norm() * z.norm())) << motion.text;
                   } else {
                     worst_unequal = std::max(worst_unequal, change);
                   }
                 });
  }
  EXPECT_GT(worst_unequal, 1e-3);  // only there
}

/// On the circle of (iii) P = pi3, so P - |pi| (nu3 > 0) or P + |pi| (nu3 < 0) is stationary on
/// the leaf.
TEST(Flow, MaterialMomentumIsStationaryOnTheCircle) {
  for (const double nu : {0.3, -0.3}) {
    const SolvedMotion m =
        motion(Body(1.2, 1.2, 0.7), reciprocal, {1.0, 2.0}, {1.0, 3.0}, Branch::iii, nu);
    ASSERT_EQ(m.at.q.xi, m.at.q.zeta);
    const Vector11<double> z = point(m);
    const auto invariant = [&](const Vector11<double>& y) {
      return material_momentum(y) - (nu > 0.0 ? 1.0 : -1.0) * y.head<3>().norm();
    };
    EXPECT_NEAR(invariant(z), 0.0, 1e-15);
    for (int k = 0; k < 11; ++k) {
      Vector11<double> ahead = z;
      Vector11<double> behind = z;
      ahead[k] += 1e-4;
      behind[k] -= 1e-4;
      EXPECT_NEAR(invariant(ahead) - invariant(behind), 0.0, 1e-11) << k;
    }
  }
}

/// S(t) and, from conservation in space, L pi = const: pi(t) = L(t)^T pi(0). With pi' = pi x nu it
/// would be L(t) pi(0).
TEST(Flow, ReducedAndInSpaceAreOneMotion) {
  over_motions(
      704, false, [](const SolvedMotion& motion, const Flows& flow, support::Random& random) {
        const Body& body = motion.problem.body();
        const Vector11<double> z = disturbed(motion, random, 0.05);
        for (const double time : {0.7, 2.5}) {
          const Vector11<double> reduced = integrated<11>(flow.reduced, z, time);
          const Polar space = polar(integrated<14>(flow.in_space, placed_state(body, z), time));
          const double allowed = 1e-9 * (1.0 + z.norm());
          EXPECT_LE((space.q.vector() - reduced.segment<4>(3)).norm(), allowed) << motion.text;
          const Vector3<double> pi = z.head<3>();
          EXPECT_LE((space.L.transpose() * pi - reduced.head<3>()).norm(), allowed) << motion.text;
        }
      });
}

/// Each e^{+-s time} of the spectrum is an eigenvalue of the tangent of the flow.
void expect_multipliers(const SolvedMotion& motion, const Spectrum& spectrum,
                        const Eigen::MatrixXd& tangent, double time) {
  const Eigen::VectorXcd multipliers = tangent.eigenvalues();
  for (const Mode& m : modes(spectrum)) {
    if (m.forced_zero) continue;
    for (const Complex s :
         {Complex(m.re, m.im), Complex(-m.re, m.im), Complex(m.re, -m.im), Complex(-m.re, -m.im)}) {
      const Complex expected = std::exp(s * time);
      double nearest = INFINITY;
      for (const Complex& multiplier : multipliers)
        nearest = std::min(nearest, std::abs(multiplier - expected));
      EXPECT_LE(nearest, 1e-6 * (1.0 + std::abs(expected))) << motion.text << "\n  s " << s << "\n"
                                                            << spectrum;
    }
  }
}

TEST(Flow, TangentHasThePredictedMultipliers) {
  over_motions(705, false, [](const SolvedMotion& motion, const Flows& flow, support::Random&) {
    const Body& body = motion.problem.body();
    const Spectrum spectrum = motion.blocks();
    const double time = 0.9;
    const Vector11<double> z = point(motion);
    expect_multipliers(motion, spectrum, tangent<11>(flow.reduced, z, time), time);
    // In space, seen from the turning frame.
    const Eigen::MatrixXd in_space = tangent<14>(flow.in_space, placed_state(body, z), time);
    Vector3<double> axis_vector = Vector3<double>::Zero();
    axis_vector[axis(motion.problem.branch())] = 1.0;
    const Matrix3<double> back =
        Eigen::AngleAxisd(motion.nu() * time, axis_vector).toRotationMatrix();
    Eigen::MatrixXd frame = Eigen::MatrixXd::Identity(14, 14);
    for (const int start : {0, 3, 7, 10}) frame.block<3, 3>(start, start) = back;
    expect_multipliers(motion, spectrum, frame * in_space, time);
  });
}

/// Of reciprocal-determinant 1, 2, thickness 1, 3: a disturbance along an eigenvector over many
/// periods, the mean of +- to cancel second order.
void expect_carried(const SolvedMotion& motion, double time, double allowed) {
  const Body& body = motion.problem.body();
  const Vector11<double> z = point(motion);
  const Separable<ReciprocalDeterminant<Number50>, ReciprocalQuadratic<Number50>> widened{{1, 2},
                                                                                          {1, 3}};
  const Stretch& at = motion.at.q;
  const BasicStretch<Number50> q{Number50(0), Number50(at.xi), Number50(at.zeta), Number50(at.rho)};
  const Vector3<Number50> nu = angular_velocity(motion.problem.branch(), Number50(motion.nu()));
  const auto wide = lie_poisson_matrix(body, widened, steady_point(body, q, nu));
  Eigen::MatrixXd A(11, 11);
  for (int i = 0; i < 11; ++i)
    for (int j = 0; j < 11; ++j) A(i, j) = wide(i, j).convert_to<double>();
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(A);
  const Flows flow = flows(body, motion.problem.potential());
  constexpr double size = 1e-5;
  for (const Mode& m : modes(motion.blocks())) {
    const Complex s(m.re, m.im);
    Eigen::Index best = 0;
    for (Eigen::Index k = 1; k < 11; ++k)
      if (std::abs(eigen.eigenvalues()[k] - s) < std::abs(eigen.eigenvalues()[best] - s)) best = k;
    const Eigen::VectorXcd v = eigen.eigenvectors().col(best);
    const Vector11<double> start = v.real();
    const Vector11<double> ahead =
        integrated<11>(flow.reduced, Vector11<double>(z + size * start), time);
    const Vector11<double> behind =
        integrated<11>(flow.reduced, Vector11<double>(z - size * start), time);
    const Vector11<double> carried = (ahead - behind) / (2.0 * size);
    const Vector11<double> expected = (std::exp(s * time) * v).real();
    EXPECT_LE((carried - expected).norm(), allowed * std::exp(m.re * time))
        << motion.text << "\n  s " << s;
  }
}

TEST(Flow, UnstableMotionGrowsAtThePredictedRate) {
  const SolvedMotion m =
      motion(Body(1.0, 1.7, 0.6), reciprocal, {1.0, 2.0}, {1.0, 3.0}, Branch::i, 0.5);
  EXPECT_EQ(m.blocks().verdict, StabilityClass::unstable);
  // 1e-6 in e^{s 30} is 3e-8 in s.
  expect_carried(m, 30.0, 1e-6);
}

TEST(Flow, StableMotionsVibrateAtThePredictedFrequencies) {
  const SolvedMotion m =
      motion(Body(1.0, 1.7, 0.6), reciprocal, {1.0, 2.0}, {1.0, 3.0}, Branch::iii, 0.5);
  ASSERT_EQ(m.blocks().growth, 0.0);
  expect_carried(m, 30.0, 1e-6);
}

}  // namespace
}  // namespace stationary
