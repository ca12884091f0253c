// The spectra for the processors everything is compiled for.
#include "solver/batch_spectrum/spectrum_kernel.hpp"

namespace stationary {

const SpectrumKernels& SpectrumKernels::baseline() { return spectrum_kernels<Pack<16>>(); }

}  // namespace stationary
