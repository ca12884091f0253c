// What an exhaustive search says of itself, and the box it is asked for; for every family's.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "solver/search.hpp"

namespace stationary {

/// Throws std::invalid_argument unless 1e-100 <= min_stretch < max_stretch <= 1e100.
void require_box(const SearchOptions& options);

/// "stretches in [0.001, 1000]: proven to be all", or what is not decided, where, and what that may
/// be; names: of the stretches.
std::string search_message(const SearchOptions& options, SearchStatus status, std::size_t proven,
                           const std::vector<StretchBox>& undecided,
                           std::string_view may_be =
                               "a fold, a bifurcation, or solutions that are "
                               "not isolated",
                           const std::array<std::string_view, 3>& names = {"xi", "zeta", "rho"});

}  // namespace stationary
