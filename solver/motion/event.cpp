#include "solver/motion/event.hpp"

#include <cmath>
#include <limits>

#include "lib/body/inertia.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The Lambdas of one block: the real ones ascending; the complex ones, two modes a quadruple, one
/// after the other.
struct BlockModes {
  std::array<const Mode*, 5> real;
  std::size_t count = 0;
  std::size_t negative = 0;  ///< of the real ones, for certain
  std::size_t zeros = 0;     ///< of the real ones, those that may be 0
  std::array<const Mode*, 4> complex;
  std::size_t complex_count = 0;
};

std::array<BlockModes, 4> by_block(const Spectrum& spectrum) {
  std::array<BlockModes, 4> out;
  for (int k = 0; k < spectrum.modes; ++k) {
    const Mode& mode = spectrum.mode[static_cast<std::size_t>(k)];
    if (mode.forced_zero) continue;
    BlockModes& block = out[static_cast<std::size_t>(mode.block)];
    if (mode.lambda_im > 0.0) {
      block.complex[block.complex_count++] = &mode;
      continue;
    }
    block.negative += mode.lambda_re < -mode.lambda_error;
    block.zeros += std::abs(mode.lambda_re) <= mode.lambda_error;
    std::size_t place = block.count++;
    for (; place > 0 && mode.lambda_re < block.real[place - 1]->lambda_re; --place)
      block.real[place] = block.real[place - 1];
    block.real[place] = &mode;
  }
  return out;
}

/// Leaves the sign of function k open unless the value it has the sign of is beyond its error.
void require_beyond(double value, double error, std::size_t k, TestValues& out) {
  if (!(std::abs(value) > error)) out.uncertain |= 1U << static_cast<unsigned>(k);
}

/// The signatures of a block's negative Lambdas, where all are certain.
void set_signatures(const BlockModes& block, std::size_t name, TestValues& out) {
  unsigned positive = 0;
  for (std::size_t k = 0; k < block.negative; ++k) {
    const int krein = block.real[k]->krein;
    if (krein == 0) return;
    positive |= (krein > 0 ? 1U : 0U) << static_cast<unsigned>(k);
  }
  out.signatures[name] = static_cast<std::uint8_t>(positive);
  out.signed_blocks |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(name));
}

/// Of the blocks whose Lambdas may meet: each meeting makes a complex pair of two real Lambdas or the
/// reverse, and so changes the sign, however many such pairs there are.
void set_collision(const std::array<BlockModes, 4>& blocks, const TestContext& context,
                   TestValues& out) {
  double least = std::numeric_limits<double>::infinity();
  double sign = 1.0;
  std::size_t gap = 0;
  // Of mean +- half, or mean +- half i; relative: the square of half to that of both.
  const auto meet = [&](double mean, double half, double relative, double error) {
    require_beyond(half, error, TestValues::collision, out);
    if (!(relative < least)) return;
    least = relative;
    out.collides_imaginary = mean < 0.0;
  };
  for (const Block name : {Block::even, Block::odd, Block::shear}) {
    if (!context.kind.may_collide(name, context)) continue;
    const BlockModes& block = blocks[static_cast<std::size_t>(name)];
    set_signatures(block, static_cast<std::size_t>(name), out);
    for (std::size_t k = 1; k < block.count; ++k) {
      const Mode& a = *block.real[k - 1];
      const Mode& b = *block.real[k];
      const double half = 0.5 * (b.lambda_re - a.lambda_re);
      const double mean = 0.5 * (b.lambda_re + a.lambda_re);
      const double relative = half * half / (mean * mean + half * half);
      meet(mean, half, relative, a.lambda_error + b.lambda_error);
      out.gaps[gap++] = relative;
    }
    for (std::size_t k = 0; k < block.complex_count; k += 2) {
      const Mode& mode = *block.complex[k];
      const double relative = mode.lambda_im / hypotenuse(mode.lambda_re, mode.lambda_im);
      meet(mode.lambda_re, mode.lambda_im, relative * relative, 2.0 * mode.lambda_error);
      out.gaps[gap++] = -relative * relative;
      sign = -sign;
    }
  }
  if (std::isfinite(least)) out.value[TestValues::collision] = sign * least;
}

