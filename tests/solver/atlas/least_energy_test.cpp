// The motion of least energy at each |pi|, against motions found apart from the sheets: all of them at many
// nu, by searches with proof, brought to one |pi| by bisection. Where it changes hands both motions have one
// energy, a sheet whose |pi| turns twice hands over to itself, and what the box cuts off is cut at its side.
#include "solver/atlas/least_energy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "lib/balance/balance.hpp"
#include "lib/body/inertia.hpp"
#include "solver/program/case/case_atlas.hpp"
#include "solver/program/case/case_file.hpp"
#include "solver/search/tilted_search.hpp"
#include "tests/support/atlas_text.hpp"

namespace stationary {
namespace {

using namespace testing;

Case shipped(const std::string& name) {
  return make_case(CaseTree::read(STATIONARY_CASES "/" + name + ".toml"));
}

struct Found {
  std::string kind;
  Stretch q;
  double spin;
  double momentum;
  double energy;
};

/// Motions at one |pi|, from all motions at many nu.
class BruteForce {
 public:
  BruteForce(const Case& of, double to, int count) : case_(of) {
    std::vector<std::vector<Found>> all;
    for (int k = 1; k <= count; ++k) all.push_back(at(to * k / count));
    for (std::size_t k = 1; k < all.size(); ++k)
      for (const Found& a : all[k - 1])
        if (const Found* const b = next_of(a, all[k])) steps_.push_back({a, *b});
  }

  std::vector<Found> at_momentum(double momentum) const {
    std::vector<Found> out;
    for (const auto& [a, b] : steps_) {
      if ((a.momentum < momentum) == (b.momentum < momentum)) continue;
      Found low = a.momentum < b.momentum ? a : b;
      Found high = a.momentum < b.momentum ? b : a;
      for (int k = 0; k < 12; ++k) {
        const double share =
            k % 3 == 2 ? 0.5 : (momentum - low.momentum) / (high.momentum - low.momentum);
        const double nu = low.spin + share * (high.spin - low.spin);
        const std::vector<Found> there = at(nu);
        const Found* const next = next_of(low, there);
        if (next == nullptr) break;
        (next->momentum < momentum ? low : high) = *next;
      }
      // dE = |nu| d|pi|, and what is left of the bracket is small.
      Found& near =
          std::abs(low.momentum - momentum) < std::abs(high.momentum - momentum) ? low : high;
      near.energy += near.spin * (momentum - near.momentum);
      if (std::abs(momentum - near.momentum) < 1e-6 * momentum) out.push_back(near);
    }
    return out;
  }

 private:
  struct Step {
    Found a;
    Found b;
  };

  std::vector<Found> at(double nu) const {
    std::vector<Found> out;
    const auto add = [&](std::string_view kind, const SearchResult& result) {
      for (const Equilibrium& each : result.solutions) {
        const Vector3<double> pi = locked_inertia(case_.body, each.q) * each.nu;
        out.push_back({std::string(kind), each.q, nu, pi.norm(),
                       energy(case_.body, case_.potential, each.q, each.nu)});
      }
    };
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii})
      add(name(branch), search({case_.body, case_.potential, branch}, nu));
    for (const TiltPlane plane : {TiltPlane::one_three, TiltPlane::two_three})
      add(name(plane), search_tilted(case_.body, case_.potential, {plane, nu}));
    return out;
  }

  static const Found* next_of(const Found& a, const std::vector<Found>& all) {
    const Found* out = nullptr;
    double least = 0.2;
    for (const Found& each : all) {
      if (each.kind != a.kind) continue;
      const double far = std::max({std::abs(std::log(each.q.xi / a.q.xi)),
                                   std::abs(std::log(each.q.zeta / a.q.zeta)),
                                   std::abs(std::log(each.q.rho / a.q.rho))});
      if (far < least) {
        least = far;
        out = &each;
      }
    }
    return out;
  }

  const Case& case_;
  std::vector<Step> steps_;
};

