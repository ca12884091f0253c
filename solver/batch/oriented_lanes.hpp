// The last corrections of many points of one lane at once (anisotropic_batch.hpp), of a potential made
// of a built-in planar model, a thickness and fibres: what kernels are given and give back, plain
// numbers, so that files compiled for other instruction sets share nothing else with the rest
// (oriented_kernel.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "lib/body/direction.hpp"
#include "lib/body/motion.hpp"
#include "solver/batch/march.hpp"
#include "solver/motion/oriented_system.hpp"

namespace stationary {

/// One lane's body and potential.
struct OrientedLane {
  struct LaneFibre {
    double k;
    Direction<double> along;
    Direction<DoubleDouble> wide;
    Direction<double> turned;  ///< slope to a relative change of its degrees
  };
  std::array<double, 3> inertia;
  Branch branch;
  std::size_t plane_model = 0;  ///< of PlanarPotential
  std::array<double, 2> plane{};
  bool harmonic = false;
  std::array<double, 2> thickness{};
  std::array<LaneFibre, AnisotropicModel<double>::max_fibres> fibre{};
  std::size_t fibres = 0;
};

/// Points near the lane's curve, in: x = (xi, zeta, rho, x_a) and nu; out: each corrected as refine()
/// corrects, where accepted is 1.
struct OrientedPoints {
  static constexpr std::size_t size = 32;
  using Numbers = std::array<double, size>;
  std::array<Numbers, 4> x;
  Numbers nu;
  Numbers alpha;
  Numbers error_bound;  ///< of x, as of Refined
  Numbers accepted;
  Numbers positive;  ///< 1 where det dG/d ln x > 0
};

/// Kernels by the planar model, null where it has none: where alpha is an unknown, and where it is 0.
struct OrientedKernels {
  using Kernel = void (*)(const OrientedLane&, OrientedPoints&);
  std::array<Kernel, std::variant_size_v<PlanarPotential>> sheared;
  std::array<Kernel, std::variant_size_v<PlanarPotential>> straight;

  static const OrientedKernels& baseline();
  /// On x86-64 alone.
  static const OrientedKernels& avx2();
  static const OrientedKernels& avx512();
};

/// Nothing where the potential has other parts, gravity or a held volume.
std::optional<OrientedLane> oriented_lane(const Body& body, Branch branch,
                                          const AnisotropicPotential& V);

}  // namespace stationary
