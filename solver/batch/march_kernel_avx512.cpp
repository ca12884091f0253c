// The marches for processors with AVX-512 F and DQ; compiled with those flags.
#include "solver/batch/march_kernel.hpp"

namespace stationary {

const MarchKernels& MarchKernels::avx512() { return march_kernels<Pack<64>>(); }

}  // namespace stationary
