// The kinds of stationary motion, each with the numbers that prescribe one:
//
//   about a material axis   nu = (nu1, 0, 0), (0, nu2, 0) or (0, 0, nu3): the paper's branches (i),
//                           (ii), (iii)
//   tilted                  nu = (nu1, 0, nu3) or (0, nu2, nu3), by its length; about an axis in no
//                           material plane too (sheared_balance.hpp)
//   oblique                 nu = (nu1, nu2, 0), by its length
//   two-polar               R diag(lambda, mu, rho) U^-1, R and U turning steadily about axis 3
//                           (J1 = J2; two_polar.hpp), by the two rates or by the two momenta
#pragma once

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/body/stretch.hpp"

namespace stationary {

enum class Branch { i, ii, iii };

constexpr std::string_view name(Branch branch) {
  return branch == Branch::i ? "i" : branch == Branch::ii ? "ii" : "iii";
}

constexpr std::optional<Branch> branch_from_name(std::string_view text) {
  for (const Branch branch : {Branch::i, Branch::ii, Branch::iii})
    if (text == name(branch)) return branch;
  return std::nullopt;
}

/// Index 0, 1, 2 of the axis the branch spins about.
constexpr int axis(Branch branch) { return static_cast<int>(branch); }

/// nu as a vector; nu_along in reciprocal time, either sign.
template <class S>
Vector3<S> angular_velocity(Branch branch, const S& nu_along) {
  Vector3<S> nu = Vector3<S>::Constant(S(0.0));
  nu[axis(branch)] = nu_along;
  return nu;
}

constexpr std::string_view tilted_name = "tilted";
constexpr std::string_view oblique_name = "oblique";
constexpr std::string_view two_polar_name = "two-polar";

/// The planes a tilted axis can lie in.
enum class TiltPlane { one_three, two_three };
/// Their names, and last of a tilted axis in none of them (SpatialRotation).
constexpr std::string_view tilt_plane_names[] = {"13", "23", "123"};
constexpr std::string_view spatial_plane_name = tilt_plane_names[2];
constexpr std::string_view name(TiltPlane plane) {
  return tilt_plane_names[static_cast<int>(plane)];
}

/// The branch about the plane's other axis than 3.
constexpr Branch in_plane_branch(TiltPlane plane) {
  return plane == TiltPlane::one_three ? Branch::i : Branch::ii;
}

/// nu in the plane, from its components along that branch's axis and along axis 3.
template <class S>
Vector3<S> angular_velocity(TiltPlane plane, const S& in_plane, const S& normal) {
  Vector3<S> nu = angular_velocity(in_plane_branch(plane), in_plane);
  nu[axis(Branch::iii)] = normal;
  return nu;
}

struct AxisRotation {
  Branch branch;
  double nu;  ///< along that axis; radians per unit of time, here and below
};

struct TiltedRotation {
  TiltPlane plane;
  double nu;  ///< |nu| > 0
};
/// In a plane, or in whichever has one.
struct TiltedMotion {
  std::optional<TiltPlane> plane;
  double nu;  ///< |nu| > 0

  std::vector<TiltedRotation> rotations() const {
    if (plane) return {{*plane, nu}};
    return {{TiltPlane::one_three, nu}, {TiltPlane::two_three, nu}};
  }
};

/// Tilted out of both planes: nu1 nu2 nu3 != 0.
struct SpatialRotation {
  double nu;  ///< |nu| > 0
};

struct ObliqueRotation {
  double nu;  ///< |nu| > 0
  /// The branch, (i) or (ii), whose axis the family's is at rest, or which it leaves at an event.
  std::optional<Branch> near = std::nullopt;
};

/// About axis 3: of S = U diag(lambda, mu, rho) U^T U turns at theta_dot, and R = L U at omega.
template <class S>
struct TwoPolarRates {
  S omega;      ///< of the figure in space
  S theta_dot;  ///< of the figure in the material; either may be 0 or negative
};
/// Conjugate to these angles, in units of J nu.
template <class S>
struct TwoPolarMomenta {
  S s3;       ///< the angular momentum
  S p_theta;  ///< of the circulation
};
using TwoPolarMotion = std::variant<TwoPolarRates<double>, TwoPolarMomenta<double>>;

/// What a stationary ellipsoid is asked for by.
using Motion =
    std::variant<AxisRotation, TiltedMotion, TwoPolarMotion, ObliqueRotation, SpatialRotation>;

/// As the column `branch` has it.
constexpr std::string_view name(const Motion& motion) {
  if (const auto* rotation = std::get_if<AxisRotation>(&motion)) return name(rotation->branch);
  if (std::holds_alternative<TiltedMotion>(motion) ||
      std::holds_alternative<SpatialRotation>(motion))
    return tilted_name;
  return std::holds_alternative<ObliqueRotation>(motion) ? oblique_name : two_polar_name;
}

}  // namespace stationary
