// What is claimed of modes put together, condition by condition: each is dropped by itself in what
// the collectors are given.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/leaf/circle_momentum.hpp"
#include "lib/leaf/reversible_leaf.hpp"
#include "lib/stability/enclosure_collector.hpp"
#include "lib/stability/general_spectrum.hpp"
#include "lib/stability/mode_collector.hpp"
#include "lib/stability/spectrum_enclosure.hpp"
#include "solver/solve/solve.hpp"
#include "solver/solve/stability.hpp"
#include "tests/support/bodies/whole_body.hpp"

namespace stationary {
namespace {

/// Of two modes, to be told what is proven of them.
Spectrum two_modes(double first, double second) {
  ModeCollector out;
  out.add_real(first, 1e-3, 1);
  out.add_real(second, 1e-3, 1);
  return out.finish();
}

SpectrumEnclosure proven(const RootEnclosure& first, const RootEnclosure& second, bool semisimple) {
  EnclosureCollector out;
  out.negative.add(0);
  out.add(first, 1, semisimple);
  out.add(second, 1, semisimple);
  return out.finish(two_modes(-1.5, -1.5));
}

TEST(Claims, AComplexLambdaIsApartFromTheAxis) {
  const auto complex = [](double low, double high) {
    return RootEnclosure{{Interval(-1.6, -1.4), Interval(low, high)}, true};
  };
  EXPECT_EQ(proven(complex(0.1, 0.2), complex(-0.2, -0.1), false).verdict,
            StabilityClass::oscillatory);
  EXPECT_FALSE(proven(complex(-0.1, 0.2), complex(-0.2, 0.1), false).verdict);
}

TEST(Claims, ADoubleLambdaNeedsToBeSemisimple) {
  const RootEnclosure twice{{Interval(-1.6, -1.4), 0.0}, false};
  EXPECT_EQ(proven(twice, twice, true).verdict, StabilityClass::stable);
  EXPECT_FALSE(proven(twice, twice, false).verdict);
}

/// Two that rounding has made complex stay real where no signatures can meet.
TEST(Claims, CloseRootsStayOnTheAxisWhereNothingCanMeet) {
  const Polynomial<Conditioned, 2> p{
      {Conditioned(1.0 + 1e-13, 1.0), Conditioned(2.0, 2.0), Conditioned(1.0, 1.0)}};
  const UncertainPolynomial<2> uncertain(p, 1e-12);
  const auto pair = quadratic_roots(2.0, 1.0 + 1e-13);
  ASSERT_LT(pair.separation, 0.0);
  const auto verdict = [&](bool collision_possible) {
    ModeCollector out;
    out.add_pair(pair, uncertain, collision_possible, [](double) { return 1; });
    return out.finish();
  };
  const Spectrum apart = verdict(false);
  EXPECT_EQ(apart.verdict, StabilityClass::stable);
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(apart.mode[static_cast<std::size_t>(k)].lambda_im, 0.0);
    EXPECT_NEAR(apart.mode[static_cast<std::size_t>(k)].lambda_re, -1.0, 1e-5);
  }
  EXPECT_EQ(verdict(true).verdict, StabilityClass::marginal);
}

/// A Lambda that may be positive has no signature yet, so that its neighbour has none that counts.
TEST(Claims, AnOpenSignLeavesItsNeighbourOpen) {
  for (const bool first_is_open : {true, false}) {
    ModeCollector out;
    const double error = 1e-8;
    const double lambda[2] = {first_is_open ? -1e-9 : -3e-8, first_is_open ? -3e-8 : -1e-9};
    for (const double each : lambda) out.add_real(each, error, 1, Axis::may_leave);
    const Spectrum spectrum = out.finish();
    EXPECT_EQ(spectrum.verdict, StabilityClass::marginal);
    for (int k = 0; k < 2; ++k)
      EXPECT_TRUE(spectrum.mode[static_cast<std::size_t>(k)].krein_open) << k;
  }
}

/// E'' positive, in one direction by no more than what its entries are known to.
TEST(Claims, ADefiniteFormIsSoForAllInputs) {
  Leaf leaf{};
  leaf.pairs = 5;
  constexpr std::size_t rho = 4;  // a direction the momentum's form does not see
  for (std::size_t k = 0; k < 10; ++k) {
    leaf.second_variation[k][k] = k == rho ? 1e-10 : 1.0;
    leaf.magnitude[k][k] = 1.0;
  }
  EXPECT_TRUE(definite_with_momentum(leaf, 1e-12));
  EXPECT_FALSE(definite_with_momentum(leaf, 1e-9));
  // Indefinite, and made definite by the momentum; then by no more than its entries are known to.
  leaf.second_variation[rho][rho] = 1.0;
  leaf.second_variation[0][0] = leaf.second_variation[5][5] = -0.2;
  EXPECT_TRUE(definite_with_momentum(leaf, 1e-12));
  EXPECT_FALSE(definite_with_momentum(leaf, 0.5));
}

/// B = 1 and A symmetric with eigenvalues next to each other: Lambda is within its bound of them, or
/// not given.
TEST(Claims, LambdaNextToEachOtherAreWithinTheirBoundsOrNotGiven) {
  constexpr std::size_t n = 3;
  int given = 0;
  int refused = 0;
  for (double apart = 0.25; apart > 1e-12; apart *= 0.75) {
    const std::array exact{0.7, 0.7 + apart, 0.7 + 2.3 * apart};
    ReversibleLeaf<n> leaf;
    // The reflection 1 - 2 v v^T/v^T v of v = (1, 2, 4).
    const double v[n] = {1.0, 2.0, 4.0};
    const auto Q = [&](std::size_t i, std::size_t j) {
      return DoubleDouble(i == j ? 1.0 : 0.0) - DoubleDouble(2.0 * v[i] * v[j]) / 21.0;
    };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        DoubleDouble sum(0.0);
        for (std::size_t l = 0; l < n; ++l) sum = sum + Q(i, l) * (Q(j, l) * exact[l]);
        leaf.A[i][j] = renormalized(sum);
        leaf.A_magnitude[i][j] = std::abs(leading(sum));
        leaf.B[i][j] = DoubleDouble(i == j ? 1.0 : 0.0);
        leaf.B_magnitude[i][j] = i == j ? 1.0 : 0.0;
      }
    }
    for (const double uncertainty : {0x1p-53, 1e-13, 1e-12, 1e-11, 1e-10}) {
      LeafModes<n> modes;
      if (!ReversibleProblem<n>(leaf, {false, uncertainty}).find(modes)) {
        ++refused;
        continue;
      }
      ++given;
      std::ranges::sort(modes.lambda, std::ranges::greater{}, [](auto z) { return z.real(); });
      const double error = std::ranges::max(modes.error);
      for (std::size_t l = 0; l < n; ++l)
        EXPECT_LE(std::abs(modes.lambda[l] + exact[l]), error) << apart << ", " << uncertainty;
    }
  }
  EXPECT_GT(given, 5);
  EXPECT_GT(refused, 5);
}

