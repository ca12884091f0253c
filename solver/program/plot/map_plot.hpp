// The heat map of a table over two parameters as a gnuplot script, data included: each cell in the
// colour of its class, or of a number by the bar beside it; grey where there is no solution, light
// where that is proven. A logarithmic axis where the grid is.
#pragma once

#include <string>
#include <string_view>

#include "solver/program/plot/map_diagram.hpp"
#include "solver/program/plot/plot.hpp"

namespace stationary {

/// title: shown as it is; empty for none.
std::string gnuplot_script(const MapDiagram& diagram, ImageFormat format, std::string_view title);

}  // namespace stationary