std::string kind_of(const Atlas& found, int sheet) {
  const AtlasSheet& of = found.sheets[static_cast<std::size_t>(sheet) - 1];
  return std::string(of.plane ? name(*of.plane) : kind_name(of));
}

/// What is named at an end of a piece is there, and nothing that is there has less energy.
TEST(LeastEnergy, IsThatOfAllMotionsAtOneMomentum) {
  int compared = 0;
  int exchanged = 0;
  for (const char* name :
       {"apart", "neo_hookean", "double_well", "two_wells", "broken_pitchfork"}) {
    const Case input = shipped(name);
    AtlasOptions how = atlas_options(input, 64, false);
    const Atlas found = atlas(input.body, input.potential, how);
    const auto pieces = least_energy(found.sheets, how.search);
    ASSERT_FALSE(pieces.empty()) << name;
    const BruteForce all(input, how.to, 250);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const LeastEnergyPiece& piece = pieces[k];
      ASSERT_LT(piece.from.momentum, piece.to.momentum);
      for (const LeastEnergyEnd& end : {piece.from, piece.to}) {
        if (end.momentum == 0.0) continue;
        // Where the sheet before ends, that one still has less.
        const bool last_ends = k > 0 && end.momentum == pieces[k - 1].to.momentum &&
                               pieces[k - 1].to.energy < end.energy * (1.0 - 1e-9);
        if (last_ends) continue;
        const double scale = end.momentum * end.spin + 1e-3 * std::abs(end.energy);
        bool met = false;
        for (const Found& each : all.at_momentum(end.momentum)) {
          EXPECT_GE(each.energy, end.energy - 1e-9 * scale)
              << name << ": (" << each.kind << ") at |pi| = " << end.momentum << ", piece " << k;
          met = met || (each.kind == kind_of(found, piece.sheet) &&
                        std::abs(each.energy - end.energy) < 1e-9 * scale &&
                        std::abs(each.spin - end.spin) < 1e-5 * end.spin);
        }
        compared += met;
      }
      // Inside, the least has the sheet's kind.
      const double middle = piece.from.momentum + 0.4 * (piece.to.momentum - piece.from.momentum);
      const std::vector<Found> there = all.at_momentum(middle);
      // Near a fold of nu none of its kind may be met.
      if (std::ranges::find(there, kind_of(found, piece.sheet), &Found::kind) != there.end()) {
        const Found& least = *std::ranges::min_element(there, {}, &Found::energy);
        const bool is_circle_or_mirror = input.body.symmetric();
        if (!is_circle_or_mirror) {
          EXPECT_EQ(least.kind, kind_of(found, piece.sheet)) << name << " at |pi| = " << middle;
        }
        EXPECT_GE(least.spin, std::min(piece.from.spin, piece.to.spin) * (1.0 - 1e-6)) << name << k;
      }
      if (k == 0 || pieces[k - 1].to.momentum != piece.from.momentum) continue;
      const LeastEnergyEnd& last = pieces[k - 1].to;
      if (std::abs(last.energy - piece.from.energy) < 1e-6 * std::abs(last.energy)) {
        EXPECT_NEAR(last.energy, piece.from.energy, 1e-13 * std::abs(last.energy))
            << name << ' ' << k;
        ++exchanged;
      }
    }
  }
  EXPECT_GE(compared, 6);
  EXPECT_GE(exchanged, 3);
}

