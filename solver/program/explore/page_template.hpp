// The page as it is built from web/: all of it but the title and the data, in pieces to be put one after the other. The
// places for these are title_place and data_place.
#pragma once

#include <span>
#include <string_view>

namespace stationary {

constexpr std::string_view title_place = "@TITLE@";
constexpr std::string_view data_place = "@DATA@";

/// Nothing where the program was built without it (no node, or no packages).
std::span<const std::string_view> page_template();

}  // namespace stationary
