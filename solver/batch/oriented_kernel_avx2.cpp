// The corrections for processors with AVX2 and FMA; compiled with those flags.
#include "solver/batch/oriented_kernel.hpp"

namespace stationary {

const OrientedKernels& OrientedKernels::avx2() { return oriented_kernels<Pack<32>>(); }

}  // namespace stationary