void set_crossings(const std::array<BlockModes, 4>& blocks, TestValues& out) {
  std::size_t k = TestValues::crossings;
  for (std::size_t a = 0; a < blocks.size(); ++a) {
    out.composition[a] = {static_cast<std::uint8_t>(blocks[a].count),
                          static_cast<std::uint8_t>(blocks[a].negative)};
    out.zeros[a] = static_cast<std::uint8_t>(blocks[a].zeros);
    for (std::size_t b = a + 1; b < blocks.size(); ++b) {
      for (std::size_t i = 0; i < blocks[a].count; ++i) {
        for (std::size_t j = 0; j < blocks[b].count && k < TestValues::count; ++j, ++k) {
          const Mode& first = *blocks[a].real[i];
          const Mode& second = *blocks[b].real[j];
          if (!(first.lambda_re < 0.0 && second.lambda_re < 0.0)) continue;
          out.value[k] =
              (first.lambda_re - second.lambda_re) / -(first.lambda_re + second.lambda_re);
          require_beyond(first.lambda_re - second.lambda_re,
                         first.lambda_error + second.lambda_error, k, out);
          if (first.krein * second.krein < 0)
            out.opposite |= 1U << static_cast<unsigned>(k - TestValues::crossings);
        }
      }
    }
  }
}

/// Those of a spin about a material axis.
void set_axis_tests(const Member& member, const TestContext& context, TestValues& out) {
  const Body& J = member.body;
  const Vector3<double> m = second_moments(J, member.q);
  // On a circle two axes are alike: of equal inertias, and equal to the third at once.
  if (context.circle != Circle::xi_rho)
    out.value[TestValues::inertia_13] = relative_difference(m[2], m[0]);
  if (context.circle == Circle::none)
    out.value[TestValues::inertia_12] = relative_difference(m[1], m[0]);
  if (context.circle == Circle::none || context.circle == Circle::xi_rho)
    out.value[TestValues::inertia_23] = relative_difference(m[2], m[1]);
  if (context.circle != Circle::none && context.circle != Circle::xi_zeta)
    out.value[TestValues::ellipse] = member.round_stiffness;
  if (!std::isnan(member.turn)) {
    out.value[TestValues::turn] = member.turn;
  } else if (context.branch == Branch::iii) {
    const double pull = (J.J1 + J.J2) * member.nu * member.nu;  // of alpha
    const double shear = member.shear_stiffness / (std::abs(member.shear_stiffness) + 2.0 * pull);
    if (context.circle == Circle::xi_zeta) {
      out.value[TestValues::ellipse] = shear;
    } else if (!context.material_symmetry) {
      out.value[TestValues::turn] = shear;
    }
  } else if (!context.material_symmetry) {
    // K_aa (I1 - I2) - h^2 omega^2 of an isotropic V, but for factors that keep their sign.
    out.value[TestValues::turn] = relative_difference(J.J1, J.J2);
  }
}

bool axis_may_collide(Block block, const TestContext& context) {
  if (block == Block::shear) return true;
  return block == (context.branch == Branch::iii ? Block::even : Block::odd) &&
         !(context.circle == Circle::xi_zeta && block == Block::even);
}

}  // namespace

KindEvents axis_events() {
  return {.set = set_axis_tests,
          .may_collide = axis_may_collide,
          .turn = EventType::none,  // by its branch
          .mirror = EventType::none,
          .mirror_reason = {},
          .end = EventType::none,
          .end_reason = nullptr,
          .circle_on_own_leaf = false};
}

EventSet TestContext::sought_for(EventSet asked) {
  if (asked.has(EventType::krein_pass) || asked.has(EventType::unexplained)) return {};
  return asked.add(EventType::fold_nu).add(EventType::fold_parameter).add(EventType::tilt);
}

