// What half a unit in the last place of every number of a problem does to its equations is no more
// than input_sensitivity() says: against differences by each number.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "lib/material/gravitating/body_model.hpp"
#include "lib/material/gravitating/rest_state.hpp"
#include "lib/material/models/any_model.hpp"
#include "solver/family/coefficient_slope.hpp"
#include "solver/motion/oriented_system.hpp"
#include "solver/motion/tilted_system.hpp"
#include "solver/newton/reduced_system.hpp"
#include "tests/support/bodies/random_anisotropic.hpp"

namespace stationary {
namespace {

using support::Random;

constexpr double h = 1e-5;

/// Sum over the places of |dG/d ln p|; at(place, h): G with that number larger by a share h.
template <int N>
ReducedVector<N> spread(std::size_t places,
                        const std::function<ReducedVector<N>(std::size_t, double)>& at) {
  ReducedVector<N> out = ReducedVector<N>::Zero();
  for (std::size_t k = 0; k < places; ++k) out += ((at(k, h) - at(k, -h)) / (2.0 * h)).cwiseAbs();
  return out;
}

/// Every elastic part, with and without gravity.
std::vector<BodyModel<>> bodies(Random& random) {
  std::vector<BodyModel<>> out;
  for (const double g : {0.0, 0.9}) {
    for (int part = 0; part < 4; ++part) {
      BodyModel<> model;
      if (part == 0 || part == 1)
        model.elastic.plane =
            AnyPlane<>{Hencky<>{random.uniform(0.5, 2.0), random.uniform(0.1, 1.0)}};
      if (part == 1)
        model.elastic.thickness =
            AnyThickness<>{ReciprocalQuadratic<>{random.uniform(0.5, 2.0), 1.3}};
      if (part == 2)
        model.elastic.coupled = NeoHookean3d<>{random.uniform(0.5, 2.0), random.uniform(0.1, 1.0)};
      if (part == 3 && g == 0.0) continue;
      model.gravitates = g != 0.0;
      model.g = g;
      model.J = {random.uniform(0.5, 2.0), random.uniform(0.5, 2.0), random.uniform(0.5, 2.0)};
      out.push_back(model);
    }
  }
  return out;
}

/// The model with one of its numbers larger by a share of it.
BodyModel<> changed(const BodyModel<>& model, std::size_t place, double share) {
  return with_indexed_coefficients(model, [&](double value, std::size_t k) {
    return k == place ? value * (1.0 + share) : value;
  });
}

template <int N>
void expect_held(const ReducedVector<N>& seen, const ReducedVector<N>& claimed) {
  const double rounding = 1e-7 * (1.0 + claimed.maxCoeff());
  for (int i = 0; i < N; ++i) {
    EXPECT_LE(seen[i], claimed[i] + rounding) << i;
    // It is a bound by some terms, not by many.
    EXPECT_GE(40.0 * seen[i] + rounding, claimed[i]) << i;
  }
}

TEST(InputSensitivity, HoldsWhatTheNumbersOfAWholeBodyDo) {
  Random random(24);
  int body = 0;
  for (BodyModel<> model : bodies(random)) {
    SCOPED_TRACE(body++);
    for (const bool held : {false, true}) {
      SCOPED_TRACE(held);
      if (held) {
        model.volume = 1.1;
        model.stiffness = 0.01;
      }
      for (int trial = 0; trial < 6; ++trial) {
        ReducedVector<3> x(random.uniform(0.6, 1.6), random.uniform(0.6, 1.6), 0.0);
        x[2] = held ? *model.volume / (x[0] * x[1]) : random.uniform(0.6, 1.6);
        // J_k nu^2: by J once, by nu twice.
        const std::array rates{random.uniform(0.0, 0.6), random.uniform(0.0, 0.6),
                               trial % 2 == 0 ? 0.0 : random.uniform(0.2, 0.6)};
        const auto at = [&](const BodyModel<>& own, const std::array<double, 3>& c) {
          return CoupledSystem<BodyModel<>>{own, {c[0], c[1], c[2]}}.extended_residual(x);
        };
        const std::function<ReducedVector<3>(std::size_t, double)> by_number =
            [&](std::size_t place, double share) {
              return at(changed(model, place, share), rates);
            };
        const std::function<ReducedVector<3>(std::size_t, double)> by_rate = [&](std::size_t k,
                                                                                 double share) {
          auto c = rates;
          c[k] *= 1.0 + share;
          return at(model, c);
        };
        const CoupledSystem<BodyModel<>> system{model, {rates[0], rates[1], rates[2]}};
        expect_held<3>(spread<3>(BodyModel<>::places, by_number) + 3.0 * spread<3>(3, by_rate),
                       system.input_sensitivity(x));
        // One by one they say no more, and with their signs what all numbers together do.
        ReducedVector<3> sum = ReducedVector<3>::Zero();
        ReducedVector<3> together = ReducedVector<3>::Zero();
        system.for_each_input(x, [&](const ReducedVector<3>& by) {
          sum += by.cwiseAbs();
          together += by;
        });
        expect_held<3>(sum, system.input_sensitivity(x));
        const auto all = [&](double share) {
          BodyModel<> own = model;
          for (std::size_t k = 0; k < BodyModel<>::places; ++k) own = changed(own, k, share);
          auto c = rates;
          for (double& rate : c) rate *= std::pow(1.0 + share, 3);
          return at(own, c);
        };
        const ReducedVector<3> seen = (all(h) - all(-h)) / (2.0 * h);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(together[i], seen[i], 1e-7 * (1.0 + sum[i])) << i;
      }
    }
  }
}

/// Of a tilted axis J tie rho as well.
TEST(InputSensitivity, HoldsWhatTheNumbersOfATiltedBodyDo) {
  Random random(25);
  int body = 0;
  for (BodyModel<> model : bodies(random)) {
    SCOPED_TRACE(body++);
    model.volume = 1.1;
    model.stiffness = 0.01;
    for (const TiltPlane plane : {TiltPlane::one_three, TiltPlane::two_three}) {
      SCOPED_TRACE(static_cast<int>(plane));
      for (int trial = 0; trial < 4; ++trial) {
        const std::array J{random.uniform(0.5, 2.0), random.uniform(0.5, 2.0),
                           random.uniform(0.5, 2.0)};
        const double nu = random.uniform(0.2, 0.8);
        const ReducedVector<2> x(random.uniform(0.7, 1.4), random.uniform(0.7, 1.4));
        const auto at = [&](const BodyModel<>& own, const std::array<double, 4>& numbers) {
          const Body turned(numbers[0], numbers[1], numbers[2]);
          BodyModel<> same = own;
          same.J = {numbers[0], numbers[1], numbers[2]};
          return TiltedSystem<BodyModel<>>{
              same, turned, plane,
              axis_rates(turned, Branch::iii, DoubleDouble(numbers[3] * numbers[3]))};
        };
        const std::array<double, 4> numbers{J[0], J[1], J[2], nu};
        const std::function<ReducedVector<2>(std::size_t, double)> by_coefficient =
            [&](std::size_t place, double share) {
              return at(changed(model, place, share), numbers).extended_residual(x);
            };
        const std::function<ReducedVector<2>(std::size_t, double)> by_motion = [&](std::size_t k,
                                                                                   double share) {
          auto own = numbers;
          own[k] *= 1.0 + share;
          return at(model, own).extended_residual(x);
        };
        // Its own J are the body's.
        const ReducedVector<2> seen =
            spread<2>(BodyModel<>::inertia_place, by_coefficient) + spread<2>(4, by_motion);
        expect_held<2>(seen, at(model, numbers).input_sensitivity(x));
      }
    }
  }
}

/// The slope by each number of a body is that of its values.
TEST(InputSensitivity, SlopesByTheNumbersOfAWholeBodyAreSlopes) {
  Random random(29);
  int body = 0;
  for (BodyModel<> model : bodies(random)) {
    SCOPED_TRACE(body++);
    for (const bool held : {false, true}) {
      if (held) {
        model.volume = 1.1;
        model.stiffness = 0.3;
      }
      ReducedVector<3> x(random.uniform(0.6, 1.6), random.uniform(0.6, 1.6), 0.0);
      x[2] = held ? *model.volume / (x[0] * x[1]) : random.uniform(0.6, 1.6);
      const auto values = model.coefficients();
      for (std::size_t place = 0; place < BodyModel<>::places; ++place) {
        if (values[place] == 0.0) continue;
        const auto at = [&](double share) {
          return CoupledSystem<BodyModel<>>{changed(model, place, share), {0.0, 0.0, 0.0}}
              .extended_residual(x);
        };
        const ReducedVector<3> seen = (at(h) - at(-h)) / (2.0 * h * values[place]);
        const ReducedVector<3> found = body_slope(model, place, x);
        EXPECT_LE((seen - found).cwiseAbs().maxCoeff(), 1e-7) << place << held;
      }
    }
  }
}

/// Makes a model in which the coefficient at one place is larger by some amount.
struct Shifted {
  int place;
  double by;
  mutable int next = 0;

