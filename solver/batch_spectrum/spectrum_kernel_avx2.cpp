// The spectra for processors with AVX2 and FMA; compiled with those flags.
#include "solver/batch_spectrum/spectrum_kernel.hpp"

namespace stationary {

const SpectrumKernels& SpectrumKernels::avx2() { return spectrum_kernels<Pack<32>>(); }

}  // namespace stationary
