// The spectra for processors with AVX-512 F and DQ; compiled with those flags.
#include "lib/material/potential.hpp"
#include "solver/batch_spectrum/spectrum_kernel.hpp"

namespace stationary {
namespace {

using Lanes = Pack<64>;

template <template <class> class Model>
constexpr auto plane = &plane_derivatives<Lanes, Model>;
template <template <class> class Model>
constexpr auto thickness = &thickness_derivatives<Lanes, Model>;

}  // namespace

const SpectrumKernels& spectrum_kernels_avx512() {
  static constexpr SpectrumKernels kernels{
      {plane<ReciprocalDeterminant>, plane<SaintVenantKirchhoff>, plane<Biot>, plane<BiotLog>,
       plane<NeoHookean>, plane<Hencky>},
      {thickness<ReciprocalQuadratic>, thickness<Harmonic>},
      &lane_spectra<Lanes, false>,
      &lane_spectra<Lanes, true>};
  return kernels;
}

}  // namespace stationary
