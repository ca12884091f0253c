// The spectra for processors with AVX-512 F and DQ; compiled with those flags.
#include "solver/batch_spectrum/spectrum_kernel.hpp"

namespace stationary {

const SpectrumKernels& SpectrumKernels::avx512() { return spectrum_kernels<Pack<64>>(); }

}  // namespace stationary
