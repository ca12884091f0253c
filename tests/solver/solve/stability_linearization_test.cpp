// Two linearizations that share nothing with the library's blocks: of the Lie-Poisson equations
// from values of H (tests/support/lie_poisson.hpp) and of the motion in space, which never uses pi
// (tests/support/placement.hpp). Both in 50 digits, their eigenvalues by the QR algorithm there.
#include <gtest/gtest.h>

#include "tests/support/bodies/motions.hpp"
#include "tests/support/general_path.hpp"
#include "tests/support/lie_poisson.hpp"
#include "tests/support/numbers/wide_eigenvalues.hpp"
#include "tests/support/placement.hpp"

namespace stationary {
namespace {

using namespace testing;

/// Each +-s of the spectrum is among the eigenvalues, each once; what is left is returned.
/// s^2 must agree within the mode's own bound.
std::vector<WideEigenvalue> expect_modes_among(const SolvedMotion& motion, const Spectrum& spectrum,
                                               std::vector<WideEigenvalue> eigenvalues) {
  const double size = scale(spectrum);
  for (const Mode& m : modes(spectrum)) {
    if (m.forced_zero) continue;
    // A quadruple is in the list twice, each time for one conjugate pair of s.
    const std::array<std::array<double, 2>, 2> wanted{{{m.re, m.im}, {-m.re, -m.im}}};
    for (const auto& s : wanted) {
      std::size_t best = 0;
      const auto away = [&](const WideEigenvalue& e) {
        const Number50 re = abs(e.re) - std::abs(s[0]);
        const Number50 im = abs(e.im) - std::abs(s[1]);
        return Number50(re * re + im * im);
      };
      for (std::size_t k = 1; k < eigenvalues.size(); ++k)
        if (away(eigenvalues[k]) < away(eigenvalues[best])) best = k;
      const WideEigenvalue e = eigenvalues[best];
      const Number50 off_re = e.re * e.re - e.im * e.im - m.lambda_re;
      const Number50 off_im = abs(Number50(2 * e.re * e.im)) - m.lambda_im;
      const double off = sqrt(Number50(off_re * off_re + off_im * off_im)).convert_to<double>();
      EXPECT_LE(off, m.lambda_error + 1e-16 * size)
          << motion.text << "\n  s " << s[0] << " " << s[1] << "\n"
          << spectrum;
      eigenvalues.erase(eigenvalues.begin() + static_cast<std::ptrdiff_t>(best));
    }
  }
  return eigenvalues;
}

/// The rest: zeros (a Jordan block's, so only to a root of the differences' error) and +-i |nu|.
void expect_rest(const SolvedMotion& motion, std::vector<WideEigenvalue> rest, std::size_t zeros,
                 bool turns) {
  if (turns) {
    for (int k = 0; k < 2; ++k) {
      std::size_t best = 0;
      const auto away = [&](const WideEigenvalue& e) {
        return abs(Number50(abs(e.im) - std::abs(motion.nu()))) + abs(e.re);
      };
      for (std::size_t i = 1; i < rest.size(); ++i)
        if (away(rest[i]) < away(rest[best])) best = i;
      EXPECT_LE(away(rest[best]).convert_to<double>(), 1e-14) << motion.text;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best));
    }
  }
  EXPECT_EQ(rest.size(), zeros) << motion.text;
  for (const WideEigenvalue& e : rest)
    EXPECT_LE((abs(e.re) + abs(e.im)).convert_to<double>(), 1e-5) << motion.text;
}

std::size_t forced(const Spectrum& spectrum) {
  std::size_t out = 0;
  for (const Mode& m : modes(spectrum)) out += m.forced_zero ? 2 : 0;
  return out;
}

struct Oracles {
  std::vector<WideEigenvalue> lie_poisson;
  std::vector<WideEigenvalue> placement;
};

Oracles oracles(const SolvedMotion& motion) {
  const auto wide = wide_motion(motion).state;
  const Body& body = motion.problem.body();
  const BasicStretch<Number50> q{Number50(0), wide.xi, wide.zeta, wide.rho};
  const Vector3<Number50> nu = angular_velocity(motion.problem.branch(), Number50(motion.nu()));
  Oracles out;
  motion.problem.potential().visit_parts([&](const auto& model) {
    const auto widened = support::widen<Number50>(model);
    out.lie_poisson =
        wide_eigenvalues(lie_poisson_matrix(body, widened, steady_point(body, q, nu)));
    out.placement = wide_eigenvalues(placement_matrix(body, widened, q, nu));
  });
  return out;
}

class LinearizationTest : public ::testing::TestWithParam<std::size_t> {
 protected:
  const PotentialName& potential() const { return potential_names()[GetParam()]; }
};
INSTANTIATE_TEST_SUITE_P(Potentials, LinearizationTest,
                         ::testing::Range(std::size_t{0}, potential_names().size()),
                         [](const auto& info) {
                           const PotentialName& p = potential_names()[info.param];
                           std::string out = std::string(p.model) + "_" + std::string(p.thickness);
                           for (char& letter : out)
                             if (letter == '-') letter = '_';
                           return out;
                         });

