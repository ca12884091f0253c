#include "solver/program/case/case_motion.hpp"

#include <fmt/format.h>

namespace stationary {
namespace {

template <class... F>
struct Cases : F... {
  using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

/// f(the motion as its own type), rates and momenta apart.
template <class AnyMotion, class... F>
auto by_kind(AnyMotion& motion, F... f) {
  const Cases cases{f...};
  return std::visit(
      [&]<class M>(M& own) {
        if constexpr (std::is_same_v<std::remove_const_t<M>, TwoPolarMotion>) {
          return std::visit(cases, own);
        } else {
          return cases(own);
        }
      },
      motion);
}

}  // namespace

std::string motion_text(const Motion& motion) {
  return by_kind(
      motion,
      [](const AxisRotation& at) {
        const Vector3<double> v = angular_velocity(at.branch, at.nu);
        return fmt::format("branch ({}), nu = ({}, {}, {})", name(at.branch), v[0] + 0.0, v[1] + 0.0, v[2] + 0.0);  // 0, not -0
      },
      [](const TiltedMotion& at) {
        const char* plane = !at.plane                           ? "1-3 or the 2-3"
                            : *at.plane == TiltPlane::one_three ? "1-3"
                                                                : "2-3";
        return fmt::format("tilted in the {} plane, |nu| = {}", plane, at.nu);
      },
      [](const SpatialRotation& at) {
        return fmt::format("tilted out of both planes, |nu| = {}", at.nu);
      },
      [](const ObliqueRotation& at) {
        const char* near = !at.near                ? ""
                           : *at.near == Branch::i ? ", the family of axis 1"
                                                   : ", the family of axis 2";
        return fmt::format("about an axis in the plane of axes 1 and 2, |nu| = {}{}", at.nu, near);
      },
      [](const TwoPolarRates<double>& at) {
        return fmt::format("two-polar, omega = {}, theta_dot = {}", at.omega, at.theta_dot);
      },
      [](const TwoPolarMomenta<double>& at) {
        return fmt::format("two-polar, s3 = {}, p_theta = {}", at.s3, at.p_theta);
      });
}

std::vector<MotionItem> motion_items(const Motion& motion) {
  std::vector<MotionItem> out{{"branch", name(motion)}};
  by_kind(
      motion, [&](const AxisRotation& at) { out.emplace_back("nu", at.nu); },
      [&](const TiltedMotion& at) {
        if (at.plane) out.emplace_back("plane", name(*at.plane));
        out.emplace_back("nu", at.nu);
      },
      [&](const SpatialRotation& at) {
        out.emplace_back("plane", spatial_plane_name);
        out.emplace_back("nu", at.nu);
      },
      [&](const ObliqueRotation& at) {
        if (at.near) out.emplace_back("axis", *at.near == Branch::i ? "1" : "2");
        out.emplace_back("nu", at.nu);
      },
      [&](const TwoPolarRates<double>& at) {
        out.emplace_back("omega", at.omega);
        out.emplace_back("theta_dot", at.theta_dot);
      },
      [&](const TwoPolarMomenta<double>& at) {
        out.emplace_back("s3", at.s3);
        out.emplace_back("p_theta", at.p_theta);
      });
  return out;
}

std::vector<MotionNumber> motion_numbers(Motion& motion) {
  using Numbers = std::vector<MotionNumber>;
  return by_kind(
      motion,
      [](TwoPolarRates<double>& at) {
        return Numbers{{"motion.omega", &at.omega}, {"motion.theta_dot", &at.theta_dot}};
      },
      [](TwoPolarMomenta<double>& at) {
        return Numbers{{"motion.s3", &at.s3, true}, {"motion.p_theta", &at.p_theta, true}};
      },
      [](auto& at) {
        return Numbers{{"nu", &at.nu}};
      });
}

bool nu_is_length(const Motion& motion) {
  return is_followed_in_nu_alone(motion) || std::holds_alternative<ObliqueRotation>(motion);
}
bool keeps_round(const Motion& motion) { return std::holds_alternative<TwoPolarMotion>(motion); }
bool is_followed_in_nu_alone(const Motion& motion) { return name(motion) == tilted_name; }
bool may_have_alpha(const Motion& motion, const Potential& potential) {
  if (!potential.is_isotropic() || std::holds_alternative<SpatialRotation>(motion) ||
      std::holds_alternative<ObliqueRotation>(motion))
    return true;
  const auto spin = spin_of(motion);
  return spin && spin->branch == Branch::iii && potential.may_shear();
}
bool has_rates(const Motion& motion) { return std::holds_alternative<TwoPolarMotion>(motion); }
bool has_rates(std::string_view branch) { return branch == two_polar_name; }
std::optional<AxisRotation> spin_of(const Motion& motion) {
  const auto* const spin = std::get_if<AxisRotation>(&motion);
  return spin == nullptr ? std::nullopt : std::optional(*spin);
}

bool has_lanes(const Motion& motion) { return std::holds_alternative<AxisRotation>(motion); }

bool may_have_axis(const Motion& motion, const Vector3<double>& nu) {
  const auto* const tilted = std::get_if<TiltedMotion>(&motion);
  if (tilted == nullptr || !tilted->plane) return true;
  return nu[*tilted->plane == TiltPlane::one_three ? 1 : 0] == 0.0;
}

Motion decided(Motion motion, bool about_axis_2) {
  if (auto* tilted = std::get_if<TiltedMotion>(&motion); tilted != nullptr && !tilted->plane)
    tilted->plane = about_axis_2 ? TiltPlane::two_three : TiltPlane::one_three;
  return motion;
}

}  // namespace stationary
