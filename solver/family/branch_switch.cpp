#include "solver/family/branch_switch.hpp"

#include <Eigen/SVD>
#include <numbers>

#include "lib/balance/anisotropic_balance.hpp"
#include "solver/continuation/corrector.hpp"

namespace stationary {

template <int N>
std::optional<Member> leave_straight(const Family<N>& family, const Member& event, Branch branch) {
  const Corrector<N> corrector(family, event.nu, Circle::none);
  ReducedVector<N> x;
  ArcVector<N> away = ArcVector<N>::Zero();
  if constexpr (N < 5) {
    const auto alpha = family.mirrored();
    if (!alpha) return std::nullopt;
    x = family.coordinates(event.q, event.parameter);
    away[*alpha] = 1.0;
  } else {
    x << event.q.xi, event.q.zeta, event.q.rho, 1.0,
        axis_coordinate(branch == Branch::i ? 0.0 : 0.5 * std::numbers::pi);
    const Eigen::Matrix2d block =
        family.linearize(x, event.parameter).jacobian.template bottomRightCorner<2, 2>();
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(block, Eigen::ComputeFullV);
    away.template segment<2>(3) = svd.matrixV().col(1);
  }
  for (const double step : {1e-2, 3e-3, 1e-3}) {
    const Corrected<N> at = corrector.correct(
        moved<N>(x, ReducedVector<N>(step * away.template head<N>())), event.parameter, away, step);
    if (at.status != CorrectorStatus::converged) continue;
    return family.member(at.point.x, at.point.tail, at.point.p, at.point.error_bound);
  }
  return std::nullopt;
}

template std::optional<Member> leave_straight<3>(const Family<3>&, const Member&, Branch);
template std::optional<Member> leave_straight<4>(const Family<4>&, const Member&, Branch);
template std::optional<Member> leave_straight<5>(const Family<5>&, const Member&, Branch);

std::optional<Member> leave_straight(const AnyFamily& family, const Member& event, Branch branch) {
  return std::visit(
      [&](const auto& own) -> std::optional<Member> {
        if constexpr (std::decay_t<decltype(*own)>::dimension == 2) {
          return std::nullopt;
        } else {
          return leave_straight(*own, event, branch);
        }
      },
      family);
}

}  // namespace stationary
