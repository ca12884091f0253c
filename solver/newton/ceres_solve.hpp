// A reduced system by Ceres: Levenberg-Marquardt over the balance of lib and its Jacobian, unknowns
// ln x (the domain cannot be left).
//
//   minimize |G(x)|^2 / (2 s^2),  s = magnitude of G's terms at the start
//
// All of Ceres' tolerances are set (its default parameter_tolerance would stop at an error of
// 1e-8). Its verdict is not used: the caller refines and recomputes the residual.
#pragma once

#include <string>

#include "lib/material/potential.hpp"
#include "solver/newton/reduced_system.hpp"

namespace stationary {

/// "2.1.0"; empty where this was built without: then its method stands in no_ceres.cpp.
std::string version_of_ceres();

struct CeresOutcome {
  bool usable = false;  ///< Ceres returned a finite point no worse than the start
  int iterations = 0;
  int residuals = 0;
  int jacobians = 0;
};

/// x in place, threads >= 1. Compiled in ceres_solve.cpp for the types that
/// Potential::visit_parts() gives.
template <class System>
CeresOutcome ceres_solve(const System& system, ReducedVector<System::dimension>& x, int threads);

}  // namespace stationary
