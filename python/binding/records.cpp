#include "python/binding/records.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/program/text/input_error.hpp"

namespace stationary::python {
namespace {

/// Of less the modes lose their digits; a case's nu is refused likewise (case_parameter.cpp).
constexpr double least_spin = 1e-100;

using Column = py::array_t<double, py::array::c_style | py::array::forcecast>;

bool has(const py::array& records, const char* name) {
  const py::object names = records.dtype().attr("names");
  return !names.is_none() && names.contains(name);
}

Column needed(const py::array& records, const char* name) {
  if (has(records, name)) {
    const auto numbers = Column::ensure(records.attr("__getitem__")(name));
    // A field of arrays has another shape.
    if (numbers && numbers.ndim() == records.ndim() &&
        std::equal(numbers.shape(), numbers.shape() + numbers.ndim(), records.shape()))
      return numbers;
    throw InputError({}, "points", "found no numbers in the field " + in_quotes(name),
                     "one a point");
  }
  throw InputError({}, "points", "found no field " + in_quotes(name),
                   "a structured array with nu, xi, zeta and rho", "as sweep() returns it");
}

/// Empty where the field is missing.
Column optional(const py::array& records, const char* name) {
  return has(records, name) ? needed(records, name) : Column();
}

template <class Modes>
void fill(const Modes& modes, SpectrumRecord& out) {
  for (int k = 0; k < out.modes; ++k) {
    const auto& mode = modes[static_cast<std::size_t>(k)];
    out.re[k] = mode.re;
    out.im[k] = mode.im;
    out.krein[k] = mode.krein;
  }
}

template <class S>
SpectrumRecord record_of(const S& spectrum) {
  SpectrumRecord out;
  out.growth = spectrum.growth;
  out.verdict = static_cast<std::int32_t>(spectrum.verdict);
  out.negative = spectrum.negative;
  out.modes = spectrum.modes;
  fill(spectrum.mode, out);
  return out;
}

}  // namespace

SpectrumRecord record(const CellSpectrum& spectrum) { return record_of(spectrum); }
SpectrumRecord record(const Spectrum& spectrum) { return record_of(spectrum); }

Points::Points(const py::array& records)
    : nu_(needed(records, "nu")),
      xi_(needed(records, "xi")),
      zeta_(needed(records, "zeta")),
      rho_(needed(records, "rho")),
      alpha_(optional(records, "alpha")),
      error_bound_(optional(records, "error_bound")),
      status_(optional(records, "status")),
      shape_(records.shape(), records.shape() + records.ndim()),
      size_(static_cast<std::size_t>(records.size())) {
  for (std::size_t k = 0; k < size_; ++k) {
    const Equilibrium at = equilibrium(Branch::i, k);
    if (at.status != SolveStatus::solved) continue;
    const char* wrong = violated_inequality(at.q);
    if (wrong == nullptr && !std::isfinite(nu(k))) wrong = "a finite nu";
    if (wrong == nullptr && nu(k) != 0.0 && std::abs(nu(k)) < least_spin)
      wrong = "nu = 0 or |nu| >= 1e-100";
    if (wrong != nullptr)
      throw InputError({}, "points", "found another in record " + std::to_string(k), wrong);
  }
}

Equilibrium Points::equilibrium(Branch branch, std::size_t k) const {
  Equilibrium out;
  out.status = status_.size() == 0 ? SolveStatus::solved
                                   : static_cast<SolveStatus>(static_cast<int>(status_.data()[k]));
  out.q = {alpha_.size() == 0 ? 0.0 : alpha_.data()[k], xi_.data()[k], zeta_.data()[k],
           rho_.data()[k]};
  out.nu = angular_velocity(branch, nu_.data()[k]);
  if (error_bound_.size() != 0) out.error_bound = error_bound_.data()[k];
  return out;
}

}  // namespace stationary::python
