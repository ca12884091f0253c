// Every sheet over a range: the known ones, also those apart from rest; nothing twice; the same
// whatever the threads.
#include "solver/atlas/atlas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <thread>

#include "tests/support/atlas_text.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

using namespace testing;

Potential potential_of(const char* plane, double p1, double p2, double a = 1.0, double b = 3.0) {
  return {Potential::planar(plane, std::array{p1, p2}),
          Potential::thickness("reciprocal-quadratic", std::array{a, b})};
}

Atlas atlas_to(double to, const Body& body, const Potential& potential, int threads = 2) {
  AtlasOptions options;
  options.to = to;
  options.step.tolerance = 1e-6;
  options.threads = threads;
  return atlas(body, potential, options);
}

void expect_joined(const AtlasSheet& sheet, int from, int to) {
  ASSERT_TRUE(sheet.parent && sheet.joins);
  EXPECT_EQ(sheet.parent->sheet, from);
  EXPECT_EQ(sheet.joins->sheet, to);
  EXPECT_EQ(sheet.joins->event, EventType::tilt);
}

TEST(Atlas, OfANeoHookeanBodyIsItsSheetsFromRestAndOneBeyond) {
  const Atlas found = atlas_to(1.1, plate, potential_of("neo-hookean", 1.0, 2.0));
  EXPECT_EQ(text_of(found),
            "i: limit tilt escape; ii: limit inertia-exchange tilt escape; iii: limit tilt escape; "
            "iii: escape tilt fold-momentum fold-nu escape; 13: tilt tilt; "
            "23: tilt hamiltonian-hopf real-collision tilt; ");
  expect_complete(found);
  constexpr Entry entries[] = {Entry::rest,   Entry::rest, Entry::rest,
                               Entry::search, Entry::tilt, Entry::tilt};
  for (std::size_t k = 0; k < found.sheets.size(); ++k)
    EXPECT_EQ(found.sheets[k].entry, entries[k]) << k;
  // Tilted in the 1-3 plane from (i) to (iii), in the 2-3 plane to the sheet apart from rest.
  expect_joined(found.sheets[4], 1, 3);
  expect_joined(found.sheets[5], 2, 4);
  EXPECT_NEAR(found.sheets[5].joins->nu, 1.0033331936, 1e-9);
}

/// Of what is left open between proven classes the events there are named, and no others; what is excluded
/// of numbers of motions is so of their classes.
TEST(Atlas, OpenClassesNameTheEventsWithinThem) {
  AtlasOptions options;
  options.to = 1.1;
  options.step.tolerance = 1e-6;
  options.complete = true;
  options.spectrum = true;
  const Atlas found = atlas(plate, potential_of("neo-hookean", 1.0, 2.0), options);
  ASSERT_FALSE(found.completeness.empty());
  int open = 0;
  int with_events = 0;
  std::set<Beyond> met;
  for (const Completeness& branch : found.completeness) {
    for (const ClassInterval& each : branch.classes) {
      bool all_excluded = true;
      for (const CompleteInterval& other : branch.intervals)
        if (other.from < each.to && each.from < other.to)
          all_excluded = all_excluded && other.beyond == Beyond::excluded;
      EXPECT_EQ(each.beyond == Beyond::excluded, all_excluded) << each.from;
      met.insert(each.beyond);
      if (each.proven) continue;
      std::set<EventType> expected;
      for (const AtlasSheet& sheet : found.sheets) {
        const bool of_branch = branch.plane || sheet.branch == branch.branch;
        if (sheet.plane != branch.plane || !of_branch || sheet.oblique != branch.oblique) continue;
        for (const EventRecord& event : sheet.report.events) {
          const double nu = std::abs(event.parameter);
          if (nu >= each.from * (1.0 - 1e-9) && nu <= each.to * (1.0 + 1e-9))
            expected.insert(event.type);
        }
      }
      ++open;
      with_events += !expected.empty();
      EXPECT_EQ(std::set(each.events.begin(), each.events.end()), expected)
          << name(branch.branch) << " " << each.from << " " << each.to;
    }
  }
  EXPECT_GE(open, 6);
  EXPECT_GE(with_events, 4);
  EXPECT_TRUE(met.contains(Beyond::excluded));
  EXPECT_GE(met.size(), 2U);
}

