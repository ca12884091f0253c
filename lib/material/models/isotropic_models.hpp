// The built-in isotropic models, by what they are a potential of, with coefficients in any number
// type C.
#pragma once

#include <variant>

#include "lib/material/models/biot.hpp"
#include "lib/material/models/biot_log.hpp"
#include "lib/material/models/hencky.hpp"
#include "lib/material/models/neo_hookean.hpp"
#include "lib/material/models/neo_hookean_3d.hpp"
#include "lib/material/models/reciprocal_determinant.hpp"
#include "lib/material/models/saint_venant_kirchhoff.hpp"
#include "lib/material/models/thickness.hpp"

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

}  // namespace stationary
