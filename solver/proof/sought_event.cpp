#include "solver/proof/sought_event.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/body/inertia.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {
namespace {

double relative_gap(double a, double b) { return std::abs(a - b) / (std::abs(a) + std::abs(b)); }

/// The pair of modes that meets at the event: of one block and of one sign, or of two blocks,
/// imaginary and of opposite signature; whichever are nearest to each other.
std::optional<SoughtEvent> meeting_modes(const Spectrum& spectrum, EventType type) {
  const bool within = type != EventType::krein_pass;
  const bool imaginary = type != EventType::real_collision;
  std::optional<SoughtEvent> out;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](double gap, double lambda, Block first, Block second) {
    if (!(gap < least) || (lambda < 0.0) != imaginary) return;
    least = gap;
    const auto kind = within ? EventFunction::Kind::collision : EventFunction::Kind::crossing;
    out = SoughtEvent{{kind, 0, 0, first, second}, lambda};
  };
  for (int i = 0; i < spectrum.modes; ++i) {
    const Mode& a = spectrum.mode[static_cast<std::size_t>(i)];
    if (a.forced_zero) continue;
    if (within && a.lambda_im > 0.0)
      offer(a.lambda_im / hypotenuse(a.lambda_re, a.lambda_im), a.lambda_re, a.block, a.block);
    for (int k = 0; k < i; ++k) {
      const Mode& b = spectrum.mode[static_cast<std::size_t>(k)];
      if (b.forced_zero || a.lambda_im > 0.0 || b.lambda_im > 0.0) continue;
      if ((a.block == b.block) != within || (!within && a.krein * b.krein > 0)) continue;
      offer(relative_gap(a.lambda_re, b.lambda_re), 0.5 * (a.lambda_re + b.lambda_re), a.block,
            b.block);
    }
  }
  return out;
}

/// The pairs of inertias whose equality is an event of the type, as moments of the stretches; the
/// nearest to equal first.
std::vector<SoughtEvent> equal_inertias(EventType type, Branch branch, const Member& member) {
  const Vector3<double> moment = second_moments(member.body, member.q);
  std::vector<SoughtEvent> out;
  struct Pair {
    int a;
    int b;
  };
  for (const Pair each : {Pair{0, 2}, Pair{1, 2}, Pair{0, 1}}) {
    // A tilt's, unless the spin is about the axis left over.
    const bool tilts = each.b == 2 && !(branch == Branch::i && each.a == 1) &&
                       !(branch == Branch::ii && each.a == 0);
    if (tilts == (type == EventType::tilt))
      out.push_back({{.kind = EventFunction::Kind::inertia, .a = each.a, .b = each.b}});
  }
  std::ranges::sort(out, {}, [&](const SoughtEvent& each) {
    return relative_gap(moment[each.function.a], moment[each.function.b]);
  });
  return out;
}

}  // namespace

std::vector<SoughtEvent> sought_events(EventType type, Branch branch, const Member& member) {
  const auto plain = [](EventFunction::Kind kind) {
    return std::vector{SoughtEvent{EventFunction{.kind = kind}}};
  };
  switch (type) {
    case EventType::fold_nu:
    case EventType::fold_parameter:
      return plain(EventFunction::Kind::fold);
    case EventType::fold_momentum:
      return plain(EventFunction::Kind::momentum);
    case EventType::ellipse:
    case EventType::ellipse_23:
    case EventType::ellipse_13:
      return plain(EventFunction::Kind::ellipse);
    case EventType::oblique:
    case EventType::shear:
      return plain(EventFunction::Kind::turn);
    case EventType::tilt:
    case EventType::inertia_exchange:
      return equal_inertias(type, branch, member);
    case EventType::hamiltonian_hopf:
    case EventType::real_collision:
    case EventType::krein_pass:
      if (member.spectrum)
        if (const auto meeting = meeting_modes(*member.spectrum, type)) return {*meeting};
      return {};
    default:
      return {};
  }
}

}  // namespace stationary
