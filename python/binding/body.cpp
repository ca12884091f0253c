#include "lib/body/body.hpp"

#include <memory>
#include <string>

#include "python/binding/module.hpp"
#include "solver/program/text/input_error.hpp"

namespace stationary::python {

void declare_body(py::module_& module) {
  py::class_<Body, std::shared_ptr<Body>>(
      module, "Body",
      "The body: its inertia J = diag(J1, J2, J3) in the material frame, the second moments "
      "of mass along each axis. Raises InputError unless all are finite and > 0.")
      .def(py::init<double, double, double>(), py::arg("J1"), py::arg("J2"), py::arg("J3"))
      .def(py::init([](const py::object& J1, const py::object& J2,
                       const py::object& J3) -> std::shared_ptr<Body> {
             throw InputError({}, "body.J",
                              "found " + std::string(py::repr(py::make_tuple(J1, J2, J3))),
                              "three numbers");
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
