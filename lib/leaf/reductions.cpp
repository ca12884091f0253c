#include "lib/leaf/reductions.hpp"

namespace stationary {

/// reductions_fused.cpp.
const LeafReductions& leaf_reductions_compiled_for_fused();

const LeafReductions& portable_leaf_reductions() {
  static constexpr LeafReductions out = leaf_reductions_in<DoubleDouble>();
  return out;
}

const LeafReductions* fused_leaf_reductions() {
#ifdef STATIONARY_FUSED_KERNELS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return &leaf_reductions_compiled_for_fused();
#endif
  return nullptr;
}

const LeafReductions& leaf_reductions() {
  static const LeafReductions& best = []() -> const LeafReductions& {
    const LeafReductions* fused = fused_leaf_reductions();
    return fused != nullptr ? *fused : portable_leaf_reductions();
  }();
  return best;
}

}  // namespace stationary
