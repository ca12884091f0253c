// What an exhaustive search says of itself, and the box it is asked for; for every family's.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "solver/search/search.hpp"

namespace stationary {

/// Throws std::invalid_argument unless 1e-100 <= min < max <= 1e100 for the range of each stretch.
void require_box(const SearchOptions& options);

/// Of one that is proven to exist, or of one in an undecided box.
std::string found_by_search(bool proven);
/// "; 2 more found by Newton's method there, not proven", or nothing.
std::string unproven_text(std::size_t unproven);

/// "stretches in [0.001, 1000]"; where they differ, each range by itself. names: of the stretches.
std::string range_text(const SearchOptions& options,
                       const std::array<std::string_view, 3>& names = {"xi", "zeta", "rho"});

/// "stretches in [0.001, 1000]: proven to be all", or what is not decided, where, and what that may be.
std::string search_message(const SearchOptions& options, SearchStatus status, std::size_t proven,
                           const std::vector<StretchBox>& undecided,
                           std::string_view may_be =
                               "a fold, a bifurcation, or solutions that are "
                               "not isolated",
                           const std::array<std::string_view, 3>& names = {"xi", "zeta", "rho"});

}  // namespace stationary