/// Two that coincide and do not move have no other bound than 0.
TEST(Claims, DiscsOfPointsThatDoNotMoveArePoints) {
  const auto discs = eigenvalue_discs<2>({-1.0, -1.0}, {});
  ASSERT_TRUE(discs);
  EXPECT_EQ((*discs)[0], 0.0);
  EXPECT_EQ((*discs)[1], 0.0);
}

/// A slow rotation about axis 3 in which two modes have one frequency; input: a double in S.
template <class S, class Input>
StraightState<S> slow_rotation(const Input& input) {
  StraightState<S> out{{input(1.0), input(1.0), input(0.5)},
                       input(1.25),
                       input(0.75),
                       input(1.0),
                       input(1e-12),
                       {},
                       {},
                       {},
                       {},
                       {},
                       {},
                       {}};
  out.V_aa = input(1.0);
  out.V_xx = out.V_zz = input(2.0);
  out.V_rr = input(3.0);
  out.V_xz = out.V_xr = out.V_zr = S(0.0);
  return out;
}

/// E'' positive, and two Lambda that the uncertainty does not tell apart.
TEST(Claims, ADefiniteMotionIsStableWhereItsFrequenciesMeet) {
  const BlockFacts facts{Branch::iii, false, false, 1e-13};
  const Spectrum spectrum =
      block_spectrum(facts, slow_rotation<DoubleDouble>([](double x) { return DoubleDouble(x); }),
                     slow_rotation<Conditioned>(Conditioned::input));
  EXPECT_EQ(spectrum.verdict, StabilityClass::stable);
  EXPECT_EQ(spectrum.negative, 0);
}

