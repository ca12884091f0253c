// What a batch's kernels are given and give back: plain arrays, so that files compiled for other
// instruction sets share nothing else with the rest (march_kernel.hpp, batch.hpp).
//
// A march goes from the rest state through growing nu = speed s, s_0 = 0 < s_1 < ..., in several
// lanes at once; a lane is one body and potential. It solves one part of the balance, (xi, zeta) or
// rho, of which the other knows nothing.
#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include "lib/material/models/isotropic_models.hpp"

namespace stationary {

/// A value of s. The predictor is the polynomial in s^2 through the last points, at most four:
/// weight[k] times the k-th last, 0 where there is none.
struct MarchStep {
  double s = 0.0;
  double weight[4] = {0.0, 0.0, 0.0, 0.0};
  std::ptrdiff_t slot = -1;  ///< of the output; -1: on the way only
};

/// Pointers to `lanes` numbers each, lane by lane; outputs have `stride` numbers a slot.
struct March {
  const double* speed;
  const double* inertia[2];      ///< of c_xi, c_zeta = inertia nu^2, or of c_rho and none
  const double* coefficient[2];  ///< of the model
  const double* rest;            ///< xi = zeta, or rho, at nu = 0
  const MarchStep* steps;
  std::ptrdiff_t step_count;
  bool extended;  ///< residuals of outputs in pairs of doubles, rounded correctly; else in double
  bool bounded;   ///< error bounds wanted
  std::ptrdiff_t stride;
  double* x[2];         ///< xi and zeta, or rho and none
  double* error_bound;  ///< as Equilibrium::error_bound; untouched unless bounded
  std::ptrdiff_t* end;  ///< a lane's first step that was not solved, or step_count
};

enum class InstructionSet { baseline, avx2, avx512 };

/// The models of a variant, for functions that take their names alone.
template <class Models>
constexpr const Models* models = nullptr;

/// Marches by the index of the model in PlanarPotential and ThicknessPotential.
struct MarchKernels {
  using Kernel = void (*)(const March&);
  int lanes;
  std::array<Kernel, std::variant_size_v<PlanarPotential>> plane;
  std::array<Kernel, std::variant_size_v<ThicknessPotential>> thickness;

  static const MarchKernels& baseline();
  /// On x86-64 alone.
  static const MarchKernels& avx2();
  static const MarchKernels& avx512();
};

}  // namespace stationary
