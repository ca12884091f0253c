// Covers of bodies that are not isotropic: those of an isotropic body where the coefficients are its
// own, and between gaps the numbers of motions of searches.
#include <gtest/gtest.h>

#include <set>

#include "solver/search/anisotropic_search.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/covers.hpp"

namespace stationary::testing {
namespace {

/// With mu = c66 and lambda = c12 it is saint-venant-kirchhoff.
TEST(OrientedCover, OfIsotropicCoefficientsIsThatOfTheIsotropicBody) {
  const double mu = 1.1;
  const double lambda = 0.7;
  const double stiff = 2.0 * mu + lambda;
  const AnisotropicPotential V(OrthotropicSaintVenantKirchhoff<>{stiff, stiff, lambda, mu},
                               plate_thickness, {});
  const Potential isotropic(SaintVenantKirchhoff<>{mu, lambda}, plate_thickness);
  const double to = 3.0;
  for (const Branch branch : {Branch::i, Branch::ii}) {
    const auto cover =
        cover_oriented({plate, Potential(V), branch}, false, 0.0, to, {}, /*classes=*/false);
    ASSERT_TRUE(cover.has_value());
    const KindCover meant = cover_axis({plate, isotropic, branch}, 0.0, to, {}, /*classes=*/false);
    EXPECT_LT(length_of(*cover), 1e-9) << name(branch);
    ASSERT_EQ(cover->gaps.size(), meant.gaps.size()) << name(branch);
    EXPECT_FALSE(meant.gaps.empty() && branch == Branch::i);
    for (std::size_t k = 0; k < meant.gaps.size(); ++k) {
      EXPECT_FALSE(cover->gaps[k].undecided);
      EXPECT_EQ(cover->gaps[k].turns, meant.gaps[k].turns);
      EXPECT_EQ(cover->gaps[k].crosses, meant.gaps[k].crosses);
      EXPECT_NEAR(cover->gaps[k].nu.mid(), meant.gaps[k].nu.mid(), 1e-11);
    }
  }
}

/// Fibres along axis 1, and aslant: alpha is an unknown about axis 3.
TEST(OrientedCover, AgreesWithSearches) {
  int parts = 0;
  for (const double degrees : {0.0, 25.0}) {
    const AnisotropicPotential V(NeoHookean<>{1.0, 1.5}, plate_thickness, {{0.3, degrees}});
    for (const Branch branch : {Branch::i, Branch::iii}) {
      if (branch == Branch::i && !V.shear_free()) continue;
      const double from = 0.1;
      const double to = 0.6;
      const auto cover =
          cover_oriented({plate, Potential(V), branch}, false, from, to, {}, /*classes=*/false);
      ASSERT_TRUE(cover.has_value());
      EXPECT_LT(length_of(*cover), 1e-3 * (to - from)) << name(branch) << " " << degrees;
      for (const auto& [begin, end] : known_parts(*cover, from, to, 1e-3)) {
        std::set<std::size_t> numbers;
        for (const double part : {0.1, 0.5, 0.9}) {
          const SearchResult found =
              search_anisotropic({plate, Potential(V), branch}, begin + part * (end - begin), {});
          EXPECT_EQ(found.status, SearchStatus::complete);
          numbers.insert(found.solutions.size());
        }
        EXPECT_EQ(numbers.size(), 1U) << name(branch) << " " << degrees << " from " << begin;
        ++parts;
      }
    }
  }
  EXPECT_GE(parts, 3);
}

TEST(OrientedCover, FiveUnknownsAreNotCovered) {
  const AnisotropicPotential V(NeoHookean3d<>{1.0, 1.5}, {{0.3, 25.0}});
  EXPECT_FALSE(cover_oriented({plate, Potential(V), Branch::i}, true, 0.1, 0.6, {}).has_value());
}

}  // namespace
}  // namespace stationary::testing
