// Where the panels and the legend of a diagram are on its page, and how large a page they need: no line
// of the legend is left out, numbers and names of axes are apart.
#pragma once

#include "solver/program/diagram/diagram.hpp"
#include "solver/program/plot/diagram_picture.hpp"

namespace stationary {

/// The lines of the legend, empty ones between its parts included; less of them may be in view.
std::size_t most_legend_lines(const Diagram& diagram);

/// The least page on which a diagram can be read.
PageSize least_page(const Diagram& diagram);

/// Places the panels, which have their titles already, and sizes the page.
void lay_out(const Diagram& diagram, const PageChoice& choice, DiagramPicture& picture);

}  // namespace stationary
