// Many bodies and potentials at many nu (solver/batch/batch.hpp), with their spectra.
#include "solver/batch/batch.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "python/binding/interruptible.hpp"
#include "python/binding/module.hpp"
#include "python/binding/potential.hpp"
#include "python/binding/records.hpp"
#include "solver/batch_spectrum/batch_spectrum.hpp"
#include "solver/newton/thread_arena.hpp"
#include "solver/program/case/case_parameter.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Cells solved together: their results are still in the cache when they are written out.
constexpr std::size_t cells_at_once = 65536;

/// A parameter's values, one a lane.
struct Varied {
  FamilyParameter what;
  const double* values;
};

/// Throws InputError for a key that is no parameter, or values that are not one a lane.
std::vector<Varied> varied(const std::vector<ModelChoice>& models,
                           const std::map<std::string, Numbers>& parameters, std::size_t lanes) {
  std::vector<std::string> keys = case_parameters(AxisRotation{Branch::i, 0.0}, models);
  std::erase(keys, "nu");
  const std::vector<std::string_view> names(keys.begin(), keys.end());
  std::vector<Varied> out;
  for (const auto& [key, values] : parameters) {
    if (std::ranges::find(keys, key) == keys.end())
      throw InputError({}, "parameters", "found " + in_quotes(key), "one of " + listed(names),
                       did_you_mean(nearest_name(key, names)));
    if (values.ndim() != 1)
      throw InputError({}, key,
                       values.ndim() == 0 ? "found one number"
                                          : "found an array of shape " +
                                                std::string(py::str(values.attr("shape"))),
                       "an array of shape (lanes,), a number for each lane");
    if (static_cast<std::size_t>(values.size()) != lanes)
      throw InputError(
          {}, key, "found " + std::to_string(values.size()) + " values",
          std::to_string(lanes) + ", an array of as many as the other parameters have");
    out.push_back({family_parameter(key, models), values.data()});
  }
  return out;
}

BatchInput share(const Problem& problem, const std::vector<Varied>& parameters,
                 const std::vector<double>& nu, std::size_t begin, std::size_t count) {
  BatchInput out(problem, count, nu);
  for (const Varied& each : parameters)
    out.vary(each.what, {each.values + begin, each.values + begin + count});
  return out;
}

/// The spectra of a share's solved cells, by all threads.
void spectra(const BatchInput& input, const BatchResult& solved, bool modes, int threads,
             SpectrumRecord* out) {
  for_each_by(threads, input.lanes, [&](std::size_t lane) {
    std::vector<CellPlace> places;
    for (std::size_t k = 0; k < input.nu.size(); ++k)
      if (solved.cell(lane, k).status == SolveStatus::solved) places.push_back({lane, k});
    std::vector<CellSpectrum> found(places.size());
    cell_spectra(input, solved, places, {.modes = modes}, found);
    for (std::size_t i = 0; i < places.size(); ++i)
      out[lane * input.nu.size() + places[i].k] = record(found[i]);
  });
}

/// Cells (lanes, nu), and their spectra where they are asked for.
py::tuple solve_batch(const Body& body, const Material& material, const std::string& branch,
                      const Numbers& nu, const std::map<std::string, Numbers>& parameters,
                      const std::optional<std::string>& spectrum, bool error_bound,
                      std::optional<int> threads) {
  constexpr std::string_view spectra_names[] = {"class", "modes"};
  if (spectrum && std::ranges::find(spectra_names, *spectrum) == std::end(spectra_names))
    throw InputError({}, "spectrum", "found the string " + in_quotes(*spectrum),
                     "None, or one of " + listed(spectra_names));
  const Problem problem(body, material.potential, branch_named(branch));
  const std::size_t lanes =
      parameters.empty() ? 1 : static_cast<std::size_t>(parameters.begin()->second.size());
  const std::vector<Varied> lane_values = varied(material.models, parameters, lanes);
  const std::vector<double> spins(nu.data(), nu.data() + nu.size());
  const auto count = static_cast<py::ssize_t>(spins.size());
  const auto rows = static_cast<py::ssize_t>(lanes);
  py::array_t<CellRecord> cells({rows, count});
  std::optional<py::array_t<SpectrumRecord>> modes;
  if (spectrum) modes.emplace(std::vector<py::ssize_t>{rows, count});
  CellRecord* const out = cells.mutable_data();
  SpectrumRecord* const spectra_out = modes ? modes->mutable_data() : nullptr;
  BatchOptions how;
  how.error_bound = error_bound;
  how.threads = thread_count(threads);
  interruptible([&](const std::atomic<bool>& stop) {
    if (spins.empty() || lanes == 0) return;
    how.stop = &stop;
    constexpr std::size_t tile = BatchResult::tile;
    const std::size_t at_once = std::max<std::size_t>(cells_at_once / spins.size() / tile,
                                                      static_cast<std::size_t>(how.threads)) *
                                tile;
    BatchResult solved;
    for (std::size_t begin = 0; begin < lanes && !stop; begin += at_once) {
      const std::size_t share_of = std::min(at_once, lanes - begin);
      const BatchInput input = share(problem, lane_values, spins, begin, share_of);
      stationary::solve_batch(input, how, solved);
      CellRecord* at = out + begin * spins.size();
      for (std::size_t lane = 0; lane < share_of; ++lane) {
        for (std::size_t k = 0; k < spins.size(); ++k) {
          const BatchCell cell = solved.cell(lane, k);
          *at++ = {cell.alpha, cell.xi,          cell.zeta,
                   cell.rho,   cell.error_bound, static_cast<std::int32_t>(cell.status)};
        }
      }
      if (spectra_out != nullptr) {
        SpectrumRecord* const share_out = spectra_out + begin * spins.size();
        std::fill_n(share_out, share_of * spins.size(), SpectrumRecord());
        if (!stop) spectra(input, solved, *spectrum == "modes", how.threads, share_out);
      }
    }
  });
  return py::make_tuple(cells, modes ? py::object(*modes) : py::none());
}

}  // namespace

void declare_batch(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(CellRecord, alpha, xi, zeta, rho, error_bound, status);
  module.def("solve_batch", &solve_batch, py::arg("body"), py::arg("potential"), py::arg("branch"),
             py::arg("nu"), py::arg("parameters"), py::arg("spectrum"), py::arg("error_bound"),
             py::arg("threads"));
  module.attr("instructions") = std::string(name(best_instruction_set()));
}

}  // namespace stationary::python
