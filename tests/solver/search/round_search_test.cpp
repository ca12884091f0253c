// The search of bodies with J1 = J2: the same solutions as of a search that is not divided, and decided however near
// the place is where ellipses branch off the circle.
#include "solver/search/round_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "solver/proof/axis_boxes.hpp"
#include "solver/search/search.hpp"
#include "solver/search/two_polar_search.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

using namespace testing;
using support::Random;

constexpr ReciprocalQuadratic<> thickness{1.0, 3.0};

/// How many of the solutions are ellipses: their mirror images count too where they are listed.
int ellipses(const SearchResult& found) {
  return static_cast<int>(std::ranges::count_if(
      found.solutions, [](const Equilibrium& each) { return each.q.xi != each.q.zeta; }));
}

/// -(W_d + J slip^2) d on the circle: ellipses branch off where it is 0, and are where it has one of its signs.
double beyond(const Potential& V, double J, double slip, double radius) {
  return V.visit_parts([&](const auto& model) {
    if constexpr (requires { model.plane; }) {
      const auto w = model.plane.template evaluate<1>(planar_invariants(radius, radius));
      return -(w.w_l + J * slip * slip * radius * radius);
    } else {
      return std::numeric_limits<double>::quiet_NaN();
    }
  });
}

double radius_of(const SearchResult& found) {
  double out = std::numeric_limits<double>::quiet_NaN();
  for (const Equilibrium& each : found.solutions)
    if (each.q.xi == each.q.zeta) out = each.q.xi;
  return out;
}

/// Ellipses are at the one end of [low, high] and not at the other: searches at p decide of all p beside where they begin.
template <class Search, class Sign>
void expect_decided(const Search& search_at, const Sign& beyond_at, double low, double high,
                    int how_many) {
  const auto side = [&](double p) { return beyond_at(p, radius_of(search_at(p))) > 0.0; };
  const bool at_low = side(low);
  ASSERT_NE(at_low, side(high));
  const bool where = ellipses(search_at(low)) > 0 ? at_low : !at_low;
  ASSERT_EQ(ellipses(search_at(low)) + ellipses(search_at(high)), how_many);
  while (std::abs(high - low) > 4e-16 * std::abs(high)) {
    const double middle = 0.5 * (low + high);
    (side(middle) == at_low ? low : high) = middle;
  }
  int compared = 0;
  for (double distance = 1e-2; distance > 5e-12; distance *= 0.1) {
    for (const double sign : {-1.0, 1.0}) {
      const double p = high * (1.0 + sign * distance);
      const SearchResult found = search_at(p);
      EXPECT_EQ(found.status, SearchStatus::complete) << distance << ": " << found.message;
      EXPECT_EQ(ellipses(found), side(p) == where ? how_many : 0) << sign * distance;
      EXPECT_LT(found.boxes, 1000) << sign * distance;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 20);
}

TEST(RoundSearch, DecidesBesideTheCirclesEllipses) {
  const Body body(1.0, 1.0, 0.6);
  const Potential V{BiotLog<>{1.0, 4.0}, thickness};
  expect_decided([&](double nu) { return search(Problem(body, V, Branch::iii), nu); },
                 [&](double nu, double radius) { return beyond(V, body.J1, nu, radius); }, 1.0, 1.2,
                 2);
}

TEST(RoundSearch, DecidesBesideTheEllipsesOfRates) {
  const Body body(0.8, 0.8, 2.3);
  const Potential V{SaintVenantKirchhoff<>{0.9, 2.1}, ReciprocalQuadratic<>{1.1, 1.5}};
  expect_decided(
      [&](double theta_dot) {
        return search_two_polar(body, V, TwoPolarRates<double>{1.2, theta_dot});
      },
      [&](double theta_dot, double radius) { return beyond(V, body.J1, 1.2 - theta_dot, radius); },
      -0.55, -0.5, 1);
}

/// The same problem by both, in parts and whole.
template <class Plane>
void expect_same(const Body& body, const Plane& plane, double nu, int& solutions) {
  const Problem problem(body, Potential{plane, thickness}, Branch::iii);
  const auto rates = problem.rates(two_product(nu, nu));
  const PlanarSystem<Plane> system{plane, rates};
  const auto in_intervals = interval_model(plane, Inputs::decimals);
  using Intervals = std::decay_t<decltype(in_intervals)>;
  const PlanarBoxSystem<Intervals> boxes{in_intervals,
                                         rate_intervals(problem, nu, Inputs::decimals)};
  const double pull = body.J1 * nu * nu;
  const TwoPolarInvariantSystem<Plane, 2> invariants{plane, pull, pull};
  const EllipseBoxSystem<Intervals, 2> near{
      in_intervals, Interval::decimal(body.J1), {Interval::decimal(nu), Interval(0.0)}};
  const Box<2> everything{Interval(1e-3, 1e3), Interval(1e-3, 1e3)};
  const PruneOptions options;
  const auto parts = RoundSearch(system, boxes, invariants, near, Mirror::both, everything)
                         .finished(options, nullptr);
  const auto whole =
      WholeSearch(system, boxes, Mirror::both, everything).finished(options, nullptr);
  ASSERT_TRUE(whole->undecided.empty()) << nu;
  EXPECT_TRUE(parts->undecided.empty()) << nu;
  ASSERT_EQ(parts->solutions.size(), whole->solutions.size()) << nu;
  for (const auto& each : whole->solutions) {
    ++solutions;
    EXPECT_TRUE(std::ranges::any_of(parts->solutions,
                                    [&](const auto& other) {
                                      return ((other.x - each.x).array().abs() <=
                                              (each.proof.error_bound + other.proof.error_bound) *
                                                  each.x.array())
                                          .all();
                                    }))
        << nu << " at " << each.x.transpose();
  }
}

TEST(RoundSearch, FindsWhatAWholeSearchFinds) {
  Random random(7);
  int solutions = 0;
  for (int k = 0; k < 40; ++k) {
    const double J = random.log_uniform(0.3, 3.0);
    const Body body(J, J, random.log_uniform(0.3, 3.0));
    const double mu = random.log_uniform(0.3, 3.0);
    const double lambda = random.log_uniform(0.3, 6.0);
    const double nu = random.uniform(0.05, 2.0);
    expect_same(body, BiotLog<>{mu, lambda}, nu, solutions);
    expect_same(body, Hencky<>{mu, lambda}, nu, solutions);
    expect_same(body, ReciprocalDeterminant<>{mu, lambda}, nu, solutions);
    expect_same(body, SaintVenantKirchhoff<>{mu, lambda}, nu, solutions);
  }
  EXPECT_GT(solutions, 150);
}

/// Stretches of a box, not of the means that its boxes are sought in.
TEST(RoundSearch, FindsNoneBeyondTheBox) {
  const Problem problem(Body(1.0, 1.0, 0.6), Potential{BiotLog<>{1.0, 4.0}, thickness},
                        Branch::iii);
  const double nu = 1.0651183124924546 * (1.0 + 1e-6);
  const SearchResult all = search(problem, nu);
  ASSERT_EQ(all.solutions.size(), 3U);
  double largest = 0.0;
  for (const Equilibrium& each : all.solutions) largest = std::max(largest, each.q.xi);
  SearchOptions below;
  below.max_stretch = largest * (1.0 - 1e-7);
  const SearchResult some = search(problem, nu, below);
  EXPECT_EQ(some.status, SearchStatus::complete) << some.message;
  EXPECT_EQ(some.solutions.size(), 1U);
}

}  // namespace
}  // namespace stationary
