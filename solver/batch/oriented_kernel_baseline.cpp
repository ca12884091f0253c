// The corrections for any processor.
#include "solver/batch/oriented_kernel.hpp"

namespace stationary {

const OrientedKernels& OrientedKernels::baseline() { return oriented_kernels<Pack<16>>(); }

}  // namespace stationary
