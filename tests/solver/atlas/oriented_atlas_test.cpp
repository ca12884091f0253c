// With J1 = J2 and a potential unchanged with axes 1 and 2 exchanged, oblique families leave (i)
// and (ii) at the same nu: both are in the atlas.
#include <gtest/gtest.h>

#include <vector>

#include "solver/program/case/case_file.hpp"
#include "tests/support/atlas_text.hpp"

namespace stationary {
namespace {

TEST(OrientedAtlas, EveryAxisLosesItsFamily) {
  const Case input = make_case(CaseTree::parse(
      "[body]\nJ = [1.0, 1.0, 0.6]\n[motion]\nbranch = \"i\"\nnu = 0.3\n[potential]\n"
      "plane = { expression = \"m/2*(I1 - 2 - 2*log(d)) + l/2*log(d)^2 + "
      "p*((xi^2-zeta^2)^2 - 4*alpha^2*(xi+zeta)^2)*(1 - r*((xi^2-zeta^2)^2 + "
      "4*alpha^2*(xi+zeta)^2))\", m = 1.0, l = 2.0, p = -0.02, r = 3.0 }\n"
      "thickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n",
      "square"));
  AtlasOptions how;
  how.from = 0.6;
  how.to = 0.75;
  how.checkpoints = 1;
  how.branches = {Branch::i, Branch::ii};
  how.search.max_boxes = 10;  // not searched through: the events lead there
  const Atlas found = atlas(input.body, input.potential, how);
  std::vector<const AtlasSheet*> left;
  for (const AtlasSheet& sheet : found.sheets)
    if (sheet.oblique && sheet.parent) left.push_back(&sheet);
  ASSERT_EQ(left.size(), 2U) << testing::text_of(found);
  EXPECT_NE(left[0]->parent->sheet, left[1]->parent->sheet);
  EXPECT_NEAR(left[0]->parent->nu, left[1]->parent->nu, 1e-9);
}

}  // namespace
}  // namespace stationary
