// Potentials with directions of their own: derivatives, facts, symmetries, number types.
#include "lib/material/anisotropic_potential.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lib/material/potential.hpp"
#include "tests/support/bodies/random_anisotropic.hpp"
#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

using support::agrees;

using Wide = BasicStretch<DoubleDouble>;

Wide moved_stretch(const Wide& q, int i, double h) {
  Vector4<DoubleDouble> v = q.vector();
  v[i] = v[i] + h;
  return Wide::from(v);
}

Wide widened(const Stretch& q) { return {q.alpha, q.xi, q.zeta, q.rho}; }

template <class F>
void over_bodies(std::uint64_t seed, const F& f) {
  support::Random random(seed);
  for (int k = 0; k < 40; ++k) f(support::random_anisotropic(random, k), random);
}

TEST(AnisotropicPotential, DerivativesAreTheSlopesOfValueAndGradient) {
  over_bodies(301, [](const support::Anisotropic& of, support::Random& random) {
    const auto model = of.V.model(AsExtended());
    const Wide q = widened(random.stretch());
    const auto at = potential_derivatives<2>(model, q);
    const double scale = 1.0 + double(at.hessian.cwiseAbs().maxCoeff());
    constexpr double h = 1e-9;
    for (int i = 0; i < 4; ++i) {
      const auto ahead = potential_derivatives<1>(model, moved_stretch(q, i, h));
      const auto behind = potential_derivatives<1>(model, moved_stretch(q, i, -h));
      const double slope = double(ahead.value - behind.value) / (2.0 * h);
      EXPECT_NEAR(slope, double(at.gradient[i]), 1e-13 * scale) << of.text;
      for (int j = 0; j < 4; ++j) {
        EXPECT_NEAR(double(ahead.gradient[j] - behind.gradient[j]) / (2.0 * h),
                    double(at.hessian(i, j)), 1e-12 * scale)
            << of.text << ", entry " << i << " " << j;
      }
    }
  });
}

TEST(AnisotropicPotential, NumberTypesAgree) {
  over_bodies(302, [](const support::Anisotropic& of, support::Random& random) {
    const Stretch q = random.stretch();
    const auto plain = potential_derivatives<2>(of.V.model(), q);
    const auto extended = potential_derivatives<2>(of.V.model(AsExtended()), widened(q));
    const auto input = [](double x) { return Conditioned::input(x); };
    const auto conditioned = potential_derivatives<2>(
        of.V.model(AsConditioned()),
        BasicStretch<Conditioned>{input(q.alpha), input(q.xi), input(q.zeta), input(q.rho)});
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        // Rounding stays within the conditioning, a few times.
        const double allowed = 64.0 * 0x1p-53 * conditioned.hessian(i, j).condition;
        EXPECT_NEAR(plain.hessian(i, j), double(extended.hessian(i, j)), allowed) << of.text;
      }
    }
  });
}

TEST(AnisotropicPotential, EvenIsAsItSays) {
  over_bodies(303, [](const support::Anisotropic& of, support::Random& random) {
    double worst = 0.0;
    for (int k = 0; k < 5; ++k) {
      const Stretch q = random.diagonal_stretch();
      const auto at = potential_derivatives<2>(of.V.model(), q);
      const double scale = at.hessian.cwiseAbs().maxCoeff();
      for (const double odd :
           {at.gradient[0], at.hessian(0, 1), at.hessian(0, 2), at.hessian(0, 3)})
        worst = std::max(worst, std::abs(odd) / scale);
      Stretch sheared = random.stretch();
      const double V = potential_derivatives<0>(of.V.model(), sheared).value;
      sheared.alpha = -sheared.alpha;
      const double image = potential_derivatives<0>(of.V.model(), sheared).value;
      worst = std::max(worst, std::abs(V - image) / (1.0 + std::abs(V)));
    }
    if (of.V.even_in_alpha()) {
      EXPECT_LE(worst, 1e-12) << of.text;
    } else {
      EXPECT_GT(worst, 1e-6) << of.text;
    }
  });
}

