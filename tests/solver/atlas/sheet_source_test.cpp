// Of a motion and its mirror images an atlas keeps one place.
#include "solver/atlas/sheet_source.hpp"

#include <gtest/gtest.h>

namespace stationary {
namespace {

const Potential separable(Hencky<>{1.0, 3.0}, ReciprocalQuadratic<>{1.0, 3.0});
const Potential coupled(NeoHookean3d<>{1.0, 2.0});

void expect_place(const SheetSource& source, const Stretch& at, const Stretch& kept) {
  const Stretch found = source.canonical({at}).q;
  EXPECT_EQ(found.alpha, kept.alpha);
  EXPECT_DOUBLE_EQ(found.xi, kept.xi);
  EXPECT_DOUBLE_EQ(found.zeta, kept.zeta);
  EXPECT_DOUBLE_EQ(found.rho, kept.rho);
}

TEST(SheetSource, WithoutACircleEveryPlaceIsItsOwn) {
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
    const auto source = axis_sheets(Problem(Body(1.0, 1.7, 0.6), separable, branch));
    for (const Stretch& q : {Stretch{0.0, 0.8, 1.3, 0.9}, Stretch{0.0, 1.3, 0.8, 0.9}})
      expect_place(*source, q, q);
  }
}

TEST(SheetSource, OfAnEllipseAndItsImageTheOneAlongTheFirstAxisIsKept) {
  const auto third = axis_sheets(Problem(Body(1.7, 1.7, 0.6), separable, Branch::iii));
  expect_place(*third, {0.0, 0.8, 1.3, 0.9}, {0.0, 1.3, 0.8, 0.9});
  expect_place(*third, {0.0, 1.3, 0.8, 0.9}, {0.0, 1.3, 0.8, 0.9});
  expect_place(*third, {0.0, 1.1, 1.1, 0.9}, {0.0, 1.1, 1.1, 0.9});
  const auto first = axis_sheets(Problem(Body(0.6, 1.7, 1.7), coupled, Branch::i));
  expect_place(*first, {0.0, 0.9, 0.8, 1.3}, {0.0, 0.9, 1.3, 0.8});
  expect_place(*first, {0.0, 0.9, 1.3, 0.8}, {0.0, 0.9, 1.3, 0.8});
}

}  // namespace
}  // namespace stationary
