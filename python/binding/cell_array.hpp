// A table with columns of any name as a NumPy structured array.
//
//   texts    as Unicode strings of the longest cell's length
//   numbers of a row, a curve, a point   64-bit integers
//   numbers, and the counts that may be missing   doubles, NaN where the cell is empty
#pragma once

#include <pybind11/numpy.h>

#include "solver/program/table/cell_table.hpp"

namespace stationary::python {

/// Of a table that kept its lines.
pybind11::array cell_array(const CellTable& table);

}  // namespace stationary::python
