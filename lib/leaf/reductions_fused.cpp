// The reductions for processors with fused multiply-adds; compiled with those flags.
#include "lib/leaf/reductions.hpp"
#include "lib/number/fused.hpp"

namespace stationary {

const LeafReductions& leaf_reductions_compiled_for_fused() {
  static constexpr LeafReductions out = leaf_reductions_in<FusedPair>();
  return out;
}

}  // namespace stationary
