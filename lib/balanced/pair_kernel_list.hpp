// PairKernels (pair_kernels.hpp) of one kind of pair.
#pragma once

#include "lib/balanced/pair_kernels.hpp"

namespace stationary {

template <class P, template <class> class Model>
[[gnu::flatten]] void plane_kernel(const std::array<double, 2>& c, const PairSpin& spin,
                                   PairCurvatures& out) {
  plane_pairs<P>(Model<double>{c[0], c[1]}, spin, out);
}
template <class P, template <class> class Model>
[[gnu::flatten]] void thickness_kernel(const std::array<double, 2>& c, const PairSpin& spin,
                                       PairCurvatures& out) {
  thickness_pairs<P>(Model<double>{c[0], c[1]}, spin, out);
}

template <class P, template <class> class... Plane, template <class> class... Thickness>
constexpr PairKernels pair_kernels_of(const std::variant<Plane<double>...>*,
                                      const std::variant<Thickness<double>...>*) {
  return {{&plane_kernel<P, Plane>...},
          {&thickness_kernel<P, Thickness>...},
          &in_plane_blocks<P>,
          &normal_blocks<P>};
}

template <class P>
inline constexpr PairKernels kernels_in_pairs = pair_kernels_of<P>(
    static_cast<const PlanarPotential*>(nullptr), static_cast<const ThicknessPotential*>(nullptr));

}  // namespace stationary
