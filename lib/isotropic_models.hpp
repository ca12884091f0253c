// The built-in isotropic models, by what they are a potential of, with coefficients in any number
// type C.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "lib/potentials/biot.hpp"
#include "lib/potentials/biot_log.hpp"
#include "lib/potentials/hencky.hpp"
#include "lib/potentials/neo_hookean.hpp"
#include "lib/potentials/neo_hookean_3d.hpp"
#include "lib/potentials/reciprocal_determinant.hpp"
#include "lib/potentials/saint_venant_kirchhoff.hpp"
#include "lib/potentials/thickness.hpp"

namespace stationary {

template <class C>
using PlanarModels = std::variant<ReciprocalDeterminant<C>, SaintVenantKirchhoff<C>, Biot<C>,
                                  BiotLog<C>, NeoHookean<C>, Hencky<C>>;
template <class C>
using ThicknessModels = std::variant<ReciprocalQuadratic<C>, Harmonic<C>>;
template <class C>
using CoupledModels = std::variant<NeoHookean3d<C>>;

using PlanarPotential = PlanarModels<double>;
using ThicknessPotential = ThicknessModels<double>;
using CoupledPotential = CoupledModels<double>;

/// convert(c) of each coefficient c, in their order.
template <template <class> class Model, class Convert>
auto with_coefficients(const Model<double>& model, const Convert& convert) {
  const auto c = model.coefficients();
  using C = std::remove_cvref_t<decltype(convert(c[0]))>;
  return [&]<std::size_t... k>(std::index_sequence<k...>) {
    return Model<C>{convert(c[k])...};
  }(std::make_index_sequence<std::tuple_size_v<std::remove_const_t<decltype(c)>>>{});
}

}  // namespace stationary
