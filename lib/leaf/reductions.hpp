// A leaf's second variation (symplectic_leaf.hpp) in pairs of doubles and its reductions
// (reduced_leaf.hpp), compiled once for any processor and once for those with fused multiply-adds.
// Both give the same bits.
#pragma once

#include <cstddef>
#include <tuple>

#include "lib/leaf/reduced_leaf.hpp"
#include "lib/leaf/symplectic_leaf.hpp"

namespace stationary {

/// E'' of a motion, its entries renormalized, P of reduced_leaf.hpp. Returns the axis that its frame
/// is across (leaf_frame).
template <class P>
std::size_t second_variation_in_pairs(const Body& body, const BasicStretch<DoubleDouble>& q,
                                      const Vector3<DoubleDouble>& nu, const LeafShape& shape,
                                      const Matrix4<DoubleDouble>& V_qq,
                                      LeafForm<DoubleDouble>& out) {
  const auto pair = [](const DoubleDouble& x) { return P(x.hi, x.lo); };
  Matrix4<P> V;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) V(i, j) = pair(V_qq(i, j));
  const Vector3<P> spin{pair(nu[0]), pair(nu[1]), pair(nu[2])};
  std::size_t aside = 0;
  const LeafForm<P> form =
      second_variation(body, BasicStretch<P>{pair(q.alpha), pair(q.xi), pair(q.zeta), pair(q.rho)},
                       spin, shape, V, [&](const std::array<P, 3>& pi) {
                         aside = least_component(pi);
                         return leaf_spin(leaf_frame(pi, aside), spin, pi);
                       });
  const std::size_t n = 2 * shape.pairs();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const P entry = renormalized(form[i][j]);
      out[i][j] = {double(entry.hi), double(entry.lo)};
    }
  }
  return aside;
}

struct LeafReductions {
  decltype(&second_variation_in_pairs<DoubleDouble>) second_variation;
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
  return {&second_variation_in_pairs<P>,
          {leaf_reductions_of<P, 2>(), leaf_reductions_of<P, 3>(), leaf_reductions_of<P, 4>(),
           leaf_reductions_of<P, 5>()}};
}

const LeafReductions& portable_leaf_reductions();
/// Null where the processor has no such instruction, or its kind has no code for it here.
const LeafReductions* fused_leaf_reductions();

/// The faster of those there are.
const LeafReductions& leaf_reductions();

}  // namespace stationary
