#include "solver/family/two_polar_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lib/body/inertia.hpp"

namespace stationary {
namespace {

/// The product of the symmetric block's Lambdas, which are real, relative to the largest: zero where
/// the stiffness at fixed momenta is singular.
double stiffness_at_momenta(const Spectrum& spectrum) {
  double product = 1.0;
  double largest = 0.0;
  for (int k = 0; k < spectrum.modes; ++k) {
    const Mode& mode = spectrum.mode[static_cast<std::size_t>(k)];
    if (mode.block != Block::even || mode.forced_zero || mode.lambda_im > 0.0) continue;
    product *= mode.lambda_re;
    largest = std::max(largest, std::abs(mode.lambda_re));
  }
  return product / (largest * largest * largest);
}

/// a and b of the wobble Lambda = -a b (lib/stability/linearization.hpp); the stiffness at fixed
/// momenta by its Lambdas.
void set_tests(const Member& member, const TestContext& context, TestValues& out) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto& rates = member.two_polar->rates;
  const auto& momenta = member.two_polar->momenta;
  const Vector3<double> m = second_moments(member.body, member.q);
  out.value[TestValues::momentum] = none;
  if (context.circle != Circle::none) {
    const double pull = 2.0 * member.body.J1 * member.nu * member.nu;
    out.value[TestValues::ellipse] =
        member.shear_stiffness / (std::abs(member.shear_stiffness) + pull);
    // Ellipses branch off at these rates, and where the circle itself, as a motion of (iii), has
    // its own: only omega + theta' matters to it.
    const double own = member.body.J1 * member.nu * member.nu;
    out.value[TestValues::turn] = member.turn / (std::abs(member.turn) + 2.0 * own);
    // Both are differences of terms that may be far larger.
    const double error = member.turn_condition * (member.error_bound + 0x1p-50);
    for (const auto& [k, value] : {std::pair{TestValues::ellipse, member.shear_stiffness},
                                   std::pair{TestValues::turn, member.turn}})
      if (!(std::abs(value) > error)) out.uncertain |= 1U << static_cast<unsigned>(k);
    out.value[TestValues::inertia_13] = relative_difference(m[2], m[0]);
    return;
  }
  const auto axis_leaves = [&](double inertia) {
    const double turn = momenta.s3 / inertia;
    return (rates.omega - turn) / (std::abs(rates.omega) + std::abs(turn));
  };
  // Given itself and 0 it is 0 on all of the sheet.
  if (momenta.s3 != 0.0 || !member.two_polar->by_momenta) {
    const double product = 2.0 * member.body.J1 * member.q.xi * member.q.zeta;
    out.value[TestValues::zero_momentum] =
        momenta.s3 / ((m[0] + m[1]) * std::abs(rates.omega) + product * std::abs(rates.theta_dot));
  }
  out.value[TestValues::inertia_13] = axis_leaves(m[1] + m[2]);
  out.value[TestValues::inertia_23] = axis_leaves(m[0] + m[2]);
  if (member.two_polar->by_momenta) {  // what turns is a momentum
    out.value[TestValues::momentum] = out.value[TestValues::fold];
    out.value[TestValues::fold] = none;
  } else if (member.spectrum) {
    out.value[TestValues::momentum] = stiffness_at_momenta(*member.spectrum);
  }
}

}  // namespace

KindEvents two_polar_events() {
  KindEvents out = axis_events();
  out.set = set_tests;
  out.may_collide = [](Block block, const TestContext& context) {
    return context.circle != Circle::none && axis_events().may_collide(block, context);
  };
  out.turn = EventType::ellipse;
  out.circle_on_own_leaf = true;
  return out;
}

std::optional<TwoPolarVanishing> vanishing_at(EventType type, bool circle, const Member& near) {
  const auto& rates = near.two_polar->rates;
  const Vector3<double> m = second_moments(near.body, near.q);
  const auto gap = [](double a, double b) { return std::abs(a - b) / (std::abs(a) + std::abs(b)); };
  const double s3 = near.two_polar->momenta.s3;
  switch (type) {
    case EventType::fold_nu:
    case EventType::fold_parameter:
      return TwoPolarVanishing::fold;
    case EventType::fold_momentum:
      return near.two_polar->by_momenta ? TwoPolarVanishing::fold
                                        : TwoPolarVanishing::momentum_fold;
    case EventType::ellipse:
      if (!circle) return std::nullopt;
      return std::abs(near.shear_stiffness) < std::abs(near.turn) ? TwoPolarVanishing::ellipse
                                                                  : TwoPolarVanishing::shear;
    case EventType::tilt:
      if (circle) return TwoPolarVanishing::leaves_circle;
      return gap(rates.omega, s3 / (m[1] + m[2])) < gap(rates.omega, s3 / (m[0] + m[2]))
                 ? TwoPolarVanishing::leaves_mu
                 : TwoPolarVanishing::leaves_lambda;
    case EventType::zero_momentum:
      // A momentum that is varied is where it is.
      if (circle || near.two_polar->by_momenta) return std::nullopt;
      return TwoPolarVanishing::momentum;
    default:
      return std::nullopt;
  }
}

}  // namespace stationary
