// Error bounds and classes against 50 digits: |Delta Lambda| <= lambda_error for the doubles given
// and for every input shaken by half a unit; the class is the one decided in 50 digits, or marginal
// where that lies within the bounds: never wrong, and never marginal far from a change.
#include <gtest/gtest.h>

#include "tests/support/bodies/motions.hpp"
#include "tests/support/general_path.hpp"
#include "tests/support/numbers/wide_spectrum.hpp"

namespace stationary {
namespace {

using namespace testing;

const PotentialName neo_hookean{"neo-hookean", "reciprocal-quadratic"};
const PotentialName biot_log{"biot-log", "reciprocal-quadratic"};

/// Largest |Delta Lambda| / lambda_error.
double expect_within_bounds(const SolvedMotion& motion, const Spectrum& spectrum,
                            const WideMotion& wide) {
  const auto found = by_lambda(spectrum);
  EXPECT_EQ(found.size(), wide.lambdas.size()) << motion.text;
  if (found.size() != wide.lambdas.size()) return 0.0;
  double worst = 0.0;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double off = distance(found[k], wide.lambdas[k]);
    EXPECT_LE(off, found[k].lambda_error)
        << motion.text << "\n  exact " << wide.lambdas[k].re << " " << wide.lambdas[k].im << "\n"
        << spectrum;
    if (off > 0.0) worst = std::max(worst, off / found[k].lambda_error);
  }
  return worst;
}

/// Never wrong. Returns whether the class was claimed.
bool expect_right_or_marginal(const SolvedMotion& motion, const Spectrum& spectrum,
                              const WideMotion& wide) {
  const WideVerdict exact = wide_verdict(motion, wide);
  if (spectrum.verdict == StabilityClass::marginal) return false;
  EXPECT_EQ(name(spectrum.verdict), name(exact.verdict)) << motion.text << "\n" << spectrum;
  EXPECT_EQ(spectrum.negative, exact.negative) << motion.text << "\n" << spectrum;
  return true;
}

Number50 half_unit_shaken(support::Random& random, double x) {
  return Number50(x) * (1 + random.sign() * Number50(0x1p-53));
}

/// Least distance of the exact spectrum from a change of class: a Lambda (not forced) at zero, or
/// two meeting, relative to the largest.
double remoteness(const WideMotion& wide) {
  Number50 size = 0;
  for (const auto& l : wide.lambdas) size = std::max(size, Number50(abs(l.re) + l.im));
  Number50 least = size;
  for (std::size_t k = 0; k < wide.lambdas.size(); ++k) {
    const auto& a = wide.lambdas[k];
    if (a.re != 0 || a.im != 0) least = std::min(least, Number50(abs(a.re) + a.im));
    for (std::size_t j = 0; j < k; ++j) {
      const auto& b = wide.lambdas[j];
      if (a.im == 0 && b.im == 0) least = std::min(least, Number50(abs(Number50(a.re - b.re))));
      if (a.im > 0) least = std::min(least, a.im);
    }
  }
  return Number50(least / size).convert_to<double>();
}

class StabilityBoundsTest : public ::testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Potentials, StabilityBoundsTest,
                         ::testing::Range(std::size_t{0}, potential_names().size()),
                         [](const auto& info) {
                           const PotentialName& p = potential_names()[info.param];
                           std::string out = std::string(p.model) + "_" + std::string(p.thickness);
                           for (char& letter : out)
                             if (letter == '-') letter = '_';
                           return out;
                         });

TEST_P(StabilityBoundsTest, HoldForTheDoublesAndForShakenInputs) {
  support::Random random(501 + GetParam());
  const PotentialName& potential = potential_names()[GetParam()];
  double worst = 0.0;
  double worst_shaken = 0.0;
  for (int k = 0; k < 15; ++k) {
    for (const Branch branch : branches) {
      for (const bool symmetric : {false, true}) {
        const SolvedMotion motion = random_motion(random, potential, branch, symmetric);
        const Spectrum spectrum = motion.blocks();
        const WideMotion wide = wide_motion(motion);
        worst = std::max(worst, expect_within_bounds(motion, spectrum, wide));
        const bool claimed = expect_right_or_marginal(motion, spectrum, wide);
        if (remoteness(wide) > 1e-8) {
          EXPECT_TRUE(claimed) << motion.text << "\n" << spectrum;
        }
        for (int trial = 0; trial < 3; ++trial) {
          const WideMotion shaken =
              wide_motion(motion, [&](double x) { return half_unit_shaken(random, x); });
          worst_shaken = std::max(worst_shaken, expect_within_bounds(motion, spectrum, shaken));
        }
      }
    }
  }
  EXPECT_GT(worst_shaken, 0.01);  // no bound that is merely large
  RecordProperty("worst_ratio", std::to_string(worst));
  RecordProperty("worst_ratio_shaken", std::to_string(worst_shaken));
}

