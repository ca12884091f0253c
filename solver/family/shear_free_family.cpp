#include "solver/family/shear_free_family.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

#include "lib/body/inertia.hpp"
#include "lib/matrix/elementwise.hpp"
#include "solver/newton/newton.hpp"
#include "solver/newton/refine.hpp"

namespace stationary {

OrientedSetting OrientedSettings::at(double p) const {
  using Kind = FamilyParameter::Kind;
  OrientedSetting out{body_, models_, nu_};
  const int k = parameter_.index;
  switch (parameter_.kind) {
    case Kind::nu:
      out.nu = p;
      break;
    case Kind::inertia:
      inertia_of(out.body, k) = p;
      break;
    default:
      break;
  }
  if (const int place = coefficient_place(); place >= 0) {
    if (!varied_ || varied_at_ != p)
      varied_ =
          std::make_shared<const OrientedModels>(models_->potential.with_coefficient(place, p));
    varied_at_ = p;
    out.models = varied_;
  }
  return out;
}

Turn turn_at(const OrientedSetting& at, Branch branch, double V_aa, const Stretch& q) {
  const double stiffness = shear_stiffness(V_aa, at.models->plain.body.volume.has_value(), branch,
                                           at.body.J3, at.nu * at.nu, q);
  return turn_of(at.body, branch, stiffness, q, at.nu);
}

std::optional<ExtendedEvent<3>> ShearFreeFamily::located(const ReducedVector<3>& x,
                                                         double p) const {
  const auto equations =
      oriented_event_equations<StraightLayout>(settings_->varied(), branch_, TestValues::turn);
  const auto root = equations->root({DoubleDouble(x[0]), DoubleDouble(x[1]), DoubleDouble(x[2]),
                                     DoubleDouble(p), DoubleDouble(1.0)});
  if (!root) return std::nullopt;
  constexpr auto parameter = ExtendedEventEquations<event_dimension<3>>::parameter;
  return ExtendedEvent<3>{{root->y[0], root->y[1], root->y[2]},
                          root->y[parameter],
                          equations->stretch_error(root->error),
                          root->error[parameter]};
}

std::optional<ShearFreeFamily::TurningPoint> ShearFreeFamily::turning_point(
    const ReducedVector<3>& near, double p) const {
  const auto turn = [&](double at) {
    const auto found = point(near, at);
    return found ? found->turn : std::numeric_limits<double>::quiet_NaN();
  };
  // Of a number in any unit; of one that is 0 in that of numbers of order one.
  double reach = 1e-6 * (p != 0.0 ? std::abs(p) : 1.0);
  for (; reach < 0.1 * (1.0 + std::abs(p)); reach *= 4.0) {
    const double a = turn(p - reach);
    const double b = turn(p + reach);
    if (std::isnan(a) || std::isnan(b)) return std::nullopt;
    if ((a < 0.0) == (b < 0.0)) continue;
    std::uintmax_t evaluations = 80;
    const auto [low, high] = boost::math::tools::toms748_solve(
        turn, p - reach, p + reach, a, b, boost::math::tools::eps_tolerance<double>(52),
        evaluations);
    const double middle = 0.5 * (low + high);
    const auto found = point(near, middle);
    const auto ahead = point(near, p + reach);
    const auto behind = point(near, p - reach);
    if (!found || !ahead || !behind) return std::nullopt;
    if (const auto known = located(found->x, middle)) {
      TurningPoint out{ReducedVector<3>::Zero(), ReducedVector<3>::Zero(), double(known->parameter),
                       known->error_bound + 0x1p-53};
      for (int i = 0; i < 3; ++i) {
        const DoubleDouble& x = known->x[static_cast<std::size_t>(i)];
        out.x[i] = double(x);
        out.tail[i] = double(x - out.x[i]);
      }
      return out;
    }
    // What the turn's own rounding leaves open of p, along the family.
    constexpr double noise = 64.0 * 0x1p-53;
    const double moved_by = logarithms(ahead->x.array() / behind->x.array()).abs().maxCoeff();
    const double along = noise * moved_by / std::abs(b - a);
    return TurningPoint{found->x, ReducedVector<3>::Zero(), middle,
                        2.0 * found->error_bound + along};
  }
  return std::nullopt;
}

std::optional<ShearFreeFamily::Point> ShearFreeFamily::point(const ReducedVector<3>& near,
                                                             double p) const {
  const OrientedSetting at = settings_->at(p);
  const OrientedSystem<StraightLayout> system{at.models.get(), at.body, branch_, at.nu};
  ReducedVector<3> x = near;
  if (!newton(system, x).converged) return std::nullopt;
  const Refined refined = refine(system, x);
  if (!refined.converged) return std::nullopt;
  const Stretch q{0.0, x[0], x[1], x[2]};
  const double V_aa = potential_derivatives<2>(at.models->plain, q).hessian(0, 0);
  return Point{x, turn_at(at, branch_, V_aa, q).value, refined.error_bound};
}

}  // namespace stationary