TEST(AnisotropicPotential, FibresAlongTheAxesAndOpposedPairsAreEven) {
  const ThicknessPotential thickness = Harmonic<>{1.0, 1.0};
  const auto even = [&](std::vector<Fibre> fibres) {
    return AnisotropicPotential(Biot<>{1.0, 1.0}, thickness, std::move(fibres)).even_in_alpha();
  };
  for (const double degrees : {0.0, 90.0, -90.0, 180.0, 270.0, 720.0})
    EXPECT_TRUE(even({{0.7, degrees}})) << degrees;
  EXPECT_TRUE(even({{0.7, 33.0}, {0.7, -33.0}}));
  EXPECT_TRUE(even({{0.7, 33.0}, {0.7, 147.0}}));
  EXPECT_FALSE(even({{0.7, 33.0}, {0.8, -33.0}}));
  EXPECT_FALSE(even({{0.7, 33.0}, {0.7, -34.0}}));
  EXPECT_FALSE(even({{0.7, 45.0}}));
}

/// Whether they are so by chance: whatever its stiffness, one along an axis is; whatever its angle,
/// none.
TEST(AnisotropicPotential, WhatKeepsItEven) {
  const ThicknessPotential thickness = Harmonic<>{1.0, 1.0};
  const AnisotropicPotential one(Biot<>{1.0, 1.0}, thickness, {{0.7, 90.0}});
  const AnisotropicPotential pair(Biot<>{1.0, 1.0}, thickness, {{0.7, 33.0}, {0.7, -33.0}});
  const AnisotropicPotential skew(Biot<>{1.0, 1.0}, thickness, {{0.7, 33.0}});
  const int stiffness = one.fibre_place();
  for (int place = -1; place < stiffness; ++place) {
    EXPECT_TRUE(one.keeps_shear_free(place)) << place;
    EXPECT_TRUE(pair.keeps_shear_free(place)) << place;
    EXPECT_FALSE(skew.keeps_shear_free(place)) << place;
  }
  EXPECT_TRUE(one.keeps_shear_free(stiffness));
  EXPECT_FALSE(one.keeps_shear_free(stiffness + 1));
  for (int place = stiffness; place < stiffness + 4; ++place)
    EXPECT_FALSE(pair.keeps_shear_free(place)) << place;
}

/// Axes exchanged, an axis turned about, a whole half turn of a fibre.
TEST(AnisotropicPotential, SymmetriesOfTheMaterialFrame) {
  support::Random random(304);
  const ThicknessPotential thickness = ReciprocalQuadratic<>{1.0, 3.0};
  for (int k = 0; k < 20; ++k) {
    const double degrees = random.uniform(-90.0, 90.0);
    const double stiffness = random.log_uniform(0.1, 10.0);
    const auto V = [&](double angle, const Stretch& q) {
      const AnisotropicPotential of(NeoHookean<>{1.0, 0.7}, thickness, {{stiffness, angle}});
      return potential_derivatives<0>(of.model(), q).value;
    };
    const Stretch q = random.stretch();
    const double expected = V(degrees, q);
    const double allowed = 1e-13 * (1.0 + std::abs(expected));
    EXPECT_NEAR(V(90.0 - degrees, {q.alpha, q.zeta, q.xi, q.rho}), expected, allowed);
    EXPECT_NEAR(V(-degrees, {-q.alpha, q.xi, q.zeta, q.rho}), expected, allowed);
    EXPECT_NEAR(V(degrees + 180.0, q), expected, allowed);
  }
}

