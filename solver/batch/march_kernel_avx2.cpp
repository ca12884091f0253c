// The marches for processors with AVX2 and FMA; compiled with those flags.
#include "solver/batch/march_kernel.hpp"

namespace stationary {

const MarchKernels& MarchKernels::avx2() { return march_kernels<Pack<32>>(); }

}  // namespace stationary
