// The measurements as log-log panels: time an item against the worst error, a mark for each
// tolerance. A mark stands for all models and branches: the geometric mean of their times, the
// worst of their errors; of spectra each has its own mark.
#pragma once

#include <filesystem>
#include <vector>

#include "tests/bench/measurement.hpp"

namespace stationary::bench {

/// By the extension: .svg or .png.
void draw_work_precision(const std::vector<Measured>& results, const std::filesystem::path& into);

}  // namespace stationary::bench
