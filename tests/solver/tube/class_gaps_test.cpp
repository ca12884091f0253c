// Where the class of a motion is not proven: the points where it changes, and not much besides; and
// between them the classes of searches.
#include "solver/tube/class_gaps.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "solver/search/anisotropic_search.hpp"
#include "solver/solve/stability.hpp"
#include "solver/tube/curve_cover.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/covers.hpp"

namespace stationary::testing {
namespace {

/// x = a + b q + c q^2, as ln xi or as ln rho.
class PlacedParabola final : public CurveEquations<1> {
 public:
  PlacedParabola(double a, double b, double c, bool is_thickness)
      : a_(a), b_(b), c_(c), is_thickness_(is_thickness) {}

  CurveLinearized<1> linearize(const CurveBox<1>& y) const override {
    CurveLinearized<1> out;
    out.g = {y[0] - Interval(a_) - b_ * y[1] - c_ * square(y[1])};
    out.slope[0] = {Interval(1.0), -Interval(b_) - (2.0 * c_) * y[1]};
    return out;
  }
  void place(const CurveCoordinates<1>& y, PlacedMotions& motions) const override {
    (is_thickness_ ? motions.rho : motions.xi) = exp(y[0]);
  }

 private:
  double a_;
  double b_;
  double c_;
  bool is_thickness_;
};

/// All of a curve over q in [0, 1].
struct Covered {
  PlacedParabola equations;
  CurveRegion<1> region;
  std::unique_ptr<ProvenCurvesOf<1>> curves;

