#include "solver/event_curve/event_sides.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "lib/matrix/elimination.hpp"
#include "solver/continuation/corrector.hpp"

namespace stationary {
namespace {

/// answer(family).
template <class Answer>
auto visit_family(const AnyFamily& family, const Answer& answer) {
  return std::visit([&](const auto& own) { return answer(*own); }, family);
}

template <int N>
ArcVector<N> with_parameter(const ReducedVector<N>& x, double p) {
  ArcVector<N> out;
  out.template head<N>() = x;
  out[N] = p;
  return out;
}

/// Of a matrix that is singular but for rounding: by the cofactors of the row that has the largest.
template <int N>
ReducedVector<N> null_direction(const Eigen::Matrix<double, N, N>& A) {
  ReducedVector<N> out = ReducedVector<N>::Zero();
  for (int left_out = 0; left_out < N; ++left_out) {
    Eigen::Matrix<double, N - 1, N> others;
    for (int i = 0, row = 0; i < N; ++i)
      if (i != left_out) others.row(row++) = A.row(i);
    const ReducedVector<N> by_this = kernel_by_cofactors<N - 1>(others);
    if (by_this.norm() > out.norm()) out = by_this;
  }
  return out.normalized();
}

template <int N>
struct Side {
  Corrected<N> at;
  Member member;
};

/// At a small distance along the family: p1 below and above the event, or the two sheets of a fold.
template <int N>
std::optional<Side<N>> beside(const Family<N>& family, const EventPlace& place, bool fold,
                              double side) {
  const Corrector<N> corrector(family, 1.0, place.circle);
  const ReducedVector<N> x = EventPlace::of<N>(place.x);
  const FamilyLinearization<N> at = corrector.linearize(x, place.first);
  Side<N> out;
  if (fold) {
    constexpr double distance = 1e-3;
    const ReducedVector<N> w = null_direction<N>(at.jacobian);
    const double turned = side * distance;
    out.at = corrector.correct(moved<N>(x, ReducedVector<N>(turned * w)), place.first,
                               with_parameter<N>(w, 0.0), 1.0);
  } else {
    constexpr double distance = 1e-5;
    const double step = side * distance * std::abs(place.first);
    const ReducedVector<N> slope = -(Elimination<N>(at.jacobian).inverse() * at.slope);
    out.at = corrector.correct_at(moved<N>(x, ReducedVector<N>(step * slope)), place.first + step,
                                  with_parameter<N>(ReducedVector<N>::Zero(), 1.0));
  }
  if (out.at.status != CorrectorStatus::converged) return std::nullopt;
  const ArcPoint<N>& point = out.at.point;
  out.member = family.member(point.x, point.tail, point.p, point.error_bound);
  return out;
}

std::optional<StabilityClass> class_of(const Member& member) {
  if (!member.spectrum) return std::nullopt;
  return member.spectrum->verdict;
}

}  // namespace

EventPlace place_of(const AnyFamily& family, const Member& member, Circle circle) {
  EventPlace out{.first = member.parameter, .error_bound = member.error_bound, .circle = circle};
  out.x[2] = member.q.rho;
  visit_family(family,
               [&](const auto& own) { EventPlace::put(own.coordinates_of(member), out.x); });
  return out;
}

EventPlace place_of(const AnyFamily& family, const Stretch& q, double first, double error_bound,
                    Circle circle) {
  EventPlace out{.first = first, .error_bound = error_bound, .circle = circle};
  out.x[2] = q.rho;
  visit_family(family, [&](const auto& own) { EventPlace::put(own.coordinates(q, first), out.x); });
  return out;
}

Member member_at(const AnyFamily& family, const EventPlace& place) {
  return visit_family(family, [&]<int N>(const Family<N>& own) {
    return own.member(EventPlace::of<N>(place.x), EventPlace::of<N>(place.tail), place.first,
                      place.error_bound);
  });
}

EventSides sides_of(const AnyFamily& family, const EventPlace& place, bool fold) {
  return visit_family(family, [&]<int N>(const Family<N>& own) {
    auto before = beside(own, place, fold, -1.0);
    auto after = beside(own, place, fold, 1.0);
    if (!before || !after) return EventSides{};
    if (fold && own.spin_inertia(before->member).own > own.spin_inertia(after->member).own)
      std::swap(before, after);
    return EventSides{class_of(before->member), class_of(after->member)};
  });
}

EventFunctions functions_at(const AnyFamily& family, const EventPlace& place,
                            const Member& member) {
  return visit_family(family, [&]<int N>(const Family<N>& own) {
    const Corrector<N> corrector(own, 1.0, place.circle);
    const FamilyLinearization<N> G = corrector.linearize(EventPlace::of<N>(place.x), place.first);
    const SpinInertia<N> I = own.spin_inertia(member);
    Eigen::Matrix<double, N + 1, N + 1> bordered;
    bordered.template topLeftCorner<N, N>() = G.jacobian;
    bordered.template topRightCorner<N, 1>() = member.nu * G.nu_slope;
    bordered.template bottomLeftCorner<1, N>() = 2.0 * I.half_slope.transpose();
    bordered(N, N) = I.own;
    EventFunctions out{{},
                       {.branch = own.branch(),
                        .material_symmetry = own.material_symmetry(),
                        .circle = place.circle,
                        .kind = own.events(),
                        .along_nu = own.along_nu()},
                       determinant<N>(G.jacobian)};
    out.values = test_values(member, out.context, out.turning, determinant<N + 1>(bordered) / I.own,
                             place.error_bound);
    return out;
  });
}

}  // namespace stationary
