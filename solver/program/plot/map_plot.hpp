// The heat map of a table over two parameters as a gnuplot script, data included: each cell in the
// colour of its class, or of a number by the bar beside it; hatched where no solution was found, white
// where it is proven that there is none. A logarithmic axis where the grid is.
#pragma once

#include <array>
#include <iterator>
#include <string>
#include <string_view>

#include "lib/stability/spectrum.hpp"
#include "solver/program/diagram/map_diagram.hpp"
#include "solver/program/plot/plot.hpp"

namespace stationary {

/// By class. Apart in grey: of lightness 18, 76, 38, 59 and 94 of 100; marginal cells, mostly a border,
/// are the quietest.
constexpr std::array<std::string_view, std::size(stability_names)> class_colours{
    "#12355b", "#9fcbe6", "#c2410c", "#e0862a", "#f6efdc"};

/// The least page on which a map can be read, all of its legend included.
PageSize least_page(const MapDiagram& diagram);

/// title: shown as it is; empty for none.
std::string gnuplot_script(const MapDiagram& diagram, ImageFormat format, std::string_view title,
                           const PageChoice& choice = {});

}  // namespace stationary
