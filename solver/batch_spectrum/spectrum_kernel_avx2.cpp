// The spectra for processors with AVX2 and FMA; compiled with those flags.
#include "lib/material/potential.hpp"
#include "solver/batch_spectrum/spectrum_kernel.hpp"

namespace stationary {
namespace {

using Lanes = Pack<32>;

template <template <class> class Model>
constexpr auto plane = &plane_derivatives<Lanes, Model>;
template <template <class> class Model>
constexpr auto thickness = &thickness_derivatives<Lanes, Model>;

}  // namespace

const SpectrumKernels& spectrum_kernels_avx2() {
  static constexpr SpectrumKernels kernels{
      {plane<ReciprocalDeterminant>, plane<SaintVenantKirchhoff>, plane<Biot>, plane<BiotLog>,
       plane<NeoHookean>, plane<Hencky>},
      {thickness<ReciprocalQuadratic>, thickness<Harmonic>},
      &lane_spectra<Lanes, false>,
      &lane_spectra<Lanes, true>};
  return kernels;
}

}  // namespace stationary
