// The parts of continuation on curves that are made up: error bounds at a turn and beside an
// asymptote, circles, ends, borders of a domain that a step leaps over.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "tests/support/bodies/made_up_families.hpp"
#include "tests/support/followed.hpp"

namespace stationary {
namespace {

using namespace testing;

/// The bound that a corrected point of the graph at u is given.
double bound_at(const Graph& graph, double perturbation, double u) {
  const GraphFamily family(graph, perturbation);
  const Corrector<2> corrector(family, 1.0, Circle::none);
  const ArcVector<2> ahead = ArcVector<2>(1.0, 0.0, graph.slope(u)).normalized();
  const Corrected<2> found = corrector.correct({std::exp(u), 1.0}, graph.value(u), ahead, 0.1);
  EXPECT_EQ(found.status, CorrectorStatus::converged) << u;
  EXPECT_TRUE(found.point.at_turn);
  return found.point.error_bound;
}

/// p = 1 - k u^2/2: where p is off by D its point is off by sqrt(2 D/k).
TEST(MadeUpCurve, TheBoundAtATurnIsThatOfTheParabola) {
  for (const double k : {0.3, 1.0, 20.0}) {
    const Graph parabola{[k](double u) { return 1.0 - 0.5 * k * u * u; },
                         [k](double u) { return -k * u; }};
    for (const double perturbation : {0.0, 1e-15, 1e-12, 1e-9}) {
      const double off = std::sqrt(2.0 * (perturbation + 0x1p-54) / k);
      const double bound = bound_at(parabola, perturbation, 0.0);
      EXPECT_GE(bound, off) << k << " " << perturbation;
      EXPECT_LE(bound, 8.0 * off) << k << " " << perturbation;
    }
  }
}

/// p = 1 - e^-u: where p is off by D, u is off by -ln(1 - D e^u), and by any amount from D e^u = 1 on.
TEST(MadeUpCurve, TheBoundBesideAnAsymptoteHolds) {
  const Graph asymptote{[](double u) { return 1.0 - std::exp(-u); },
                        [](double u) { return std::exp(-u); }};
  int finite = 0;
  int infinite = 0;
  for (double slope = 1e-2; slope > 5e-17; slope *= 0.8) {
    for (const double perturbation : {0.0, 0x1p-53, 0x1p-52, 0x1p-50, 0x1p-46}) {
      const double share = (perturbation + 0x1p-54) / slope;
      const double off =
          share < 1.0 ? -std::log1p(-share) : std::numeric_limits<double>::infinity();
      const double bound = bound_at(asymptote, perturbation, -std::log(slope));
      EXPECT_GE(bound, off) << slope << " " << perturbation;
      (std::isfinite(bound) ? finite : infinite)++;
      if (share < 1e-3) {
        EXPECT_LE(bound, 8.0 * off + 0x1p-50) << slope << " " << perturbation;
      }
    }
  }
  EXPECT_GT(finite, 300);
  EXPECT_GT(infinite, 20);
}

/// The end of the range is a row of it or none: where the curve has no point there, that is said.
TEST(MadeUpCurve, AnEndOfTheRangeThatIsNotReachedIsNotClaimed) {
  const Graph graph{[](double u) { return u; },
                    [](double u) {
                      return std::abs(u - 1.0) < 1e-9 ? std::numeric_limits<double>::quiet_NaN()
                                                      : 1.0;
                    }};
  const GraphFamily family(graph, 1e-16);
  Kept kept;
  const FollowReport report =
      follow_family<2>(family, {0.0, 1.0, 1.0, 1.0}, 0.0, range(0.0, 1.0), kept);
  EXPECT_EQ(report.forward.event, EventType::stalled) << report.forward.reason;
  for (const FollowedRow& row : kept.rows) EXPECT_LT(row.member.parameter, 1.0);
}

/// Beyond its end a curve is not stepped along.
TEST(MadeUpCurve, NoStepIsTakenBeyondTheEnd) {
  const LineFamily family{Line()};
  const Curve<2> curve(family, 1.0, Circle::none);
  const Corrected<2> start = curve.corrector().correct_at({1.0, 1.0}, 0.0, {1.0, 1.0, 1.0});
  ASSERT_EQ(start.status, CorrectorStatus::converged);
  ContinuationOptions options;
  Continuation<2> sheet(curve, curve.complete(start.point), 1, options);
  int steps = 0;
  while (sheet.end() == EventType::none && steps < 1000) {
    ASSERT_TRUE(sheet.step());
    ++steps;
  }
  EXPECT_EQ(sheet.end(), EventType::limit);
  EXPECT_EQ(sheet.point().arc.p, 1.0);
  const long counted = sheet.counts().steps;
  for (int k = 0; k < 3; ++k) {
    EXPECT_FALSE(sheet.step());
    EXPECT_EQ(sheet.point().arc.p, 1.0);
    EXPECT_EQ(sheet.counts().steps, counted);
  }
}

/// u^2 + (p - 1/2)^2 = r^2 of u = ln xi, zeta = 1.
class CircleFamily final : public Family<2> {
 public:
  static constexpr double radius = 0.2;
  Branch branch() const override { return Branch::iii; }
  bool along_nu() const override { return true; }
  bool material_symmetry() const override { return false; }
  FamilyLinearization<2> linearize(const ReducedVector<2>& x, double p) const override {
    FamilyLinearization<2> out;
    const double u = std::log(x[0]);
    out.g << u * u + (p - 0.5) * (p - 0.5) - radius * radius, std::log(x[1]);
    out.jacobian << 2.0 * u, 0.0, 0.0, 1.0;
    out.slope << 2.0 * (p - 0.5), 0.0;
    out.nu_slope = out.slope;
    return out;
  }
  Refined refine_at(ReducedVector<2>&, ReducedVector<2>&, double) const override { return {}; }
  ReducedVector<2> extended_residual(const ReducedVector<2>& x, double p) const override {
    return linearize(x, p).g;
  }
  ReducedVector<2> input_perturbation(const ReducedVector<2>&, double) const override {
    return {1e-16, 0.0};
  }
  Member member(const ReducedVector<2>& x, const ReducedVector<2>&, double p,
                double error_bound) const override {
    Member out;
    out.parameter = out.nu = p;
    out.body = Body(1.0, 2.0, 40.0);
    out.q = {0.0, x[0], x[1], 1.0};
    out.error_bound = error_bound;
    return out;
  }
};

/// A closed sheet is gone round once: its rows are all of it, and each of its two turns is met once, wherever it
/// begins between them.
TEST(MadeUpCurve, AClosedSheetIsGoneRoundOnce) {
  const CircleFamily family;
  for (const double angle :
       {0.5, 0.003, 0.01, 0.03, 0.06, 0.1, 0.94, 0.97, 0.99, -0.003, -0.03, -0.97}) {
    Kept kept;
    const double phi = angle * std::numbers::pi;
    const double x = std::exp(CircleFamily::radius * std::sin(phi));
    const double p = 0.5 + CircleFamily::radius * std::cos(phi);
    const FollowReport report =
        follow_family<2>(family, {0.0, x, 1.0, 1.0}, p, range(0.0, 1.0), kept);
    ASSERT_EQ(report.failure, "") << angle;
    EXPECT_EQ(report.backward.event, EventType::closed) << angle;
    EXPECT_EQ(report.forward.event, EventType::closed) << angle;
    double turned = 0.0;
    const auto place = [](const FollowedRow& row) {
      return std::array{std::log(row.member.q.xi), row.member.parameter - 0.5};
    };
    bool on_and_on = true;
    for (std::size_t k = 1; k < kept.rows.size(); ++k) {
      const auto [a, b] = place(kept.rows[k - 1]);
      const auto [c, d] = place(kept.rows[k]);
      const double turn = std::asin(
          std::clamp((a * d - b * c) / (CircleFamily::radius * CircleFamily::radius), -1.0, 1.0));
      on_and_on = on_and_on && (turned == 0.0 || turn * turned > 0.0);
      turned += turn;
    }
    EXPECT_TRUE(on_and_on) << angle;
    EXPECT_NEAR(std::abs(turned), 2.0 * std::numbers::pi, 1e-6) << angle;
    const auto folds = std::ranges::count(report.events, EventType::fold_nu, &EventRecord::type);
    EXPECT_EQ(folds, 2) << angle;
  }
}

/// The guard of a line on which condition(p) > 0 is asked for, entered at p = 0.
class Guarded {
 public:
  explicit Guarded(const std::function<double(double)>& condition) : family_(line(condition)) {
    start_.x.setOnes();
    start_.p = 0.0;
    guard_.enter(start_);
  }
  const DomainGuard<2>& guard() const { return guard_; }
  ArcPoint<2> at(double p) const {
    ArcPoint<2> out = start_;
    out.p = p;
    return out;
  }

