// What tests ask of covers of the nu range (solver/tube/kind_cover.hpp).
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "solver/search/search.hpp"
#include "solver/tube/kind_cover.hpp"

namespace stationary::testing {

inline double length_of(const KindCover& cover) {
  double out = 0.0;
  for (const NuGap& each : cover.gaps) out += each.nu.width();
  return out;
}

/// Ends of what is known between gaps, where it is longer than this.
inline std::vector<std::pair<double, double>> known_parts(const KindCover& cover, double from,
                                                          double to, double longer) {
  std::vector<std::pair<double, double>> out;
  double begin = from;
  for (const NuGap& each : cover.gaps) {
    if (each.nu.lo - begin > longer) out.emplace_back(begin, each.nu.lo);
    begin = each.nu.hi;
  }
  if (to - begin > longer) out.emplace_back(begin, to);
  return out;
}

/// Of an ellipse about axis 3 and the same turned by a right angle one is counted.
inline bool is_counted(const Problem& problem, const Stretch& q) {
  const bool round = problem.branch() == Branch::iii && problem.body().symmetric();
  return !round || std::log(q.xi / q.zeta) > -1e-9;
}

inline int motions_at(const Problem& problem, double nu) {
  const SearchResult found = search(problem, nu);
  EXPECT_EQ(found.status, SearchStatus::complete) << nu;
  return static_cast<int>(std::ranges::count_if(
      found.solutions, [&](const Equilibrium& each) { return is_counted(problem, each.q); }));
}

/// The numbers of motions between gaps, each found the same at three nu.
inline std::vector<int> numbers_of(const Problem& problem, const KindCover& cover, double from,
                                   double to) {
  std::vector<int> out;
  for (const auto& [begin, end] : known_parts(cover, from, to, 1e-4)) {
    std::set<int> numbers;
    for (const double part : {0.03, 0.4, 0.97})
      numbers.insert(motions_at(problem, begin + part * (end - begin)));
    EXPECT_EQ(numbers.size(), 1U) << "from nu = " << begin << " to " << end;
    out.push_back(*numbers.begin());
  }
  return out;
}

}  // namespace stationary::testing