TEST_P(LinearizationTest, BothOraclesHaveTheModesAndNoOthers) {
  support::Random random(301 + GetParam());
  for (const Branch branch : branches) {
    for (const bool symmetric : {false, true}) {
      const SolvedMotion motion = random_motion(random, potential(), branch, symmetric);
      const Oracles oracle = oracles(motion);
      for (const Spectrum& spectrum : {motion.blocks(), general(motion)}) {
        const std::size_t zeros = forced(spectrum);
        expect_rest(motion, expect_modes_among(motion, spectrum, oracle.lie_poisson), zeros + 1,
                    false);
        expect_rest(motion, expect_modes_among(motion, spectrum, oracle.placement), zeros + 2,
                    true);
      }
    }
  }
}

/// reciprocal-determinant c 1, k 2, thickness 1, 3, J (1, 1.7, 0.6) at nu = (0.5, 0, 0).
SolvedMotion sign_case() {
  return motion(Body(1.0, 1.7, 0.6), {"reciprocal-determinant", "reciprocal-quadratic"}, {1.0, 2.0},
                {1.0, 3.0}, Branch::i, 0.5);
}

/// Real parts of real eigenvalues > 0 and the imaginary parts of imaginary ones, > 0.
bool has_growth(const std::vector<WideEigenvalue>& eigenvalues, double rate) {
  for (const auto& e : eigenvalues)
    if (abs(Number50(e.re - rate)) < 6e-11 && abs(e.im) < 1e-18) return true;
  return false;
}
bool has_frequency(const std::vector<WideEigenvalue>& eigenvalues, double frequency) {
  for (const auto& e : eigenvalues)
    if (abs(Number50(e.im - frequency)) < 6e-11 && abs(e.re) < 1e-18) return true;
  return false;
}

TEST(SignOfTheBracket, MotionInSpaceDecidesIt) {
  const SolvedMotion motion = sign_case();
  const Oracles oracle = oracles(motion);
  for (const Spectrum& spectrum : {motion.blocks(), general(motion)}) {
    EXPECT_EQ(spectrum.verdict, StabilityClass::unstable);
    EXPECT_NEAR(spectrum.growth, 0.1543037674, 6e-11);
    double nearest = 1.0;
    for (const Mode& m : modes(spectrum))
      nearest = std::min(nearest, std::abs(m.im - 1.8153678880));
    EXPECT_LE(nearest, 6e-11);
  }
  for (const auto& eigenvalues : {oracle.lie_poisson, oracle.placement}) {
    EXPECT_TRUE(has_growth(eigenvalues, 0.1543037674));
    EXPECT_TRUE(has_frequency(eigenvalues, 1.8153678880));
  }
}

/// The paper prints pi' = pi x nu. With its own nu = L^-1 L' that is not how a body moves.
TEST(SignOfTheBracket, AsPrintedInThePaperContradictsTheMotionInSpace) {
  const SolvedMotion motion = sign_case();
  const auto wide = wide_motion(motion).state;
  const Body& body = motion.problem.body();
  const BasicStretch<Number50> q{Number50(0), wide.xi, wide.zeta, wide.rho};
  const Vector3<Number50> nu{Number50(0.5), Number50(0), Number50(0)};
  const Oracles oracle = oracles(motion);
  motion.problem.potential().visit_parts([&](const auto& model) {
    const auto widened = support::widen<Number50>(model);
    const auto printed =
        wide_eigenvalues(lie_poisson_matrix(body, widened, steady_point(body, q, nu), -1.0));
    EXPECT_TRUE(has_growth(printed, 0.1415393858));
    EXPECT_TRUE(has_frequency(printed, 1.9790823784));
    EXPECT_FALSE(has_growth(printed, 0.1543037674));
  });
  EXPECT_FALSE(has_growth(oracle.placement, 0.1415393858));
  EXPECT_FALSE(has_frequency(oracle.placement, 1.9790823784));
}

/// Relative equilibria and (iii) do not see the sign.
TEST(SignOfTheBracket, BranchThreeDoesNotSeeIt) {
  support::Random random(302);
  const SolvedMotion motion = random_motion(random, potential_names()[0], Branch::iii, false);
  const auto wide = wide_motion(motion).state;
  const Body& body = motion.problem.body();
  const BasicStretch<Number50> q{Number50(0), wide.xi, wide.zeta, wide.rho};
  const Vector3<Number50> nu = angular_velocity(Branch::iii, Number50(motion.nu()));
  motion.problem.potential().visit_parts([&](const auto& model) {
    const auto widened = support::widen<Number50>(model);
    const auto printed =
        wide_eigenvalues(lie_poisson_matrix(body, widened, steady_point(body, q, nu), -1.0));
    expect_rest(motion, expect_modes_among(motion, motion.blocks(), printed), 1, false);
  });
}

}  // namespace
}  // namespace stationary
