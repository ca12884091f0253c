// What the kernels of spectra are given and give back: plain arrays, so that files compiled for
// other instruction sets share nothing else with the rest (spectrum_kernel.hpp,
// batch_spectrum.hpp).
//
// A tile is `size` cells side by side, all of one branch and the same models, no two of which need
// have anything else in common. Branch (ii) is handed over as (i), axes 1 and 2 exchanged.
#pragma once

#include <array>
#include <cstddef>
#include <variant>

#include "solver/batch/march.hpp"

namespace stationary {

struct SpectrumTile {
  static constexpr std::size_t size = 16;
  using Numbers = double[size];

  // Given.
  Numbers nu;
  Numbers q[3];         ///< xi, zeta, rho
  Numbers uncertainty;  ///< relative, of all numbers here: BlockFacts::uncertainty
  Numbers inertia[3];   ///< J1, J2, J3
  Numbers pull[3];      ///< the same where the spin pulls at that stretch, else 0
  Numbers plane[2];     ///< coefficients
  Numbers thickness[2];

  /// A derivative of the balance in logarithmic coordinates (log_balance.hpp): its value, as a pair
  /// where modes are asked for, and the units of its error (running_error.hpp).
  struct Derivative {
    Numbers head;
    Numbers tail;
    Numbers units;
  };
  // Between the model's kernels and the branch's.
  Numbers tail[3];  ///< q - the exact solution's rounding, with the opposite sign: q + tail
  Derivative uu;
  Derivative uv;
  Derivative vv;
  Derivative ww;

  // Given back.
  Numbers verdict;  ///< a StabilityClass as a number; -1: left to the scalar path, as all below
  Numbers negative;
  Numbers growth;  ///< from here on only where modes were asked for
  Numbers re[5];   ///< as Spectrum::mode, in its order
  Numbers im[5];
  Numbers krein[5];
};

/// By the index of the model in PlanarPotential and ThicknessPotential; the branch's kernel comes
/// after them. modes: growth and modes too, in pairs.
struct SpectrumKernels {
  using Kernel = void (*)(SpectrumTile&, bool modes);
  std::array<Kernel, std::variant_size_v<PlanarPotential>> plane;
  std::array<Kernel, std::variant_size_v<ThicknessPotential>> thickness;
  Kernel in_plane;  ///< (i)
  Kernel normal;    ///< (iii)

  static const SpectrumKernels& baseline();
  /// On x86-64 alone.
  static const SpectrumKernels& avx2();
  static const SpectrumKernels& avx512();
};

}  // namespace stationary
