#include "lib/balanced/pair_kernels.hpp"

#include "lib/balanced/pair_kernel_list.hpp"

namespace stationary {

/// pair_kernels_fused.cpp.
const PairKernels& compiled_for_fused();

const PairKernels& portable_pair_kernels() { return kernels_in_pairs<DoubleDouble>; }

const PairKernels* fused_pair_kernels() {
#ifdef STATIONARY_FUSED_KERNELS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return &compiled_for_fused();
#endif
  return nullptr;
}

const PairKernels& pair_kernels() {
  static const PairKernels& best = []() -> const PairKernels& {
    const PairKernels* fused = fused_pair_kernels();
    return fused != nullptr ? *fused : portable_pair_kernels();
  }();
  return best;
}

}  // namespace stationary