  Covered(double a, double b, double c, bool is_thickness) : equations(a, b, c, is_thickness) {
    region.lower = {Interval(-5.0)};
    region.upper = {Interval(5.0)};
    region.q = {0.0, 1.0};
    curves = std::make_unique<ProvenCurvesOf<1>>(equations, region, TubeOptions{});
    const CurveCover cover = cover_curves(equations, region, CoverOptions{}, curves->set());
    EXPECT_TRUE(cover.undecided.empty());
  }
};

/// Stable where f(xi, rho, nu) < 0, unstable where it is > 0.
ClassOver by_sign(const std::function<Sloped(const Sloped&, const Sloped&, const Sloped&)>& f) {
  return [f](const MotionArc& arc) -> std::optional<StabilityClass> {
    const auto sloped = [&](const Interval& over, const Interval& at, const Interval& slope) {
      return arc.has_slopes ? Sloped(over, at, slope) : Sloped(over);
    };
    const Interval value =
        range(f(sloped(arc.over.stretches.xi, arc.at.stretches.xi, arc.stretch_slope.xi),
                sloped(arc.over.stretches.rho, arc.at.stretches.rho, arc.stretch_slope.rho),
                sloped(arc.over.nu, arc.at.nu, arc.nu_slope)));
    if (value.positive()) return StabilityClass::unstable;
    if (value.negative()) return StabilityClass::stable;
    return std::nullopt;
  };
}

TEST(ClassGaps, AreWhereTheClassChanges) {
  std::vector<std::vector<std::unique_ptr<ProvenCurves>>> factors(1);
  Covered covered(0.0, 1.0, 0.0, false);
  factors[0].push_back(std::move(covered.curves));
  // xi = e^q passes 2 at q = ln 2.
  const ClassGaps found = class_gaps(
      factors, by_sign([](const Sloped& xi, const Sloped&, const Sloped&) { return xi - 2.0; }),
      1.0, 10'000);
  ASSERT_EQ(found.gaps.size(), 1U);
  EXPECT_TRUE(found.gaps[0].may_be(std::log(2.0)) ||
              std::abs(found.gaps[0].mid() - std::log(2.0)) < 1e-15);
  EXPECT_LT(found.gaps[0].width(), 1e-12);
  EXPECT_LT(found.arcs, 1000);
}

/// Tubes run on beyond the range: what is inferred from an arc's middle has a motion there.
TEST(ClassGaps, AChangeJustBeforeTheEndOfTheRangeIsSeen) {
  for (const double before : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    std::vector<std::vector<std::unique_ptr<ProvenCurves>>> factors(1);
    Covered covered(0.0, 1.0, 0.0, false);
    factors[0].push_back(std::move(covered.curves));
    // xi = e^q, q = nu^2: 2/e xi - q passes c once, at q = 1 - before.
    const double c = 2.0 * std::exp(-before) - (1.0 - before);
    const ClassOver of_sign = by_sign([&](const Sloped& xi, const Sloped&, const Sloped& nu) {
      return (2.0 / std::exp(1.0)) * xi - square(nu) - Sloped(c);
    });
    const ClassGaps found = class_gaps(
        factors,
        [&](const MotionArc& arc) {
          if (arc.has_slopes) {
            EXPECT_FALSE(log(arc.at.stretches.xi).apart_from(square(arc.at.nu)))
                << "no motion at " << arc.at.nu.mid();
          }
          return of_sign(arc);
        },
        1.0, 10'000);
    ASSERT_EQ(found.gaps.size(), 1U) << before;
    EXPECT_NEAR(found.gaps[0].mid(), 1.0 - before, 1e-11);
  }
}

/// A motion's thickness is a curve of its own; nu is of both.
TEST(ClassGaps, OfFactorsTogether) {
  std::vector<std::vector<std::unique_ptr<ProvenCurves>>> factors(2);
  Covered plane(0.0, 0.5, 0.25, false);
  Covered across(0.2, -0.4, 0.0, true);
  factors[0].push_back(std::move(plane.curves));
  factors[1].push_back(std::move(across.curves));
  const auto f = [](const Sloped& xi, const Sloped& rho, const Sloped& nu) {
    return xi / rho - Sloped(2.0 * std::exp(0.5)) * square(nu);
  };
  // 0.5 q + q^2/4 - 0.2 + 0.4 q = 0.5 + ln 2 q
  double q = 0.3;
  for (int k = 0; k < 50; ++k)
    q -= (0.25 * q * q + 0.9 * q - 0.7 - std::log(2.0 * q)) / (0.5 * q + 0.9 - 1.0 / q);
  const ClassGaps found = class_gaps(factors, by_sign(f), 1.0, 100'000);
  ASSERT_EQ(found.gaps.size(), 1U);
  EXPECT_NEAR(found.gaps[0].mid(), q, 1e-12);
  EXPECT_LT(found.gaps[0].width(), 1e-11);
}

TEST(ClassGaps, OfAClassNeverProvenAreTheWholeRange) {
  std::vector<std::vector<std::unique_ptr<ProvenCurves>>> factors(1);
  Covered covered(0.0, 1.0, 0.0, false);
  factors[0].push_back(std::move(covered.curves));
  const ClassGaps found = class_gaps(
      factors, [](const MotionArc&) -> std::optional<StabilityClass> { return std::nullopt; }, 1.0,
      500);
  ASSERT_EQ(found.gaps.size(), 1U);
  EXPECT_LE(found.gaps[0].lo, 0.0);
  EXPECT_GE(found.gaps[0].hi, 1.0);
  EXPECT_EQ(found.arcs, 500);
  std::atomic<bool> stop{true};
  EXPECT_TRUE(class_gaps(factors, {}, 1.0, 500, &stop).interrupted);
}

/// At several nu between two gaps as many motions of each class, by the spectrum of each.
int parts_of_one_mixture(const Problem& problem, double to) {
  const KindCover cover = cover_axis(problem, 0.0, to, {});
  if (!cover.class_gaps) {
    ADD_FAILURE() << "no classes";
    return 0;
  }
  std::vector<Interval> gaps = *cover.class_gaps;
  for (const NuGap& each : cover.gaps) gaps.push_back(each.nu);
  std::ranges::sort(gaps, {}, &Interval::lo);
  double open = 0.0;
  for (const Interval& each : gaps) open += each.width();
  EXPECT_LT(open, 1e-6 * to);
  int out = 0;
  double begin = 0.0;
  gaps.emplace_back(to);
  for (const Interval& gap : gaps) {
    const double length = gap.lo - begin;
    if (length > 1e-5) {
      std::vector<std::map<StabilityClass, int>> mixtures;
      for (const double part : {0.02, 0.3, 0.6, 0.98}) {
        const double nu = begin + part * length;
        mixtures.emplace_back();
        for (const Equilibrium& each : search(problem, nu).solutions)
          if (is_counted(problem, each.q)) ++mixtures.back()[stability(problem, each).verdict];
      }
      for (const auto& each : mixtures)
        EXPECT_EQ(each, mixtures.front()) << "from nu = " << begin << " to " << gap.lo;
      ++out;
    }
    begin = std::max(begin, gap.hi);
  }
  return out;
}

TEST(ClassGaps, LeaveTheClassesOfSearchesBetween) {
  const Potential potentials[] = {
      Potential(ReciprocalDeterminant<>{1.0, 2.0}, plate_thickness),
      Potential(BiotLog<>{1.0, 0.6}, plate_thickness),
      Potential(Hencky<>{1.1, 0.8}, plate_thickness),
      Potential(SaintVenantKirchhoff<>{1.0, 0.5}, plate_thickness),
      Potential(NeoHookean3d<>{1.0, 2.0}),
  };
  int parts = 0;
  for (const Potential& V : potentials)
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii})
      parts += parts_of_one_mixture({plate, V, branch}, 1.2);
  EXPECT_GE(parts, 20);
}

TEST(ClassGaps, OfRoundBodies) {
  const Body round{1.0, 1.0, 0.6};
  int parts = 0;
  for (const Branch branch : {Branch::i, Branch::iii})
    parts +=
        parts_of_one_mixture({round, Potential(BiotLog<>{1.0, 4.0}, plate_thickness), branch}, 1.5);
  EXPECT_GE(parts, 4);
}

/// Of a fibred body slopes are of no use: less is decided, but some, and it is what the spectra say.
TEST(ClassGaps, OfAFibredBody) {
  const AnisotropicPotential V(NeoHookean<>{1.0, 1.5}, plate_thickness, {{0.3, 0.0}});
  const Problem problem(plate, Potential(V), Branch::i);
  const double from = 0.1;
  const double to = 0.6;
  const auto cover = cover_oriented(problem, false, from, to, {});
  ASSERT_TRUE(cover.has_value() && cover->class_gaps.has_value());
  std::vector<Interval> gaps = *cover->class_gaps;
  for (const NuGap& each : cover->gaps) gaps.push_back(each.nu);
  gaps.emplace_back(to);
  std::ranges::sort(gaps, {}, &Interval::lo);
  double begin = from;
  double decided = 0.0;
  for (const Interval& gap : gaps) {
    if (gap.lo - begin > 1e-3) {
      decided += gap.lo - begin;
      std::vector<StabilityClass> first;
      for (const double part : {0.1, 0.5, 0.9}) {
        const double nu = begin + part * (gap.lo - begin);
        std::vector<StabilityClass> classes;
        for (const Equilibrium& each : search_anisotropic(problem, nu, {}).solutions)
          classes.push_back(stability(problem, each).verdict);
        std::ranges::sort(classes);
        if (first.empty()) first = classes;
        EXPECT_EQ(classes, first) << "nu = " << nu;
      }
    }
    begin = std::max(begin, gap.hi);
  }
  EXPECT_GT(decided, 0.5 * (to - from));
}

/// No classes where none are asked for.
TEST(ClassGaps, AreNotLookedForWithoutNeed) {
  const Problem problem(plate, Potential(ReciprocalDeterminant<>{1.0, 2.0}, plate_thickness),
                        Branch::i);
  const KindCover cover = cover_axis(problem, 0.0, 1.0, {}, /*classes=*/false);
  EXPECT_FALSE(cover.class_gaps.has_value());
  EXPECT_EQ(cover.class_arcs, 0);
}

}  // namespace
}  // namespace stationary::testing
