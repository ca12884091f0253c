// Which of the kernels that are compiled once for each instruction set. For files of this library
// alone: STATIONARY_X86 is told to no other.
#pragma once

#include "solver/batch/march.hpp"

namespace stationary {

/// Kernels: with baseline(), avx2(), avx512().
template <class Kernels>
const Kernels& kernels_for(InstructionSet set) {
#ifdef STATIONARY_X86
  if (set == InstructionSet::avx512) return Kernels::avx512();
  if (set == InstructionSet::avx2) return Kernels::avx2();
#endif
  (void)set;
  return Kernels::baseline();
}

}  // namespace stationary