/// Bodies that are nearly spheres, at rest and at slow spins: three or four Lambda near one another, which
/// the characteristic polynomials know to a third or a quarter of their digits.
TEST(StabilityNearASphere, BoundsHoldHoweverNearTheFrequenciesAre) {
  support::Random random(977);
  struct Shape {
    PotentialName name;
    std::array<double, 2> plane;
    std::array<double, 2> axial;
  };
  const Shape shapes[] = {{{"neo-hookean-3d", ""}, {3.0, 0.5}, {}},
                          {{"neo-hookean-3d", ""}, {2.0, 1e-5}, {}},
                          {{"biot", "harmonic"}, {1.0, 0.0}, {2.0, 1.0}},
                          {{"saint-venant-kirchhoff", "harmonic"}, {1.5, 0.0}, {3.0, 1.0}},
                          {{"hencky", "harmonic"}, {1.0, 0.0}, {2.0, 1.0}}};
  int claimed = 0;
  int all = 0;
  double widest = 0.0;
  std::string widest_text;
  for (const Shape& shape : shapes) {
    for (const Branch branch : branches) {
      for (const double gap : {0.0, 1e-15, 1e-11, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3}) {
        for (const double nu : {0.0, 1e-6, 1e-4, 6.17e-4, 1e-3, 1e-2}) {
          const double j = random.log_uniform(0.5, 2.0);
          const auto near = [&] { return j * (1.0 + gap * random.uniform(-1.0, 1.0)); };
          const Body body(near(), near(), near());
          const SolvedMotion at = motion(body, shape.name, shape.plane, shape.axial, branch, nu);
          const Spectrum spectrum = at.blocks();
          // Nearer than that 50 digits of the polynomials are not enough to compare with.
          if (gap >= 1e-8) {
            const WideMotion wide = wide_motion(at);
            expect_within_bounds(at, spectrum, wide);
            claimed += expect_right_or_marginal(at, spectrum, wide);
            ++all;
          }
          int near_shear = 0;  // -2 mu/J, of a sphere at rest
          for (const Mode& mode : modes(spectrum)) {
            if (mode.forced_zero) continue;
            EXPECT_TRUE(std::isfinite(mode.lambda_error)) << at.text << "\n" << spectrum;
            if (mode.lambda_error / scale(spectrum) > widest) {
              widest = mode.lambda_error / scale(spectrum);
              widest_text = at.text;
            }
            const double off = std::abs(mode.lambda_re * j / (2.0 * shape.plane[0]) + 1.0);
            near_shear += off <= 4.0 * (gap + nu) + 1e-8;
          }
          EXPECT_GE(near_shear, nu == 0.0 ? 3 : 2) << at.text << "\n" << spectrum;
        }
      }
    }
  }
  EXPECT_LT(widest, 1e-2) << widest_text;
  EXPECT_GT(claimed, 0);
  RecordProperty("claimed", std::to_string(claimed) + " of " + std::to_string(all));
}

/// nu of the sign change of f between low and high, f evaluated at solved motions.
template <class F>
double bisected(double low, double high, const F& f) {
  const bool below = f(low) > 0.0;
  for (int k = 0; k < 60 && std::nextafter(low, high) < high; ++k) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0.0) == below ? low : high) = middle;
  }
  return low;
}

/// Motions of a family at nu0 (1 +- 10^-k) and a few ulps around nu0.
template <class Make>
void around(double nu0, const Make& make, int& claimed, int& marginal, double far) {
  for (const double side : {-1.0, 1.0}) {
    for (double relative = 1e-6; relative > 1e-17; relative *= 0.1) {
      const SolvedMotion motion = make(nu0 * (1.0 + side * relative));
      const Spectrum spectrum = motion.blocks();
      const WideMotion wide = wide_motion(motion);
      expect_within_bounds(motion, spectrum, wide);
      const bool decided = expect_right_or_marginal(motion, spectrum, wide);
      const Spectrum whole = general(motion);  // no sharper than its rounding, but never wrong
      expect_within_bounds(motion, whole, wide);
      expect_right_or_marginal(motion, whole, wide);
      if (relative > far) {
        EXPECT_TRUE(decided) << motion.text << relative << "\n" << spectrum;
      }
      ++(decided ? claimed : marginal);
    }
  }
}

