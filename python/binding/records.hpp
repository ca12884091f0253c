// Records of the arrays that the library's functions return, and how they read those they are given.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "lib/stability/spectrum.hpp"
#include "solver/batch_spectrum/batch_spectrum.hpp"
#include "solver/motion/equilibrium.hpp"

namespace stationary::python {

namespace py = pybind11;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
/// Of a class that was not computed.
constexpr std::int32_t no_class = -1;

/// A cell of solve_batch, which writes it through NumPy's memory.
struct CellRecord {
  double alpha;
  double xi;
  double zeta;
  double rho;
  double error_bound;
  std::int32_t status;
};

struct SpectrumRecord {
  double growth = not_a_number;
  double re[5] = {not_a_number, not_a_number, not_a_number, not_a_number, not_a_number};
  double im[5] = {not_a_number, not_a_number, not_a_number, not_a_number, not_a_number};
  std::int32_t verdict = no_class;
  std::int32_t negative = -1;
  std::int32_t krein[5] = {0, 0, 0, 0, 0};
  std::int32_t modes = 0;
};

SpectrumRecord record(const CellSpectrum& spectrum);
SpectrumRecord record(const Spectrum& spectrum);

/// Solved motions about a material axis, read from an array of records with the fields nu, xi, zeta,
/// rho, and where they are there alpha, error_bound and status.
class Points {
 public:
  /// Throws InputError where a field is missing.
  explicit Points(const py::array& records);

  std::size_t size() const { return size_; }
  const std::vector<py::ssize_t>& shape() const { return shape_; }
  /// As an answer of `solve` for that branch.
  Equilibrium equilibrium(Branch branch, std::size_t k) const;
  double nu(std::size_t k) const { return nu_.data()[k]; }

 private:
  using Column = py::array_t<double, py::array::c_style | py::array::forcecast>;
  Column nu_, xi_, zeta_, rho_, alpha_, error_bound_, status_;
  std::vector<py::ssize_t> shape_;
  std::size_t size_;
};

}  // namespace stationary::python