/// J1 = J2: S with xi and zeta exchanged is the same body. A box that holds one of the two has it, whichever.
TEST(Atlas, ABoxThatHoldsOneOfTwoMirrorImagesHasItsSheet) {
  const Body round(1.0, 1.0, 0.6);
  const Potential potential = potential_of("biot-log", 1.0, 4.0);
  const Interval small(0.5, 1.0);
  const Interval large(1.5, 2.5);
  for (const bool exchanged : {false, true}) {
    AtlasOptions options;
    options.from = 1.09;
    options.to = 1.11;
    options.checkpoints = 1;
    options.complete = true;
    options.search.box = {exchanged ? small : large, exchanged ? large : small, small};
    const Atlas found = atlas(round, potential, options);
    // (ii) is not (i) over again: its box is another.
    EXPECT_GT(std::ranges::count(found.checkpoints, Branch::ii, &Checkpoint::branch), 0);
    EXPECT_GT(std::ranges::count(found.checkpoints, Branch::iii, &Checkpoint::branch), 0);
    for (const Checkpoint& at : found.checkpoints) {
      EXPECT_EQ(at.status, SearchStatus::complete);
      if (at.branch == Branch::iii) {
        EXPECT_EQ(at.proven, 1) << exchanged;
      }
    }
    ASSERT_EQ(std::ranges::count(found.sheets, Branch::iii, &AtlasSheet::branch), 1);
    int complete = 0;
    for (const Completeness& each : found.completeness) {
      if (each.branch != Branch::iii) continue;
      for (const CompleteInterval& interval : each.intervals) {
        EXPECT_TRUE(interval.proven) << interval.reason;
        EXPECT_EQ(interval.sheets, 1);
      }
      for (const ClassInterval& interval : each.classes) {
        EXPECT_TRUE(interval.proven) << interval.reason;
        EXPECT_EQ(std::accumulate(interval.sheets.begin(), interval.sheets.end(), 0), 1);
        ++complete;
      }
    }
    EXPECT_GT(complete, 0);
  }
}

/// There motions tilted from axis 2 are no mirror images of those listed: they leave (ii) in a plane of their own.
TEST(Atlas, ABoxThatIsNotAlikeHasTheTiltedSheetsOfBothPlanes) {
  const Body round(1.0, 1.0, 0.6);
  AtlasOptions options;
  options.to = 1.5;
  options.checkpoints = 4;
  options.spectrum = false;
  options.search.box = {Interval(1e-3, 1e3), Interval(1e-2, 1e2), Interval(1e-3, 1e3)};
  const Atlas found = atlas(round, potential_of("reciprocal-determinant", 1.0, 2.0), options);
  for (const TiltPlane plane : {TiltPlane::one_three, TiltPlane::two_three}) {
    const auto sheet = std::ranges::find(found.sheets, std::optional(plane), &AtlasSheet::plane);
    ASSERT_NE(sheet, found.sheets.end());
    ASSERT_TRUE(sheet->parent);
    const AtlasSheet& parent = found.sheets[static_cast<std::size_t>(sheet->parent->sheet - 1)];
    EXPECT_EQ(parent.branch, plane == TiltPlane::one_three ? Branch::i : Branch::ii);
  }
}

/// Nor is the ellipse counted on where it, and not its mirror image, leaves the box.
TEST(Atlas, ABoxThatHoldsOneOfTwoMirrorImagesLosesIt) {
  const Body round(1.0, 1.0, 0.6);
  const Potential potential = potential_of("biot-log", 1.0, 4.0);
  const Interval small(0.5, 1.0);
  const Interval large(1.5, 2.5);
  constexpr double leaves = 1.1513;  // there its shorter stretch is 0.5, and the longer one 2.46
  for (const bool exchanged : {false, true}) {
    for (const double from : {1.09, 1.14}) {  // the middle of the range is before it, and beyond
      AtlasOptions options;
      options.from = from;
      options.to = 1.2;
      options.checkpoints = 1;
      options.complete = true;
      options.search.box = {exchanged ? small : large, exchanged ? large : small, small};
      const Atlas found = atlas(round, potential, options);
      int before = 0;
      int beyond = 0;
      for (const Completeness& each : found.completeness) {
        if (each.branch != Branch::iii) continue;
        for (const CompleteInterval& interval : each.intervals) {
          if (!interval.proven) continue;
          EXPECT_FALSE(interval.from < leaves - 1e-3 && interval.to > leaves + 1e-3)
              << interval.from << " to " << interval.to;
          EXPECT_EQ(interval.sheets, interval.to < leaves + 1e-3 ? 1 : 0);
          ++(interval.sheets == 1 ? before : beyond);
        }
      }
      EXPECT_GT(before, 0) << exchanged << " from " << from;
      EXPECT_GT(beyond, 0) << exchanged << " from " << from;
    }
  }
}

