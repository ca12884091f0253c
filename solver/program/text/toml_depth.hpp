// How deeply a text of TOML nests, found without a parser: parsers and trees of tables are
// recursive, and their stack ends before a text does.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace stationary {

constexpr int largest_key_parts = 16;   ///< of one dotted key
constexpr int largest_toml_depth = 32;  ///< of arrays and inline tables in one another

/// The place of the first key with more parts, or of the first bracket that is deeper.
std::optional<std::size_t> too_deep(std::string_view toml);

}  // namespace stationary
