// The rest state's sheet followed from nu = 0 both ways, to escape or nu = 3, for each tolerance:
//   follow          equilibria, bounds and the events that need no spectrum
//   follow-spectra  with spectra, signatures and all events
// An item is a row; errors are how far the rows, interpolated, are from the curve.
#pragma once

#include <vector>

#include "solver/family/axis_family.hpp"
#include "tests/bench/measurement.hpp"

namespace stationary::bench {

struct Curve {
  std::string model;
  Branch branch;
  Stretch rest;
  AnyFamily equilibria;
  AnyFamily with_spectra;
};

Curve curve(std::string_view model, Branch branch);

/// `of` must outlive the entries.
void add_curves(const Curve& of, const std::string& what, std::vector<Entry>& out);

}  // namespace stationary::bench
