// What a drawing of a table shows, found by what the program draws with gnuplot.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

namespace stationary::python {

/// A bifurcation diagram: a dict of its parameter, points, lines by class, events and axes. Throws
/// InputError where the table lacks what is needed.
pybind11::dict diagram(const std::string& csv);

/// A heat map over two parameters.
pybind11::dict map_diagram(const std::string& csv, const std::optional<std::string>& quantity);

}  // namespace stationary::python
