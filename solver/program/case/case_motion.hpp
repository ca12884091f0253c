// A motion (lib/body/motion.hpp) as case files, messages and metadata name it: its words and its
// numbers by their keys.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/body/motion.hpp"
#include "lib/material/potential.hpp"

namespace stationary {

/// "branch (i), nu = (0.5, 0, 0)", "two-polar, omega = 1.2, theta_dot = -0.35".
std::string motion_text(const Motion& motion);

/// Of [motion]: branch and the keys that the motion has, with their values.
using MotionItem = std::pair<std::string_view, std::variant<std::string_view, double>>;
std::vector<MotionItem> motion_items(const Motion& motion);

/// The numbers of the motion by their parameter's keys: nu, or motion.omega ... of a two-polar one.
struct MotionNumber {
  std::string_view parameter;
  double* value;
  bool momentum = false;
};
std::vector<MotionNumber> motion_numbers(Motion& motion);

/// Whether its nu is a length, >= 0.
bool nu_is_length(const Motion& motion);
/// Whether it is a motion of bodies with J1 = J2 alone.
bool keeps_round(const Motion& motion);
/// Whether its family is followed in nu and in nothing else.
bool is_followed_in_nu_alone(const Motion& motion);
/// Whether its rows have rates and momenta of their own, and lambda, mu for xi, zeta.
bool has_rates(const Motion& motion);
/// Likewise of a motion by its branch's name, as a case, a row or a column of rows has it.
bool has_rates(std::string_view branch);
/// The spin about a material axis that it is; nothing of another kind.
std::optional<AxisRotation> spin_of(const Motion& motion);
/// Whether alpha may be no zero.
bool may_have_alpha(const Motion& motion, const Potential& potential);
/// Whether maps solve it along lanes in nu, and not cell by cell.
bool has_lanes(const Motion& motion);

/// Whether nu may be its angular velocity: that it lies in the plane prescribed.
bool may_have_axis(const Motion& motion, const Vector3<double>& nu);

/// The plane or axis left open, decided by a motion of it: the component of nu that is not zero.
Motion decided(Motion motion, bool about_axis_2);

}  // namespace stationary
