// The reductions of a leaf (reduced_leaf.hpp), compiled once for any processor and once for those with
// fused multiply-adds. Both give the same bits.
#pragma once

#include <cstddef>
#include <tuple>

#include "lib/leaf/reduced_leaf.hpp"

namespace stationary {

struct LeafReductions {
  /// Of n pairs of coordinates.
  template <std::size_t n>
  struct Of {
    decltype(&reduce_product<DoubleDouble, n>) product;
    decltype(&reduce_square<DoubleDouble, n>) square;
  };
  std::tuple<Of<2>, Of<3>, Of<4>, Of<5>> of;

  template <std::size_t n>
  const Of<n>& pairs() const {
    return std::get<Of<n>>(of);
  }
};

template <class P, std::size_t n>
constexpr LeafReductions::Of<n> leaf_reductions_of() {
  return {&reduce_product<P, n>, &reduce_square<P, n>};
}
template <class P>
constexpr LeafReductions leaf_reductions_in() {
  return {{leaf_reductions_of<P, 2>(), leaf_reductions_of<P, 3>(), leaf_reductions_of<P, 4>(),
           leaf_reductions_of<P, 5>()}};
}

const LeafReductions& portable_leaf_reductions();
/// Null where the processor has no such instruction, or its kind has no code for it here.
const LeafReductions* fused_leaf_reductions();

/// The faster of those there are.
const LeafReductions& leaf_reductions();

}  // namespace stationary
