// What vanishes where the circle of a figure about axis 1 or 2 breaks, against its closed form.
#include <gtest/gtest.h>

#include "solver/family/axis_family.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {
namespace {

/// neo-hookean-3d: zeta e^s and rho e^-s leave the volume, so that the reduced energy is (mu - J nu^2)
/// (zeta^2 + rho^2)/2 along s but for a constant; in (ii) of xi and rho.
TEST(RoundStiffness, OfNeoHookeanIsWhatTheSpinLeavesOfMu) {
  const double mu = 1.1;
  const double J = 0.7;
  const Potential V(NeoHookean3d<>{mu, 2.0});
  for (const Branch branch : {Branch::i, Branch::ii}) {
    const Body body = branch == Branch::i ? Body(1.3, J, J) : Body(J, 1.3, J);
    const Problem problem(body, V, branch);
    const AnyFamily any = axis_family(problem, {.nu = 0.0, .parameter = {}, .spectrum = false});
    const auto& family = *std::get<std::unique_ptr<Family<3>>>(any);
    for (const double nu : {0.1, 0.4, 0.7, 1.0}) {
      const Equilibrium at = solve(problem, nu);
      ASSERT_EQ(at.status, SolveStatus::solved) << at.message;
      const ReducedVector<3> tail =
          ReducedVector<3>::Constant(std::numeric_limits<double>::quiet_NaN());
      const Member member = family.member(family.coordinates(at.q, nu), tail, nu, 1e-15);
      const double pull = J * nu * nu;
      const double left = mu - pull;
      EXPECT_NEAR(member.round_stiffness, left / (std::abs(left) + pull), 1e-12) << nu;
    }
  }
}

}  // namespace
}  // namespace stationary
