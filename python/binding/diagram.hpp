// What a drawing of a table shows, found by what the program draws with gnuplot.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "solver/program/diagram/diagram.hpp"

namespace stationary::python {

/// A bifurcation diagram, or of energy and momentum: a dict of its panels' lines by class, rates, events
/// and axes. Throws InputError where the table lacks what is needed.
pybind11::dict diagram(const std::string& csv, const DiagramChoice& choice);

/// A heat map over two parameters.
pybind11::dict map_diagram(const std::string& csv, const std::optional<std::string>& quantity);

/// Curves of events in two parameters.
pybind11::dict curve_diagram(const std::string& csv);

}  // namespace stationary::python
