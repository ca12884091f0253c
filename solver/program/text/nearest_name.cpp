#include "solver/program/text/nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace stationary {
namespace {

constexpr std::size_t longest_name = 64;  // of ours; anything longer is no misspelling

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1);
  std::vector<int> above(b.size() + 1);
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
      if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
          lower(a[i - 2]) == lower(b[j - 1])) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    std::swap(before, above);
    std::swap(above, row);
  }
  return above[b.size()];
}

std::optional<std::string_view> nearest_name(std::string_view name,
                                             std::span<const std::string_view> candidates) {
  if (name.empty() || name.size() > longest_name) return std::nullopt;
  constexpr std::size_t telling = 4;  // characters of a name that is not whole
  for (const std::string_view candidate : candidates)
    if (name.size() >= telling && candidate.starts_with(name)) return candidate;
  std::optional<std::string_view> best;
  int best_distance = 0;
  for (const std::string_view candidate : candidates) {
    const int distance = edit_distance(name, candidate);
    // A third of the longer name may be wrong; beyond that the guess would mislead.
    const std::size_t length = std::max(name.size(), candidate.size());
    const int allowed = std::max(1, static_cast<int>((length + 1) / 3));
    if (distance > allowed || distance >= static_cast<int>(length)) continue;
    if (!best || distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

}  // namespace stationary
