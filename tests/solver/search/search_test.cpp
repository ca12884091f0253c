// Exhaustive search: what was found independently is found and proven, where there is nothing that
// is proven, and double roots and continua end as undecided boxes.
#include "solver/search/search.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/numbers/high_precision.hpp"
#include "tests/support/reference_table.hpp"

namespace stationary {
namespace {

using namespace testing;
using support::Random;

struct Pair {
  double xi;
  double zeta;
};

std::string text(const SearchResult& found) {
  std::ostringstream out;
  out.precision(12);
  out << found.message << " (" << found.boxes << " boxes)";
  for (const Equilibrium& each : found.solutions)
    out << "\n  " << each.q.xi << " " << each.q.zeta << " " << each.q.rho << " +- "
        << each.error_bound;
  return out.str();
}

/// Exactly these, in this order, proven complete.
void expect_all(const SearchResult& found, const std::vector<Pair>& expected, double tolerance,
                long most_boxes) {
  EXPECT_EQ(found.status, SearchStatus::complete) << text(found);
  EXPECT_TRUE(found.undecided.empty()) << text(found);
  ASSERT_EQ(found.solutions.size(), expected.size()) << text(found);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const Equilibrium& each = found.solutions[k];
    EXPECT_EQ(each.status, SolveStatus::solved);
    EXPECT_NEAR(each.q.xi, expected[k].xi, tolerance * expected[k].xi) << text(found);
    EXPECT_NEAR(each.q.zeta, expected[k].zeta, tolerance * expected[k].zeta) << text(found);
    EXPECT_LE(each.error_bound, 1e-12) << text(found);
    EXPECT_LE(each.residual, 1e-14) << text(found);
    EXPECT_EQ(each.compatibility, 0.0);
  }
  EXPECT_LE(found.boxes, most_boxes) << text(found);
}

const Problem& apart() {
  static const Problem problem(Body(1.0, 1.7, 0.6), make_potential("biot-log", {1.0, 0.6}),
                               Branch::iii);
  return problem;
}

TEST(Search, DisconnectedPairOfBiotLog) {
  expect_all(search(apart(), 1.4), {{48.91, 0.722}, {49.98, 0.0215}}, 1e-3, 60);
  expect_all(search(apart(), -1.4), {{48.91, 0.722}, {49.98, 0.0215}}, 1e-3, 60);
  expect_all(search(apart(), 1.2), {}, 0.0, 60);
}

struct Sheet {
  double nu;
  std::vector<Pair> solutions;
};
void PrintTo(const Sheet& sheet, std::ostream* out) { *out << "nu = " << sheet.nu; }

class BrokenPitchforkTest : public ::testing::TestWithParam<Sheet> {};

TEST_P(BrokenPitchforkTest, EverySheetOfNeoHookean) {
  const Problem problem(
      Body(1.046, 0.972, 0.234),
      make_potential("neo-hookean", {0.0525, 2.3792}, "reciprocal-quadratic", {0.591, 1.917}),
      Branch::iii);
  expect_all(search(problem, GetParam().nu), GetParam().solutions, 2e-3, 100);
}

INSTANTIATE_TEST_SUITE_P(Nus, BrokenPitchforkTest,
                         ::testing::Values(Sheet{0.2, {{1.0722, 0.94857}}}, Sheet{0.23, {}},
                                           Sheet{0.24, {{0.829, 1.236}, {50.20, 74.84}}},
                                           Sheet{0.35, {{0.9949, 1.0604}, {12.696, 13.533}}},
                                           Sheet{0.5, {{1.0356, 1.0847}, {6.5671, 6.8785}}},
                                           Sheet{0.8, {{1.1913, 1.2399}, {2.8581, 2.9745}}},
                                           Sheet{0.94, {{1.4860, 1.5451}, {1.8239, 1.8964}}},
                                           Sheet{0.96, {}}));

TEST(Search, EveryRowOfTheTables) {
  for (const char* table : {"equilibria.csv", "equilibria_extreme.csv"}) {
    for (const auto& row : support::reference_table(table)) {
      const Problem problem(row.body(), row.potential(), row.branch());
      const SearchResult found = search(problem, row.number<double>("nu"));
      ASSERT_EQ(found.status, SearchStatus::complete) << row.where() << text(found);
      const auto exact = row.stretch<support::Real50>();
      int matching = 0;
      for (const Equilibrium& each : found.solutions) {
        const double error = relative_error(each.q, {exact.xi, exact.zeta, exact.rho});
        matching += error <= each.error_bound;
        EXPECT_TRUE(error <= each.error_bound || error > 1e-6) << row.where() << text(found);
      }
      EXPECT_EQ(matching, 1) << row.where() << text(found);
    }
  }
}

// hencky, (i): zeta = sqrt e at the fold, nu^2 = 2 mu (mu + lambda)/((2 mu + lambda) e J2).
class FoldTest : public ::testing::Test {
 protected:
  static constexpr double mu = 1.1;
  static constexpr double lambda = 0.8;
  const Problem problem_{Body(1.0, 1.7, 0.6), make_potential("hencky", {mu, lambda}), Branch::i};
  const double fold_ =
      std::sqrt(2.0 * mu * (mu + lambda) / ((2.0 * mu + lambda) * std::exp(1.0) * 1.7));
};

TEST_F(FoldTest, BothSolutionsBelowItNoneAbove) {
  for (const double off : {1e-2, 1e-6, 1e-10}) {
    const SearchResult below_fold = search(problem_, fold_ * (1.0 - off));
    EXPECT_EQ(below_fold.status, SearchStatus::complete) << off << text(below_fold);
    EXPECT_EQ(below_fold.solutions.size(), 2U) << off << text(below_fold);
    const SearchResult above_fold = search(problem_, fold_ * (1.0 + off));
    EXPECT_EQ(above_fold.status, SearchStatus::complete) << off << text(above_fold);
    EXPECT_TRUE(above_fold.solutions.empty()) << off << text(above_fold);
  }
}

TEST_F(FoldTest, TheDoubleRootStaysUndecided) {
  const SearchResult found = search(problem_, fold_);
  EXPECT_EQ(found.status, SearchStatus::undecided) << text(found);
  EXPECT_TRUE(found.solutions.empty()) << text(found);
  ASSERT_EQ(found.undecided.size(), 1U) << text(found);
  const StretchBox& box = found.undecided.front();
  EXPECT_TRUE(box.zeta.may_be(std::exp(0.5)));
  EXPECT_LT(box.zeta.width(), 1e-5);
  EXPECT_LT(found.boxes, 2000);
  EXPECT_NE(found.message.find("fold"), std::string::npos);
}

TEST(Search, AContinuumEndsUndecidedAfterBoundedWork) {
  // (iii), J1 = J2: neo-hookean at J nu^2 = mu and biot at J nu^2 = 2 mu have a line of ellipses.
  const Body round(1.0, 1.0, 0.6);
  const Problem neo(round, make_potential("neo-hookean", {1.0, 2.0}), Branch::iii);
  const Problem biot(round, make_potential("biot", {0.5, 2.0}), Branch::iii);
  for (const Problem* problem : {&neo, &biot}) {
    SearchOptions options;
    options.max_boxes = 3000;
    const SearchResult found = search(*problem, 1.0, options);
    EXPECT_EQ(found.status, SearchStatus::undecided);
    // Of the line its circle, which is alone among circles.
    EXPECT_LE(found.solutions.size(), 1U) << text(found);
    for (const Equilibrium& each : found.solutions) EXPECT_EQ(each.q.xi, each.q.zeta);
    EXPECT_FALSE(found.undecided.empty());
    EXPECT_LE(found.undecided.size(), 10U) << text(found);
    EXPECT_LE(found.boxes, 2 * options.max_boxes + 10);  // in parts, and whole
    EXPECT_NE(found.message.find("not isolated"), std::string::npos);
    // Beside that nu there is no continuum, and no doubt.
    EXPECT_EQ(search(*problem, 0.99).status, SearchStatus::complete);
    EXPECT_EQ(search(*problem, 1.01).status, SearchStatus::complete);
  }
}

TEST(Search, MirrorImagesBothStandInTheList) {
  const Problem problem(Body(1.0, 1.0, 0.6),
                        make_potential("biot-log", {1.0, 4.0}, "harmonic", {1.0, 3.0}),
                        Branch::iii);
  const SearchResult found = search(problem, 1.1);
  EXPECT_EQ(found.status, SearchStatus::complete) << text(found);
  ASSERT_EQ(found.solutions.size(), 3U) << text(found);
  const auto& [ellipse, circle, mirror] =
      std::tie(found.solutions[0].q, found.solutions[1].q, found.solutions[2].q);
  EXPECT_EQ(circle.xi, circle.zeta);
  EXPECT_EQ(ellipse.xi, mirror.zeta);
  EXPECT_EQ(ellipse.zeta, mirror.xi);
  EXPECT_LT(ellipse.xi, ellipse.zeta);
  for (const Equilibrium& each : found.solutions) {
    const auto exact = reference_solution(problem, 1.1, each.q);
    EXPECT_LE(relative_error(each.q, exact), each.error_bound);
  }
}

TEST(Search, OnlyWhatIsInTheBox) {
  SearchOptions options;
  options.max_stretch = 49.0;
  EXPECT_EQ(search(apart(), 1.4, options).solutions.size(), 1U);
  options.min_stretch = 0.73;
  const SearchResult none = search(apart(), 1.4, options);
  EXPECT_EQ(none.status, SearchStatus::complete) << text(none);
  EXPECT_TRUE(none.solutions.empty()) << text(none);
}

TEST(Search, MisuseAndInterruption) {
  EXPECT_THROW(search(apart(), std::nan("")), std::invalid_argument);
  SearchOptions options;
  options.min_stretch = 2.0;
  options.max_stretch = 1.0;
  EXPECT_THROW(search(apart(), 1.0, options), std::invalid_argument);
  const std::atomic<bool> stop = true;
  SearchOptions stopped;
  stopped.stop = &stop;
  const SearchResult found = search(apart(), 1.4, stopped);
  EXPECT_EQ(found.status, SearchStatus::interrupted);
  EXPECT_TRUE(found.solutions.empty());
}

}  // namespace
}  // namespace stationary
