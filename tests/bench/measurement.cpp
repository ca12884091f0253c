#include "tests/bench/measurement.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace stationary::bench {
namespace {

constexpr double least_seconds = 2e-3;  ///< of a repeat, so that the clock's own cost is nothing

double median(std::vector<double> x) {
  if (x.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  return *middle;
}

Measured summary(const Entry& entry, const std::vector<double>& seconds,
                 std::vector<double> errors) {
  const std::size_t all = errors.size();
  std::erase_if(errors, [](double e) { return std::isnan(e); });
  const auto [least, most] = std::ranges::minmax(seconds);
  return {&entry,
          median(seconds),
          least,
          most,
          errors.empty() ? std::numeric_limits<double>::quiet_NaN() : std::ranges::max(errors),
          median(errors),
          all - errors.size()};
}

}  // namespace

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<Measured> measure(const std::vector<Entry>& entries, int repeats) {
  std::vector<long> passes;
  std::vector<std::vector<double>> errors;
  for (const Entry& entry : entries) {
    entry.seconds(1);  // caches, pages
    passes.push_back(std::max(1L, std::lround(least_seconds / entry.seconds(1))));
    errors.push_back(entry.errors());
  }
  std::vector<std::vector<double>> seconds(entries.size());
  std::vector<std::size_t> order(entries.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937_64 random(1);
  for (int repeat = 0; repeat < repeats; ++repeat) {
    std::ranges::shuffle(order, random);
    for (const std::size_t k : order) {
      const double items = static_cast<double>(passes[k]) * static_cast<double>(entries[k].items);
      seconds[k].push_back(entries[k].seconds(passes[k]) / items);
    }
  }
  std::vector<Measured> out;
  for (std::size_t k = 0; k < entries.size(); ++k)
    out.push_back(summary(entries[k], seconds[k], std::move(errors[k])));
  return out;
}

}  // namespace stationary::bench
