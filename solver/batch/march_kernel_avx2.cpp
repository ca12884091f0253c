// The marches for processors with AVX2 and FMA; compiled with those flags.
#include "lib/material/potential.hpp"
#include "solver/batch/march_kernel.hpp"

namespace stationary {
namespace {

using Lanes = Pack<32>;

template <template <class> class Model>
constexpr auto plane = &march<Lanes, PlanarLanes<Lanes, Model>>;
template <template <class> class Model>
constexpr auto thickness = &march<Lanes, ThicknessLanes<Lanes, Model>>;

}  // namespace

const MarchKernels& march_kernels_avx2() {
  static constexpr MarchKernels kernels{
      Lanes::lanes,
      {plane<ReciprocalDeterminant>, plane<SaintVenantKirchhoff>, plane<Biot>, plane<BiotLog>,
       plane<NeoHookean>, plane<Hencky>},
      {thickness<ReciprocalQuadratic>, thickness<Harmonic>}};
  return kernels;
}

}  // namespace stationary
