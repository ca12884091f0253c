// The walk along the rest state's sheet: it arrives, passes folds, keeps the circle, and never
// changes sheets.
#include "solver/continuation/rest_walk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <typeinfo>
#include <utility>

#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/closed_forms.hpp"

namespace stationary {
namespace {

template <class Model>
WalkResult<2> walk(const Model& model, double rate_xi, double rate_zeta,
                   const WalkOptions& options = {}, const std::atomic<bool>* stop = nullptr) {
  const PlanarSystem<Model> system{model, {rate_xi, rate_zeta, 0.0}};
  const double r = model.rest_stretch();
  return RestWalk<PlanarSystem<Model>>(system, {r, r}, options).run(stop);
}

WalkOptions with_steps(double first, double max_angle) {
  WalkOptions out;
  out.step.first = first;
  out.step.max_angle = max_angle;
  return out;
}
/// So short that no path is mistaken: what the walk's own steps are held against.
WalkOptions short_steps() {
  WalkOptions out = with_steps(1e-3, 0.05);
  out.step.max = 0.05;
  return out;
}

/// (iii) of a nearly round plate: a circle-to-ellipse pitchfork broken into two sheets that almost
/// touch at nu = 0.21.
struct NearlyDegenerate {
  static constexpr NeoHookean<> model{0.0525, 2.3792};
  static constexpr double J1 = 1.046;
  static constexpr double J2 = 0.972;
  /// J1 nu^2 = mu, where xi of the rest sheet escapes.
  static double end() { return std::sqrt(model.mu / J1); }
  static WalkResult<2> to(double nu, const WalkOptions& options) {
    return walk(model, J1 * nu * nu, J2 * nu * nu, options);
  }
};

std::vector<WalkOptions> many_options() {
  std::vector<WalkOptions> out;
  for (const double first : {0.001, 0.01, 0.05, 0.2, 0.5, 1.5})
    for (const double max_angle : {0.05, 0.1, 0.2, 0.35, 0.5})
      out.push_back(with_steps(first, max_angle));
  return out;
}

TEST(RestWalk, StaysOnTheRestSheetOfANearlyDegeneratePair) {
  for (const WalkOptions& options : many_options()) {
    double last = 1.0;
    for (const double nu : {0.05, 0.1, 0.15, 0.2, 0.21, 0.22, 0.224, 0.22403, 0.2240339}) {
      const WalkResult<2> result = NearlyDegenerate::to(nu, options);
      ASSERT_EQ(result.end, WalkEnd::reached) << nu;
      EXPECT_GT(result.x[0], result.x[1]) << "the other sheet has xi < zeta; nu = " << nu;
      EXPECT_GT(result.x[0], last) << "xi grows along the rest sheet; nu = " << nu;
      last = result.x[0];
      const PlanarSystem<NeoHookean<>> system{
          NearlyDegenerate::model,
          {NearlyDegenerate::J1 * nu * nu, NearlyDegenerate::J2 * nu * nu, 0.0}};
      const Linearized<2> at = system.linearize(result.x);
      EXPECT_LE(at.g.cwiseAbs().maxCoeff(), 1e-9 * at.magnitude);
    }
  }
}

TEST(RestWalk, EscapesWhereTheRestSheetEndsWhateverTheSteps) {
  const double end = NearlyDegenerate::end();
  EXPECT_NEAR(end, 0.22403394, 1e-8);
  for (const WalkOptions& options : many_options()) {
    for (const double nu : {0.22403394, 0.2241, 0.23, 0.25, 0.3, 0.35, 0.6, 0.9, 0.95}) {
      const WalkResult<2> result = NearlyDegenerate::to(nu, options);
      EXPECT_EQ(result.end, WalkEnd::escaped)
          << nu << " " << options.step.first << " " << options.step.max_angle;
      EXPECT_NEAR(nu * std::sqrt(result.largest_tau), end, 1e-9) << nu;
      EXPECT_GT(result.x[0], result.x[1]);
    }
  }
}

/// However small the gap of the broken bifurcation: the rest sheet turns into the ellipses with
/// xi > zeta (J1 > J2), and straight ahead lies another one. Where the gap is below what steps can
/// resolve, the walk may give up, not go on.
TEST(RestWalk, DoesNotCrossTheGapOfABrokenBifurcation) {
  const BiotLog<> model{1.0, 4.0};
  int reached = 0;
  for (int k = 2; k <= 12; ++k) {
    const double difference = std::pow(10.0, -k);
    double last = 1.0;
    // The circle's bifurcation of J1 = J2 = 1 is at nu = 1.065.
    for (const double nu : {1.1, 1.2, 1.3, 1.4}) {
      const WalkResult<2> result = walk(model, (1.0 + difference) * nu * nu, nu * nu);
      if (result.end == WalkEnd::stuck) {
        EXPECT_GE(k, 11) << "a gap that steps can resolve";
        continue;
      }
      ASSERT_EQ(result.end, WalkEnd::reached) << difference << " " << nu;
      ++reached;
      EXPECT_GT(result.x[0], 2.0 * result.x[1]) << difference << " " << nu;
      EXPECT_GT(result.x[0], last);
      last = result.x[0];
    }
  }
  EXPECT_GE(reached, 36);
}

TEST(RestWalk, TakesTheLowerPartOfAFoldUpToTheFold) {
  const Hencky<> model{1.1, 0.8};
  const double J2 = 1.7;
  const support::HenckyFold<double> fold(J2, model.mu, model.lambda);
  double last = 1.0;
  for (int k = 1; k <= 12; ++k) {
    const double gap = std::pow(10.0, -k);
    const WalkResult<2> below = walk(model, 0.0, J2 * fold.nu_squared * (1.0 - gap));
    ASSERT_EQ(below.end, WalkEnd::reached) << gap;
    EXPECT_EQ(below.largest_tau, 1.0);
    EXPECT_LT(below.x[1], fold.zeta) << gap;
    EXPECT_GT(below.x[1], last) << gap;
    // ln zeta = 1/2 - s: nu^2 falls by 2 s^2 of itself.
    const double distance = std::log(fold.zeta / below.x[1]);
    EXPECT_NEAR(2.0 * distance * distance / gap, 1.0, 2.0 * std::sqrt(gap) + 1e-13 / gap) << gap;
    last = below.x[1];
  }
}

TEST(RestWalk, PassesTheFoldAndDoesNotReachWhatLiesAbove) {
  const Hencky<> model{1.1, 0.8};
  const double J2 = 1.7;
  const support::HenckyFold<double> fold(J2, model.mu, model.lambda);
  for (int k = 0; k <= 13; ++k) {
    const double gap = std::pow(10.0, -k);
    const WalkResult<2> above = walk(model, 0.0, J2 * fold.nu_squared * (1.0 + gap));
    EXPECT_EQ(above.end, WalkEnd::escaped) << gap;
    EXPECT_GT(above.x[1], 1e6) << "nu falls again while zeta grows without bound";
    EXPECT_LT(above.largest_tau, 1.0);
    EXPECT_NEAR(above.largest_tau * (1.0 + gap), 1.0, 1e-2) << gap;
    if (k >= 2) {
      EXPECT_NEAR(above.largest_tau * (1.0 + gap), 1.0, 1e-12) << gap;
    }
  }
}

TEST(RestWalk, KeepsTheCircleWhereTheEllipseBranchesOff) {
  // biot: the circle is xi = (mu + lambda)/(mu + lambda - J nu^2/2), and the ellipses branch off
  // at J nu^2 = 2 mu all at once.
  const Biot<> model{1.0, 2.0};
  for (const double rate : {0.5, 1.0, 1.9, 2.0, 2.1, 3.0, 4.0, 5.0, 5.9}) {
    const WalkResult<2> result = walk(model, rate, rate);
    ASSERT_EQ(result.end, WalkEnd::reached) << rate;
    EXPECT_EQ(result.x[0], result.x[1]) << rate;
    EXPECT_NEAR(result.x[0], 3.0 / (3.0 - 0.5 * rate), 1e-9 * result.x[0]) << rate;
  }
  // biot-log bifurcates too; a walk beyond it stays circular, bit for bit.
  const BiotLog<> log_model{1.0, 4.0};
  for (const double rate : {0.5, 1.0, 1.5, 1.9}) {
    const WalkResult<2> result = walk(log_model, rate, rate);
    ASSERT_EQ(result.end, WalkEnd::reached) << rate;
    EXPECT_EQ(result.x[0], result.x[1]) << rate;
  }
}

/// Its answer does not depend on its steps: the same point for every options, over random cases.
TEST(RestWalk, EveryStepSizeArrivesAtTheSamePoint) {
  support::Random random(81);
  int reached = 0;
  for (int k = 0; k < 60; ++k) {
    const auto model = NeoHookean<>{random.log_uniform(0.1, 10.0), random.log_uniform(0.1, 10.0)};
    const double rate_xi = model.mu * random.uniform(0.0, 1.2);
    const double rate_zeta = model.mu * random.uniform(0.0, 1.2);
    const WalkResult<2> fine = walk(model, rate_xi, rate_zeta, short_steps());
    for (const WalkOptions& options : many_options()) {
      const WalkResult<2> result = walk(model, rate_xi, rate_zeta, options);
      ASSERT_EQ(result.end, fine.end) << model.mu << " " << model.lambda << " " << rate_xi;
      if (fine.end != WalkEnd::reached) continue;
      ++reached;
      EXPECT_LE((result.x.array() / fine.x.array()).log().abs().maxCoeff(), 1e-8);
    }
  }
  EXPECT_GT(reached, 500);
}

/// Of plates as nearly round as one likes, and of others, in every potential: its steps lead where short ones lead. Where
/// these give up, in a gap that they do not resolve, it may too, or come to the sheet's end.
template <class Model>
void leads_where_short_steps_lead(const Model& model, double stiffness, bool nearly_round,
                                  support::Random& random, int& reached, int& escaped) {
  if (!std::isfinite(model.rest_stretch())) return;
  const double rate = stiffness * random.uniform(0.1, 2.2);
  const double difference = random.sign() * random.log_uniform(1e-9, 0.3);
  const double other = nearly_round ? rate * (1.0 + difference) : rate * random.uniform(0.0, 1.0);
  const WalkResult<2> result = walk(model, rate, other);
  const WalkResult<2> fine = walk(model, rate, other, short_steps());
  const auto text = [&] {
    std::ostringstream out;
    out.precision(17);
    out << typeid(Model).name() << " rates " << rate << " " << other;
    return out.str();
  };
  EXPECT_EQ(result.end == WalkEnd::reached, fine.end == WalkEnd::reached) << text();
  if (fine.end == WalkEnd::escaped) {
    EXPECT_EQ(result.end, WalkEnd::escaped) << text();
    EXPECT_NEAR(result.largest_tau, fine.largest_tau, 1e-6 * fine.largest_tau) << text();
    ++escaped;
  }
  if (result.end != WalkEnd::reached || fine.end != WalkEnd::reached) return;
  EXPECT_LE((result.x.array() / fine.x.array()).log().abs().maxCoeff(), 1e-7) << text();
  EXPECT_LT(result.linearizations, fine.linearizations) << text();
  ++reached;
}

TEST(RestWalk, LeadsWhereShortStepsLead) {
  for (const bool nearly_round : {false, true}) {
    support::Random random(nearly_round ? 82 : 83);
    int reached = 0;
    int escaped = 0;
    for (int k = 0; k < 60; ++k) {
      const double mu = random.log_uniform(0.1, 10.0);
      const double lambda =
          k % 8 == 0 ? -0.6 * mu * random.uniform(0.0, 1.0) : random.log_uniform(0.1, 10.0);
      const auto leads = [&](const auto& model, double stiffness) {
        leads_where_short_steps_lead(model, stiffness, nearly_round, random, reached, escaped);
      };
      leads(ReciprocalDeterminant<>{mu, std::abs(lambda)}, std::abs(lambda));
      leads(SaintVenantKirchhoff<>{mu, lambda}, mu);
      leads(Biot<>{mu, lambda}, mu);
      leads(BiotLog<>{mu, lambda}, mu);
      leads(NeoHookean<>{mu, lambda}, mu);
      leads(Hencky<>{mu, lambda}, mu);
    }
    EXPECT_GT(reached, 150) << nearly_round;
    EXPECT_GT(escaped, 50) << nearly_round;
  }
}

/// A step may pass tau = 1 where a point on the way to it is refused, as one predicted from further away.
TEST(RestWalk, FindsTheEndThatALongStepPasses) {
  const BiotLog<> model{7.3106857833541739, -3.8633767680539588};
  const WalkResult<2> result = walk(model, 4.8255589915213895, 4.825559036258201);
  ASSERT_EQ(result.end, WalkEnd::reached);
  EXPECT_NEAR(result.x[0], 1.7441873, 1e-6);
}

/// nu falls to 0 while a circle grows without bound: what is left of nu^2 is rounding, also below 0.
TEST(RestWalk, AnEscapeIsNoWayBackToRest) {
  for (const WalkOptions& options : many_options()) {
    const Hencky<> stiff{4.7035304685041188, 0.14000128313566232};
    EXPECT_EQ(walk(stiff, 4.5693951258074383, 4.5693951258074383, options).end, WalkEnd::escaped);
    const Hencky<> soft{1.179170996809467, 0.18326909647637959};
    EXPECT_EQ(walk(soft, 1.1083153751440087, 1.1083153751440087, options).end, WalkEnd::escaped);
  }
}

/// Slow motions take one step, of few linearizations; none takes many.
TEST(RestWalk, TakesFewLinearizations) {
  const auto taken = [](const auto& model, double rate_xi, double rate_zeta) {
    const WalkResult<2> result = walk(model, rate_xi, rate_zeta);
    EXPECT_EQ(result.end, WalkEnd::reached);
    return std::pair(result.steps, result.linearizations);
  };
  for (const double rate : {1e-4, 0.01, 0.1}) {
    for (const double share : {0.0, 0.6, 1.0, 1.7}) {
      const auto few = [&](const auto& model) {
        const auto [steps, linearizations] = taken(model, rate, share * rate);
        EXPECT_EQ(steps, 1) << rate << " " << share;
        EXPECT_LE(linearizations, 8) << rate << " " << share;
      };
      few(ReciprocalDeterminant<>{1.0, 2.0});
      few(SaintVenantKirchhoff<>{1.0, 0.6});
      few(Biot<>{1.0, 0.6});
      few(BiotLog<>{1.0, 0.6});
      few(NeoHookean<>{1.0, 0.6});
      few(Hencky<>{1.0, 0.6});
    }
  }
  EXPECT_LE(taken(NeoHookean<>{1.0, 0.6}, 0.9, 0.5).second, 40);
  EXPECT_LE(taken(ReciprocalDeterminant<>{1.0, 2.0}, 1.9, 1.0).second, 40);
  // Through the near-degenerate pair, to the end of its sheet.
  EXPECT_LE(NearlyDegenerate::to(0.22403, {}).linearizations, 120);
}

TEST(RestWalk, ThreeUnknowns) {
  const CoupledSystem<NeoHookean3d<>> system{{1.0, 0.5}, {0.3, 0.6, 0.9}};
  const auto result =
      RestWalk<CoupledSystem<NeoHookean3d<>>>(system, {1.0, 1.0, 1.0}, {}).run(nullptr);
  ASSERT_EQ(result.end, WalkEnd::reached);
  // (mu - c_i) x_i^2 is one number.
  EXPECT_NEAR(0.7 * result.x[0] * result.x[0], 0.4 * result.x[1] * result.x[1], 1e-9);
  EXPECT_NEAR(0.7 * result.x[0] * result.x[0], 0.1 * result.x[2] * result.x[2], 1e-9);
}

TEST(RestWalk, StopsWhenAskedAndAtItsLimits) {
  const NeoHookean<> model{1.0, 0.5};
  const std::atomic<bool> stop = true;
  const WalkResult<2> stopped = walk(model, 0.5, 0.3, {}, &stop);
  EXPECT_EQ(stopped.end, WalkEnd::interrupted);
  EXPECT_EQ(stopped.steps, 0);
  const std::atomic<bool> go_on = false;
  EXPECT_EQ(walk(model, 0.5, 0.3, {}, &go_on).end, WalkEnd::reached);
  WalkOptions two_short_steps = short_steps();
  two_short_steps.max_steps = 2;
  const WalkResult<2> limited = walk(model, 0.5, 0.3, two_short_steps);
  EXPECT_EQ(limited.end, WalkEnd::too_long);
  EXPECT_EQ(limited.steps, 2);
  EXPECT_GT(limited.largest_tau, 0.0);
  EXPECT_LT(limited.largest_tau, 1.0);
}

}  // namespace
}  // namespace stationary
