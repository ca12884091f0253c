// The valid name nearest to a misspelt one, for "did you mean".
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace stationary {

/// Insertions, deletions, replacements and exchanges of neighbours that turn a into b; case counts
/// nothing.
int edit_distance(std::string_view a, std::string_view b);

/// The first candidate that begins with a name of four characters and more, else the one with the least edit
/// distance, if near enough to be what was meant.
std::optional<std::string_view> nearest_name(std::string_view name,
                                             std::span<const std::string_view> candidates);

}  // namespace stationary
