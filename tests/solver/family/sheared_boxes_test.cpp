// The axis of a motion about none in a material plane, from its stretches in intervals.
#include "solver/family/sheared_boxes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "tests/support/bodies/whole_body.hpp"

namespace stationary {
namespace {

using namespace testing;

/// Each where its squares have their signs: (1 - sigma/tau) w and 2 V_T + (sigma/tau) w. The stretches need not
/// solve the balance.
TEST(ShearedBoxesTest, AnAxisIsGivenWhereBothSquaresArePositive) {
  const Body body(1.0, 1.7, 0.9);
  const AnyPlane<> plane{Biot<>{1.1, 0.8}};
  const AnyThickness<> thickness{ReciprocalQuadratic<>{1.0, 3.0}};
  struct Posed {
    std::optional<double> g;
    double nu;
    double d;  ///< rho = 1/d
    bool in_plane;
    bool normal;
  };
  // V_T > 0, so that w < 0 where |nu| is small. tau > sigma where d is.
  for (const Posed& at : {Posed{{}, 1.3, 0.5, true, true}, Posed{{}, 1.3, 2.0, false, true},
                          Posed{0.4, 2.0, 0.5, true, true}, Posed{0.4, 2.0, 2.0, false, true},
                          Posed{0.4, 1e-3, 2.0, true, false}, Posed{0.4, 1e-3, 0.5, false, true}}) {
    const ShearedEquations<3> equations(body, whole_body(plane, thickness, 1.0, at.g, body),
                                        ShearedAxis::in_no_plane, false);
    const ShearedBoxes<3> boxes(equations, at.nu, Inputs::doubles);
    const double root = std::sqrt(at.d);
    const Box<3> x{Interval(1.2 * root), Interval(root / 1.1), Interval(1.2)};
    const auto squares = boxes.squares(x);
    EXPECT_EQ(squares.in_plane.positive(), at.in_plane) << at.nu << " " << at.d;
    EXPECT_EQ(squares.in_plane.negative(), !at.in_plane) << at.nu << " " << at.d;
    EXPECT_EQ(squares.normal.positive(), at.normal) << at.nu << " " << at.d;
    EXPECT_EQ(squares.normal.negative(), !at.normal) << at.nu << " " << at.d;
    const auto axis = boxes.axis(x);
    ASSERT_EQ(axis.has_value(), at.in_plane && at.normal) << at.nu << " " << at.d;
    if (!axis) continue;
    const Interval length = square((*axis)[0]) + square((*axis)[1]) + square((*axis)[2]);
    EXPECT_TRUE(length.may_be(1.0));
    EXPECT_LE(length.width(), 1e-13);
  }
}

}  // namespace
}  // namespace stationary