/// Its |pi| turns twice: E has a swallowtail, and where that crosses itself the spin jumps.
TEST(LeastEnergy, OfASheetThatHandsOverToItself) {
  Case input = make_case(CaseTree::parse(
      "[body]\nJ = [1.0, 1.2, 0.6]\n[motion]\nbranch = \"iii\"\nnu = 0.3\n[potential]\n"
      "plane = { expression = \"mu/2*(I1 - 2*d) + k*(d - 1)^2*(d - 2)^2 + s*d\", mu = 1.0, k = "
      "2.0, "
      "s = 0.5 }\n"
      "thickness = { model = \"harmonic\", k = 3.0, rest = 1.0 }\n",
      "a tilted double well"));
  AtlasOptions how;
  how.to = 0.92;
  how.checkpoints = 8;
  how.branches = {Branch::iii};
  how.spectrum = false;
  how.step.tolerance = 1e-6;
  const Atlas found = atlas(input.body, input.potential, how);
  std::vector<AtlasSheet> own{found.sheets.front()};
  ASSERT_EQ(own[0].entry, Entry::rest);
  const auto turns = std::ranges::count(own[0].rows, EventType::fold_momentum, &AtlasRow::event);
  ASSERT_EQ(turns, 2);
  const auto pieces = least_energy(own, how.search);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].sheet, pieces[1].sheet);
  EXPECT_EQ(pieces[0].to.momentum, pieces[1].from.momentum);
  EXPECT_NEAR(pieces[0].to.energy, pieces[1].from.energy, 1e-13);
  EXPECT_LT(pieces[1].from.spin, pieces[0].to.spin - 0.1);
  // The same |pi| of coarser rows.
  how.step.tolerance = 1e-3;
  std::vector<AtlasSheet> coarse{atlas(input.body, input.potential, how).sheets.front()};
  ASSERT_LT(coarse[0].rows.size(), own[0].rows.size());
  const auto again = least_energy(coarse, how.search);
  ASSERT_EQ(again.size(), 2U);
  EXPECT_NEAR(again[0].to.momentum, pieces[0].to.momentum, 1e-12);
}

/// Two sheets on the way to their escapes, whose energies differ by less than is told between two rows: each
/// |pi| is one's, not one's and the other's in turn.
TEST(LeastEnergy, IsNoNoiseOfInterpolation) {
  const Case input = shipped("fold");
  const AtlasOptions how = atlas_options(input, 32, false);
  const Atlas found = atlas(input.body, input.potential, how);
  const auto pieces = least_energy(found.sheets, how.search);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_EQ(kind_of(found, pieces[0].sheet), "iii");
  EXPECT_EQ(kind_of(found, pieces[1].sheet), "i");
  EXPECT_EQ(kind_of(found, pieces[2].sheet), "iii");
  // The last begins where branch (i) leaves the box, zeta = 1000, in which the other stretch is smaller.
  const double zeta = how.search.max_stretch;
  const double nu = std::sqrt(2.0 * 1.1 * 1.9 / 3.0 * 2.0 * std::log(zeta) / (zeta * zeta * 1.7));
  EXPECT_NEAR(pieces[1].to.spin, nu, 1e-10 * nu);
}

/// Who has the least, and from where, is no matter of how coarse the sheets' rows are: where two that are
/// near each other are solved for, where one leaves another at an event, and on the way to an escape, where
/// a double's worth of nu is many of |pi|.
TEST(LeastEnergy, IsTheSameOfCoarseRows) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> bodies{
      {"fold",
       {"body.J=[1.0,0.5,0.6]", "potential.plane={model=\"hencky\",mu=0.5,lambda=0.8}",
        "continuation.to=1.0"}},
      {"third_axis", {}},
      {"circle", {}},
      {"no_plane", {}}};
  for (const auto& [name, more] : bodies) {
    std::vector<std::vector<LeastEnergyPiece>> of;
    for (const char* const tolerance : {"1e-10", "1e-6", "1e-4"}) {
      std::vector<Override> overrides{{std::string("continuation.tolerance=") + tolerance}};
      for (const std::string& each : more) overrides.push_back({each});
      const Case input =
          make_case(CaseTree::read(STATIONARY_CASES "/" + name + ".toml"), overrides);
      const AtlasOptions how = atlas_options(input, 8, false);
      of.push_back(least_energy(atlas(input.body, input.potential, how).sheets, how.search));
    }
    ASSERT_GE(of[0].size(), 3U);
    for (const auto& each : of) {
      ASSERT_EQ(each.size(), of[0].size()) << name;
      for (std::size_t k = 0; k < each.size(); ++k) {
        EXPECT_EQ(each[k].sheet, of[0][k].sheet) << name << " " << k;
        if (k > 0) {
          EXPECT_NEAR(each[k].from.momentum / of[0][k].from.momentum, 1.0, 1e-9)
              << name << " " << k;
        }
      }
    }
  }
}

