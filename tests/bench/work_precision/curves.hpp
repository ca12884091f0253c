// The rest state's sheet followed from nu = 0 both ways, to escape or nu = 3, for each tolerance:
//   follow          equilibria, bounds and the events that need no spectrum
//   follow-spectra  with spectra, signatures and all events
// An item is a row. Errors are lengths in (ln xi, ln zeta, ln rho, nu/3), where the stretches are
// between 1e-3 and 1e3:
//   curve       how far the rows, interpolated, are from the curve
//   curve-rows  how far the rows themselves are, at one tolerance, in 50 digits: the digits they keep
#pragma once

#include <array>
#include <vector>

#include "lib/number/double_double.hpp"
#include "solver/family/axis_family.hpp"
#include "tests/bench/measurement.hpp"

namespace stationary::bench {

inline constexpr double last_nu = 3.0;

struct Curve {
  std::string model;
  Branch branch;
  Stretch rest;
  AnyFamily equilibria;
  AnyFamily with_spectra;
};

Curve curve(std::string_view model, Branch branch);

/// A row of a curve, as exactly as whoever computed it has it.
struct CurveRow {
  std::array<DoubleDouble, 3> stretches;
  double nu;
};

std::vector<double> errors_between(const Curve& of, const std::vector<CurveRow>& rows);
std::vector<double> errors_at(const Curve& of, const std::vector<CurveRow>& rows);

/// Both panels; `of` must outlive the entries.
void add_curves(const Curve& of, std::vector<Entry>& out);

}  // namespace stationary::bench
