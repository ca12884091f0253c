// The page as it is built from web/: all of it but the title and the data, in pieces to be put one after the other. The
// places for these are named here.
#pragma once

#include <span>
#include <string_view>

namespace stationary {

constexpr std::string_view title_place = "@TITLE@";
constexpr std::string_view data_place = "@DATA@";
constexpr std::string_view live_place = "@LIVE@";
/// At the end of the page's policy: what a page that computes is allowed besides.
constexpr std::string_view live_policy_place = "@LIVE_POLICY@";

/// Nothing where the program was built without it (no node, or no packages).
std::span<const std::string_view> page_template();

}  // namespace stationary