/// On the circle, shear unstable: Lambda = -(omega +- i W)^2, W^2 = -omega^2 - K_aa/2 J.
TEST(Claims, ACircleThatSpinsTooFastForItsShearIsOscillatory) {
  const double omega = 1.0;
  const double V_xx = 2.0;
  const double V_xz = 2.5;
  StraightState<Interval> s{{1.0, 1.0, 0.5}, 1.0, 1.0, 1.0, omega, {}, {}, {}, {}, {}, {}, {}};
  s.V_aa = 2.0 * (V_xx - V_xz);  // of every isotropic V
  s.V_xx = s.V_zz = V_xx;
  s.V_xz = V_xz;
  s.V_xr = s.V_zr = 0.0;
  s.V_rr = 3.0;
  Spectrum order;
  order.modes = 5;
  const EnclosureFacts facts{Branch::iii, false, true, true, false};
  const SpectrumEnclosure found = enclose_spectrum(facts, s, order);
  EXPECT_EQ(found.verdict, StabilityClass::oscillatory);
  EXPECT_EQ(found.negative, 2);
  const double W = std::sqrt(0.5);  // K_aa = V_aa - 2 J omega^2 = -3
  int complex = 0;
  for (const ComplexInterval& lambda : found.lambda) {
    if (lambda.im.may_be(0.0)) continue;
    ++complex;
    EXPECT_NEAR(lambda.re.mid(), W * W - omega * omega, 1e-14);
    EXPECT_NEAR(lambda.im.mid(), 2.0 * omega * W, 1e-14);
  }
  EXPECT_EQ(complex, 2);
}

/// On a long circle E'' is indefinite, and with the material momentum's it is definite while (omega +
/// Omega)/2 + omega (I3/I1 - 1) > 0: here for rho < 2. Where that is open, nothing is said.
TEST(Claims, ACircleIsStableOrEllipticOnlyWhereItsMomentumTells) {
  const auto verdict = [](const Interval& rho) {
    StraightState<Interval> s{{1.0, 1.0, 1.0}, 1.0, 1.0, rho, 1.0, {}, {}, {}, {}, {}, {}, {}};
    s.V_xx = s.V_zz = 2.0;
    s.V_xz = 1.96;
    s.V_aa = 2.0 * (s.V_xx - s.V_xz);  // Omega = 0.2
    s.V_xr = s.V_zr = 0.0;
    s.V_rr = 3.0;
    return enclose_spectrum({Branch::iii, false, true, true, false}, s, {}).verdict;
  };
  EXPECT_EQ(verdict({1.99, 1.999}), StabilityClass::stable);
  EXPECT_EQ(verdict({1.999, 2.001}), std::nullopt);
  EXPECT_EQ(verdict({2.001, 2.01}), StabilityClass::elliptic);
}

/// Bodies so long that the two forms of the odd block leave nothing of a signature in doubles. The class and the
/// negative directions of the second variation: in 60 digits.
TEST(Claims, SignaturesOfNeedlesNextToJ1EqualJ2) {
  struct Needle {
    Body body;
    Potential V;
    Branch branch;
    double nu;
    Stretch start;
    StabilityClass verdict;
    int negative;
  };
  const Body gravitating(1.43445, 1.4344510418402, 1.14482);
  const Body held_body(0.711048, 0.71104800037748, 0.761999);
  BodyModel<> planar;
  planar.elastic.plane = AnyPlane<>{Hencky<>{1.25197, 3.4282}};
  planar.volume = 0.615372;
  const Needle needles[] = {
      {gravitating,
       testing::whole_body(AnyPlane<>{Hencky<>{0.576447, 0.799011}},
                           AnyThickness<>{ReciprocalQuadratic<>{0.21094, 1.25688}}, {}, 0.35389,
                           gravitating),
       Branch::i,
       8.649387309547992e-05,
       {0.0, 0.013058450368796375, 40058.12585413502, 0.551593309066842},
       StabilityClass::stable,
       0},
      {held_body,
       testing::whole_body(AnyPlane<>{Hencky<>{0.384006, 1.21655}},
                           AnyThickness<>{Harmonic<>{4.40141, 0.377363}}, 0.531824, {}, held_body),
       Branch::i,
       0.013030828433783328,
       {0.0, 0.03339079279097232, 237.53011746549873, 0.06705366464668228},
       StabilityClass::stable,
       0},
      {Body(1.47502, 1.4750200000455, 0.322258),
       Potential(planar),
       Branch::ii,
       0.05124423166434716,
       {0.0, 65.28817826606847, 0.0893719922574447, 0.10546339353231408},
       StabilityClass::elliptic,
       2}};
  for (const Needle& each : needles) {
    const Problem problem(each.body, each.V, each.branch);
    const Equilibrium at = solve(problem, each.nu, {.start = each.start});
    ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
    const Spectrum found = stability(problem, at);
    EXPECT_EQ(found.verdict, each.verdict);
    EXPECT_EQ(found.negative, each.negative);
    EXPECT_EQ(2 * std::ranges::count(found.mode, -1, &Mode::krein), each.negative);
  }
}

