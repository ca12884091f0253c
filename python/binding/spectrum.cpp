// The spectrum of each of many solved motions.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>

#include "python/binding/interruptible.hpp"
#include "python/binding/module.hpp"
#include "python/binding/potential.hpp"
#include "python/binding/records.hpp"
#include "solver/kind/kind.hpp"
#include "solver/newton/thread_arena.hpp"

namespace stationary::python {
namespace {

py::array spectrum(const Body& body, const Material& material, const std::string& branch,
                   const py::array& records, std::optional<int> threads) {
  const Branch about = branch_named(branch);
  const Points points(records);
  py::array_t<SpectrumRecord> out(points.shape());
  SpectrumRecord* const all = out.mutable_data();
  const int count = thread_count(threads);
  interruptible([&](const std::atomic<bool>& stop) {
    for_each_by(count, points.size(), [&](std::size_t k) {
      all[k] = SpectrumRecord();
      const Equilibrium at = points.equilibrium(about, k);
      if (stop || at.status != SolveStatus::solved) return;
      const auto kind = kind_of(body, material.potential, AxisRotation{about, points.nu(k)});
      if (const auto found = kind->spectrum(at)) all[k] = record(*found);
    });
  });
  return out;
}

}  // namespace

void declare_spectrum(py::module_& module) {
  PYBIND11_NUMPY_DTYPE_EX(SpectrumRecord, verdict, "class", negative, "negative", growth, "growth",
                          re, "re", im, "im", krein, "krein", modes, "modes");
  module.def("spectrum", &spectrum, py::arg("body"), py::arg("potential"), py::arg("branch"),
             py::arg("points"), py::arg("threads"));
}

}  // namespace stationary::python
