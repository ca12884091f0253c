// What is solved, and its true solutions (references.hpp).
#pragma once

#include <span>
#include <vector>

#include "solver/batch/sweep.hpp"
#include "tests/bench/measurement.hpp"

namespace stationary::bench {

/// The rest state's sheet of a body at some nu.
struct Equilibria {
  std::string model;
  Problem problem;
  std::vector<double> nu;
  Stretch rest;
  Equilibrium first;  ///< at the first nu
  std::vector<std::array<DoubleDouble, 3>> exact;

  /// Relative errors of stretches found at each nu; NaN where one is not finite.
  std::vector<double> errors(std::span<const Vector4<double>> found) const;
};

/// At count nu, evenly spaced from 0 (left out) to 0.5.
Equilibria equilibria(std::string_view model, Branch branch, int count);

/// A sweep, each solve from the ones before; `of` must outlive the entries.
void add_warm(const Equilibria& of, const std::string& what, std::vector<Entry>& out);

/// Each solve from the rest state.
void add_cold(const Equilibria& of, const std::string& what, std::vector<Entry>& out);

}  // namespace stationary::bench
