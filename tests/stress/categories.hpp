// The categories of hard cases: each draws from a generator of its own with a fixed seed, so that a
// case is known by its category and its number.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "tests/stress/judge/tally.hpp"

namespace stationary::stress {

struct Category {
  std::string_view name;
  long cases;  ///< of the whole measurement
  std::uint64_t seed;
  std::function<Outcome(Random&)> try_one;
};

const std::vector<Category>& categories();

/// The first `count` cases of a category.
Tally tried(const Category& category, long count);

}  // namespace stationary::stress
