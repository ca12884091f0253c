// Laws of spectra over every potential and branch at random motions (J1 = J2 in half of them):
// the blocks and the general problem agree, the count law, and what symmetries of the problem leave
// alone.
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "solver/search/two_polar_search.hpp"
#include "solver/solve/two_polar_equilibrium.hpp"
#include "tests/support/bodies/motions.hpp"
#include "tests/support/general_path.hpp"

namespace stationary {
namespace {

using namespace testing;

bool has_undecided_krein(const Spectrum& spectrum) {
  for (const Mode& m : modes(spectrum))
    if (m.lambda_re < 0.0 && m.lambda_im == 0.0 && m.krein == 0 && !m.forced_zero) return true;
  return false;
}

/// The negative directions that its modes tell of: one of a real Lambda > 0, two of negative energy.
/// Nothing where a Lambda or a signature is not certain.
std::optional<int> negative_by_modes(const Spectrum& spectrum) {
  int out = 0;
  for (const Mode& m : modes(spectrum)) {
    if (m.forced_zero || std::abs(m.lambda_re) + m.lambda_im <= m.lambda_error) return std::nullopt;
    if (m.lambda_im > 0.0) {
      out += 1;  // a quadruple is two modes
    } else {
      out += m.lambda_re > 0.0 ? 1 : m.krein < 0 ? 2 : 0;
    }
  }
  if (has_undecided_krein(spectrum)) return std::nullopt;
  return out;
}

/// Two spectra of one motion: modes within their bounds, verdicts and signs equal.
void expect_same(const std::string& where, const Spectrum& a, const Spectrum& b,
                 double frequency = 1.0) {
  ASSERT_EQ(a.modes, b.modes) << where;
  const auto x = by_lambda(a);
  const auto y = by_lambda(b);
  const double square = frequency * frequency;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double off = std::hypot(square * x[k].lambda_re - y[k].lambda_re,
                                  square * x[k].lambda_im - y[k].lambda_im);
    EXPECT_LE(off, square * x[k].lambda_error + y[k].lambda_error + 0x1p-52 * scale(b))
        << where << "\n  " << a << "\n  " << b;
    EXPECT_EQ(x[k].forced_zero, y[k].forced_zero) << where << "\n  " << a << "\n  " << b;
    if (x[k].krein != 0 && y[k].krein != 0) {
      EXPECT_EQ(x[k].krein, y[k].krein) << where << "\n  " << a << "\n  " << b;
    }
  }
  EXPECT_EQ(a.negative, b.negative) << where << "\n  " << a << "\n  " << b;
  EXPECT_EQ(name(a.verdict), name(b.verdict)) << where << "\n  " << a << "\n  " << b;
}

class StabilityLawsTest : public ::testing::TestWithParam<std::size_t> {
 protected:
  const PotentialName& potential() const { return potential_names()[GetParam()]; }
  /// f(motion) over branches, with and without material symmetry.
  template <class F>
  void over_motions(std::uint64_t seed, int count, const F& f) {
    support::Random random(seed + GetParam());
    for (int k = 0; k < count; ++k)
      for (const Branch branch : branches)
        for (const bool symmetric : {false, true})
          f(random_motion(random, potential(), branch, symmetric));
  }
};
INSTANTIATE_TEST_SUITE_P(Potentials, StabilityLawsTest,
                         ::testing::Range(std::size_t{0}, potential_names().size()),
                         [](const auto& info) {
                           const PotentialName& p = potential_names()[info.param];
                           std::string out = std::string(p.model) + "_" + std::string(p.thickness);
                           for (char& letter : out)
                             if (letter == '-') letter = '_';
                           return out;
                         });

TEST_P(StabilityLawsTest, BlocksAndGeneralProblemAgree) {
  over_motions(401, 12, [](const SolvedMotion& motion) {
    expect_same(motion.text, motion.blocks(), general(motion));
  });
}

TEST_P(StabilityLawsTest, NegativeDirectionsAreCounted) {
  int counted = 0;
  over_motions(402, 40, [&](const SolvedMotion& motion) {
    const Spectrum spectrum = motion.blocks();
    const auto expected = negative_by_modes(spectrum);
    if (!expected) return;
    ++counted;
    EXPECT_EQ(spectrum.negative, *expected) << motion.text << "\n" << spectrum;
  });
  EXPECT_GT(counted, 100);
}

/// Ellipses with internal motion: some of them wobble away, some stretch away.
TEST(TwoPolarStabilityLaws, NegativeDirectionsAreCounted) {
  const Body body(1.0, 1.0, 0.6);
  int counted = 0;
  std::map<Block, int> unstable;
  for (const std::string_view model : {"hencky", "biot-log"}) {
    const Potential V = named_potential({model, "reciprocal-quadratic"}, {1.0, 10.0});
    for (const double omega : {0.2, 0.4, 0.6, 1.1, 1.15}) {
      for (const double theta_dot : {0.0, 0.1, 0.75, 0.8}) {
        const TwoPolarRates<double> rates{omega, theta_dot};
        for (const Equilibrium& at : search_two_polar(body, V, rates, {}).solutions) {
          const Spectrum spectrum = two_polar_stability(body, V, at);
          const auto expected = negative_by_modes(spectrum);
          if (!expected || at.q.xi == at.q.zeta) continue;
          ++counted;
          for (const Mode& m : modes(spectrum)) unstable[m.block] += m.lambda_re > 0.0;
          EXPECT_EQ(spectrum.negative, *expected) << model << " " << omega << "\n" << spectrum;
        }
      }
    }
  }
  EXPECT_GE(counted, 10);
  EXPECT_GE(unstable[Block::odd], 3);
  EXPECT_GE(unstable[Block::even], 3);
}

TEST_P(StabilityLawsTest, TurningTheOtherWayChangesNothing) {
  over_motions(403, 8, [](const SolvedMotion& motion) {
    SolvedMotion back = motion;
    back.at.nu = -back.at.nu;
    expect_same(motion.text, motion.blocks(), back.blocks(), 1.0);
    expect_same(motion.text + "general", general(motion), general(back), 1.0);
  });
}

/// Axes 1 and 2 exchanged: (i) becomes (ii), (iii) itself.
TEST_P(StabilityLawsTest, ExchangeOfAxesOneAndTwo) {
  over_motions(404, 8, [](const SolvedMotion& motion) {
    const Body& body = motion.problem.body();
    const Branch branch = motion.problem.branch();
    const Branch other = branch == Branch::i    ? Branch::ii
                         : branch == Branch::ii ? Branch::i
                                                : Branch::iii;
    SolvedMotion exchanged{
        Problem(Body(body.J2, body.J1, body.J3), motion.problem.potential(), other), motion.at,
        motion.text};
    exchanged.at.nu = angular_velocity(other, motion.nu());
    std::swap(exchanged.at.q.xi, exchanged.at.q.zeta);
    const Spectrum a = motion.blocks();
    const Spectrum b = exchanged.blocks();
    expect_same(motion.text, a, b);
    for (std::size_t k = 0; k < static_cast<std::size_t>(a.modes); ++k)
      EXPECT_NEAR(a.mode[k].lambda_re, b.mode[k].lambda_re, 1e-14 * scale(a)) << motion.text;
  });
}

/// J1 = J2: the same motion seen from material axes turned by theta has alpha != 0.
TEST_P(StabilityLawsTest, MaterialRotationAtEqualInertias) {
  support::Random random(405 + GetParam());
  for (int k = 0; k < 6; ++k) {
    for (const Branch branch : branches) {
      const SolvedMotion motion = random_motion(random, potential(), branch, true);
      const double theta = random.uniform(-1.5, 1.5);
      expect_same(motion.text + "theta " + std::to_string(theta), motion.blocks(),
                  general(motion, theta));
    }
  }
}

/// nu = 0: four modes, whatever the branch; stable, E'' = T + V'' being definite.
TEST_P(StabilityLawsTest, Rest) {
  support::Random random(406 + GetParam());
  for (const bool symmetric : {false, true}) {
    for (int k = 0; k < 4; ++k) {
      const std::array<double, 2> plane{random.uniform(0.3, 3.0), random.uniform(0.3, 3.0)};
      const Body body = symmetric ? random.symmetric_body() : random.body();
      std::vector<Spectrum> all;
      for (const Branch branch : branches) {
        const SolvedMotion at_rest = motion(body, potential(), plane, {1.0, 3.0}, branch, 0.0);
        const Spectrum spectrum = at_rest.blocks();
        EXPECT_EQ(spectrum.modes, 4) << at_rest.text;
        EXPECT_EQ(spectrum.verdict, StabilityClass::stable) << at_rest.text << "\n" << spectrum;
        EXPECT_EQ(spectrum.negative, 0) << at_rest.text;
        EXPECT_EQ(spectrum.growth, 0.0) << at_rest.text;
        expect_same(at_rest.text, spectrum, general(at_rest));
        all.push_back(spectrum);
      }
      for (std::size_t j = 1; j < all.size(); ++j) expect_same("rest", all[0], all[j]);
      // As nu -> 0 the moving spectra have these four and one more that vanishes with nu.
      for (const Branch branch : branches) {
        const SolvedMotion slow = motion(body, potential(), plane, {1.0, 3.0}, branch, 1e-7);
        auto moving = modes(slow.blocks());
        ASSERT_EQ(moving.size(), 5U);
        const auto still = modes(all[0]);
        for (std::size_t j = 0; j < 4; ++j)
          EXPECT_NEAR(moving[j + 1].im, still[j].im, 1e-6 * (1.0 + still[j].im)) << slow.text;
        EXPECT_LE(moving[0].re + moving[0].im, 1e-6) << slow.text;
      }
    }
  }
}

TEST_P(StabilityLawsTest, ScalesOfInertiaAndEnergyTogetherDoNotCount) {
  support::Random random(407 + GetParam());
  const bool length = potential().thickness == "harmonic";  // its second coefficient
  for (int k = 0; k < 6; ++k) {
    for (const Branch branch : branches) {
      const Body body = random.body();
      const std::array<double, 2> plane{random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)};
      const std::array<double, 2> axial{random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)};
      const double nu = 0.3 * std::sqrt(0.5 / std::max({body.J1, body.J2, body.J3}));
      const SolvedMotion one = motion(body, potential(), plane, axial, branch, nu);
      for (const double s : {0x1p-20, 0x1p7, 1000.0}) {
        const Body scaled(s * body.J1, s * body.J2, s * body.J3);
        const SolvedMotion other =
            motion(scaled, potential(), {s * plane[0], s * plane[1]},
                   {s * axial[0], length ? axial[1] : s * axial[1]}, branch, nu);
        expect_same(one.text, one.blocks(), other.blocks());
      }
      // Time: V -> s^2 V, nu -> s nu multiplies every frequency by s.
      const double s = 8.0;
      const SolvedMotion faster =
          motion(body, potential(), {s * s * plane[0], s * s * plane[1]},
                 {s * s * axial[0], length ? axial[1] : s * s * axial[1]}, branch, s * nu);
      expect_same(one.text, one.blocks(), faster.blocks(), s);
    }
  }
}

}  // namespace
}  // namespace stationary
