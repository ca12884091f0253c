// Exhaustive search against multistart Newton over random cases of every model and branch: nothing
// Newton finds is missing from the search, and each solution of the search is one Newton's method
// finds again from beside it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <type_traits>

#include "solver/newton/newton.hpp"
#include "solver/search/search.hpp"
#include "tests/support/bodies/random_problem.hpp"

namespace stationary {
namespace {

using namespace testing;
using support::Random;

/// Newton from a start: the solution it ends at, or nothing.
std::optional<Stretch> newton_from(const Problem& problem, double nu, const Stretch& start) {
  const auto rates = problem.rates(two_product(nu, nu));
  const auto polished = [](const auto& system, auto x) {
    using Vector = decltype(x);
    const bool done = newton(system, x).converged && refine<false>(system, x).converged;
    return done ? std::optional<Vector>(x) : std::nullopt;
  };
  return problem.potential().visit_parts([&](const auto& model) -> std::optional<Stretch> {
    if constexpr (requires { model.plane; }) {
      const auto plane =
          polished(PlanarSystem<std::decay_t<decltype(model.plane)>>{model.plane, rates},
                   ReducedVector<2>(start.xi, start.zeta));
      const auto rho = polished(
          ThicknessSystem<std::decay_t<decltype(model.thickness)>>{model.thickness, rates.rho},
          ReducedVector<1>(start.rho));
      if (!plane || !rho) return std::nullopt;
      return Stretch{0.0, (*plane)[0], (*plane)[1], (*rho)[0]};
    } else {
      const auto all = polished(CoupledSystem<std::decay_t<decltype(model)>>{model, rates},
                                ReducedVector<3>(start.xi, start.zeta, start.rho));
      if (!all) return std::nullopt;
      return Stretch{0.0, (*all)[0], (*all)[1], (*all)[2]};
    }
  });
}

bool near(const Stretch& a, const Stretch& b, double tolerance) {
  return std::abs(a.xi / b.xi - 1.0) <= tolerance && std::abs(a.zeta / b.zeta - 1.0) <= tolerance &&
         std::abs(a.rho / b.rho - 1.0) <= tolerance;
}

bool listed(const SearchResult& found, const Stretch& x) {
  return std::ranges::any_of(found.solutions,
                             [&x](const Equilibrium& each) { return near(each.q, x, 1e-9); }) ||
         std::ranges::any_of(found.undecided, [&x](const StretchBox& box) {
           return box.xi.may_be(x.xi) && box.zeta.may_be(x.zeta) && box.rho.may_be(x.rho);
         });
}

/// Well inside the box searched by default.
bool in_the_box(const Stretch& x) {
  const SearchOptions box;
  return std::ranges::all_of(std::array{x.xi, x.zeta, x.rho}, [&box](double each) {
    return each > 1.001 * box.min_stretch && each < 0.999 * box.max_stretch;
  });
}

struct Tally {
  long starts = 0;
  long hits = 0;  ///< starts that ended at a solution in the box
  long missed = 0;
  long proven = 0;
  long confirmed = 0;  ///< of the proven ones
  long undecided = 0;  ///< cases
  std::string faults;
};

std::ostream& operator<<(std::ostream& out, const Tally& t) {
  return out << t.starts << " starts, " << t.hits << " at a solution, " << t.missed
             << " of these not in the search; " << t.proven << " solutions proven, " << t.confirmed
             << " confirmed by Newton, " << t.undecided << " cases undecided" << t.faults;
}

Tally compare(std::uint64_t seed, int cases, int starts) {
  Random random(seed);
  const auto anywhere = [&random] { return random.log_uniform(1e-3, 1e3); };
  Tally out;
  for (int k = 0; k < cases; ++k) {
    const Posed posed = random_problem(random, 2.0);
    const SearchResult found = search(posed.problem, posed.nu);
    out.undecided += found.status != SearchStatus::complete;
    for (const Equilibrium& each : found.solutions) {
      ++out.proven;
      const Stretch beside{0.0, each.q.xi * (1.0 + 1e-8), each.q.zeta * (1.0 - 1e-8),
                           each.q.rho * (1.0 + 1e-8)};
      const auto again = newton_from(posed.problem, posed.nu, beside);
      if (again && near(*again, each.q, each.error_bound)) {
        ++out.confirmed;
      } else {
        out.faults += "\nnot confirmed: " + posed.text;
      }
    }
    for (int start = 0; start < starts; ++start) {
      ++out.starts;
      const auto x =
          newton_from(posed.problem, posed.nu, {0.0, anywhere(), anywhere(), anywhere()});
      if (!x || !in_the_box(*x)) continue;
      ++out.hits;
      if (listed(found, *x)) continue;
      ++out.missed;
      out.faults += "\nnot in the search: " + posed.text;
    }
  }
  return out;
}

void expect_agreement(const Tally& tally, int cases) {
  EXPECT_EQ(tally.missed, 0) << tally;
  EXPECT_EQ(tally.confirmed, tally.proven) << tally;
  EXPECT_GT(tally.hits, tally.starts / 4) << tally;
  EXPECT_GT(tally.proven, cases / 2) << tally;
  EXPECT_LE(tally.undecided, cases / 50) << tally;
}

TEST(SearchMultistart, TwentyThousandStartsFindNothingMore) {
  expect_agreement(compare(941, 200, 100), 200);
}

/// Twenty thousand a case, and the tally printed. Run with --gtest_also_run_disabled_tests.
TEST(SearchMultistart, DISABLED_FourMillionStartsFindNothingMore) {
  const Tally tally = compare(942, 200, 20000);
  std::cout << tally << "\n";
  expect_agreement(tally, 200);
}

}  // namespace
}  // namespace stationary
