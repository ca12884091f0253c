#include "python/binding/module.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace stationary::python;
  module.doc() = "What of the package stationary is written in C++; see there.";
  module.attr("version") = STATIONARY_VERSION;
  declare_errors(module);
  declare_case(module);
  declare_computed(module);
  declare_body(module);
  declare_potential(module);
  declare_sweep(module);
  declare_batch(module);
  declare_spectrum(module);
  declare_certify(module);
  declare_search(module);
}
