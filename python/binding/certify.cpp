// Proofs about each of many solved motions.
#include "solver/proof/certify.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <vector>

#include "python/binding/interruptible.hpp"
#include "python/binding/module.hpp"
#include "python/binding/potential.hpp"
#include "python/binding/records.hpp"
#include "solver/kind/kind.hpp"
#include "solver/newton/thread_arena.hpp"

namespace stationary::python {
namespace {

struct ProofRecord {
  double error_bound = not_a_number;
  /// Where the solution lies, lower and upper bound.
  double alpha[2] = {not_a_number, not_a_number};
  double xi[2] = {not_a_number, not_a_number};
  double zeta[2] = {not_a_number, not_a_number};
  double rho[2] = {not_a_number, not_a_number};
  bool proven = false;
  bool class_proven = false;
};

void set(double (&bounds)[2], const Interval& interval) {
  bounds[0] = interval.lo;
  bounds[1] = interval.hi;
}

ProofRecord proof(const Kind& kind, const Equilibrium& at, std::string& reason) {
  const Certificate found = kind.certify(at);
  ProofRecord out;
  out.proven = found.proven;
  reason = found.reason;
  if (!found.proven) return out;
  out.error_bound = found.error_bound;
  set(out.alpha, found.solution.alpha);
  set(out.xi, found.solution.xi);
  set(out.zeta, found.solution.zeta);
  set(out.rho, found.solution.rho);
  if (const auto spectrum = kind.spectrum(at))
    out.class_proven = kind.enclose(at, found, *spectrum).verdict == spectrum->verdict;
  return out;
}

py::tuple certify(const Body& body, const Material& material, const std::string& branch,
                  const py::array& records, std::optional<int> threads) {
  const Branch about = branch_named(branch);
  const Points points(records);
  py::array_t<ProofRecord> out(points.shape());
  ProofRecord* const all = out.mutable_data();
  std::vector<std::string> reasons(points.size());
  const int count = thread_count(threads);
  interruptible([&](const std::atomic<bool>& stop) {
    for_each_by(count, points.size(), [&](std::size_t k) {
      all[k] = ProofRecord();
      const Equilibrium at = points.equilibrium(about, k);
      if (at.status != SolveStatus::solved) reasons[k] = "not solved";
      if (stop || at.status != SolveStatus::solved) return;
      const auto kind = kind_of(body, material.potential, AxisRotation{about, points.nu(k)});
      all[k] = proof(*kind, at, reasons[k]);
    });
  });
  return py::make_tuple(out, reasons, material.potential.assumptions());
}

}  // namespace

void declare_certify(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(ProofRecord, proven, class_proven, error_bound, alpha, xi, zeta, rho);
  module.def("certify", &certify, py::arg("body"), py::arg("potential"), py::arg("branch"),
             py::arg("points"), py::arg("threads"));
}

}  // namespace stationary::python
