// Spectra of motions of anisotropic bodies against the body as it moves in space: (Phi1, Phi2, rho)
// of tests/support/flows.hpp, where the fibre's stretch is |Phi f| itself and neither alpha nor an
// angular momentum occurs.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <complex>

#include "solver/motion/oriented_stability.hpp"
#include "solver/search/anisotropic_search.hpp"
#include "solver/solve/stability.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/flows.hpp"

namespace stationary::testing {

/// An isotropic model and a fibre, as potentials of the placement.
template <class Model>
struct FibredPlacement {
  Model isotropic;
  double k;
  double degrees;
};

template <class Model, class S>
S elastic_energy(const FibredPlacement<Model>& model, const Vector7<S>& X) {
  const double angle = model.degrees * M_PI / 180.0;
  S length_squared(0.0);
  for (int i = 0; i < 3; ++i) {
    const S along = std::cos(angle) * X[i] + std::sin(angle) * X[3 + i];
    length_squared += along * along;
  }
  const S n = length_squared - 1.0;
  return elastic_energy(model.isotropic, X) + 0.5 * model.k * n * n;
}

namespace {

using Model = Separable<BiotLog<>, ReciprocalQuadratic<>>;
using Complex = std::complex<double>;

struct Fibred {
  Body body;
  Model isotropic;
  double k;
  double degrees;

