// The solver of a page (web/live): WebAssembly, as zlib packs it, in base64; in pieces to be put one after the other.
#pragma once

#include <span>
#include <string_view>

namespace stationary {

/// Nothing where the program was built without it (no clang for WebAssembly).
std::span<const std::string_view> live_solver();

}  // namespace stationary
