// The atlas of a body with directions of its own: every sheet about the material axes and about
// oblique ones, against searches; families that leave alpha = 0 entered at their events.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/atlas/atlas.hpp"
#include "solver/solve/anisotropic_equilibrium.hpp"
#include "tests/support/atlas_text.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/bodies/fibred_plates.hpp"

namespace stationary {
namespace {

using namespace testing;

AtlasOptions atlas_range(double from, double to, int checkpoints) {
  AtlasOptions out;
  out.from = from;
  out.to = to;
  out.checkpoints = checkpoints;
  out.step.tolerance = 1e-6;
  return out;
}

/// No search there is left undecided.
TEST(AnisotropicAtlas, OfASkewFibreAxisThreeAndTwoObliqueFamiliesFromRest) {
  AtlasOptions how = atlas_range(0.0, 0.6, 6);
  const Atlas found = atlas(plate, skew_fibres, how);
  EXPECT_EQ(text_of(found), "iii: limit limit; oblique: limit limit; oblique: limit limit; ");
  expect_complete(found);
  ASSERT_EQ(found.checkpoints.size(), 12U);
  for (const Checkpoint& at : found.checkpoints) EXPECT_EQ(at.proven, at.oblique ? 2 : 1) << at.nu;
  for (const AtlasSheet& sheet : found.sheets) {
    EXPECT_EQ(sheet.entry, Entry::rest);
    for (const AtlasRow& row : sheet.rows) EXPECT_LE(row.member.residual, 1e-14);
  }
  // About axes 1 and 2 there is nothing to follow, which is said.
  ASSERT_EQ(found.remarks.size(), 2U);
  EXPECT_FALSE(found.remarks[0].entry);
  EXPECT_EQ(found.remarks[1].branch, Branch::ii);
  EXPECT_EQ(found.remarks[1].reason.substr(0, 14), "not looked for");
  how.threads = 2;
  const Atlas shared = atlas(plate, skew_fibres, how);
  ASSERT_EQ(shared.sheets.size(), found.sheets.size());
  for (std::size_t k = 0; k < found.sheets.size(); ++k) {
    ASSERT_EQ(shared.sheets[k].rows.size(), found.sheets[k].rows.size());
    EXPECT_EQ(shared.sheets[k].rows.back().member.q.alpha,
              found.sheets[k].rows.back().member.q.alpha);
  }
}

/// Very slow spins: an axis is found where it starts.
TEST(AnisotropicAtlas, AxesAreKnownDownToRest) {
  expect_complete(atlas(plate, skew_fibres, atlas_range(0.0, 0.02, 8)));
}

/// The sheets of an even V: (i), (ii) and (iii) have alpha = 0 and the oblique family leaves (i).
TEST(AnisotropicAtlas, AnObliqueFamilyLeavesTheFirstAxis) {
  AtlasOptions how = atlas_range(0.7, 0.76, 2);
  how.branches = {Branch::i};
  const Atlas found = atlas(plate, fibres_along, how);
  ASSERT_EQ(found.sheets.size(), 2U) << text_of(found);
  const AtlasSheet& oblique = found.sheets[1];
  EXPECT_TRUE(oblique.oblique);
  ASSERT_TRUE(oblique.parent);
  EXPECT_EQ(oblique.parent->sheet, 1);
  EXPECT_EQ(oblique.parent->event, EventType::oblique);
  EXPECT_NEAR(oblique.parent->nu, 0.7405, 1e-4);
}

/// Where no checkpoint meets it, it is entered at the event.
TEST(AnisotropicAtlas, AnObliqueFamilyBetweenCheckpointsIsEnteredAtItsEvent) {
  AtlasOptions how = atlas_range(0.735, 0.742, 1);
  how.branches = {Branch::i};
  const Atlas found = atlas(plate, fibres_along, how);
  ASSERT_EQ(found.sheets.size(), 2U) << text_of(found);
  EXPECT_EQ(found.sheets[1].entry, Entry::oblique);
  ASSERT_TRUE(found.sheets[1].parent);
  EXPECT_NEAR(found.sheets[1].entry_nu, found.sheets[1].parent->nu, 1e-12);
}

TEST(AnisotropicAtlas, AnEllipseTurnsAwayFromTheAxes) {
  AtlasOptions how = atlas_range(0.0, 0.75, 3);
  how.branches = {Branch::iii};
  how.oblique = false;
  const Atlas found = atlas(turning_plate, fibres_across, how);
  const auto sheared = std::ranges::find_if(
      found.sheets, [](const AtlasSheet& sheet) { return sheet.parent.has_value(); });
  ASSERT_NE(sheared, found.sheets.end()) << text_of(found);
  EXPECT_EQ(sheared->parent->event, EventType::shear);
  EXPECT_EQ(sheared->parent->sheet, 1);
  long upright = 0;
  for (const AtlasRow& row : sheared->rows) upright += row.member.q.alpha == 0.0;
  EXPECT_EQ(upright, 1);
  // Once, not with its mirror image.
  EXPECT_EQ(std::ranges::count_if(found.sheets,
                                  [](const AtlasSheet& sheet) { return sheet.parent.has_value(); }),
            1);
}

}  // namespace
}  // namespace stationary
