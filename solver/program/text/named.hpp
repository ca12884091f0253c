// A word read back as the value that it names.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>

namespace stationary {

/// Of an enumeration whose names stand in its order; nothing where `word` is none of them.
template <class E, std::size_t count>
constexpr std::optional<E> named(const std::string_view (&names)[count], std::string_view word) {
  const auto* const at = std::ranges::find(names, word);
  if (at == std::end(names)) return std::nullopt;
  return static_cast<E>(at - std::begin(names));
}

}  // namespace stationary
