// Steady rotations about a material axis: the paper's branches
//   (i) nu = (nu1, 0, 0),   (ii) nu = (0, nu2, 0),   (iii) nu = (0, 0, nu3),
// and about an axis tilted in the plane of one of axes 1, 2 and of axis 3:
//   nu = (nu1, 0, nu3)  or  nu = (0, nu2, nu3)
//
// or in that of axes 1 and 2, nu = (nu1, nu2, 0): "oblique".
#pragma once

#include <optional>
#include <string_view>

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

/// The planes a tilted axis can lie in.
enum class TiltPlane { one_three, two_three };
constexpr std::string_view tilt_plane_names[] = {"13", "23"};
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

}  // namespace stationary
