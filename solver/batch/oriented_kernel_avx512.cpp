// The corrections for processors with AVX-512; compiled with those flags.
#include "solver/batch/oriented_kernel.hpp"

namespace stationary {

const OrientedKernels& OrientedKernels::avx512() { return oriented_kernels<Pack<64>>(); }

}  // namespace stationary
