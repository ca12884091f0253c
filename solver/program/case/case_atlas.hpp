// What a case asks of an atlas: its body, potential and range of nu.
#pragma once

#include <optional>

#include "solver/atlas/atlas.hpp"
#include "solver/program/case/case_file.hpp"

namespace stationary {

/// Of an anisotropic body, whose searches take up to some seconds each.
constexpr int few_checkpoints = 32;

/// checkpoints: as asked, by the case, or by the body's symmetry. Without threads, stop and progress. Throws
/// InputError where the case has no range in nu.
AtlasOptions atlas_options(const Case& input, std::optional<int> checkpoints, bool with_spectrum);

}  // namespace stationary
