// Krawczyk's test and the inverse that it is preconditioned by, on equations whose solutions are known.
#include "solver/proof/krawczyk.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stationary {
namespace {

/// x y = 6, x + y = sum: (2, 3) where the sum is 5; a double root where it is 2 sqrt 6.
struct SumAndProduct {
  static constexpr int dimension = 2;
  double sum;

  GeneralBoxLinearized<2> linearize(const Box<2>& x) const {
    const Interval product = x[0] * x[1];
    GeneralBoxLinearized<2> out;
    out.g = {product - Interval(6.0), x[0] + x[1] - Interval(sum)};
    out.slope = {Box<2>{product, product}, Box<2>{x[0], x[1]}};
    return out;
  }
};

TEST(Krawczyk, ProvesTheSolutionThatIsKnown) {
  const SumAndProduct system{5.0};
  const Krawczyk test(system, ReducedVector<2>(2.0 + 1e-9, 3.0 - 1e-9));
  const Proof<2> proof = test.prove();
  ASSERT_TRUE(proof.proven);
  EXPECT_TRUE(Interval(2.0).within(proof.solution[0]));
  EXPECT_TRUE(Interval(3.0).within(proof.solution[1]));
  EXPECT_TRUE(proof.solution[0].within(proof.unique[0]));
  EXPECT_GE(proof.error_bound, 0.99 * 1e-9 / 2.0);  // the true error of the first
  EXPECT_LT(proof.error_bound, 1e-9);
  EXPECT_TRUE(test.unique_within(0.01));
  EXPECT_FALSE(test.unique_within(0.19));  // (3, 2) is too near for a proof over so wide a box
}

/// From far off K(D) leaves 0 out, and what is told next must be true of the solution all the same.
TEST(Krawczyk, HoldsTheSolutionFromFarOffToo) {
  const SumAndProduct system{5.0};
  for (const double off : {1e-6, 1e-4, 1e-3, 1e-2}) {
    const Krawczyk test(system, ReducedVector<2>(2.0 + off, 3.0 - off));
    const Proof<2> proof = test.prove();
    ASSERT_TRUE(proof.proven) << off;
    EXPECT_TRUE(Interval(2.0).within(proof.solution[0])) << off;
    EXPECT_TRUE(Interval(3.0).within(proof.solution[1])) << off;
    EXPECT_GE(proof.error_bound, off / 2.0 * (1.0 - 1e-15)) << off;
    EXPECT_LE(proof.error_bound, off) << off;
  }
}

TEST(Krawczyk, ProvesNothingWhereThereIsNoneOrTwoInOne) {
  const SumAndProduct none{4.0};
  EXPECT_FALSE(Krawczyk(none, ReducedVector<2>(2.0, 3.0)).prove().proven);
  const double root = std::sqrt(6.0);
  const SumAndProduct twice{2.0 * root};
  EXPECT_FALSE(Krawczyk(twice, ReducedVector<2>(root, root)).prove().proven);
}

/// Far stiffer in volume than in shape: its cofactors cancel, the elimination of a symmetric matrix does not.
TEST(BoxSlopes, ASymmetricSystemIsInvertedAsOne) {
  constexpr double stiff = 0x1p40;
  const BoxLinearized<3> over{{},
                              {Interval(stiff + 1.0), Interval(stiff), Interval(stiff),
                               Interval(stiff + 2.0), Interval(stiff), Interval(stiff + 4.0)}};
  const BoxSlopes<3> slopes(over);
  ASSERT_TRUE(slopes.symmetric);
  EXPECT_EQ(slopes(2, 0).lo, over(0, 2).lo);
  EXPECT_EQ(slopes.inverse(), over.middle().inverse().matrix());
  // D^-1 - D^-1 1 1^T D^-1/(1/stiff + sum of D^-1), D = diag(1, 2, 4).
  const double total = 1.0 / (1.0 / stiff + 1.75);
  const Eigen::Vector3d d(1.0, 0.5, 0.25);
  const Eigen::Matrix3d expected = Eigen::Matrix3d(d.asDiagonal()) - total * d * d.transpose();
  EXPECT_LT((slopes.inverse() - expected).cwiseAbs().maxCoeff(), 1e-3);
}

TEST(BoxSlopes, OneWithoutSymmetryIsInvertedAsItIs) {
  const Box<2> at{Interval(2.0), Interval(3.0)};
  const BoxSlopes<2> slopes(SumAndProduct{5.0}.linearize(at));
  EXPECT_FALSE(slopes.symmetric);
  const Eigen::Matrix2d expected{{0.5, -1.0}, {-1.0 / 3.0, 1.0}};  // of [[6, 6], [2, 3]]
  EXPECT_LT((slopes.inverse() - expected).cwiseAbs().maxCoeff(), 1e-15);
}

}  // namespace
}  // namespace stationary