  Potential potential() const {
    return Potential(AnisotropicPotential(isotropic.plane, isotropic.thickness, {{k, degrees}}));
  }
  PlacementFlow<FibredPlacement<Model>> flow() const { return {body, {isotropic, k, degrees}}; }
};

Fibred random_fibred(support::Random& random) {
  return {random.body(2.0),
          {{random.log_uniform(0.5, 2.0), random.uniform(0.1, 2.0)}, {1.0, 3.0}},
          random.log_uniform(0.2, 2.0),
          random.uniform(-90.0, 90.0)};
}

std::string described(std::string_view family, const Body& body, const Stretch& q,
                      const Vector3<double>& nu) {
  std::ostringstream out;
  out.precision(17);
  out << family << ", J (" << body.J1 << ", " << body.J2 << ", " << body.J3 << "), q ("
      << q.vector().transpose() << "), nu (" << nu.transpose() << ")";
  return out.str();
}

Matrix3<double> generator(const Vector3<double>& nu) {  // L^-1 L'
  Matrix3<double> out;
  out << 0.0, nu[2], -nu[1], -nu[2], 0.0, nu[0], nu[1], -nu[0], 0.0;
  return out;
}

/// The field seen from the frame that turns with the motion: zero at it.
Vector14d seen_turning(const Vector14d& field, const Vector14d& x, const Vector3<double>& nu) {
  const Matrix3<double> spin = generator(nu);
  Vector14d out = field;
  for (const int start : {0, 3, 7, 10}) out.segment<3>(start) -= spin * x.segment<3>(start);
  return out;
}

/// Central differences of eighth order: errors near 1e-13 of a field of order one.
Eigen::Matrix<double, 14, 14> linearized(const Fibred& at, const Vector14d& x,
                                         const Vector3<double>& nu) {
  const auto flow = at.flow();
  constexpr double weight[] = {4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0};
  constexpr double h = 4e-3;
  Eigen::Matrix<double, 14, 14> out;
  for (int k = 0; k < 14; ++k) {
    Vector14d sum = Vector14d::Zero();
    for (int j = 1; j <= 4; ++j) {
      Vector14d ahead = x;
      Vector14d behind = x;
      ahead[k] += j * h;
      behind[k] -= j * h;
      sum += weight[j - 1] *
             (seen_turning(flow(ahead), ahead, nu) - seen_turning(flow(behind), behind, nu));
    }
    out.col(k) = sum / h;
  }
  return out;
}

void expect_verified(const Fibred& at, const Equilibrium& found, const Spectrum& spectrum,
                     const std::string& text) {
  const Vector14d x = placed_state(at.body, steady_point(at.body, found.q, found.nu));
  const double size = 1.0 + at.flow()(x).norm();
  EXPECT_LE(seen_turning(at.flow()(x), x, found.nu).norm(), 1e-12 * size) << text;
  const Eigen::VectorXcd in_space = linearized(at, x, found.nu).eigenvalues();
  for (int k = 0; k < spectrum.modes; ++k) {
    const Mode& mode = spectrum.mode[static_cast<std::size_t>(k)];
    for (const Complex s : {Complex(mode.re, mode.im), Complex(-mode.re, -mode.im)}) {
      double nearest = INFINITY;
      for (const Complex& other : in_space) nearest = std::min(nearest, std::abs(other - s));
      EXPECT_LE(nearest, 1e-10 * (1.0 + std::abs(s))) << text << ", s = " << s;
    }
  }
}

TEST(AnisotropicStability, ObliqueMotionsAgreeWithTheDynamicsInSpace) {
  support::Random random(421);
  int unstable = 0;
  for (int k = 0; k < 12; ++k) {
    const Fibred at = random_fibred(random);
    const double nu = random.uniform(0.1, 0.4);
    for (const Branch near : {Branch::i, Branch::ii}) {
      const Potential V = at.potential();
      const Equilibrium found = solve_oblique(at.body, V, {nu, near}, without_search());
      ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
      ASSERT_NE(found.nu[0] * found.nu[1], 0.0);
      const auto spectrum = oblique_stability(at.body, V, found);
      ASSERT_TRUE(spectrum);
      unstable += spectrum->verdict == StabilityClass::unstable;
      expect_verified(at, found, *spectrum, described("oblique", at.body, found.q, found.nu));
    }
  }
  EXPECT_GT(unstable, 2);
  EXPECT_LT(unstable, 22);
}

TEST(AnisotropicStability, MotionsAboutAxisThreeAgreeWithTheDynamicsInSpace) {
  support::Random random(422);
  for (int k = 0; k < 12; ++k) {
    const Fibred at = random_fibred(random);
    const Problem problem(at.body, at.potential(), Branch::iii);
    const Equilibrium found = solve(problem, random.uniform(0.1, 0.6), without_search());
    ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
    ASSERT_NE(found.q.alpha, 0.0);
    expect_verified(at, found, stability(problem, found),
                    described("(iii)", at.body, found.q, found.nu));
  }
}

/// What the reflection in the plane of axes 1 and 2 leaves to itself, by its closed forms.
TEST(AnisotropicStability, WobbleAndThicknessOfAxisThreeAreBlocksOfTheirOwn) {
  support::Random random(424);
  for (int k = 0; k < 12; ++k) {
    const Fibred at = random_fibred(random);
    const Problem problem(at.body, at.potential(), Branch::iii);
    const double nu = random.uniform(0.1, 0.6);
    const Equilibrium found = solve(problem, nu, without_search());
    ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
    const Spectrum spectrum = stability(problem, found);
    const Matrix3<double> I = locked_inertia(at.body, found.q);
    const Eigen::Matrix2d in_plane = I.topLeftCorner<2, 2>();
    const double wobble = -nu * nu *
                          (I(2, 2) * Eigen::Matrix2d::Identity() - in_plane).determinant() /
                          in_plane.determinant();
    const double V_rr = problem.potential().derivatives(found.q).hessian(3, 3);
    int seen = 0;
    for (int j = 0; j < spectrum.modes; ++j) {
      const Mode& mode = spectrum.mode[static_cast<std::size_t>(j)];
      if (mode.block == Block::odd) {
        EXPECT_NEAR(mode.lambda_re, wobble, mode.lambda_error + 1e-13 * std::abs(wobble));
      } else if (mode.block == Block::thickness) {
        EXPECT_NEAR(mode.lambda_re, -V_rr / at.body.J3, 1e-13 * V_rr / at.body.J3);
      } else {
        continue;
      }
      ++seen;
    }
    EXPECT_EQ(seen, 2);
    EXPECT_EQ(spectrum.modes, 5);
  }
}

/// A fibre along an axis: the blocks, and the whole problem's own path, against the dynamics.
TEST(AnisotropicStability, BlocksOfAnEvenPotentialAgreeWithTheDynamicsInSpace) {
  support::Random random(423);
  for (int k = 0; k < 12; ++k) {
    Fibred at = random_fibred(random);
    at.degrees = k % 2 == 0 ? 0.0 : 90.0;
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      const Problem problem(at.body, at.potential(), branch);
      const Equilibrium found = solve(problem, random.uniform(0.1, 0.4), without_search());
      ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
      ASSERT_EQ(found.q.alpha, 0.0);
      expect_verified(at, found, stability(problem, found),
                      described(name(branch), at.body, found.q, found.nu));
    }
  }
}

/// Neo-Hookean with a fibre along axis 2: K_alpha,alpha is 0, to the last bit, at J1 nu^2 = mu.
TEST(AnisotropicStability, NoZeroIsASymmetrysWhereTheEllipseTurnsAway) {
  const Problem problem(Body(1.0, 1.7, 0.6), fibred(NeoHookean<>{1.0, 2.0}, 0.4, 90.0),
                        Branch::iii);
  for (const auto& [nu, expected] :
       {std::pair{0.999, StabilityClass::stable}, std::pair{1.0, StabilityClass::marginal},
        std::pair{1.001, StabilityClass::unstable}}) {
    const Equilibrium found = solve(problem, nu, without_search());
    ASSERT_EQ(found.status, SolveStatus::solved) << found.message;
    const Spectrum spectrum = stability(problem, found);
    EXPECT_EQ(spectrum.verdict, expected) << nu;
    for (int k = 0; k < spectrum.modes; ++k)
      EXPECT_FALSE(spectrum.mode[static_cast<std::size_t>(k)].forced_zero) << nu;
  }
}

/// Every oblique motion there is, found without a start.
TEST(AnisotropicStability, AllObliqueMotionsOfASearchAgree) {
  const Fibred at{Body(1.0, 1.7, 0.6), {{1.0, 0.6}, {1.0, 3.0}}, 0.5, 30.0};
  const Potential V = at.potential();
  const SearchResult all = search_oblique(at.body, V, {0.3}, {});
  ASSERT_EQ(all.status, SearchStatus::complete) << all.message;
  EXPECT_GE(all.solutions.size(), 2U);
  for (const Equilibrium& each : all.solutions) {
    const auto spectrum = oblique_stability(at.body, V, each);
    ASSERT_TRUE(spectrum);
    expect_verified(at, each, *spectrum, described("oblique", at.body, each.q, each.nu));
  }
}

/// A component of nu that cancels leaves a pair whose first part is rounding: it is as good as none.
TEST(AnisotropicStability, OfAComponentThatCancels) {
  BodyTerms<double> held;
  held.volume = 0.5;
  const AnisotropicPotential V =
      AnisotropicPotential(OrthotropicSaintVenantKirchhoff<>{0.9378, 2.134, 0.1849, 0.3036},
                           ReciprocalQuadratic<>{2.183, 0.6789}, {})
          .with_body(held);
  const Body body(0.5498, 1.351, 0.827);
  const OrientedModels models(V);
  const OrientedSpin about_none{body, Branch::i, false};
  SolveOptions start;
  start.start = Stretch{0.0, 1.206, 0.2448, 1.694};
  for (int k = 0; k < 20; ++k) {
    const double nu = 0.5 + 0.005 * k;
    const Equilibrium at = solve(Problem(body, Potential(V), Branch::ii), nu, start);
    ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
    const BasicStretch<DoubleDouble> q{0.0, at.q.xi, at.q.zeta, at.q.rho};
    const auto spectrum = [&](const DoubleDouble& first) {
      return oriented_stability(about_none, models, q, {first, nu, 0.0}, 1e-15);
    };
    const Spectrum exact = spectrum(0.0);
    const Spectrum cancelled = spectrum(DoubleDouble(0x1p-53, -0x1p-53));
    ASSERT_EQ(cancelled.modes, exact.modes);
    EXPECT_EQ(cancelled.negative, exact.negative);
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(cancelled.mode[i].lambda_re, exact.mode[i].lambda_re) << nu;
  }
}

}  // namespace
}  // namespace stationary::testing
