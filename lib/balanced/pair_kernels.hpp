// What the spectrum of a spin needs in pairs of doubles, compiled once for any processor and once for
// those with fused multiply-adds, where it takes two thirds of the time. Both give the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "lib/balanced/pair_blocks.hpp"
#include "lib/material/models/isotropic_models.hpp"

namespace stationary {

/// Where Own stands in a variant; its size where nowhere.
template <class Own, class... Each>
constexpr std::size_t place_among(const std::variant<Each...>*) {
  const bool is[] = {std::is_same_v<Own, Each>...};
  std::size_t place = 0;
  while (place < sizeof...(Each) && !is[place]) ++place;
  return place;
}

/// Of the built-in models, in the order of their variants, by their two coefficients.
struct PairKernels {
  using Part = void (*)(const std::array<double, 2>& coefficients, const PairSpin&,
                        PairCurvatures&);
  /// material_symmetry: as of BlockFacts.
  template <class Blocks>
  using Of = void (*)(const PairSpin&, const PairCurvatures&, const SpinUnits&,
                      bool material_symmetry, Blocks&);

  std::array<Part, std::variant_size_v<PlanarPotential>> plane;
  std::array<Part, std::variant_size_v<ThicknessPotential>> thickness;
  Of<InPlaneBlocks> in_plane_blocks;
  Of<NormalBlocks> normal_blocks;
};

const PairKernels& portable_pair_kernels();
/// Null where the processor has no such instruction, or its kind has no kernel here.
const PairKernels* fused_pair_kernels();

/// The faster of those there are.
const PairKernels& pair_kernels();

}  // namespace stationary