bool TestContext::seeks(std::size_t function) const {
  if (function == TestValues::collision) {
    return sought.has(EventType::hamiltonian_hopf) || sought.has(EventType::real_collision);
  }
  if (function >= TestValues::crossings) return sought.has(EventType::krein_pass);
  return sought.has(event_type(function, *this, {}));
}

TestValues test_values(const Member& member, const TestContext& context, double fold,
                       double momentum, double error) {
  TestValues out;
  out.value.fill(none);
  out.gaps.fill(none);
  out.value[TestValues::fold] = fold;
  out.value[TestValues::momentum] = momentum;
  out.value[TestValues::tilt_in_plane] = member.tilt_in_plane;
  out.value[TestValues::tilt_normal] = member.tilt_normal;
  context.kind.set(member, context, out);
  // The locked inertias are as uncertain as the squares of the stretches.
  for (const std::size_t k :
       {TestValues::inertia_12, TestValues::inertia_13, TestValues::inertia_23})
    require_beyond(out.value[k], 2.0 * error + 0x1p-51, k, out);
  // Where V has a symmetry that is not known it is zero all along, and its sign is rounding.
  if (context.kind.turn == EventType::none && !std::isnan(member.turn))
    require_beyond(member.turn, member.turn_condition * (error + 0x1p-50), TestValues::turn, out);
  if (member.spectrum &&
      (context.seeks(TestValues::collision) || context.seeks(TestValues::crossings))) {
    const auto blocks = by_block(*member.spectrum);
    set_collision(blocks, context, out);
    set_crossings(blocks, out);
  }
  return out;
}

EventType event_type(std::size_t k, const TestContext& context, const TestValues& at) {
  switch (k) {
    case TestValues::fold:
      return context.along_nu ? EventType::fold_nu : EventType::fold_parameter;
    case TestValues::momentum:
      return EventType::fold_momentum;
    case TestValues::inertia_12:
      return EventType::inertia_exchange;
    case TestValues::inertia_13:
      return context.branch == Branch::ii ? EventType::inertia_exchange : EventType::tilt;
    case TestValues::inertia_23:
      return context.branch == Branch::i ? EventType::inertia_exchange : EventType::tilt;
    case TestValues::tilt_in_plane:
    case TestValues::tilt_normal:
      return EventType::tilt;
    case TestValues::ellipse:
      return ellipse_event(context.circle);
    case TestValues::turn:
      if (context.kind.turn != EventType::none) return context.kind.turn;
      return context.branch == Branch::iii ? EventType::shear : EventType::oblique;
    case TestValues::zero_momentum:
      return EventType::zero_momentum;
    case TestValues::collision:
      return at.collides_imaginary ? EventType::hamiltonian_hopf : EventType::real_collision;
    default:
      break;
  }
  const bool opposite = (at.opposite >> static_cast<unsigned>(k - TestValues::crossings)) & 1U;
  return opposite ? EventType::krein_pass : EventType::none;
}

std::optional<std::size_t> nearest_function(EventType type, const TestContext& context,
                                            const TestValues& at) {
  std::optional<std::size_t> out;
  for (std::size_t k = 0; k < TestValues::crossings; ++k) {
    if (k == TestValues::collision || std::isnan(at.value[k]) || event_type(k, context, at) != type)
      continue;
    if (!out || std::abs(at.value[k]) < std::abs(at.value[*out])) out = k;
  }
  return out;
}

int negative_change(EventType event, const TestContext& context) {
  switch (event) {
    case EventType::tilt:
      return context.circle == Circle::xi_zeta ? 2 : 1;  // both axes of its plane at once
    case EventType::fold_momentum:
    case EventType::oblique:
    case EventType::shear:
    case EventType::ellipse_23:
    case EventType::ellipse_13:
      return 1;
    case EventType::ellipse:
    case EventType::zero_momentum:  // the wobble's pair changes its signature
      return 2;
    default:
      return 0;
  }
}

}  // namespace stationary
