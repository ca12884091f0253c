#include <cmath>

#include "solver/family/tilted_events.hpp"
#include "solver/normal_form/isotropic_gradient.hpp"
#include "solver/normal_form/oriented_normal_form.hpp"

namespace stationary {
namespace {

/// Of the sheets that keep the circle. A held volume is kept by it too where rho is one of the two:
/// off it what is left of V (held_volume.hpp) is not symmetric in rho and another stretch.
std::vector<IntervalVector> symmetric_basis(Circle circle, bool volume_held) {
  if (circle == Circle::none) return along_coordinates({0, 1, 2}, 3);
  const CirclePlaces at = places(circle);
  const auto a = static_cast<std::size_t>(at.first);
  const auto b = static_cast<std::size_t>(at.second);
  const auto other = static_cast<std::size_t>(at.other);
  IntervalVector along(3);
  IntervalVector third(3);
  if (volume_held && circle != Circle::xi_zeta) {
    along[a] = along[b] = -sqrt(Interval(1.0) / 6.0);
    along[other] = sqrt(Interval(2.0) / 3.0);
    return {along};
  }
  along[a] = along[b] = sqrt(Interval(0.5));
  third[other] = 1.0;
  return {along, third};
}

/// What is left of a spin's tilt.
std::size_t tilts_to(Branch branch, const Member& member) {
  if (branch != Branch::iii) return 2;
  const Vector3<double> m = second_moments(member.body, member.q);
  return std::abs(m[1] - m[2]) < std::abs(m[0] - m[2]) ? 1 : 0;
}

/// The end of a tilted family on a spin about this axis.
Branch end_of(TiltPlane plane, const Member& member) {
  return std::abs(member.tilt_in_plane) < std::abs(member.tilt_normal) ? Branch::iii
                                                                       : in_plane_branch(plane);
}

/// normal_form() of an isotropic potential.
std::optional<NormalForm> isotropic_normal_form(const Problem& problem,
                                                const FamilyParameter& parameter, Circle circle,
                                                EventType type, const Member& member) {
  const bool held = problem.potential().holds_volume();
  const auto near = [&](NearAxis axis, Circle on, Varied varied = Varied::parameter) {
    return IsotropicGradient(problem.body(), problem.potential(), parameter, axis, on, member,
                             varied);
  };
  const NearAxis axis = NearAxis::along(problem.branch());
  switch (type) {
    case EventType::fold_nu:
    case EventType::fold_parameter:
    case EventType::fold_momentum: {
      const Varied varied = type == EventType::fold_momentum ? Varied::momentum : Varied::parameter;
      // One direction alone is singular by itself; all three are so too.
      const Circle kept = held && circle != Circle::xi_zeta ? Circle::none : circle;
      return fold_form(near(axis, circle, varied), symmetric_basis(kept, held));
    }
    case EventType::ellipse:
    case EventType::ellipse_23:
    case EventType::ellipse_13: {
      const Circle broken = broken_circle(type);
      // A circle with rho follows a volume that is varied: not worked out.
      const bool volume_varies = held && varies(parameter, FamilyParameter::Kind::plane,
                                                static_cast<int>(BodyModel<>::volume_place));
      if (volume_varies && broken != Circle::xi_zeta) return std::nullopt;
      const CirclePlaces at = places(broken);
      IntervalVector v(3);
      v[static_cast<std::size_t>(at.first)] = 1.0;
      v[static_cast<std::size_t>(at.second)] = -1.0;
      return breaking_form(near(axis, broken), v, symmetric_basis(broken, held));
    }
    case EventType::tilt: {
      const NearAxis tilts{axis.own, tilts_to(problem.branch(), member)};
      const IsotropicGradient gradient = near(tilts, circle);
      return turning_form(
          gradient, [&](const IntervalVector& d, double c) { return gradient.turning(d, c); },
          symmetric_basis(Circle::none, held));
    }
    default:
      return std::nullopt;
  }
}

/// Where motions with alpha != 0 leave those of an isotropic body with gravity, followed in nu.
std::optional<NormalForm> heavy_normal_form(const Problem& problem,
                                            const FamilyParameter& parameter, EventType type,
                                            const Member& member) {
  const BodyModel<>* const body = problem.potential().body_model();
  const bool heavy = body != nullptr && body->gravitates && !body->elastic.is_fluid();
  if (!heavy || problem.body().symmetric() || parameter.kind != FamilyParameter::Kind::nu)
    return std::nullopt;
  const Potential oriented(AnisotropicPotential::of_heavy(
      body->elastic, {true, body->g, body->J, body->volume, body->stiffness}));
  return oriented_normal_form(Problem(problem.body(), oriented, problem.branch()), parameter, type,
                              member);
}

}  // namespace

std::optional<NormalForm> normal_form(const Problem& problem, const FamilyParameter& parameter,
                                      Circle circle, EventType type, const Member& member) {
  if (!is_known(member)) return std::nullopt;
  if (!problem.potential().is_isotropic())
    return oriented_normal_form(problem, parameter, type, member);
  if (type == EventType::shear || type == EventType::oblique)
    return heavy_normal_form(problem, parameter, type, member);
  return isotropic_normal_form(problem, parameter, circle, type, member);
}

std::optional<NormalForm> tilted_normal_form(const Body& body, const Potential& potential,
                                             TiltPlane plane, EventType type,
                                             const Member& member) {
  if (!is_known(member)) return std::nullopt;
  const FamilyParameter in_nu;
  switch (type) {
    case EventType::fold_nu:
    case EventType::fold_momentum: {
      const Varied varied = type == EventType::fold_momentum ? Varied::momentum : Varied::parameter;
      const IsotropicGradient gradient(body, potential, in_nu,
                                       NearAxis::tilted(body, potential, plane, member),
                                       Circle::none, member, varied);
      return fold_form(gradient, along_coordinates({0, 1, 2, 3}, 4));
    }
    case EventType::tilt:  // where it leaves the spin about a material axis
      return isotropic_normal_form(Problem(body, potential, end_of(plane, member)), in_nu,
                                   Circle::none, type, member);
    default:
      return std::nullopt;
  }
}

}  // namespace stationary
