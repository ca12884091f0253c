// Seeds of the global search: the best first, apart from each other, inside the box, the same every
// time, and near every zero of the objective.
#include "solver/newton/nlopt_seed.hpp"

#include <gtest/gtest.h>

#include "tests/support/numbers/law.hpp"

namespace stationary {
namespace {

/// Zeros at three given points, in logarithmic coordinates.
double three_wells(const ReducedVector<2>& x) {
  const double a[3][2] = {{0.02, 30.0}, {1.0, 1.0}, {50.0, 0.02}};
  double product = 1.0;
  for (const auto& well : a) {
    const double u = std::log(x[0] / well[0]);
    const double v = std::log(x[1] / well[1]);
    product *= (u * u + v * v) / (1.0 + u * u + v * v);
  }
  return product;
}

TEST(NloptSeeds, SomeSeedIsNearEveryZero) {
  const Seeds<2> seeds = nlopt_seeds<2>(three_wells, {});
  for (const ReducedVector<2>& zero :
       {ReducedVector<2>(0.02, 30.0), ReducedVector<2>(1.0, 1.0), ReducedVector<2>(50.0, 0.02)}) {
    double nearest = 1e9;
    for (const auto& x : seeds.points)
      nearest = std::min(nearest, (x.array() / zero.array()).log().abs().maxCoeff());
    EXPECT_LE(nearest, 0.3) << zero.transpose();
  }
}

TEST(NloptSeeds, BestFirstApartAndInTheBox) {
  SeedOptions options;
  options.min_stretch = 1e-2;
  options.max_stretch = 1e2;
  options.seeds = 20;
  options.separation = 0.3;
  const Seeds<2> seeds = nlopt_seeds<2>(three_wells, options);
  ASSERT_EQ(seeds.points.size(), 20u);
  EXPECT_LE(seeds.evaluations, options.evaluations + 10);
  EXPECT_FALSE(seeds.interrupted);
  for (std::size_t i = 0; i < seeds.points.size(); ++i) {
    const auto& x = seeds.points[i];
    EXPECT_GE(x.minCoeff(), 1e-2 * (1 - 1e-12));
    EXPECT_LE(x.maxCoeff(), 1e2 * (1 + 1e-12));
    if (i > 0) {
      EXPECT_GE(three_wells(x), three_wells(seeds.points[i - 1]) * (1 - 1e-9));
    }
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GE((x.array() / seeds.points[j].array()).log().abs().maxCoeff(), 0.3 * (1 - 1e-12));
    }
  }
}

TEST(NloptSeeds, TheSameEveryTime) {
  const Seeds<2> a = nlopt_seeds<2>(three_wells, {});
  const Seeds<2> b = nlopt_seeds<2>(three_wells, {});
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.evaluations, b.evaluations);
}

TEST(NloptSeeds, PointsThatAreNotFiniteAreNoSeeds) {
  const auto half = [](const ReducedVector<2>& x) {
    return x[0] > 1.0 ? std::numeric_limits<double>::quiet_NaN() : three_wells(x);
  };
  const Seeds<2> seeds = nlopt_seeds<2>(half, {});
  ASSERT_FALSE(seeds.points.empty());
  for (const auto& x : seeds.points) EXPECT_LE(x[0], 1.0);
  const Seeds<2> none = nlopt_seeds<2>(
      [](const ReducedVector<2>&) { return std::numeric_limits<double>::infinity(); }, {});
  EXPECT_TRUE(none.points.empty());
  EXPECT_GT(none.evaluations, 0);
}

TEST(NloptSeeds, StopsWhenAsked) {
  std::atomic<bool> stop = false;
  SeedOptions options;
  options.stop = &stop;
  int evaluations = 0;
  const Seeds<3> seeds = nlopt_seeds<3>(
      [&](const ReducedVector<3>& x) {
        if (++evaluations == 100) stop = true;
        return x.squaredNorm();
      },
      options);
  EXPECT_TRUE(seeds.interrupted);
  EXPECT_LT(evaluations, 200);
}

}  // namespace
}  // namespace stationary
