// Which circle the figures of a body may be is seen from its inertias and its potential alone.
#include "solver/motion/body_circle.hpp"

#include <gtest/gtest.h>

#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

const Body equal_23{1.3, 0.7, 0.7};
const Body equal_13{0.7, 1.3, 0.7};
const Body equal_12{0.7, 0.7, 1.3};

const Potential coupled(NeoHookean3d<>{1.1, 0.6});

/// The same sums of the three stretches in another order round to other numbers.
Potential written(std::string_view text) {
  return Potential(support::written_coupled(text, {"mu", "la"}, {1.1, 0.6}));
}

TEST(BodyCircle, IsOfTheTwoEqualInertiasAboutTheThird) {
  const Potential symmetric[] = {
      coupled, written("mu/2*(I1 + rho^2 - 3 - 2*log(d*rho)) + la/2*log(d*rho)^2"),
      written("mu*(I1 + rho^2 - 3)/3 - mu*log(d*rho) + la*(exp(d*rho/7) + 0.1/(d*rho))")};
  for (const Potential& V : symmetric) {
    EXPECT_EQ(circle_of({equal_23, V, Branch::i}), Circle::zeta_rho);
    EXPECT_EQ(circle_of({equal_13, V, Branch::ii}), Circle::xi_rho);
    EXPECT_EQ(circle_of({equal_12, V, Branch::iii}), Circle::xi_zeta);
    EXPECT_EQ(circle_of({equal_13, V, Branch::i}), Circle::none);
    EXPECT_EQ(circle_of({equal_12, V, Branch::ii}), Circle::none);
    EXPECT_EQ(circle_of({equal_23, V, Branch::iii}), Circle::none);
  }
}

TEST(BodyCircle, NeedsAPotentialThatDoesNotTellTheStretchesApart) {
  const Potential apart[] = {
      Potential(Hencky<>{1.0, 0.6}, ReciprocalQuadratic<>{0.8, 1.3}),
      written("mu/2*(I1 + 1.000001*rho^2 - 3 - 2*log(d*rho)) + la/2*log(d*rho)^2"),
      written("mu/2*(I1 + rho^2 - 3 - 2*log(d*rho)) + la/2*log(d*rho)^2 + 0.001*log(rho)")};
  for (const Potential& V : apart) {
    EXPECT_EQ(circle_of({equal_23, V, Branch::i}), Circle::none);
    EXPECT_EQ(circle_of({equal_13, V, Branch::ii}), Circle::none);
    EXPECT_EQ(circle_of({equal_12, V, Branch::iii}), Circle::xi_zeta);
  }
  const AnisotropicPotential fibred(NeoHookean3d<>{1.1, 0.6}, {{0.4, 20.0}});
  EXPECT_EQ(circle_of({equal_12, Potential(fibred), Branch::iii}), Circle::none);
  EXPECT_EQ(circle_of({equal_23, Potential(fibred), Branch::i}), Circle::none);
}

TEST(BodyCircle, AFamilyInOneOfTheTwoInertiasHasNone) {
  using Kind = FamilyParameter::Kind;
  for (const int index : {0, 1, 2}) {
    EXPECT_EQ(circle_of({equal_23, coupled, Branch::i}, {Kind::inertia, index}),
              index == 0 ? Circle::zeta_rho : Circle::none);
  }
  EXPECT_EQ(circle_of({equal_23, coupled, Branch::i}, {Kind::plane, 1}), Circle::zeta_rho);
}

/// Whatever double the volume is.
TEST(BodyCircle, AFamilyInAHeldVolumeKeepsItsCircle) {
  using Kind = FamilyParameter::Kind;
  for (const double volume : {1.0, 1.1, 0.7, 4.18879}) {
    BodyModel<> held;
    held.elastic.coupled = NeoHookean3d<>{1.1, 0.6};
    held.volume = volume;
    EXPECT_EQ(circle_of({equal_23, Potential(held), Branch::i},
                        {Kind::plane, static_cast<int>(BodyModel<>::volume_place)}),
              Circle::zeta_rho)
        << volume;
  }
}

TEST(BodyCircle, AFamilyInACoefficientThatTellsTheStretchesApartHasNone) {
  using Kind = FamilyParameter::Kind;
  for (const double own : {0.0, 0.3}) {
    const Potential V(support::written_coupled(
        "mu/2*(I1 + rho^2 - 3 - 2*log(d*rho)) + la/2*log(d*rho)^2 + e*(rho - 1)^2",
        {"mu", "la", "e"}, {1.1, 0.6, own}));
    EXPECT_EQ(circle_of({equal_23, V, Branch::i}, {Kind::plane, 2}), Circle::none) << own;
    EXPECT_EQ(circle_of({equal_23, V, Branch::i}, {Kind::plane, 0}),
              own == 0.0 ? Circle::zeta_rho : Circle::none);
  }
}

}  // namespace
}  // namespace stationary
