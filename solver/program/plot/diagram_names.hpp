// What is written in a diagram: the names of its curves, axes, panels and tables.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/diagram/diagram.hpp"

namespace stationary {

/// Of a branch.
std::string panel_title(std::string_view branch);

/// Of the curves that have a colour: columns, or branches where these share a panel.
std::vector<std::string> series_names(const Diagram& diagram);

std::string ordinate_name(const Diagram& diagram);

/// Characters that a line of the legend has room for.
constexpr std::size_t longest_legend_line = 24;

/// Its letters, and its file without folder and extension, of a long one its beginning and its end.
std::string table_name(const Diagram& diagram, std::size_t table);

}  // namespace stationary
