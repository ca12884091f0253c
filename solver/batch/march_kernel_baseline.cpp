// The marches for the processors everything is compiled for.
#include "solver/batch/march_kernel.hpp"

namespace stationary {

const MarchKernels& MarchKernels::baseline() { return march_kernels<Pack<16>>(); }

}  // namespace stationary