/// Another that lies below by less than that, and is known along a part of the way only, takes no piece
/// whose ends it does not have.
TEST(LeastEnergy, OfASheetThatCoversPartOfAPiece) {
  const Case input = shipped("neo_hookean");
  const AtlasOptions how = atlas_options(input, 8, false);
  const Atlas found = atlas(input.body, input.potential, how);
  const auto momentum = [](const AtlasRow& row) {
    return (locked_inertia(row.member.body, row.member.q) * row.member.angular_velocity).norm();
  };
  AtlasSheet whole = found.sheets.front();
  std::erase_if(whole.rows, [&](const AtlasRow& row) { return momentum(row) > 2.0; });
  const auto alone = least_energy({whole}, how.search);
  ASSERT_EQ(alone.size(), 1U);
  const double middle = 0.5 * (alone[0].from.momentum + alone[0].to.momentum);
  AtlasSheet part = whole;
  part.number = 2;
  std::erase_if(part.rows, [&](const AtlasRow& row) {
    return momentum(row) < 0.5 * middle || momentum(row) > 1.5 * middle;
  });
  ASSERT_GE(part.rows.size(), 4U);
  for (AtlasRow& row : part.rows) row.member.energy *= 1.0 + 1e-7;
  part.arc = [&](const Member& from, const Member& to, double u) {
    auto out = whole.arc(from, to, u);
    if (out) out->energy *= 1.0 - 1e-7;
    return out;
  };
  const auto pieces = least_energy({whole, part}, how.search);
  ASSERT_EQ(pieces.size(), 1U);
  EXPECT_EQ(pieces[0].sheet, whole.number);
  EXPECT_EQ(pieces[0].to.momentum, alone[0].to.momentum);
}

/// Of an ellipse and the same turned by a right angle a sheet has one, and a box may hold the other.
TEST(LeastEnergy, IsTheSameOfABoxAndItsMirrorImage) {
  const Case input = shipped("circle");
  std::vector<std::vector<LeastEnergyPiece>> pieces;
  const Interval wide(1e-3, 1e3);
  const Interval small(1e-3, 1.0);
  for (const bool exchanged : {false, true}) {
    AtlasOptions how = atlas_options(input, 32, false);
    how.branches = {Branch::iii};
    how.tilted = false;
    how.search.box = {exchanged ? small : wide, exchanged ? wide : small, wide};
    const Atlas found = atlas(input.body, input.potential, how);
    pieces.push_back(least_energy(found.sheets, how.search));
  }
  ASSERT_EQ(pieces[0].size(), pieces[1].size());
  ASSERT_FALSE(pieces[0].empty());
  for (std::size_t k = 0; k < pieces[0].size(); ++k) {
    EXPECT_NEAR(pieces[0][k].from.momentum, pieces[1][k].from.momentum, 1e-9);
    EXPECT_NEAR(pieces[0][k].to.momentum, pieces[1][k].to.momentum, 1e-9);
    EXPECT_NEAR(pieces[0][k].to.energy, pieces[1][k].to.energy, 1e-9);
  }
}

TEST(LeastEnergy, HasNoPiecesOnceStopped) {
  const Case input = shipped("fold");
  const AtlasOptions how = atlas_options(input, 4, false);
  const Atlas found = atlas(input.body, input.potential, how);
  std::atomic<bool> stop{true};
  SearchOptions box = how.search;
  box.stop = &stop;
  EXPECT_TRUE(least_energy(found.sheets, box).empty());
  stop = false;
  EXPECT_FALSE(least_energy(found.sheets, box).empty());
}

}  // namespace
}  // namespace stationary