/// Then no sheet is followed that could say so.
TEST(Atlas, ToldToStopAfterItsSearchesWasInterrupted) {
  for (const bool complete : {false, true}) {
    std::atomic<bool> stop{false};
    AtlasOptions options;
    options.checkpoints = 4;
    options.complete = complete;
    options.stop = options.search.stop = &stop;
    std::atomic<int> left{3 * options.checkpoints};  // of (i), (ii), (iii)
    options.searched = [&](std::size_t, const SearchResult&) {
      if (--left == 0) stop = true;
    };
    EXPECT_TRUE(atlas(plate, potential_of("neo-hookean", 1.0, 2.0), options).interrupted);
    EXPECT_EQ(left, 0);
  }
}

/// A tilted family that is cut short is not entered a second time, at its other end.
TEST(Atlas, InterruptedHasNoSheetThatTheWholeHasNot) {
  using Clock = std::chrono::steady_clock;
  const Potential potential = potential_of("neo-hookean", 1.0, 2.0);
  const auto begin = Clock::now();
  const Atlas whole = atlas_to(1.1, plate, potential, 1);
  auto time = Clock::now() - begin;
  const auto is_in_whole = [&](const AtlasSheet& sheet) {
    return std::ranges::any_of(whole.sheets, [&](const AtlasSheet& each) {
      return each.branch == sheet.branch && each.plane == sheet.plane &&
             each.entry == sheet.entry && each.entry_nu == sheet.entry_nu;
    });
  };
  int cut_short = 0;
  constexpr int moments = 40;
  for (int k = 0; k < moments; ++k) {
    std::atomic<bool> stop{false};
    const std::jthread later([&, at = Clock::now() + time * (10 + k % 10) / 20] {
      std::this_thread::sleep_until(at);
      stop = true;
    });
    AtlasOptions options;
    options.to = 1.1;
    options.step.tolerance = 1e-6;
    options.threads = 1;
    options.stop = options.search.stop = &stop;
    const Atlas found = atlas(plate, potential, options);
    bool within_a_sheet = false;
    for (const AtlasSheet& sheet : found.sheets) {
      within_a_sheet = within_a_sheet || sheet.report.interrupted;
      EXPECT_TRUE(is_in_whole(sheet)) << k << ": " << sheet.entry_nu;
    }
    cut_short += within_a_sheet;
    // The machine is not always as fast.
    if (!found.interrupted) time -= time / 10;
    if (found.interrupted && !within_a_sheet) time += time / 20;
  }
  EXPECT_GT(cut_short, 0);
}

TEST(Atlas, ATiltedFamilyMayEscape) {
  const Atlas found =
      atlas_to(2.0, Body(1.7, 1.0, 0.6), potential_of("reciprocal-determinant", 1.0, 2.0));
  expect_complete(found);
  const auto escapes = std::ranges::find_if(found.sheets, [](const AtlasSheet& sheet) {
    return sheet.plane && sheet.rows.back().event == EventType::escape;
  });
  ASSERT_NE(escapes, found.sheets.end()) << text_of(found);
  EXPECT_EQ(escapes->parent->sheet, 1);
  EXPECT_NEAR(escapes->parent->nu, 1.40523, 1e-5);
  EXPECT_FALSE(escapes->joins.has_value());
}

TEST(Atlas, FindsTheSheetApartFromRest) {
  const Atlas biot = atlas_to(2.0, plate, potential_of("biot-log", 1.0, 0.6));
  EXPECT_EQ(text_of(biot),
            "i: limit tilt escape; ii: limit inertia-exchange tilt escape; iii: limit tilt escape; "
            "iii: escape fold-nu fold-momentum tilt krein-pass escape; 13: tilt tilt; "
            "23: tilt hamiltonian-hopf hamiltonian-hopf tilt; ");
  expect_complete(biot);
  EXPECT_FALSE(biot.sheets[3].parent.has_value());
  expect_joined(biot.sheets[5], 2, 4);
  const Atlas soft = atlas_to(1.0, Body(1.046, 0.972, 0.234),
                              potential_of("neo-hookean", 0.0525, 2.3792, 0.591, 1.917));
  EXPECT_EQ(std::ranges::count_if(soft.sheets, [](const auto& sheet) { return !sheet.plane; }), 4)
      << text_of(soft);
  expect_complete(soft);
}

