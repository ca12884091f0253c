// Anisotropic potentials of written-out parts against the same of built-in ones, in the number
// types a solve has, and what is known of alpha.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lib/material/anisotropic_potential.hpp"
#include "solver/proof/oriented_boxes.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary::testing {
namespace {

using support::Random;

const std::string isotropic_text = "mu/2*(I1 - 2 - 2*log(d)) + k/2*log(d)^2";
const std::string fibre_text =
    "c/2*((xi*cos(pi/6) + alpha*sin(pi/6))^2 + (alpha*cos(pi/6) + zeta*sin(pi/6))^2 - 1)^2";
const std::vector<std::string> fibred_names{"mu", "k", "c"};
const std::vector<double> fibred_values{1.1, 0.7, 0.4};

OrientedExpression<> oriented(const std::string& text, const std::vector<std::string>& parameters,
                              const std::vector<double>& coefficients) {
  const auto parsed = parse_expression(text, parameters, ExpressionSlot::plane);
  return {expression::oriented_tape(parsed.expression), coefficient_list(coefficients)};
}

const ThicknessPotential axial = ReciprocalQuadratic<>{1.0, 3.0};
AnisotropicPotential built_in() { return {NeoHookean<>{1.1, 0.7}, axial, {{0.4, 30.0}}}; }

/// The same potential: all of it written out, so too that its terms cannot be taken apart, and the
/// isotropic part alone.
std::vector<AnisotropicPotential> written() {
  return {
      AnisotropicPotential(
          oriented(isotropic_text + " + " + fibre_text, fibred_names, fibred_values), axial, {}),
      AnisotropicPotential(
          oriented("tan(atan(" + isotropic_text + " + " + fibre_text + "))", fibred_names,
                   fibred_values),
          AnyThickness<>{{support::written_thickness("a/rho + b/2*rho^2", {"a", "b"}, {1.0, 3.0})}},
          {}),
      AnisotropicPotential(
          support::written_plane(isotropic_text, {"mu", "k"}, {fibred_values[0], fibred_values[1]}),
          axial, {{0.4, 30.0}})};
}

Stretch random_stretch(Random& random) {
  const double xi = random.uniform(0.5, 1.8);
  const double zeta = random.uniform(0.5, 1.8);
  return {random.uniform(-0.6, 0.6) * std::sqrt(xi * zeta), xi, zeta, random.uniform(0.5, 1.5)};
}

template <class S>
BasicStretch<S> as(const Stretch& q) {
  return {S(q.alpha), S(q.xi), S(q.zeta), S(q.rho)};
}

void expect_same_derivatives(const PotentialDerivatives<double>& a,
                             const PotentialDerivatives<double>& b, double error) {
  EXPECT_NEAR(a.value, b.value, error);
  EXPECT_LE((a.gradient - b.gradient).cwiseAbs().maxCoeff(), error);
  EXPECT_LE((a.hessian - b.hessian).cwiseAbs().maxCoeff(), error);
}

TEST(OrientedExpression, IsTheBuiltInOneInAllNumberTypes) {
  Random random(901);
  for (const AnisotropicPotential& V : written()) {
    EXPECT_TRUE(V.is_separable());
    for (int k = 0; k < 20; ++k) {
      const Stretch q = random_stretch(random);
      expect_same_derivatives(potential_derivatives<2>(V.model(), q),
                              potential_derivatives<2>(built_in().model(), q), 1e-12);
      const auto wide = as<DoubleDouble>(q);
      const auto a = potential_derivatives<2>(V.model(AsExtended()), wide);
      const auto b = potential_derivatives<2>(built_in().model(AsExtended()), wide);
      EXPECT_LE(std::abs(double(a.value - b.value)), 1e-27);
      for (int i = 0; i < 4; ++i) {
        EXPECT_LE(std::abs(double(a.gradient[i] - b.gradient[i])), 1e-27);
        for (int j = 0; j < 4; ++j)
          EXPECT_LE(std::abs(double(a.hessian(i, j) - b.hessian(i, j))), 1e-26);
      }
    }
  }
}

TEST(OrientedExpression, IntervalsHoldThePointsOfBoxes) {
  Random random(903);
  for (const AnisotropicPotential& V : written()) {
    const auto boxed = V.model(AsIntervals{Inputs::decimals});
    for (int k = 0; k < 10; ++k) {
      const Stretch low = random_stretch(random);
      const double width = random.uniform(0.0, 0.1);
      const auto side = [&](double x) { return Interval(x, x + width); };
      const auto hull = potential_derivatives<2>(
          boxed,
          BasicStretch<Interval>{side(low.alpha), side(low.xi), side(low.zeta), side(low.rho)});
      for (int point = 0; point < 5; ++point) {
        const auto inside = [&](double x) {
          return std::min(x + width * random.uniform(0.0, 1.0), x + width);
        };
        const Stretch q{inside(low.alpha), inside(low.xi), inside(low.zeta), inside(low.rho)};
        const auto exact = potential_derivatives<2>(V.model(AsExtended()), as<DoubleDouble>(q));
        const auto holds = [](const Interval& x, const DoubleDouble& value) {
          return double(value - x.lo) >= 0.0 && double(x.hi - value) >= 0.0;
        };
        EXPECT_TRUE(holds(hull.value, exact.value));
        for (int i = 0; i < 4; ++i) {
          EXPECT_TRUE(holds(hull.gradient[i], exact.gradient[i])) << i;
          for (int j = 0; j < 4; ++j)
            EXPECT_TRUE(holds(hull.hessian(i, j), exact.hessian(i, j))) << i << j;
        }
      }
    }
  }
}

TEST(OrientedExpression, EveryCoefficientHasItsPlace) {
  Random random(902);
  // In the order of the written one's places: of its own, of the thickness, of the fibre.
  for (const AnisotropicPotential& V : written()) {
    const bool beside = !V.fibres().empty();
    EXPECT_EQ(V.thickness_place(), beside ? 2 : 3);
    EXPECT_EQ(V.fibre_place(), V.thickness_place() + 2);
    EXPECT_EQ(V.coefficient_count(), beside ? 6 : 5);
    const int own[] = {0, 1, 4, 2, 3};  // of the built-in one: mu, k, c, a, b
    for (int place = 0; place < 5; ++place) {
      const Stretch q = random_stretch(random);
      const int there = beside ? place : own[place];
      const AnisotropicPotential a = V.with_coefficient(place, 1.25);
      const AnisotropicPotential b = built_in().with_coefficient(there, 1.25);
      expect_same_derivatives(potential_derivatives<2>(a.model(), q),
                              potential_derivatives<2>(b.model(), q), 1e-12);
    }
  }
}

TEST(OrientedExpression, PullOnThePlaneIsTheSumOfItsParts) {
  Random random(904);
  for (const AnisotropicPotential& V : written()) {
    const OrientedExpression<>* expression = V.model().expression();
    if (!V.fibres().empty()) {
      EXPECT_EQ(expression, nullptr);
      continue;
    }
    ASSERT_NE(expression, nullptr);
    for (int k = 0; k < 10; ++k) {
      const Stretch q = random_stretch(random);
      const Vector4<double> force = expression->derivatives<1>(q).gradient;
      const auto pull = expression->plane_pull(q);
      ASSERT_TRUE(pull);
      EXPECT_NEAR(*pull, force.head<3>().dot(q.vector().head<3>()), 1e-12);
    }
  }
}

TEST(OrientedExpression, WhatIsKnownOfAlpha) {
  struct Known {
    const char* text;
    bool shear_free;
    bool sheared;
    bool even;
  };
  const Known all[] = {{"alpha^2 + xi", true, false, true},
                       {"cos(alpha)*xi", true, false, true},
                       {"abs(1)*xi*zeta", true, false, true},
                       {"alpha^3*xi + zeta", true, false, false},
                       {"alpha*xi", false, true, false},
                       {"sin(alpha) + d", false, true, false},
                       {"xi + sqrt(-xi - alpha)", false, false, false}};
  for (const Known& known : all) {
    const auto model = oriented(known.text, {}, {});
    EXPECT_EQ(model.shear_free(), known.shear_free) << known.text;
    EXPECT_EQ(model.sheared(), known.sheared) << known.text;
    EXPECT_EQ(model.even(), known.even) << known.text;
    const AnisotropicPotential V(model, axial, {});
    EXPECT_EQ(V.even_in_alpha(), known.even) << known.text;
    EXPECT_EQ(V.sheared(), known.sheared) << known.text;
    // A fibre that lies across the axes leaves none of it.
    const AnisotropicPotential skew(model, axial, {{1.0, 30.0}});
    EXPECT_FALSE(skew.even_in_alpha() || skew.shear_free()) << known.text;
    EXPECT_EQ(skew.sheared(), known.shear_free) << known.text;
  }
}

TEST(OrientedExpression, DomainIsFiniteParameters) {
  EXPECT_THROW(AnisotropicPotential(oriented("c*xi", {"c"}, {NAN}), axial, {}),
               std::invalid_argument);
  // Isotropic and without a fibre: no anisotropic potential.
  EXPECT_THROW(AnisotropicPotential(support::written_plane("d", {}, {}), axial, {}),
               std::invalid_argument);
}

/// Programs that no model reads are not made: their room is the others'.
TEST(OrientedExpression, ATapeHasTheProgramsItsModelReads) {
  const auto parsed = parse_expression(fibre_text, fibred_names, ExpressionSlot::coupled);
  const auto directed = expression::anisotropic_tape(parsed.expression);
  EXPECT_FALSE(directed->plane_pull.results.empty());
  EXPECT_TRUE(directed->balance.results.empty());
  EXPECT_TRUE(directed->residual.results.empty());
  EXPECT_TRUE(directed->slopes.results.empty());
  EXPECT_TRUE(directed->residual_slopes.results.empty());
  EXPECT_TRUE(directed->forces[0].results.empty());
  const auto axial_tape =
      support::written_thickness("a/rho + b*rho", {"a", "b"}, {1.0, 3.0}).tape();
  EXPECT_FALSE(axial_tape->balance.results.empty());
  EXPECT_FALSE(axial_tape->slopes.results.empty());
  EXPECT_TRUE(axial_tape->residual.results.empty());
  EXPECT_EQ(axial_tape->residual_slopes.results.size(), 2U) << "of one residual in two parameters";
  EXPECT_EQ(axial_tape->forces[1].results.size() + 1, axial_tape->evaluate[2].results.size());
}

/// A power has no slope in a parameter where that would be one beyond the largest; the formula fits.
TEST(OrientedExpression, ATapeDoesWithoutSlopesThatDoNotFit) {
  const auto fits =
      support::written_thickness("a/rho + b*rho/a^4095", {"a", "b"}, {1.0, 3.0}).tape();
  EXPECT_FALSE(fits->residual_slopes.results.empty());
  const auto largest = support::written_thickness("a/rho + b*rho/a^4096", {"a", "b"}, {1.0, 3.0});
  EXPECT_TRUE(largest.tape()->slopes.results.empty());
  EXPECT_TRUE(largest.tape()->residual_slopes.results.empty());
  EXPECT_EQ(largest.residual_sensitivity(1.5), std::nullopt);
  EXPECT_EQ(largest.forces<2>(1.5).v_rr, largest.evaluate<2>(1.5).v_rr);
}

}  // namespace
}  // namespace stationary::testing