/// I1 = I3 on (i), J1 != J2: a Lambda of the odd block passes zero.
TEST(StabilityNearChange, Tilt) {
  const Body body(1.0, 1.7, 0.6);
  const auto make = [&](Branch branch, double nu) {
    return motion(body, neo_hookean, {1.0, 2.0}, {1.0, 3.0}, branch, nu);
  };
  const struct {
    Branch branch;
    double nu;
  } events[] = {{Branch::i, 0.7479409764909196},
                {Branch::ii, 0.9913345912220252},
                {Branch::iii, 0.7613751692137570}};
  for (const auto& event : events) {
    int claimed = 0;
    int marginal = 0;
    around(
        event.nu, [&](double nu) { return make(event.branch, nu); }, claimed, marginal, 2e-13);
    EXPECT_GT(claimed, 10) << name(event.branch);
    EXPECT_GT(marginal, 0) << name(event.branch);  // it is a change of class
    const Spectrum before = make(event.branch, event.nu * (1 - 1e-6)).blocks();
    const Spectrum after = make(event.branch, event.nu * (1 + 1e-6)).blocks();
    EXPECT_NE(before.negative, after.negative) << name(event.branch);
  }
}

/// With J1 = J2 the tilt of (i) is seen in no eigenvalue, but E'' changes there.
TEST(StabilityNearChange, TiltWithMaterialSymmetry) {
  const Body body(1.0, 1.0, 1.9);
  const auto make = [&](double nu) {
    return motion(body, biot_log, {1.0, 0.6}, {1.0, 3.0}, Branch::i, nu);
  };
  const auto gap = [&](double nu) {
    const Stretch q = make(nu).at.q;
    return body.J3 * q.rho * q.rho - body.J1 * q.xi * q.xi;  // I1 - I3
  };
  ASSERT_LT(gap(0.01) * gap(0.9), 0.0);
  const double event = bisected(0.01, 0.9, gap);
  int claimed = 0;
  int marginal = 0;
  around(event, make, claimed, marginal, 1e-9);
  EXPECT_GT(claimed, 0);
  EXPECT_NE(make(event * (1 - 1e-6)).blocks().negative, make(event * (1 + 1e-6)).blocks().negative);
}

/// Two pairs of opposite signature meet and leave the axis: the soft neo-hookean's disconnected
/// sheet. Near a collision Lambda changes as a square root.
TEST(StabilityNearChange, KreinCollision) {
  const Body body(1.046, 0.972, 0.234);
  const auto make = [&](double nu) {
    SolveOptions options;
    options.method = Method::newton;
    // The sheet through (0.9949, 1.0604) at nu = 0.35, at the two events' own stretches.
    options.start = Stretch{0.0, 0.9861, 1.06103, 0.67555};
    return motion(body, neo_hookean, {0.0525, 2.3792}, {0.591, 1.917}, Branch::iii, nu, options);
  };
  // Which collision is whose sheet: see tests/data/events.csv; the start above is on this one.
  const double event = 0.3231084377189501125;
  int claimed = 0;
  int marginal = 0;
  around(event, make, claimed, marginal, 1e-11);
  EXPECT_GT(claimed, 8);
  EXPECT_GT(marginal, 0);
  const Spectrum above = make(event * (1 + 1e-4)).blocks();
  const Spectrum below = make(event * (1 - 1e-4)).blocks();
  EXPECT_EQ(
      above.verdict == StabilityClass::oscillatory || below.verdict == StabilityClass::oscillatory,
      true)
      << above << "\n"
      << below;
}

TEST(StabilityNearChange, OtherKreinCollision) {
  const Body body(1.046, 0.972, 0.234);
  const double event = 0.3226835942728774626;
  const auto make = [&](double nu) {
    SolveOptions options;
    options.method = Method::newton;
    options.start = Stretch{0.0, 15.22651635958017, 16.38664869120569, 0.67554630465904};
    return motion(body, neo_hookean, {0.0525, 2.3792}, {0.591, 1.917}, Branch::iii, nu, options);
  };
  int claimed = 0;
  int marginal = 0;
  around(event, make, claimed, marginal, 1e-10);
  EXPECT_GT(claimed, 4);
}