TEST(Atlas, EllipsesComeFromTheCircleAndOnce) {
  const Atlas found = atlas_to(3.0, Body(1.0, 1.0, 0.6), potential_of("biot-log", 1.0, 4.0));
  // (ii) is (i) turned; the tilted family joins (i) to the ellipses.
  EXPECT_EQ(text_of(found),
            "i: limit tilt escape; iii: limit ellipse fold-nu fold-nu ellipse escape; "
            "iii: ellipse tilt escape; iii: ellipse escape; 13: tilt tilt; "
            // Not connected to these.
            "13: escape fold-nu fold-momentum unexplained escape; ");
  ASSERT_EQ(found.sheets.size(), 6U);
  expect_complete(found);
  expect_joined(found.sheets[4], 1, 3);
  for (const std::size_t k : {2U, 3U}) {
    const AtlasSheet& ellipses = found.sheets[k];
    ASSERT_TRUE(ellipses.parent.has_value()) << k;
    EXPECT_EQ(ellipses.parent->sheet, 2);
    EXPECT_EQ(ellipses.parent->event, EventType::ellipse);
    for (const AtlasRow& row : ellipses.rows) {
      EXPECT_EQ(row.event == EventType::ellipse, row.member.q.xi == row.member.q.zeta);
    }
  }
}

/// Where no checkpoint meets the ellipses they are entered at the circle.
TEST(Atlas, EllipsesBetweenCheckpointsAreEnteredAtTheCircle) {
  AtlasOptions options;
  options.from = 0.0;
  options.to = 1.08;
  options.checkpoints = 3;
  options.branches = {Branch::iii};
  const Atlas found = atlas(Body(1.0, 1.0, 0.6), potential_of("biot-log", 1.0, 4.0), options);
  ASSERT_EQ(found.sheets.size(), 2U) << text_of(found);
  EXPECT_EQ(found.sheets[1].entry, Entry::ellipse);
  ASSERT_TRUE(found.sheets[1].parent.has_value());
  EXPECT_EQ(found.sheets[1].parent->sheet, 1);
}

/// biot, J1 = J2: ellipses of any eccentricity at J nu^2 = 2 mu.
TEST(Atlas, AVerticalBranchIsFollowed) {
  AtlasOptions options;
  options.to = 1.5;
  options.checkpoints = 7;
  options.branches = {Branch::iii};
  const Atlas found = atlas(Body(1.0, 1.0, 0.6), potential_of("biot", 1.0, 2.0), options);
  EXPECT_TRUE(found.remarks.empty());
  ASSERT_EQ(found.sheets.size(), 3U) << text_of(found);
  EXPECT_TRUE(found.sheets[1].report.vertical);
  EXPECT_NEAR(found.sheets[1].entry_nu, std::sqrt(2.0), 1e-14);
  EXPECT_TRUE(found.sheets[2].plane.has_value());  // off a tilt on it
}

TEST(Atlas, DoesNotDependOnTheThreads) {
  const Potential potential = potential_of("biot-log", 1.0, 0.6);
  const Atlas one = atlas_to(2.0, plate, potential, 1);
  for (const int threads : {2, 5}) {
    const Atlas many = atlas_to(2.0, plate, potential, threads);
    ASSERT_EQ(one.sheets.size(), many.sheets.size());
    for (std::size_t s = 0; s < one.sheets.size(); ++s) {
      ASSERT_EQ(one.sheets[s].rows.size(), many.sheets[s].rows.size());
      for (std::size_t k = 0; k < one.sheets[s].rows.size(); ++k) {
        EXPECT_EQ(one.sheets[s].rows[k].member.nu, many.sheets[s].rows[k].member.nu);
        EXPECT_EQ(one.sheets[s].rows[k].member.q.xi, many.sheets[s].rows[k].member.q.xi);
      }
    }
  }
}