/// Lambda of 1e8 beside such of 1e-10, in 80 digits: of the slow ones two are negative.
TEST(Claims, SlowModesBesideFastOnesOfANeedle) {
  const Body body(2.2079, 1.02489, 0.31667);
  const Potential V = testing::whole_body(AnyPlane<>{Hencky<>{0.107216, 0.788041}},
                                          AnyThickness<>{ReciprocalQuadratic<>{0.775668, 4.93227}},
                                          {}, 0.474596, body);
  const Problem problem(body, V, Branch::iii);
  const Equilibrium at = solve(
      problem, 1.4062899014154908e-05,
      {.start = Stretch{0.0, 100513.47636867507, 0.00011688709843915634, 0.5397707636128405}});
  ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
  const Spectrum found = stability(problem, at);
  for (const double lambda : {-4.12698333710995e-10, -2.28274108690197e-10}) {
    const bool there = std::ranges::any_of(found.mode, [&](const Mode& mode) {
      return std::abs(mode.lambda_re - lambda) <= 1e-12 * std::abs(lambda) &&
             mode.lambda_error <= 1e-4 * std::abs(lambda);
    });
    EXPECT_TRUE(there) << lambda;
  }
  EXPECT_NEAR(found.growth, 1.406289687977642e-05, 1e-16);
}

/// J1 = J2, a volume that is held: from material axes turned by theta the same motion has
/// alpha != 0, and the same spectrum.
TEST(Claims, TurnedMaterialAxesOfAHeldVolumeSeeOneSpectrum) {
  BodyModel<> model;
  model.elastic.plane = AnyPlane<>{Hencky<>{1.0, 0.6}};
  model.elastic.thickness = AnyThickness<>{ReciprocalQuadratic<>{1.0, 3.0}};
  model.volume = 1.3;
  const Potential V(model);
  const Body body(1.0, 1.0, 0.7);
  for (const Branch branch : {Branch::i, Branch::ii}) {
    const Equilibrium at = solve(Problem(body, V, branch), 0.5);
    ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
    const auto turned = [&](double theta) {
      const DoubleDouble c = cos(DoubleDouble(theta));
      const DoubleDouble s = sin(DoubleDouble(theta));
      const BasicStretch<DoubleDouble> q{c * s * (at.q.xi - DoubleDouble(at.q.zeta)),
                                         c * c * at.q.xi + s * s * at.q.zeta,
                                         s * s * at.q.xi + c * c * at.q.zeta, at.q.rho};
      const Vector3<DoubleDouble> nu(c * at.nu[0] - s * at.nu[1], s * at.nu[0] + c * at.nu[1],
                                     DoubleDouble(0.0));
      return general_spectrum(body, V, q, nu, 1e-15);
    };
    const Spectrum straight = turned(0.0);
    ASSERT_EQ(straight.modes, 4);
    for (const double theta : {0.3, 1.1, -0.8}) {
      const Spectrum other = turned(theta);
      ASSERT_EQ(other.modes, 4);
      EXPECT_EQ(other.verdict, straight.verdict);
      EXPECT_EQ(other.negative, straight.negative);
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(other.mode[k].lambda_re, straight.mode[k].lambda_re, 1e-11) << theta << k;
        EXPECT_NEAR(other.mode[k].lambda_im, straight.mode[k].lambda_im, 1e-11) << theta << k;
      }
    }
  }
}

}  // namespace
}  // namespace stationary
