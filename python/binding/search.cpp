// Every stationary motion at each of many nu, with proof.
#include "solver/search/search.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "python/binding/interruptible.hpp"
#include "python/binding/module.hpp"
#include "python/binding/potential.hpp"
#include "python/binding/records.hpp"
#include "solver/kind/kind.hpp"
#include "solver/newton/thread_arena.hpp"
#include "solver/search/search_message.hpp"

namespace stationary::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

struct FoundRecord {
  std::int64_t index;  ///< of nu
  double nu;
  double alpha;
  double xi;
  double zeta;
  double rho;
  double error_bound;
  double residual;
  std::int32_t status;
  bool proven;
};

void append(const std::vector<Equilibrium>& list, bool proven, std::size_t index, double nu,
            std::vector<FoundRecord>& out) {
  for (const Equilibrium& each : list)
    out.push_back({static_cast<std::int64_t>(index), nu, each.q.alpha, each.q.xi, each.q.zeta,
                   each.q.rho, each.error_bound, each.residual,
                   static_cast<std::int32_t>(SolveStatus::solved), proven});
}

/// Solutions, and for each nu whether they are proven to be all, and the program's words.
py::tuple search(const Body& body, const Material& material, const std::string& branch,
                 const Numbers& nu, const std::array<double, 2>& box, std::optional<int> threads) {
  const Branch about = branch_named(branch);
  SearchOptions options{.min_stretch = box[0], .max_stretch = box[1]};
  require_box(options);
  const auto size = static_cast<std::size_t>(nu.size());
  std::vector<SearchResult> results(size);
  const double* const spins = nu.data();
  const int count = thread_count(threads);
  interruptible([&](const std::atomic<bool>& stop) {
    options.stop = &stop;
    for_each_by(count, size, [&](std::size_t k) {
      if (stop) return;
      results[k] =
          kind_of(body, material.potential, AxisRotation{about, spins[k]})->search(options);
    });
  });
  std::vector<FoundRecord> found;
  py::array_t<bool> complete(std::vector<py::ssize_t>(nu.shape(), nu.shape() + nu.ndim()));
  std::vector<std::string> messages;
  for (std::size_t k = 0; k < size; ++k) {
    append(results[k].solutions, true, k, spins[k], found);
    append(results[k].unproven, false, k, spins[k], found);
    complete.mutable_data()[k] = results[k].status == SearchStatus::complete;
    messages.push_back(results[k].message);
  }
  py::array_t<FoundRecord> solutions(static_cast<py::ssize_t>(found.size()));
  std::ranges::copy(found, solutions.mutable_data());
  return py::make_tuple(solutions, complete, messages);
}

}  // namespace

void declare_search(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(FoundRecord, index, nu, alpha, xi, zeta, rho, error_bound, residual, status,
                       proven);
  module.def("search", &search, py::arg("body"), py::arg("potential"), py::arg("branch"),
             py::arg("nu"), py::arg("box"), py::arg("threads"));
}

}  // namespace stationary::python
