// Bodies with gravity or a held volume: what their model returns are slopes of one energy, in each
// of its forms, and rest is within its range.
#include "lib/material/gravitating/body_model.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "lib/balance/balance.hpp"
#include "lib/material/gravitating/rest_state.hpp"
#include "lib/material/material_coordinates.hpp"
#include "lib/material/models/any_model.hpp"

namespace stationary {
namespace {

BodyModel<> with_gravity(BodyModel<> model, double J1, double J2, double J3) {
  model.gravitates = true;
  model.g = 0.7;
  model.J = {J1, J2, J3};
  return model;
}

/// Solids and a fluid, with and without gravity, of equal and of different inertias.
std::vector<BodyModel<>> bodies() {
  BodyModel<> solid;
  solid.elastic.plane = AnyPlane<>{Hencky<>{1.0, 0.6}};
  solid.elastic.thickness = AnyThickness<>{ReciprocalQuadratic<>{0.8, 1.3}};
  BodyModel<> plane = solid;
  plane.elastic.thickness.reset();
  return {solid,
          plane,
          BodyModel<>{},
          with_gravity(solid, 1.2, 1.2, 0.7),
          with_gravity(solid, 1.2, 0.8, 0.7),
          with_gravity(plane, 1.2, 0.8, 0.7),
          with_gravity(BodyModel<>{}, 1.0, 1.0, 1.0)};
}

constexpr double h = 1e-5;
constexpr double near = 1e-8;

TEST(BodyModel, DerivativesInTheStretchAreSlopesOfTheEnergy) {
  int body = 0;
  for (BodyModel<> model : bodies()) {
    SCOPED_TRACE(body++);
    for (const bool held : {false, true}) {
      if (held) model.volume = 1.1;
      const auto at = [&](const Vector4<double>& x) {
        return model.derivatives<2>(Stretch{x[0], x[1], x[2], x[3]});
      };
      Vector4<double> x(0.3, 1.2, 0.9, 1.1);
      // Along the volume that is held rho is no variable.
      const int variables = held ? 3 : 4;
      for (int j = 0; j < variables; ++j) {
        Vector4<double> ahead = x;
        Vector4<double> behind = x;
        ahead[j] += h;
        behind[j] -= h;
        const auto up = at(ahead);
        const auto down = at(behind);
        const auto own = at(x);
        EXPECT_NEAR((up.value - down.value) / (2.0 * h), own.gradient[j], near) << j << held;
        for (int i = 0; i < variables; ++i)
          EXPECT_NEAR((up.gradient[i] - down.gradient[i]) / (2.0 * h), own.hessian(i, j), near)
              << i << j << held;
      }
    }
  }
}

/// J1 = J2: by the invariants it is the same.
TEST(BodyModel, AnIsotropicOneIsTheSameByItsInvariants) {
  const Stretch q{0.3, 1.2, 0.9, 1.1};
  for (const BodyModel<>& model : bodies()) {
    if (!model.isotropic()) continue;
    const auto by_q = model.derivatives<2>(q);
    const auto by_invariants = in_stretch<2>(model.evaluate<2>(planar_invariants(q), q.rho), q);
    EXPECT_NEAR(by_q.value, by_invariants.value, 1e-13);
    EXPECT_LT((by_q.gradient - by_invariants.gradient).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_LT((by_q.hessian - by_invariants.hessian).cwiseAbs().maxCoeff(), 1e-12);
  }
}

/// G_k = s_k V_k - c_k s_k^2 in the logarithms, and its slopes; of a held volume without rho.
TEST(BodyModel, TheBalanceIsTheEnergysAndItsSlopesAreSlopes) {
  const std::array rate{0.3, 0.5, 0.4};
  int body = 0;
  for (BodyModel<> model : bodies()) {
    SCOPED_TRACE(body++);
    const Vector4<double> gradient = model.derivatives<1>(Stretch{0.0, 1.2, 0.9, 1.1}).gradient;
    for (const bool held : {false, true}) {
      if (held) {
        model.volume = 1.1;
        model.stiffness = 1.7;
      }
      using Three = std::array<double, 3>;
      const auto at = [&](const Three& s) {
        return model.log_balance(s[0], s[1], s[2], rate[0], rate[1], rate[2]);
      };
      const auto values = [](const LogBalance<double>& b) {
        return Three{b.g_xi, b.g_zeta, b.g_rho};
      };
      const Three s{1.2, 0.9, 1.1};
      const LogBalance<double> own = at(s);
      const double slope[3][3] = {
          {own.uu, own.uv, own.uw}, {own.uv, own.vv, own.vw}, {own.uw, own.vw, own.ww}};
      for (std::size_t j = 0; j < 3; ++j) {
        Three ahead = s;
        Three behind = s;
        ahead[j] *= std::exp(h);
        behind[j] *= std::exp(-h);
        const Three up = values(at(ahead));
        const Three down = values(at(behind));
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_NEAR((up[i] - down[i]) / (2.0 * h), slope[i][j], near) << i << j << held;
        if (!held) {
          EXPECT_NEAR(values(own)[j],
                      s[j] * gradient[static_cast<int>(j) + 1] - rate[j] * s[j] * s[j], 1e-13);
        }
      }
      if (!held) continue;
      // G_u - G_w at the volume, and the volume's own equation.
      const double rho = *model.volume / (s[0] * s[1]);
      const LogBalance<double> all = model.whole<1>(s[0], s[1], rho, rate[0], rate[1], rate[2]);
      const double excess = model.stiffness * std::log(s[0] * s[1] * s[2] / *model.volume);
      EXPECT_NEAR(own.g_xi, all.g_xi - all.g_rho + excess, 1e-13);
      EXPECT_NEAR(own.g_zeta, all.g_zeta - all.g_rho + excess, 1e-13);
      EXPECT_NEAR(own.g_rho, excess, 1e-13);
    }
  }
}

/// The derivatives along a held volume are the same whatever rho is: a stretch of another volume is
/// no solution by what its volume is off alone.
TEST(BodyModel, AStretchOfAnotherVolumeIsNoSolution) {
  const Body body(1.2, 0.8, 0.7);
  BodyModel<> model = bodies()[4];
  model.J = {body.J1, body.J2, body.J3};
  model.volume = 1.1;
  model.stiffness = volume_stiffness(model);
  const auto [xi, zeta, rho] = rest_state(model);
  const Potential potential(model);
  const Vector3<double> at_rest = Vector3<double>::Zero();
  EXPECT_LT(check_balance(body, potential, {0.0, xi, zeta, rho}, at_rest).residual, 1e-12);
  for (const double off : {1e-9, -1e-6, 1e-3, -0.3}) {
    const Stretch q{0.0, xi, zeta, rho * (1.0 + off)};
    EXPECT_GE(check_balance(body, potential, q, at_rest).residual, 0.99 * std::abs(off)) << off;
  }
}

TEST(BodyModel, AFluidIsABodyWithoutElasticEnergy) {
  BodyModel<> fluid;
  fluid.volume = 1.3;
  EXPECT_TRUE(is_fluid(Potential(fluid)));
  BodyModel<> solid = bodies()[4];
  EXPECT_FALSE(is_fluid(Potential(solid)));
  solid.volume = 1.3;
  EXPECT_FALSE(is_fluid(Potential(solid)));
  EXPECT_FALSE(is_fluid(Potential(Hencky<>{1.0, 0.6}, ReciprocalQuadratic<>{0.8, 1.3})));
}

/// Also where J1 J2 J3 is beyond the range of doubles.
TEST(RoundBody, HasTheMeanOfTheInertias) {
  EXPECT_NEAR(round_body(Body(1.0, 2.0, 4.0)).J1, 2.0, 1e-15);
  for (const double scale : {1e-150, 1e-110, 1e105, 1e150}) {
    const Body round = round_body(Body(scale, 2.0 * scale, 4.0 * scale));
    EXPECT_NEAR(round.J1 / scale, 2.0, 1e-14) << scale;
    EXPECT_EQ(round.J1, round.J3);
  }
}

/// Of stretches from 1e-3 to 1e3 alone; between, it is the minimum.
TEST(BodyModel, RestIsWithinItsRange) {
  for (const double rest : {0.01, 0.5, 1.0, 30.0, 900.0, 2e3, 1e4, 1e8}) {
    BodyModel<> model;
    model.elastic.plane = AnyPlane<>{Hencky<>{1.0, 0.6}};
    model.elastic.thickness = AnyThickness<>{Harmonic<>{1.0, rest}};
    const auto [xi, zeta, rho] = rest_state(model);
    if (rest > 1e3) {
      EXPECT_TRUE(std::isnan(xi) && std::isnan(zeta) && std::isnan(rho)) << rest << ": " << rho;
      continue;
    }
    EXPECT_NEAR(xi, 1.0, 1e-12) << rest;
    EXPECT_NEAR(zeta, 1.0, 1e-12) << rest;
    EXPECT_NEAR(rho / rest, 1.0, 1e-12) << rest;
  }
}

}  // namespace
}  // namespace stationary
