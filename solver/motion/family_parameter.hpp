// What varies along a family of stationary ellipsoids, and what is computed at its members.
#pragma once

#include <memory>
#include <span>
#include <variant>

#include "solver/motion/family.hpp"

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

/// A number of the motion's own that varies, and all its values: what is found at one depends on
/// these, and not on which of them are asked for.
struct NumberRange {
  std::span<const double> values;  ///< ascending
  int number = 0;                  ///< of the motion's own; its first is 0

  double least() const { return values.front(); }
  double most() const { return values.back(); }
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

}  // namespace stationary
