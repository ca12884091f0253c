// The ladder as a figure: digits kept against the distance from the fold.
#pragma once

#include <string>
#include <vector>

#include "solver/program/plot/plot.hpp"
#include "tests/stress/cases/fold_ladder.hpp"

namespace stationary::stress {

/// For run_gnuplot().
std::string fold_script(const std::vector<Rung>& ladder, ImageFormat format);

}  // namespace stationary::stress
