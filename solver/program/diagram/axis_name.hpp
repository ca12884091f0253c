// What an axis is called: as in the paper, J₂, ν, θ/°, not by the key or column it is read from.
#pragma once

#include <string>
#include <string_view>

namespace stationary {

/// Of a case's key, a ratio of two, or a column; any other text is its own name.
std::string axis_name(std::string_view key);

}  // namespace stationary
