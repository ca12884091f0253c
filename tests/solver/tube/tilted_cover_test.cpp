// Covers of motions about a tilted axis: between the points where sheets turn, end in a tilt or leave the
// box the number of motions is that of searches, and between class gaps so are their classes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "solver/proof/tilted_enclosure.hpp"
#include "solver/search/tilted_search.hpp"
#include "tests/support/bodies/whole_body.hpp"
#include "tests/support/covers.hpp"

namespace stationary::testing {
namespace {

using Classes = std::map<StabilityClass, int>;

struct TiltedBody {
  Body body;
  Potential potential;
  double from;
  double to;
};

std::vector<TiltedBody> tilted_bodies() {
  const AnyThickness<> thickness{ReciprocalQuadratic<>{1.0, 3.0}};
  const Body plate(1.0, 1.7, 0.6);
  const Body flat(1.0, 1.3, 1.9);
  const AnyPlane<> hencky{Hencky<>{1.0, 0.7}};
  return {
      {plate, Potential(NeoHookean<>{1.0, 0.6}, ReciprocalQuadratic<>{1.0, 3.0}), 0.3, 1.6},
      {plate, Potential(BiotLog<>{1.0, 0.6}, ReciprocalQuadratic<>{1.0, 3.0}), 0.3, 1.6},
      {flat, Potential(Hencky<>{1.0, 0.7}, ReciprocalQuadratic<>{0.4, 2.0}), 0.2, 1.2},
      {Body(1.0, 1.0, 1.4), Potential(NeoHookean<>{1.0, 0.6}, ReciprocalQuadratic<>{1.0, 3.0}), 0.2,
       1.2},
      {flat, Potential(NeoHookean3d<>{1.0, 0.8}), 0.2, 1.4},
      {flat, whole_body(hencky, thickness, 1.0, {}, flat), 0.2, 1.4},
  };
}

TEST(TiltedCover, AgreesWithSearches) {
  int parts = 0;
  int ends = 0;
  int motions = 0;
  for (const TiltedBody& each : tilted_bodies()) {
    for (const TiltPlane plane : {TiltPlane::one_three, TiltPlane::two_three}) {
      SCOPED_TRACE(std::string(name(plane)) + " " + std::to_string(parts));
      const KindCover cover =
          cover_tilted(each.body, each.potential, plane, each.from, each.to, {}, false);
      EXPECT_LT(length_of(cover), 1e-8);
      for (const NuGap& gap : cover.gaps) EXPECT_FALSE(gap.undecided) << gap.nu.lo;
      const auto motions_at = [&](double nu) {
        const SearchResult found = search_tilted(each.body, each.potential, {plane, nu}, {});
        EXPECT_EQ(found.status, SearchStatus::complete) << nu;
        return static_cast<int>(found.solutions.size());
      };
      for (const auto& part : known_parts(cover, each.from, each.to, 1e-4)) {
        std::set<int> numbers;
        for (const double u : {0.03, 0.4, 0.97})
          numbers.insert(motions_at(part.first + u * (part.second - part.first)));
        EXPECT_EQ(numbers.size(), 1U) << "from nu = " << part.first << " to " << part.second;
        motions += *numbers.begin();
        ++parts;
      }
      for (const NuGap& gap : cover.gaps) {
        if (!gap.ends || gap.turns || gap.crosses) continue;
        constexpr double aside = 1e-6;
        EXPECT_EQ(std::abs(motions_at(gap.nu.hi + aside) - motions_at(gap.nu.lo - aside)), 1)
            << gap.nu.lo;
        ++ends;
      }
    }
  }
  EXPECT_GE(parts, 20);
  EXPECT_GE(ends, 8);
  EXPECT_GE(motions, 10);
}

/// Where none is told no class is claimed to change; where one is, each motion found has it.
TEST(TiltedCover, ClassesAreThoseOfSearches) {
  int compared = 0;
  int whole = 0;
  for (const TiltedBody& each : tilted_bodies()) {
    for (const TiltPlane plane : {TiltPlane::one_three, TiltPlane::two_three}) {
      const KindCover cover =
          cover_tilted(each.body, each.potential, plane, each.from, each.to, {}, true);
      ASSERT_TRUE(cover.class_gaps.has_value());
      double length = 0.0;
      for (const Interval& gap : *cover.class_gaps) length += gap.width();
      whole += length < 1e-9;
      // Gaps of both sorts, as one where they overlap.
      std::vector<Interval> gaps = *cover.class_gaps;
      for (const NuGap& gap : cover.gaps) gaps.push_back(gap.nu);
      KindCover both;
      for (const Interval& gap : merged(std::move(gaps))) both.gaps.push_back({.nu = gap});
      for (const auto& [begin, end] : known_parts(both, each.from, each.to, 1e-3)) {
        std::set<Classes> told;
        for (const double part : {0.1, 0.5, 0.9}) {
          const TiltedRotation motion{plane, begin + part * (end - begin)};
          const SearchResult found = search_tilted(each.body, each.potential, motion, {});
          EXPECT_EQ(found.status, SearchStatus::complete);
          Classes classes;
          for (const Equilibrium& at : found.solutions) {
            const Certificate proof = certify_tilted(each.body, each.potential, motion, at);
            ASSERT_TRUE(proof.proven) << proof.reason;
            const auto verdict =
                enclose_spectrum(each.body, each.potential, motion, proof, {}).verdict;
            ASSERT_TRUE(verdict.has_value()) << motion.nu;
            ++classes[*verdict];
            ++compared;
          }
          told.insert(classes);
        }
        EXPECT_EQ(told.size(), 1U) << name(plane) << " from nu = " << begin << " to " << end;
      }
    }
  }
  EXPECT_GE(compared, 30);
  EXPECT_GE(whole, 4);  // told but at points
}

}  // namespace
}  // namespace stationary::testing