/// J1 = J2, (iii): the circle loses its definite K_aa where the ellipse leaves it; the pair touches
/// zero and does not cross. biot-log mu 1, lambda 4, J 1: there nu^2 = 2 - 1/r, 8 ln r = r.
TEST(StabilityNearChange, CircleToEllipse) {
  double r = 1.155;
  for (int k = 0; k < 50; ++k) r -= (8.0 * std::log(r) - r) / (8.0 / r - 1.0);
  const double event = std::sqrt(2.0 - 1.0 / r);
  const Problem problem(Body(1.0, 1.0, 0.6), named_potential(biot_log, {1.0, 4.0}), Branch::iii);
  int circles = 0;
  int claimed = 0;
  for (const double side : {-1.0, 1.0}) {
    for (double relative = 1e-2; relative > 1e-17; relative *= 0.1) {
      SolveOptions options;  // the circle beyond the event too
      options.method = Method::newton;
      options.start = Stretch{0.0, r, r, 0.7};
      Equilibrium at = solve(problem, event * (1.0 + side * relative), options);
      // Within the last digits of the event Newton has a singular Jacobian across the circle.
      if (at.status != SolveStatus::solved) continue;
      std::string text =
          describe(problem.body(), biot_log, {1.0, 4.0}, {1.0, 3.0}, Branch::iii, at);
      const SolvedMotion motion{problem, std::move(at), std::move(text)};
      const Spectrum spectrum = motion.blocks();
      const WideMotion wide = wide_motion(motion);
      expect_within_bounds(motion, spectrum, wide);
      const bool decided = expect_right_or_marginal(motion, spectrum, wide);
      // The error bound of the stretch, sqrt of a unit at the event, sees the singular Jacobian
      // too.
      if (relative > 5e-8) {
        ASSERT_EQ(motion.at.q.xi, motion.at.q.zeta) << motion.text;
        EXPECT_TRUE(decided) << motion.text << relative << spectrum;
      }
      ++circles;
      claimed += decided;
    }
  }
  EXPECT_GE(circles, 12);
  EXPECT_GE(claimed, 10);
}

/// A circle at random speeds, E'' definite or not: the second invariant counts.
TEST(StabilityNearChange, CirclesFarFromChanges) {
  support::Random random(503);
  int with_momentum = 0;
  for (const PotentialName& potential : potential_names()) {
    for (int k = 0; k < 12; ++k) {
      const Body body = random.symmetric_body();
      const double r = random.uniform(0.9, 1.6);
      const std::array<double, 2> plane{random.uniform(0.5, 2.0), random.uniform(0.5, 4.0)};
      SolveOptions options;
      options.method = Method::newton;
      options.start = Stretch{0.0, r, r, 1.0};
      const Problem problem(body, named_potential(potential, plane), Branch::iii);
      const double nu = random.sign() * random.uniform(0.1, 1.2) * std::sqrt(plane[0] / body.J1);
      Equilibrium at = solve(problem, nu, options);
      if (at.status != SolveStatus::solved || at.q.xi != at.q.zeta) continue;
      std::string text = describe(body, potential, plane, {1.0, 3.0}, Branch::iii, at);
      const SolvedMotion motion{problem, std::move(at), std::move(text)};
      const Spectrum spectrum = motion.blocks();
      const WideMotion wide = wide_motion(motion);
      expect_within_bounds(motion, spectrum, wide);
      EXPECT_TRUE(expect_right_or_marginal(motion, spectrum, wide)) << motion.text << spectrum;
      const BasicStretch<DoubleDouble> q{0.0, motion.at.q.xi, motion.at.q.zeta, motion.at.q.rho};
      for (const double side : {1.0, -1.0}) {
        const Vector3<DoubleDouble> turn{0.0, 0.0, side * nu};
        const Spectrum other =
            general_spectrum(body, problem.potential(), q, turn, uncertainty(motion.at));
        EXPECT_EQ(name(other.verdict), name(spectrum.verdict)) << motion.text << side << other;
      }
      with_momentum += spectrum.verdict == StabilityClass::stable && spectrum.negative > 0;
    }
  }
  EXPECT_GT(with_momentum, 5);
}

}  // namespace
}  // namespace stationary
