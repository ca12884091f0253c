#include "solver/event_curve/event_sides.hpp"

#include <Eigen/SVD>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

#include "solver/continuation/corrector.hpp"
#include "solver/family/axis_family.hpp"

namespace stationary {
namespace {

AnyFamily family_at(const SpinningProblem& at, const FamilyParameter& first, bool spectrum) {
  return axis_family(at.problem, {.nu = at.nu, .parameter = first, .spectrum = spectrum}, false);
}

/// answer(family) of an isotropic body's family: two or three unknowns.
template <class Answer>
auto visit_axis(const AnyFamily& family, const Answer& answer) {
  if (const auto* planar = std::get_if<std::unique_ptr<Family<2>>>(&family))
    return answer(**planar);
  return answer(*std::get<std::unique_ptr<Family<3>>>(family));
}

template <int N>
ArcVector<N> with_parameter(const ReducedVector<N>& x, double p) {
  ArcVector<N> out;
  out.template head<N>() = x;
  out[N] = p;
  return out;
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
  const ReducedVector<N> x = unknowns<N>(place.q);
  const FamilyLinearization<N> at = corrector.linearize(x, place.first);
  Side<N> out;
  if (fold) {
    constexpr double distance = 1e-3;
    const Eigen::JacobiSVD<Eigen::Matrix<double, N, N>> svd(at.jacobian, Eigen::ComputeFullV);
    const ReducedVector<N> w = svd.matrixV().col(N - 1);
    const double turned = side * distance;
    out.at = corrector.correct(moved<N>(x, ReducedVector<N>(turned * w)), place.first,
                               with_parameter<N>(w, 0.0), 1.0);
  } else {
    constexpr double distance = 1e-5;
    const double step = side * distance * std::abs(place.first);
    const ReducedVector<N> slope = -at.jacobian.fullPivLu().solve(at.slope);
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

Member member_at(const SpinningProblem& at, const FamilyParameter& first, const EventPlace& place,
                 bool spectrum) {
  const AnyFamily family = family_at(at, first, spectrum);
  return visit_axis(family, [&]<int N>(const Family<N>& own) {
    return own.member(unknowns<N>(place.q), ReducedVector<N>(place.tail.template head<N>()),
                      place.first, place.error_bound);
  });
}

EventSides sides_of(const SpinningProblem& at, const FamilyParameter& first,
                    const EventPlace& place, bool fold) {
  const AnyFamily family = family_at(at, first, true);
  return visit_axis(family, [&]<int N>(const Family<N>& own) {
    auto before = beside(own, place, fold, -1.0);
    auto after = beside(own, place, fold, 1.0);
    if (!before || !after) return EventSides{};
    if (fold && own.spin_inertia(before->member).own > own.spin_inertia(after->member).own)
      std::swap(before, after);
    return EventSides{class_of(before->member), class_of(after->member)};
  });
}

TestValues functions_at(const SpinningProblem& at, const FamilyParameter& first,
                        const EventPlace& place, const Member& member) {
  const AnyFamily family = family_at(at, first, false);
  return visit_axis(family, [&]<int N>(const Family<N>& own) {
    const Corrector<N> corrector(own, 1.0, place.circle);
    const FamilyLinearization<N> G = corrector.linearize(unknowns<N>(place.q), place.first);
    const SpinInertia<N> I = own.spin_inertia(member);
    Eigen::Matrix<double, N + 1, N + 1> bordered;
    bordered.template topLeftCorner<N, N>() = G.jacobian;
    bordered.template topRightCorner<N, 1>() = member.nu * G.nu_slope;
    bordered.template bottomLeftCorner<1, N>() = 2.0 * I.half_slope.transpose();
    bordered(N, N) = I.own;
    const TestContext context{.branch = own.branch(),
                              .material_symmetry = own.material_symmetry(),
                              .circle = place.circle,
                              .along_nu = own.turns_in_nu()};
    return test_values(member, context, G.jacobian.determinant(), bordered.determinant() / I.own,
                       place.error_bound);
  });
}

std::optional<std::size_t> own_function(const EventFunction& function) {
  using Kind = EventFunction::Kind;
  switch (function.kind) {
    case Kind::fold:
      return TestValues::fold;
    case Kind::momentum:
      return TestValues::momentum;
    case Kind::inertia:
      return function.a + function.b == 1   ? TestValues::inertia_12
             : function.a + function.b == 2 ? TestValues::inertia_13
                                            : TestValues::inertia_23;
    case Kind::ellipse:
      return TestValues::ellipse;
    case Kind::turn:
      return TestValues::turn;
    case Kind::collision:
      return TestValues::collision;
    case Kind::crossing:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace stationary