 private:
  static Line line(const std::function<double(double)>& condition) {
    Line out;
    out.condition = condition;
    return out;
  }

  LineFamily family_;
  Curve<2> curve_{family_, 1.0, Circle::none};
  DomainGuard<2> guard_{curve_};
  ArcPoint<2> start_;
};

/// A point so near to a border that rounding could have it on either side is not inside: of what must
/// be positive and of what must not be 0, in each coordinate, from both sides.
TEST(DomainGuardTest, APointWithinSomeUnitsOfABorderIsNotInside) {
  const expression::TapeCondition positive{"x > 0", true};
  const expression::TapeCondition nonzero{"x != 0", false};
  int asked = 0;
  for (const auto* condition : {&positive, &nonzero}) {
    for (const int k : {0, 1}) {
      for (const double side : {1.0, -1.0}) {
        for (const double value : {1.0, -1.0}) {
          if (condition->positive && value < 0.0) continue;
          DomainGuard<2> guard(
              [&](const ReducedVector<2>& x, double) {
                return std::vector<ConditionValue>{{condition, value * side * (x[k] - 1.0)}};
              },
              1.0);
          ArcPoint<2> point;
          point.p = 0.0;
          const auto at = [&](double inside) {
            point.x.setOnes();
            point.x[k] += side * inside;
            return point;
          };
          guard.enter(at(0.1));
          EXPECT_TRUE(guard.has(at(0.2)));
          EXPECT_TRUE(guard.has(at(0x1p-40)));
          EXPECT_FALSE(guard.has(at(0x1p-50)));
          EXPECT_FALSE(guard.has(at(0.0)));
          EXPECT_FALSE(guard.has(at(-0x1p-40)));
          EXPECT_FALSE(guard.has(at(-0.2)));
          ++asked;
        }
      }
    }
  }
  EXPECT_EQ(asked, 12);
}

/// A condition that fails in the middle of an arc and holds at every place it is looked at first.
TEST(MadeUpCurve, AnArcIsSeenToDipBelowABorder) {
  const ArcVector<2> chord(1.0, 1.0, 1.0);
  const ArcVector<2> direction = chord.normalized();
  const Arc<2> arc(chord, direction, direction);
  for (const double at : {0.15, 0.34, 0.4, 0.6, 0.62, 0.85}) {
    for (const double wide : {-1e-3, 1e-3, 1e-2}) {
      const Guarded guarded(
          [&](double p) { return (p - at) * (p - at) - std::copysign(wide * wide, wide); });
      ASSERT_TRUE(guarded.guard().watches());
      EXPECT_EQ(guarded.guard().broken_on(arc) != nullptr, wide > 0.0) << at << " " << wide;
    }
  }
}

TEST(MadeUpCurve, APointBeyondABorderIsNotInside) {
  const Guarded guarded([](double p) { return 0.5 - p; });
  ASSERT_TRUE(guarded.guard().watches());
  EXPECT_TRUE(guarded.guard().has(guarded.at(0.0)));
  EXPECT_TRUE(guarded.guard().has(guarded.at(0.5 - 1e-9)));
  EXPECT_FALSE(guarded.guard().has(guarded.at(0.5 + 1e-9)));
}

/// Three unknowns, G of rows that are divided by sizes of their own.
class ThreeRows final : public Family<3> {
 public:
  Branch branch() const override { return Branch::iii; }
  bool along_nu() const override { return true; }
  bool material_symmetry() const override { return true; }
  FamilyLinearization<3> linearize(const ReducedVector<3>& x, double p) const override {
    FamilyLinearization<3> out;
    const double u = std::log(x[0]);
    const double v = std::log(x[1]);
    const double w = std::log(x[2]);
    out.g << 3.0 * u + v + 0.5 * w - p, u + 3.0 * v + 0.5 * w - p,
        0.1 * (u + v) + 0.4 * w - 0.2 * p;
    out.jacobian << 3.0, 1.0, 0.5, 1.0, 3.0, 0.5, 0.1, 0.1, 0.4;
    out.slope << -1.0, -1.0, -0.2;
    out.nu_slope = out.slope;
    return out;
  }
  Refined refine_at(ReducedVector<3>&, ReducedVector<3>&, double) const override { return {}; }
  ReducedVector<3> extended_residual(const ReducedVector<3>& x, double p) const override {
    return linearize(x, p).g;
  }
  ReducedVector<3> input_perturbation(const ReducedVector<3>&, double) const override {
    return ReducedVector<3>::Zero();
  }
  Member member(const ReducedVector<3>&, const ReducedVector<3>&, double, double) const override {
    return {};
  }
};

/// On the circle no more than the difference of the two stretches is left out of the Jacobian.
TEST(MadeUpCurve, TheJacobianOfACircleActsAsTheWholeOne) {
  const ThreeRows family;
  const Corrector<3> corrector(family, 1.0, Circle::xi_zeta);
  const ReducedVector<3> x(1.2, 1.2, 0.9);
  const auto whole = family.linearize(x, 0.4).jacobian;
  const auto kept = corrector.linearize(x, 0.4).jacobian;
  for (const ReducedVector<3>& along :
       {ReducedVector<3>(1.0, 1.0, 0.0), ReducedVector<3>(0.0, 0.0, 1.0)})
    EXPECT_LE((kept * along - whole * along).cwiseAbs().maxCoeff(), 1e-15);
  const ReducedVector<3> apart(1.0, -1.0, 0.0);
  EXPECT_LE((kept * apart - apart).cwiseAbs().maxCoeff(), 1e-15);
}

}  // namespace
}  // namespace stationary
