// Steady rotations about a material axis: the paper's branches
//   (i) nu = (nu1, 0, 0),   (ii) nu = (0, nu2, 0),   (iii) nu = (0, 0, nu3).
#pragma once

#include <optional>
#include <string_view>

#include "lib/stretch.hpp"

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

}  // namespace stationary
