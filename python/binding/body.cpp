#include "lib/body/body.hpp"

#include <array>
#include <memory>
#include <string>

#include "python/binding/module.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::python {
namespace {

/// Throws InputError unless each is a real number of Python, NumPy or SymPy that is no truth value.
std::shared_ptr<Body> body(const std::array<py::object, 3>& J) {
  const py::object real = py::module_::import("numbers").attr("Real");
  std::array<double, 3> out{};
  for (std::size_t k = 0; k < 3; ++k) {
    const bool number = py::isinstance(J[k], real) && !py::isinstance<py::bool_>(J[k]);
    if (number) out[k] = PyFloat_AsDouble(J[k].ptr());
    if (!number || PyErr_Occurred() != nullptr) {
      PyErr_Clear();  // of a whole number that no double is
      throw InputError({}, "body.J",
                       "found " + std::string(py::repr(py::make_tuple(J[0], J[1], J[2]))),
                       "three numbers");
    }
  }
  return std::make_shared<Body>(out[0], out[1], out[2]);
}

}  // namespace

void declare_body(py::module_& module) {
  py::class_<Body, std::shared_ptr<Body>>(
      module, "Body",
      "The body: its inertia J = diag(J1, J2, J3) in the material frame, the second moments "
      "of mass along each axis. Raises InputError unless all are finite and > 0.")
      // Of objects: pybind11's own conversion to double would take truth values too.
      .def(py::init([](const py::object& J1, const py::object& J2, const py::object& J3) {
             return body({J1, J2, J3});
           }),
           py::arg("J1"), py::arg("J2"), py::arg("J3"))
      .def_readonly("J1", &Body::J1)
      .def_readonly("J2", &Body::J2)
      .def_readonly("J3", &Body::J3)
      .def_property_readonly("symmetric", &Body::symmetric)
      .def(
          "__eq__", [](const Body& a, const Body& b) { return a == b; }, py::is_operator())
      .def("__hash__",
           [](const Body& body) { return py::hash(py::make_tuple(body.J1, body.J2, body.J3)); })
      .def("__reduce__",
           [](const py::object& self) {
             const auto& body = self.cast<const Body&>();
             return py::make_tuple(self.attr("__class__"),
                                   py::make_tuple(body.J1, body.J2, body.J3));
           })
      .def("__repr__", [](const Body& body) {
        return "Body(J1=" + std::string(py::repr(py::float_(body.J1))) +
               ", J2=" + std::string(py::repr(py::float_(body.J2))) +
               ", J3=" + std::string(py::repr(py::float_(body.J3))) + ")";
      });
}

}  // namespace stationary::python