  double operator()(double c) const { return next++ == place ? c + by : c; }
  Direction<double> direction(double degrees) const {
    const Direction<DoubleDouble> at = stationary::direction((*this)(degrees));
    return {double(at.cosine), double(at.sine)};
  }
};

/// The slopes by each coefficient of an anisotropic potential, of which two are had at a time.
TEST(InputSensitivity, SlopesByCoefficientsAreSlopes) {
  Random random(26);
  const Inertia3<double> J{1.0, 1.7, 0.6};
  const SpinProducts<double> n = axis_products(Branch::ii, 0.09);
  for (int kind = 0; kind < 16; ++kind) {
    const auto made = support::random_anisotropic(random, kind);
    SCOPED_TRACE(made.text);
    const OrientedStretch<double> at =
        oriented_stretch(random.uniform(0.8, 1.3), random.uniform(0.8, 1.3),
                         random.uniform(0.8, 1.3), random.uniform(1.1, 1.3));
    const int count = made.V.coefficient_count();
    for (int first = 0; first < count; first += 2) {
      const auto slopes =
          coefficient_slopes(made.V.model(CoefficientDuals{first, false}), J, at, n);
      for (int k = 0; k < 2 && first + k < count; ++k) {
        const auto ahead = oriented_balance<1>(J, made.V.model(Shifted{first + k, h}), at, n).g;
        const auto behind = oriented_balance<1>(J, made.V.model(Shifted{first + k, -h}), at, n).g;
        for (std::size_t i = 0; i < 4; ++i) {
          EXPECT_NEAR(slopes[i].slope[static_cast<std::size_t>(k)],
                      (ahead[i] - behind[i]) / (2.0 * h), 1e-7)
              << i << " by coefficient " << first + k;
        }
      }
    }
  }
}

/// The size of the terms of a balance is no less than that of its values and of its Jacobian.
TEST(Magnitude, HoldsTheValuesAndTheJacobian) {
  Random random(27);
  for (int trial = 0; trial < 200; ++trial) {
    const auto entry = [&] { return random.sign() * random.log_uniform(1e-3, 1e3); };
    LogBalance<double> b{.g_xi = entry(), .g_zeta = entry(), .g_rho = entry()};
    for (double* slope : {&b.uu, &b.uv, &b.vv, &b.uw, &b.vw, &b.ww}) *slope = entry();
    const double pull[] = {random.log_uniform(1e-3, 1e3), random.log_uniform(1e-3, 1e3),
                           random.log_uniform(1e-3, 1e3)};
    const double plane = std::abs(b.uu) + 2.0 * std::abs(b.uv) + std::abs(b.vv);
    const double values = std::abs(b.g_xi) + std::abs(b.g_zeta);
    const double rounding = 1.0 + 1e-12;
    const double of_plane = magnitude_of(b, pull[0], pull[1], pull[2], true) * rounding;
    EXPECT_GE(of_plane, plane);
    EXPECT_GE(of_plane, values);
    const double whole = plane + 2.0 * (std::abs(b.uw) + std::abs(b.vw)) + std::abs(b.ww);
    const double of_all = magnitude_of(b, pull[0], pull[1], pull[2], false) * rounding;
    EXPECT_GE(of_all, whole);
    EXPECT_GE(of_all, values + std::abs(b.g_rho));
  }
}

}  // namespace
}  // namespace stationary
