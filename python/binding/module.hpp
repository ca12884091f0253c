// The parts of the module stationary._core, a file each. What the user sees of them is in the
// package beside (stationary/*.py): names, documentation, pandas, drawings.
#pragma once

#include <pybind11/pybind11.h>

namespace stationary::python {

namespace py = pybind11;

void declare_errors(py::module_& module);
void declare_case(py::module_& module);
void declare_computed(py::module_& module);
void declare_body(py::module_& module);
void declare_potential(py::module_& module);
void declare_sweep(py::module_& module);
void declare_batch(py::module_& module);
void declare_spectrum(py::module_& module);
void declare_certify(py::module_& module);
void declare_search(py::module_& module);

}  // namespace stationary::python
