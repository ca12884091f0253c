// A box of stretches whose volume is held is narrowed to what the others leave of each, and loses
// no stretch of that volume.
#include <gtest/gtest.h>

#include <optional>

#include "lib/material/gravitating/body_model.hpp"
#include "solver/proof/box_balance.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

TEST(BoxContract, OfAHeldVolumeNarrowsAndLosesNothing) {
  support::Random random(28);
  BodyModel<> model;
  model.elastic.coupled = NeoHookean3d<>{1.0, 0.6};
  model.volume = 1.3;
  using System = CoupledBoxSystem<decltype(interval_model(model, Inputs::decimals))>;
  const System system{interval_model(model, Inputs::decimals),
                      {Interval(0.1), Interval(0.2), Interval(0.0)}};
  int narrowed = 0;
  int empty = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Box<3> box;
    for (Interval& side : box) {
      const double middle = random.log_uniform(0.3, 3.0);
      const double ratio = random.log_uniform(1.01, 2.5);
      side = {middle / ratio, middle * ratio};
    }
    Box<3> left = box;
    const bool some = system.contract(left);
    empty += some ? 0 : 1;
    for (std::size_t k = 0; k < 3 && some; ++k) {
      EXPECT_TRUE(left[k].within(box[k])) << trial << " " << k;
      narrowed += left[k].width() < 0.9 * box[k].width() ? 1 : 0;
    }
    for (int point = 0; point < 20; ++point) {
      const double xi = random.log_uniform(box[0].lo, box[0].hi);
      const double zeta = random.log_uniform(box[1].lo, box[1].hi);
      const double rho = *model.volume / (xi * zeta);
      if (!(rho > box[2].lo * (1.0 + 1e-12) && rho < box[2].hi * (1.0 - 1e-12))) continue;
      ASSERT_TRUE(some) << trial;
      EXPECT_TRUE(left[0].may_be(xi) && left[1].may_be(zeta) && left[2].may_be(rho)) << trial;
    }
  }
  EXPECT_GT(narrowed, 500);
  EXPECT_GT(empty, 100);
}

}  // namespace
}  // namespace stationary
