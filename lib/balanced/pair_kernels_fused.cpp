// The kernels for processors with fused multiply-adds; compiled with those flags.
#include "lib/balanced/pair_kernel_list.hpp"
#include "lib/number/fused.hpp"

namespace stationary {

const PairKernels& compiled_for_fused() { return kernels_in_pairs<FusedPair>; }

}  // namespace stationary
