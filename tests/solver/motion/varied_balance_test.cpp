// The elastic balance whose numbers are given one by one: the parameter of a family is p, and an
// input that changes is the one that is named.
#include "solver/motion/varied_balance.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace stationary {
namespace {

TEST(VariedElastic, TakesTheParameterAndTheInputThatChanges) {
  using Kind = FamilyParameter::Kind;
  const Potential potentials[] = {Potential(Hencky<>{1.1, 0.6}, ReciprocalQuadratic<>{0.8, 1.3}),
                                  Potential(SaintVenantKirchhoff<>{0.9, 0.4}, Harmonic<>{2.0, 0.9}),
                                  Potential(NeoHookean3d<>{1.1, 0.6})};
  const std::vector<FamilyParameter> parameters{{Kind::nu, 0},        {Kind::inertia, 1},
                                                {Kind::plane, 0},     {Kind::plane, 1},
                                                {Kind::thickness, 0}, {Kind::thickness, 1}};
  const DoubleDouble xi(1.3);
  const DoubleDouble zeta(0.8);
  const DoubleDouble rho(1.1);
  const DoubleDouble p(1.7);
  constexpr double h = 0x1p-6;
  for (const Potential& V : potentials) {
    for (const FamilyParameter& parameter : parameters) {
      const VariedElastic elastic(V, parameter);
      const auto inputs = coefficient_inputs(V, parameter);
      ASSERT_EQ(elastic.inputs(), inputs.size());
      for (std::size_t k = 0; k <= inputs.size(); ++k) {
        const bool none = k == inputs.size();
        const auto number = [&](double value, Kind kind, int index) {
          if (kind == parameter.kind && index == parameter.index) return p;
          const bool own = !none && kind == inputs[k].kind && index == inputs[k].index;
          return DoubleDouble(own ? value * (1.0 + h) : value);
        };
        const CentrifugalRates<DoubleDouble> at_rest{0.0, 0.0, 0.0};
        const auto wanted = varied_balance(V, xi, zeta, rho, at_rest, number);
        const auto found = elastic.at(xi, zeta, rho, p, none ? InputChange() : InputChange{k, h});
        EXPECT_NEAR(double(found.g_xi), double(wanted.g_xi), 1e-14) << k;
        EXPECT_NEAR(double(found.g_zeta), double(wanted.g_zeta), 1e-14) << k;
        EXPECT_NEAR(double(found.g_rho), double(wanted.g_rho), 1e-14) << k;
      }
    }
  }
}

}  // namespace
}  // namespace stationary