TEST(AnisotropicPotential, OrthotropicWithIsotropicCoefficientsIsSaintVenantKirchhoff) {
  support::Random random(305);
  for (int k = 0; k < 20; ++k) {
    const auto model = random.coefficients<SaintVenantKirchhoff<>>();
    const double stiff = model.lambda + 2.0 * model.mu;
    const ThicknessPotential thickness = Harmonic<>{1.3, 0.8};
    const Potential oriented(AnisotropicPotential(
        OrthotropicSaintVenantKirchhoff<>{stiff, stiff, model.lambda, model.mu}, thickness, {}));
    const Potential isotropic(PlanarPotential(model), thickness);
    const Stretch q = random.stretch();
    const auto a = oriented.derivatives(q);
    const auto b = isotropic.derivatives(q);
    const double allowed = 1e-12 * (1.0 + b.hessian.cwiseAbs().maxCoeff());
    EXPECT_NEAR(a.value, b.value, allowed);
    EXPECT_TRUE(support::all_agree("gradient", b.gradient, a.gradient, allowed));
    EXPECT_TRUE(support::all_agree("hessian", b.hessian, a.hessian, allowed));
  }
}

TEST(AnisotropicPotential, WithCoefficientChangesThatOne) {
  over_bodies(306, [](const support::Anisotropic& of, support::Random& random) {
    const Stretch q = random.stretch();
    const double before = potential_derivatives<0>(of.V.model(), q).value;
    for (int place = 0; place < of.V.coefficient_count(); ++place) {
      const AnisotropicPotential other = of.V.with_coefficient(place, 1.2345);
      EXPECT_NE(potential_derivatives<0>(other.model(), q).value, before) << of.text << place;
    }
    EXPECT_EQ(of.V.with_coefficient(of.V.fibre_place(), 0.5).fibres()[0].k, 0.5);
  });
}

TEST(AnisotropicPotential, DomainIsHeld) {
  const ThicknessPotential thickness = Harmonic<>{1.0, 1.0};
  using Orthotropic = OrthotropicSaintVenantKirchhoff<>;
  const auto refused = [](const auto& make, std::string_view inequality) {
    try {
      make();
      ADD_FAILURE() << inequality;
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), inequality);
    }
  };
  const auto plane = [&](const AnisotropicPotential::Plane& model, std::vector<Fibre> fibres) {
    return [=] { return AnisotropicPotential(model, thickness, fibres); };
  };
  refused(plane(Biot<>{1.0, 1.0}, {}), "a fibre, or an anisotropic plane");
  refused(plane(Biot<>{-1.0, 1.0}, {{1.0, 3.0}}), "mu > 0");
  refused(plane(Biot<>{1.0, 1.0}, {{0.0, 3.0}}), "k > 0");
  refused(plane(Biot<>{1.0, 1.0}, {{1.0, INFINITY}}), "degrees finite");
  refused(plane(Biot<>{1.0, 1.0}, std::vector<Fibre>(5, {1.0, 3.0})), "at most 4 fibres");
  refused(plane(Orthotropic{1.0, 1.0, 1.5, 1.0}, {}), "c11 c22 > c12^2");
  refused(plane(Orthotropic{1.0, -1.0, 0.5, 1.0}, {}), "c22 > 0");
  EXPECT_NO_THROW(plane(Orthotropic{1.0, 1.0, 0.5, 1.0}, {})());
}

/// A fibre in a plane whose thickness is the volume's alone.
TEST(AnisotropicPotential, ARestrictedOneWithoutAThicknessIsWithout) {
  BodyTerms<double> body;
  body.volume = 1.2;
  const AnisotropicPotential V =
      AnisotropicPotential(Biot<>{1.0, 0.6}, std::optional<AnyThickness<>>(), {{0.4, 30.0}})
          .with_body(body);
  const Stretch q{0.1, 1.1, 0.9, 1.2 / (1.1 * 0.9 - 0.01)};
  const AnisotropicPotential part = V.on_part_of(q);
  EXPECT_EQ(Potential(part).value(q), Potential(V).value(q));
  const auto* parts = std::get_if<AnisotropicModel<double>::Separate>(&part.model().base);
  ASSERT_NE(parts, nullptr);
  EXPECT_FALSE(parts->thickness);
  EXPECT_TRUE(part.conditions_at(q).empty());
}

TEST(AnisotropicPotential, VisitIsForIsotropicOnes) {
  const Potential V(AnisotropicPotential(Biot<>{1.0, 1.0}, Harmonic<>{1.0, 1.0}, {{1.0, 30.0}}));
  EXPECT_FALSE(V.is_isotropic());
  EXPECT_TRUE(V.is_separable());
  EXPECT_THROW(V.visit([](const auto&) {}), std::invalid_argument);
}

