#include "solver/program/text/faults.hpp"

#include <algorithm>
#include <tuple>

namespace stationary {
namespace {

/// Whether one of two dotted keys is the other, or stands above it.
bool related(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  return b.starts_with(a) && (a.empty() || a.size() == b.size() || b[a.size()] == '.');
}

}  // namespace

bool Faults::sound(std::string_view key) const {
  return std::ranges::none_of(all_,
                              [&](const InputError& fault) { return related(fault.key(), key); });
}

void Faults::raise() const {
  if (all_.empty()) return;
  std::vector<InputError> sorted = all_;
  std::ranges::stable_sort(sorted, {}, [](const InputError& fault) {
    const Origin& at = fault.origin();
    return std::tuple(!at.option.empty(), at.line, at.column);
  });
  throw InputError(sorted);
}

}  // namespace stationary
