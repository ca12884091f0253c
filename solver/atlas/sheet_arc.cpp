#include "solver/atlas/sheet_arc.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lib/matrix/elementwise.hpp"
#include "solver/continuation/curve.hpp"

namespace stationary {
namespace {

template <int N>
std::optional<Member> on_arc(const Family<N>& family, Member a, Member b, double u) {
  align_axes(a, b);
  Circle circle = family.circle();
  if (circle != Circle::none && !(is_on(circle, a.q) && is_on(circle, b.q))) circle = Circle::none;
  const double scale = std::max(std::abs(a.nu), std::abs(b.nu));
  const Curve<N> curve(family, scale, circle, std::nullopt, EventSet::none());
  const ReducedVector<N> from = family.coordinates_of(a);
  const ReducedVector<N> to = family.coordinates_of(b);
  ArcVector<N> chord;
  chord.template head<N>() = logarithms(to.array() / from.array()).matrix();
  chord[N] = (b.nu - a.nu) / scale;
  if (!(chord.norm() > 0.0)) return std::nullopt;
  const auto tangent = [&](const ReducedVector<N>& x, double nu) {
    const ArcVector<N> out = curve.corrector().direction_near(x, nu);
    return ArcVector<N>(out.dot(chord) < 0.0 ? -out : out);
  };
  const ArcVector<N> first = tangent(from, a.nu);
  const ArcVector<N> last = tangent(to, b.nu);
  if (!first.allFinite() || !last.allFinite()) return std::nullopt;
  ArcPoint<N> begin;
  begin.x = from;
  begin.p = a.nu;
  const Corrected<N> at = curve.at(begin, Arc<N>(chord, first, last), u);
  if (at.status != CorrectorStatus::converged) return std::nullopt;
  return family.member(at.point.x, at.point.tail, at.point.p, at.point.error_bound);
}

}  // namespace

SheetArc sheet_arc(const std::shared_ptr<const AnyFamily>& family) {
  return [family](const Member& a, const Member& b, double u) {
    return std::visit([&](const auto& f) { return on_arc(*f, a, b, u); }, *family);
  };
}

bool in_box(const Stretch& q, const SearchOptions& box, Circle mirror) {
  const PrincipalStretches planar = principal_stretches(q);
  // Sheared, the two of the plane are sought between the same bounds.
  std::array<double, 3> stretches = q.alpha == 0.0 ? std::array{q.xi, q.zeta, q.rho}
                                                   : std::array{planar.lambda, planar.mu, q.rho};
  const auto inside = [&] {
    for (std::size_t k = 0; k < 3; ++k) {
      const Interval range = box.range(k);
      if (!(stretches[k] > range.lo && stretches[k] < range.hi)) return false;
    }
    return true;
  };
  if (inside()) return true;
  if (mirror == Circle::none) return false;
  const CirclePlaces turned = places(mirror);
  std::swap(stretches[static_cast<std::size_t>(turned.first)],
            stretches[static_cast<std::size_t>(turned.second)]);
  return inside();
}

void align_axes(Member& a, Member& b) {
  if (a.nu == 0.0) a.angular_velocity = b.angular_velocity;
  if (b.nu == 0.0) b.angular_velocity = a.angular_velocity;
  // An axis is a line: both ways along it are one, and the angle between the two is what they turn.
  if (a.angular_velocity[0] < 0.0) a.angular_velocity *= -1.0;
  if (a.angular_velocity.dot(b.angular_velocity) < 0.0) b.angular_velocity *= -1.0;
}

}  // namespace stationary