TEST(Direction, WholeRightAnglesAreExact) {
  const double expected[4][2] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
  for (int k = -8; k <= 8; ++k) {
    const auto at = direction(90.0 * k);
    EXPECT_EQ(double(at.cosine), expected[(k + 8) % 4][0]) << k;
    EXPECT_EQ(double(at.sine), expected[(k + 8) % 4][1]) << k;
  }
}

TEST(Direction, UnitAndAdditive) {
  support::Random random(307);
  for (int k = 0; k < 100; ++k) {
    const double a = random.uniform(-400.0, 400.0);
    const double b = std::round(random.uniform(-400.0, 400.0));
    const auto A = direction(a);
    EXPECT_NEAR(double(A.cosine * A.cosine + A.sine * A.sine - 1.0), 0.0, 1e-29);
    const auto B = direction(b);
    // Sixths of a turn: cos 60 = 1/2.
    EXPECT_NEAR(double(direction(60.0).cosine - 0.5), 0.0, 1e-30);
    const auto twice = direction(2.0 * b);
    EXPECT_NEAR(double(twice.sine - 2.0 * (B.sine * B.cosine)), 0.0, 1e-28) << b;
    EXPECT_NEAR(double(A.cosine), std::cos(a * M_PI / 180.0), 2e-15);
  }
}

TEST(Direction, IntervalsHoldEveryAngleOfTheirs) {
  support::Random random(308);
  for (int k = 0; k < 200; ++k) {
    const double degrees = random.uniform(-200.0, 200.0);
    const double spread = random.log_uniform(1e-16, 1.0);
    const auto box = direction_interval(degrees, spread);
    for (const double offset : {-1.0, -0.3, 0.0, 0.8, 1.0}) {
      const auto at = direction(degrees + offset * spread);
      EXPECT_TRUE(box.cosine.lo <= at.cosine.hi && at.cosine.hi <= box.cosine.hi);
      EXPECT_TRUE(box.sine.lo <= at.sine.hi && at.sine.hi <= box.sine.hi);
    }
  }
  EXPECT_EQ(direction_interval(90.0, 0.0).cosine.hi, 0.0);
}

/// Fibres that cancel as decimals, and not quite in doubles, are not said to shear.
TEST(AnisotropicPotential, ShearIsSaidBeyondRoundingOnly) {
  const auto with = [](std::vector<Fibre> fibres) {
    return AnisotropicPotential(NeoHookean<>{1.0, 2.0}, ReciprocalQuadratic<>{1.0, 3.0},
                                std::move(fibres));
  };
  EXPECT_FALSE(with({{0.1, 30.0}, {0.2, 30.0}, {0.3, -30.0}}).sheared());
  EXPECT_TRUE(with({{0.1, 30.0}, {0.2, 30.0}, {0.3000001, -30.0}}).sheared());
  EXPECT_TRUE(with({{0.4, 25.0}}).sheared());
  EXPECT_FALSE(with({{0.4, 25.0}, {0.4, -25.0}}).sheared());
  EXPECT_TRUE(with({{0.4, 25.0}, {0.4, -25.0}}).even_in_alpha());
}

TEST(AnisotropicPotential, WithoutAThicknessItNeedsAVolume) {
  const AnisotropicPotential plane(NeoHookean<>{1.0, 2.0}, std::optional<AnyThickness<>>(),
                                   {{0.4, 25.0}});
  EXPECT_TRUE(std::isnan(plane.rest_thickness()));
  BodyTerms<double> gravity;
  gravity.gravitates = true;
  gravity.g = 0.4;
  gravity.J = {1.0, 1.0, 0.6};
  EXPECT_THROW((void)plane.with_body(gravity), std::invalid_argument);
  gravity.volume = 1.0;
  EXPECT_NO_THROW((void)plane.with_body(gravity));
}

}  // namespace
}  // namespace stationary
