// A family at many nu (solver/batch/sweep.hpp), written into NumPy's memory.
#include "solver/batch/sweep.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>

#include "python/binding/interruptible.hpp"
#include "python/binding/module.hpp"
#include "python/binding/potential.hpp"
#include "solver/program/session/exit_status.hpp"

namespace stationary::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Between two looks at whether it is to end.
constexpr std::size_t block = 16384;

/// The records, and where there is no start what to say of that.
py::tuple sweep(const Body& body, const Material& material, const std::string& branch,
                const Numbers& nu, const std::optional<std::array<double, 4>>& start,
                bool error_bound) {
  const Problem problem(body, material.potential, branch_named(branch));
  py::array_t<SweepPoint> out(std::vector<py::ssize_t>(nu.shape(), nu.shape() + nu.ndim()));
  const std::span<const double> values(nu.data(), static_cast<std::size_t>(nu.size()));
  const std::span<SweepPoint> points(out.mutable_data(), values.size());
  SolveStatus status = SolveStatus::solved;
  std::string message;
  interruptible([&](const std::atomic<bool>& stop) {
    if (values.empty()) return;
    SolveOptions how;
    how.stop = &stop;
    if (start) how.start = Stretch{(*start)[0], (*start)[1], (*start)[2], (*start)[3]};
    const Equilibrium first = stationary::solve(problem, values[0], how);
    status = first.status;
    message = first.message;
    if (status != SolveStatus::solved) return;
    Sweep sweep(problem, first, {.error_bound = error_bound});
    for (std::size_t begin = 0; begin < values.size() && !stop; begin += block) {
      const std::size_t count = std::min(block, values.size() - begin);
      sweep.run(values.subspan(begin, count), points.subspan(begin, count));
    }
  });
  return py::make_tuple(out, static_cast<int>(cli::exit_code(status)),
                        cli::failure_text(cli::outcome(status), message));
}

}  // namespace

void declare_sweep(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(SweepPoint, nu, xi, zeta, rho, error_bound, steps, status);
  module.def("sweep", &sweep, py::arg("body"), py::arg("potential"), py::arg("branch"),
             py::arg("nu"), py::arg("start"), py::arg("error_bound"));
}

}  // namespace stationary::python
