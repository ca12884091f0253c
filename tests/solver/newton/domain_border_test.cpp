// Steps of a solve where a formula is not defined everywhere: none leaves the domain between its
// ends, and a walk from rest says that a border stops it. And where such a walk comes back to rest.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "solver/continuation/rest_walk.hpp"
#include "solver/newton/newton.hpp"
#include "solver/proof/oriented_boxes.hpp"
#include "tests/support/bodies/written_potential.hpp"

namespace stationary {
namespace {

using System = PlanarSystem<PlanarExpression<>>;

/// Defined where ln d is not within 1/50 of a quarter, a half, or three quarters.
TEST(DomainBorder, NoStepLeapsOverWhatIsNotDefined) {
  for (const double middle : {0.25, 0.5, 0.75}) {
    const std::string text =
        "mu/2*I1 - mu*log(d) + mu*log((log(d) - " + std::to_string(middle) + ")^2 - 0.0004)";
    const System system{support::written_plane(text, {"mu"}, {1.0}), {0.0, 0.0, 0.0}};
    const auto at = [](double log_d) {
      return ReducedVector<2>(1.3 * std::exp(0.5 * log_d), std::exp(0.5 * log_d) / 1.3);
    };
    EXPECT_FALSE(stays_inside(system, at(0.0), at(1.0))) << middle;
    EXPECT_FALSE(stays_inside(system, at(1.0), at(0.0))) << middle;
    EXPECT_TRUE(stays_inside(system, at(-1.0), at(0.2))) << middle;
    EXPECT_TRUE(stays_inside(system, at(0.8), at(2.0))) << middle;
  }
}

/// Circles with xi^2 = mu/(mu - c) nearly, and the formula ends at d = 1.44 without any force there.
TEST(DomainBorder, AWalkEndsAtTheBorder) {
  const PlanarExpression<> model =
      support::written_plane("mu/2*I1 - mu*log(d) + k*sqrt(1.44 - d)^5", {"mu", "k"}, {1.0, 0.001});
  ReducedVector<2> rest(1.0, 1.0);
  ASSERT_TRUE(newton(System{model, {0.0, 0.0, 0.0}}, rest, NewtonOptions()).converged);
  const auto walk = [&](double c_xi, double c_zeta) {
    return RestWalk<System>(System{model, {c_xi, c_zeta, 0.0}}, rest, {}).run(nullptr);
  };
  const auto inside = walk(0.3, 0.1);
  EXPECT_EQ(inside.end, WalkEnd::reached);
  EXPECT_EQ(inside.border, nullptr);
  for (const double c_zeta : {0.1, 0.3, 0.6}) {
    const auto stopped = walk(0.6, c_zeta);
    ASSERT_EQ(stopped.end, WalkEnd::at_border) << c_zeta;
    ASSERT_NE(stopped.border, nullptr);
    EXPECT_TRUE(stopped.border->positive);
    EXPECT_NEAR(stopped.x[0] * stopped.x[1], 1.44, 1e-3);
    EXPECT_LT(stopped.largest_tau, 1.0);
  }
}

/// nu^2 rises from rest, falls below 0 and rises again, which a long step may not see: the sheet ends at another state of
/// rest, and what it reaches beyond is another one.
TEST(DomainBorder, AWalkEndsAtAnotherStateOfRest) {
  struct Case {
    double k, w, c_xi, c_zeta, largest;
  };
  for (const auto& [k, w, c_xi, c_zeta, largest] :
       {Case{0.29737, 1.82779, 0.99318869, 0.53470847, 0.0812},
        Case{0.0812579, 3.51335, 0.64663884, 0.97252393, 0.00624},
        Case{0.0958743, 3.22362, 0.7561435, 0.75613105, 0.00746}}) {
    const PlanarExpression<> model = support::written_plane("mu/2*I1 - mu*log(d) + k*cos(w*log(d))",
                                                            {"mu", "k", "w"}, {1, k, w});
    ReducedVector<2> rest = ReducedVector<2>::Constant(model.rest_stretch());
    ASSERT_TRUE(newton(System{model, {0.0, 0.0, 0.0}}, rest, NewtonOptions()).converged);
    for (const double first : {0.003, 0.05, 0.5, 1.5}) {
      WalkOptions options;
      options.step.first = first;
      const auto back =
          RestWalk<System>(System{model, {c_xi, c_zeta, 0.0}}, rest, options).run(nullptr);
      EXPECT_EQ(back.end, WalkEnd::turned_back) << k << " " << first;
      EXPECT_NEAR(back.largest_tau, largest, 0.01 * largest) << k << " " << first;
    }
  }
}

/// A box in which a formula is defined nowhere holds no solution of a body with fibres.
TEST(DomainBorder, ABoxOutsideTheDomainIsExcluded) {
  const AnisotropicPotential V(AnisotropicPotential::Plane(Hencky<>{1.0, 0.6}),
                               AnyThickness<>{support::written_thickness(
                                   "k*(rho - 2)^2 + k*sqrt(rho - 1.9)^5", {"k"}, {0.7})},
                               {{0.4, 30.0}});
  const OrientedBoxSystem<ShearedLayout> system(Body(1.0, 1.7, 0.6), V, Branch::iii, 0.1,
                                                Inputs::decimals);
  const Interval near_one(0.5, 2.0);
  EXPECT_FALSE(system.excludes({near_one, near_one, {1.5, 2.5}, near_one}));
  EXPECT_FALSE(system.excludes({near_one, near_one, {1.95, 2.05}, near_one}));
  EXPECT_TRUE(system.excludes({near_one, near_one, {0.5, 1.8}, near_one}));
  EXPECT_TRUE(system.excludes({near_one, near_one, {1.89, 1.899}, near_one}));
}

}  // namespace
}  // namespace stationary