/// Random bodies and models: every sheet's point at a checkpoint is a proven solution, and every
/// proven solution is on a sheet; what is not shown is said so, and rare.
TEST(Atlas, RandomBodiesAreComplete) {
  support::Random random(417);
  int checkpoints = 0;
  int complete = 0;
  for (int k = 0; k < 60; ++k) {
    const Posed posed = random_problem(random, 2.0);
    AtlasOptions options;
    options.to = 2.0 * std::abs(posed.nu);
    options.checkpoints = 12;
    options.step.tolerance = 1e-5;
    options.spectrum = false;
    options.threads = 2;
    const Atlas found = atlas(posed.problem.body(), posed.problem.potential(), options);
    for (const Checkpoint& at : found.checkpoints) {
      ++checkpoints;
      complete += at.complete();
      EXPECT_TRUE(at.complete() || at.status != SearchStatus::complete)
          << posed.text << name(at.branch) << " " << at.nu << ": " << at.proven << " "
          << at.on_sheets << " " << at.beyond << " " << text_of(found);
    }
  }
  EXPECT_GE(complete, checkpoints * 98 / 100) << checkpoints;
}

/// Families that begin close to an end of the range and leave it there.
TEST(Atlas, SheetsAreInTheRange) {
  const auto of_range = [](double from, double to, const Body& body, const Potential& potential) {
    AtlasOptions options;
    options.from = from;
    options.to = to;
    options.checkpoints = 8;
    options.step.tolerance = 1e-6;
    options.spectrum = false;
    return atlas(body, potential, options);
  };
  int listed = 0;
  int said = 0;
  for (const auto& [body, potential] :
       {std::pair{plate, potential_of("neo-hookean", 1.0, 2.0)},
        {Body(1.0, 1.0, 0.6), potential_of("biot-log", 1.0, 4.0)}}) {
    std::vector<double> begin;
    for (const AtlasSheet& sheet : of_range(0.0, 1.5, body, potential).sheets)
      for (const AtlasRow& row : sheet.rows)
        if (row.event == EventType::tilt || row.event == EventType::ellipse)
          begin.push_back(row.member.nu);
    ASSERT_GE(begin.size(), 4U);
    for (const double nu : begin) {
      for (const auto& [from, to] : {std::pair{0.0, nu * (1.0 + 1e-7)},
                                     {nu * (1.0 - 1e-7), 1.2 * nu},
                                     {0.0, nu * (1.0 + 1e-10)},
                                     {nu * (1.0 - 1e-10), 1.2 * nu}}) {
        const Atlas found = of_range(from, to, body, potential);
        for (const AtlasSheet& sheet : found.sheets) {
          listed += sheet.plane.has_value();
          for (const AtlasRow& row : sheet.rows) {
            EXPECT_GE(row.member.nu, from) << nu;
            EXPECT_LE(row.member.nu, to) << nu;
          }
        }
        for (const Remark& each : found.remarks)
          said += each.reason.find("beyond the range") != std::string::npos;
      }
    }
  }
  EXPECT_GT(listed, 0);
  EXPECT_GT(said, 0);
}

TEST(Atlas, RefusesARangeThatIsNone) {
  const Potential potential = potential_of("neo-hookean", 1.0, 2.0);
  for (const auto& [from, to] : {std::pair{-1.0, 1.0}, {1.0, 1.0}, {2.0, 1.0}, {0.0, INFINITY}}) {
    AtlasOptions options;
    options.from = from;
    options.to = to;
    EXPECT_THROW(atlas(plate, potential, options), std::invalid_argument);
  }
  AtlasOptions none;
  none.checkpoints = 0;
  EXPECT_THROW(atlas(plate, potential, none), std::invalid_argument);
}

/// A sheet that was stopped at its last row does not end there, whatever event the row is.
TEST(AtlasSheet, EndsWhereItWasNotStopped) {
  AtlasSheet sheet;
  sheet.rows.resize(1);
  sheet.rows.front().event = EventType::limit;
  sheet.report.backward.event = EventType::limit;
  sheet.report.interrupted = true;
  EXPECT_EQ(sheet.first_event(), EventType::limit);
  EXPECT_EQ(sheet.last_event(), EventType::none);
  sheet.report.interrupted = false;
  EXPECT_EQ(sheet.last_event(), EventType::limit);
  sheet.report.out_of_points = true;
  EXPECT_EQ(sheet.last_event(), EventType::none);
}

}  // namespace
}  // namespace stationary
