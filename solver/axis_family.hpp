// Families of steady rotations about a material axis, branches (i), (ii), (iii), in nu or in any
// other number of the problem:
//
//   N = 2  x = (xi, zeta)        separable V in (iii), rho untouched by the parameter and unique
//   N = 3  x = (xi, zeta, rho)   otherwise
//
// of an isotropic V; of another: anisotropic_family.hpp.
#pragma once

#include <memory>
#include <variant>

#include "solver/family.hpp"
#include "solver/problem.hpp"

namespace stationary {

/// The number that varies.
struct FamilyParameter {
  enum class Kind {
    nu,
    inertia,    ///< J_(index + 1)
    plane,      ///< coefficient `index` of the planar (or coupled) model
    thickness,  ///< of the thickness model
    shared,     ///< of both, where a formula was taken apart
    fibre,      ///< of the fibres: k and degrees of each
  };
  Kind kind = Kind::nu;
  int index = 0;
};

struct AxisFamilyOptions {
  double nu = 0.0;  ///< the spin, where it is not the parameter
  FamilyParameter parameter;
  bool spectrum = true;
  bool errors = true;  ///< residual and compatibility of each member
  bool energy = true;
};

using AnyFamily = std::variant<std::unique_ptr<Family<2>>, std::unique_ptr<Family<3>>,
                               std::unique_ptr<Family<4>>, std::unique_ptr<Family<5>>>;

/// alpha_free: of an even anisotropic V in (iii), the family with alpha != 0 and not that with
/// alpha = 0.
AnyFamily axis_family(const Problem& problem, const AxisFamilyOptions& options,
                      bool alpha_free = false);

}  // namespace stationary
