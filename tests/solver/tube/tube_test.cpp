// Tubes prove pieces of curves and nothing else: against closed forms, through a fold, and against
// tubes that are none.
#include "solver/tube/tube.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>

#include "solver/search/search.hpp"
#include "solver/tube/axis_curves.hpp"
#include "solver/tube/tube_set.hpp"
#include "tests/support/bodies/plate.hpp"

namespace stationary {
namespace {

using testing::plate;
using testing::plate_thickness;

/// The plane of a separable body's spin, nu_end = to.
CurveSet<2> plane_of(const Problem& problem, double to) {
  auto factors = axis_curves(problem, 0.0, to, {});
  return std::move(std::get<CurveSet<2>>(factors.at(1).sets.at(0)));
}

Problem disc() {
  return {plate, Potential(ReciprocalDeterminant<>{1.0, 2.0}, plate_thickness), Branch::i};
}

/// (ln xi, ln zeta, q) of `disc` at nu, in closed form.
TubePoint<2> on_disc(double nu, double to) {
  const double A1 = 2.0;
  const double A2 = 2.0 - plate.J2 * nu * nu;
  return {0.25 * std::log(std::sqrt(A2) * std::pow(A1, -1.5)),
          0.25 * std::log(std::sqrt(A1) * std::pow(A2, -1.5)), nu * nu / (to * to)};
}

CurveBox<2> about(const TubePoint<2>& y, double radius) {
  CurveBox<2> out;
  for (int i = 0; i < 3; ++i) out[std::size_t(i)] = {y[i] - radius, y[i] + radius};
  return out;
}

TEST(Tubes, HoldTheClosedForm) {
  const double to = 1.05;
  const CurveSet<2> curves = plane_of(disc(), to);
  TubeSet<2> tubes(*curves.equations, curves.region);
  ASSERT_TRUE(tubes.follow(on_disc(0.5, to)));
  EXPECT_TRUE(tubes.stuck().empty());
  for (int k = 0; k <= 200; ++k) {
    const TubePoint<2> y = on_disc(to * k / 200.0, to);
    EXPECT_TRUE(tubes.holds(about(y, 1e-12))) << k;
  }
  // The same curve is not followed twice.
  EXPECT_FALSE(tubes.follow(on_disc(0.9, to)));
}

TEST(Tubes, SlicesHoldTheClosedFormAndItsSlope) {
  const double to = 1.05;
  const CurveSet<2> curves = plane_of(disc(), to);
  const TubePoint<2> y0 = on_disc(0.5, to);
  const TubePoint<2> tangent = (on_disc(0.5 + 1e-6, to) - on_disc(0.5 - 1e-6, to)).normalized();
  const auto tube = Tube<2>::proven(*curves.equations, y0, tangent, 0.05);
  ASSERT_TRUE(tube);
  int met = 0;
  for (double s = -0.045; s < 0.05; s += 0.01) {
    const auto slice = tube->slice(*curves.equations, {s - 1e-3, s + 1e-3});
    EXPECT_LT(slice.y[2].width(), 1e-2);
    const double nu = to * std::sqrt(slice.y[2].mid());
    const TubePoint<2> exact = on_disc(nu, to);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(slice.y[std::size_t(i)].may_be(exact[i]));
    const TubePoint<2> slope = on_disc(nu + 1e-6, to) - on_disc(nu - 1e-6, to);
    const Interval ratio = slice.velocity[1] / slice.velocity[2];
    EXPECT_NEAR(ratio.mid(), slope[1] / slope[2], 1e-2);
    ++met;
  }
  EXPECT_EQ(met, 10);
}

/// q + q^2/2 = k x.
class Parabola final : public CurveEquations<1> {
 public:
  static constexpr double k = 0.8;
  CurveLinearized<1> linearize(const CurveBox<1>& y) const override {
    CurveLinearized<1> out;
    out.g = {y[1] + 0.5 * square(y[1]) - k * y[0]};
    out.slope[0] = {Interval(-k), Interval(1.0) + y[1]};
    return out;
  }
};

/// However much it bends within one. The tangent is mostly along x, so x is linear in s.
TEST(Tubes, SlicesOfAParabolaHoldEverySlope) {
  const Parabola parabola;
  constexpr double k = Parabola::k;
  const double per_s = 1.0 / std::hypot(1.0, k);
  double longest = 0.0;
  for (double h = 0.05; h < 1.0; h += 0.01) {
    const auto tube = Tube<1>::proven(parabola, {0.0, 0.0}, {per_s, k * per_s}, h);
    if (!tube) break;
    longest = h;
    for (const double half : {0.2 * h, 0.6 * h, h}) {
      for (double middle = half - h; middle <= h - half; middle += 0.1 * h) {
        const auto slice = tube->slice(parabola, {middle - half, middle + half});
        for (const double at : {-0.9999, -0.5, 0.0, 0.5, 0.9999}) {
          const double x = per_s * (middle + at * half);
          const double root = std::sqrt(1.0 + 2.0 * k * x);
          EXPECT_TRUE(slice.y[0].may_be(x)) << h << " " << half << " " << middle << " " << at;
          EXPECT_TRUE(slice.y[1].may_be(root - 1.0))
              << h << " " << half << " " << middle << " " << at;
          EXPECT_TRUE(slice.velocity[1].may_be(per_s * k / root))
              << h << " " << half << " " << middle << " " << at;
        }
      }
    }
  }
  EXPECT_GT(longest, 0.2);
}

/// x = a + r x has |x| = |a|/(1 - r) at most.
TEST(Tubes, ASlopeIsBoundedByWhatItsEquationLeaves) {
  using Real50 = boost::multiprecision::cpp_bin_float_50;
  for (const double along : {1e-3, 0.7, 13.0}) {
    for (const double rest : {0.0, 1e-9, 0.3, 0.89}) {
      const Real50 exact = Real50(along) / (1 - Real50(rest));
      const double bound = fixed_point_bound(along, rest);
      EXPECT_GE(Real50(bound), exact) << along << " " << rest;
      EXPECT_LE(Real50(bound), exact * (1 + Real50(0x1p-49))) << along << " " << rest;
    }
  }
}

TEST(Tubes, PassTheFoldOfHencky) {
  const double to = 1.0;
  const Problem problem(plate, Potential(Hencky<>{1.1, 0.8}, plate_thickness), Branch::i);
  const CurveSet<2> curves = plane_of(problem, to);
  TubeSet<2> tubes(*curves.equations, curves.region);
  ASSERT_TRUE(tubes.follow({0.0, 0.0, 0.01}));
  EXPECT_TRUE(tubes.stuck().empty());
  // zeta = sqrt e, nu^2 = 2 mu (mu + lambda)/((2 mu + lambda) e J2), and G_xi = 0 there.
  const double mu = 1.1;
  const double lambda = 0.8;
  const double q = 2.0 * mu * (mu + lambda) / ((2.0 * mu + lambda) * std::numbers::e * plate.J2);
  const TubePoint<2> fold{-0.5 * lambda / (2.0 * mu + lambda), 0.5, q};
  EXPECT_TRUE(tubes.holds(about(fold, 1e-12)));
}

TEST(FakeTubes, ShiftedAreRefused) {
  const double to = 1.05;
  const CurveSet<2> curves = plane_of(disc(), to);
  const TubePoint<2> y0 = on_disc(0.5, to);
  const TubePoint<2> tangent = (on_disc(0.5 + 1e-6, to) - on_disc(0.5 - 1e-6, to)).normalized();
  constexpr double h = 1e-5;
  constexpr double radius = 1e-7;
  EXPECT_TRUE(Tube<2>::claimed(*curves.equations, y0, tangent, h, radius));
  for (int i = 0; i < 2; ++i) {
    for (const double shift : {1e-6, -1e-6}) {
      TubePoint<2> shifted = y0;
      shifted[i] += shift;
      EXPECT_FALSE(Tube<2>::claimed(*curves.equations, shifted, tangent, h, radius));
    }
  }
}

TEST(FakeTubes, ThatJumpBetweenNearlyDegenerateSheetsAreRefused) {
  const Problem problem(
      {1.046, 0.972, 0.234},
      Potential(NeoHookean<>{0.0525, 2.3792}, ReciprocalQuadratic<>{0.591, 1.917}), Branch::iii);
  const double to = 1.0;
  const CurveSet<2> curves = plane_of(problem, to);
  const double nu = 0.35;
  const SearchResult two = search(problem, nu);
  ASSERT_EQ(two.solutions.size(), 2U);
  std::array<TubePoint<2>, 2> y;
  std::array<std::optional<Tube<2>>, 2> tube;
  for (std::size_t k = 0; k < 2; ++k) {
    const Stretch& q = two.solutions[k].q;
    y[k] = {std::log(q.xi), std::log(q.zeta), nu * nu};
    const TubePoint<2> tangent = tangent_of<2>(curves.equations->linearize(point_box<2>(y[k])));
    tube[k] = Tube<2>::proven(*curves.equations, y[k], tangent, 1e-3);
    ASSERT_TRUE(tube[k]) << k;
  }
  const CurveEquations<2>& G = *curves.equations;
  EXPECT_FALSE(glued(G, *tube[0], 1e-3, *tube[1]));
  EXPECT_FALSE(glued(G, *tube[0], -1e-3, *tube[1]));
  // A next one of the same sheet is.
  const TubePoint<2> end = middle_of<2>(tube[0]->slice(G, Interval(1e-3)).y);
  const auto next = Tube<2>::proven(G, end, tube[0]->tangent(), 1e-3);
  ASSERT_TRUE(next);
  EXPECT_TRUE(glued(G, *tube[0], 1e-3, *next));
  // One drawn straight from sheet to sheet.
  const TubePoint<2> across = y[1] - y[0];
  const TubePoint<2> half = 0.5 * (y[0] + y[1]);
  EXPECT_FALSE(Tube<2>::proven(G, half, across.normalized(), 0.5 * across.norm()));
}

/// 1/(x - q): its sign changes where x = q, and it vanishes nowhere.
class Pole final : public CurveEquations<1> {
 public:
  CurveLinearized<1> linearize(const CurveBox<1>& y) const override {
    const Interval g = Interval(1.0) / (y[0] - y[1]);
    CurveLinearized<1> out;
    out.g = {g};
    out.slope[0] = {-square(g), square(g)};
    return out;
  }
};

TEST(FakeTubes, ThroughAPoleAreRefused) {
  const Pole pole;
  const double side = 1.0 / std::numbers::sqrt2;
  for (const double offset : {0.0, 1e-9, 1e-3})
    for (const double h : {1e-6, 1e-3, 0.1})
      EXPECT_FALSE(Tube<1>::proven(pole, {0.5 + offset, 0.5}, {side, side}, h)) << offset;
}

}  // namespace
}  // namespace stationary
