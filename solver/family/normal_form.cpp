#include "solver/family/normal_form.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lib/number/interval.hpp"
#include "lib/number/interval_functions.hpp"
#include "lib/number/taylor.hpp"
#include "solver/motion/varied_balance.hpp"

namespace stationary {
namespace {

using T = Taylor<Interval, 3>;
/// Of ln (xi, zeta, rho).
using Direction = std::array<Interval, 3>;
using Matrix = std::vector<std::vector<Interval>>;

Interval dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Direction of_order(const std::array<T, 3>& g, int k) {
  return {g[0].derivative(k), g[1].derivative(k), g[2].derivative(k)};
}

/// The balance near the event.
class NearEvent {
 public:
  NearEvent(const Problem& problem, const FamilyParameter& parameter, Circle circle,
            const Member& member)
      : problem_(problem), parameter_(parameter), member_(member) {
    const Interval around(1.0 - 2.0 * member.error_bound, 1.0 + 2.0 * member.error_bound);
    double x[3] = {member.q.xi, member.q.zeta, member.q.rho};
    if (circle != Circle::none) {
      const auto [a, b, other] = places(circle);
      x[a] = x[b] = std::sqrt(x[a] * x[b]);
    }
    x_ = {around * x[0], around * x[1], around * x[2]};
    p_ = around * member.parameter;
    scale_ = member.parameter != 0.0 ? std::abs(member.parameter) : 1.0;
  }

  /// The numbers of the problem at p + c scale s.
  struct Numbers {
    const Potential& potential;
    FamilyParameter parameter;
    T p;

    T operator()(double value, FamilyParameter::Kind kind, int index) const {
      const InputPlace at = input_place(potential, kind, index);
      return varies(parameter, at.kind, at.index) ? p : T(Interval(value));
    }
  };
  Numbers numbers(double c) const {
    return {problem_.potential(), parameter_, T::along(p_, Interval(c * scale_))};
  }
  bool volume_held() const { return problem_.potential().holds_volume(); }

  struct State {
    std::array<T, 3> x;
    T nu;
    Inertia3<T> J;
  };
  /// At x e^(v s), p + c scale s.
  State state(const Direction& v, double c) const {
    using Kind = FamilyParameter::Kind;
    State out;
    for (std::size_t i = 0; i < 3; ++i) out.x[i] = T(x_[i]) * exp(T::along(Interval(0.0), v[i]));
    const Numbers number = numbers(c);
    const Body& body = problem_.body();
    out.nu = number(member_.nu, Kind::nu, 0);
    out.J = {number(body.J1, Kind::inertia, 0), number(body.J2, Kind::inertia, 1),
             number(body.J3, Kind::inertia, 2)};
    return out;
  }
  LogBalance<T> balance(const Direction& v, double c) const {
    const State s = state(v, c);
    const auto rates = axis_rates(s.J, problem_.branch(), s.nu * s.nu);
    return varied_balance(problem_.potential(), s.x[0], s.x[1], s.x[2], rates, numbers(c));
  }
  std::array<T, 3> gradient(const Direction& v, double c) const {
    const LogBalance<T> b = balance(v, c);
    return {b.g_xi, b.g_zeta, b.g_rho};
  }
  /// dG/dp, over the scale of p.
  Direction slope() const { return of_order(gradient({}, 1.0), 1); }
  /// v d^2G/dp dx likewise.
  Direction mixed(const Direction& v) const {
    const Direction up = of_order(gradient(v, 1.0), 2);
    const Direction down = of_order(gradient(v, -1.0), 2);
    Direction out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = 0.25 * (up[i] - down[i]);
    return out;
  }
  /// dG/dx in a basis.
  Matrix stiffness(const std::vector<Direction>& basis) const {
    const LogBalance<T> b = balance({}, 0.0);
    const std::array<Direction, 3> rows{Direction{b.uu.value, b.uv.value, b.uw.value},
                                        Direction{b.uv.value, b.vv.value, b.vw.value},
                                        Direction{b.uw.value, b.vw.value, b.ww.value}};
    Matrix out;
    for (const Direction& a : basis) {
      Direction image;
      for (std::size_t i = 0; i < 3; ++i) image[i] = dot(rows[i], a);
      std::vector<Interval>& row = out.emplace_back();
      for (const Direction& each : basis) row.push_back(dot(each, image));
    }
    return out;
  }

 private:
  const Problem& problem_;
  FamilyParameter parameter_;
  const Member& member_;
  Direction x_;
  Interval p_;
  double scale_;
};

/// A x = b by elimination; nothing where a pivot may vanish.
std::optional<std::vector<Interval>> solved(Matrix A, std::vector<Interval> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (A[i][k].mignitude() > A[pivot][k].mignitude()) pivot = i;
    std::swap(A[k], A[pivot]);
    std::swap(b[k], b[pivot]);
    if (A[k][k].may_be(0.0) || !A[k][k].bounded()) return std::nullopt;
    for (std::size_t i = k + 1; i < n; ++i) {
      const Interval factor = A[i][k] / A[k][k];
      for (std::size_t j = k; j < n; ++j) A[i][j] -= factor * A[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= A[k][j] * b[j];
    b[k] = b[k] / A[k][k];
  }
  return b;
}

/// Of the sheets that keep the circle. A held volume is kept by it too where rho is one of the two:
/// off it what is left of V (held_volume.hpp) is not symmetric in rho and another stretch.
std::vector<Direction> symmetric_basis(Circle circle, bool volume_held) {
  if (circle == Circle::none) return {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  const CirclePlaces at = places(circle);
  const auto a = static_cast<std::size_t>(at.first);
  const auto b = static_cast<std::size_t>(at.second);
  const auto other = static_cast<std::size_t>(at.other);
  Direction along{};
  Direction third{};
  if (volume_held && circle != Circle::xi_zeta) {
    along[a] = along[b] = -sqrt(Interval(1.0) / 6.0);
    along[other] = sqrt(Interval(2.0) / 3.0);
    return {along};
  }
  along[a] = along[b] = sqrt(Interval(0.5));
  third[other] = 1.0;
  return {along, third};
}

/// The unit vector v with K v = 0 at the event, K among these matrices: the eigenvector w in the
/// middle, |w - v| <= |K w|/gap.
std::optional<Direction> null_direction(const Matrix& K, const std::vector<Direction>& basis) {
  const auto n = static_cast<Eigen::Index>(K.size());
  Eigen::MatrixXd middle(n, n);
  double width = 0.0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const Interval& entry = K[std::size_t(i)][std::size_t(j)];
      if (!entry.bounded()) return std::nullopt;
      middle(i, j) = entry.mid();
      width = std::max(width, entry.hi - entry.lo);
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(middle);
  std::vector<Eigen::Index> order(std::size_t(n), 0);
  for (Eigen::Index i = 0; i < n; ++i) order[std::size_t(i)] = i;
  std::ranges::sort(order, {}, [&](Eigen::Index i) { return std::abs(eigen.eigenvalues()[i]); });
  const Eigen::VectorXd w = eigen.eigenvectors().col(order[0]);
  const double gap = std::abs(eigen.eigenvalues()[order[1]]) - static_cast<double>(n) * width;
  double rest = 0.0;
  for (std::size_t i = 0; i < K.size(); ++i) {
    Interval sum;
    for (std::size_t j = 0; j < K.size(); ++j) sum += K[i][j] * w[Eigen::Index(j)];
    rest += sum.magnitude();
  }
  const double radius = 1.1 * rest / gap + 0x1p-50;
  if (!(gap > 0.0 && radius < 1e-3)) return std::nullopt;
  Direction out{};
  for (std::size_t k = 0; k < basis.size(); ++k) {
    const double part = w[Eigen::Index(k)];
    for (std::size_t i = 0; i < 3; ++i)
      out[i] += basis[k][i] * Interval(part - radius, part + radius);
  }
  return out;
}

bool certain(const Interval& x) { return x.positive() || x.negative(); }

NormalForm form_of(const Interval& coefficient, bool after) {
  const double middle = coefficient.mid();
  return {middle, std::max(coefficient.hi - middle, middle - coefficient.lo),
          after ? EventSide::after : EventSide::before};
}

std::optional<NormalForm> at_fold(const NearEvent& event, Circle circle) {
  // One direction alone is singular by itself; all three are so too.
  if (event.volume_held() && circle != Circle::xi_zeta) circle = Circle::none;
  const std::vector<Direction> basis = symmetric_basis(circle, event.volume_held());
  const auto v = null_direction(event.stiffness(basis), basis);
  if (!v) return std::nullopt;
  const Interval F_vp = dot(*v, event.slope());
  Interval F_vvv = dot(*v, of_order(event.gradient(*v, 0.0), 2));
  if (!certain(F_vp) || !certain(F_vvv)) return std::nullopt;
  if (F_vp.positive()) F_vvv = -F_vvv;
  return form_of(F_vvv, F_vvv.positive());
}

/// F_vvvv, the gradient of F_vv across v, and its derivative in p at fixed x.
struct Breaking {
  Interval vvvv;
  Direction vv_slope;
  Interval vv_parameter;
};

std::optional<NormalForm> at_breaking(const NearEvent& event, const Breaking& F,
                                      const std::vector<Direction>& basis) {
  const Matrix K = event.stiffness(basis);
  const Direction slope = event.slope();
  std::vector<Interval> across;
  std::vector<Interval> pull;
  for (const Direction& each : basis) {
    across.push_back(dot(each, F.vv_slope));
    pull.push_back(-dot(each, slope));
  }
  const auto bent = solved(K, across);
  const auto moved = solved(K, pull);
  if (!bent || !moved) return std::nullopt;
  Interval a = F.vvvv;
  Interval e = F.vv_parameter;
  for (std::size_t k = 0; k < basis.size(); ++k) {
    a -= 3.0 * (across[k] * (*bent)[k]);
    e += across[k] * (*moved)[k];
  }
  if (!certain(a) || !certain(e)) return std::nullopt;
  return form_of(a, a.positive() != e.positive());
}

std::optional<NormalForm> at_ellipse(const NearEvent& event, Circle circle) {
  const CirclePlaces at = places(circle);
  Direction v{};
  v[static_cast<std::size_t>(at.first)] = 1.0;
  v[static_cast<std::size_t>(at.second)] = -1.0;
  const std::array<T, 3> g = event.gradient(v, 0.0);
  return at_breaking(event, {dot(v, of_order(g, 3)), of_order(g, 2), dot(v, event.mixed(v))},
                     symmetric_basis(circle, event.volume_held()));
}

std::optional<NormalForm> at_tilt(const NearEvent& event, Branch branch, const Member& member) {
  const auto own = static_cast<std::size_t>(axis(branch));
  const Vector3<double> m = second_moments(member.body, member.q);
  std::size_t other = own == 2 ? 0 : 2;
  if (own == 2 && std::abs(m[1] - m[2]) < std::abs(m[0] - m[2])) other = 1;
  // I_b - I_a = m_a - m_b.
  const auto stiffness = [&](double c) {
    const NearEvent::State s = event.state({}, c);
    const std::array<T, 3> J{s.J.J1, s.J.J2, s.J.J3};
    const auto moment = [&](std::size_t k) { return J[k] * square(s.x[k]); };
    const T nu2 = square(s.nu);
    return std::array{nu2 * moment(own), nu2 * moment(other)};
  };
  const auto [m_own, m_other] = stiffness(1.0);
  Breaking F{};
  F.vv_slope[own] = -2.0 * m_own.value;
  F.vv_slope[other] = 2.0 * m_other.value;
  F.vv_parameter = m_other[1] - m_own[1];
  // Along a held volume rho follows xi and zeta.
  if (event.volume_held())
    F.vv_slope = {F.vv_slope[0] - F.vv_slope[2], F.vv_slope[1] - F.vv_slope[2], Interval(0.0)};
  return at_breaking(event, F, symmetric_basis(Circle::none, event.volume_held()));
}

}  // namespace

std::optional<NormalForm> normal_form(const Problem& problem, const FamilyParameter& parameter,
                                      Circle circle, EventType type, const Member& member) {
  constexpr double least_known = 1e-6;
  if (!problem.potential().is_isotropic() || !(member.error_bound < least_known) ||
      !std::isfinite(member.parameter) || member.nu == 0.0)
    return std::nullopt;
  // rho itself follows a volume that is varied: not worked out.
  const bool volume_varies = varies(parameter, FamilyParameter::Kind::plane,
                                    static_cast<int>(BodyModel<>::volume_place)) &&
                             problem.potential().holds_volume();
  switch (type) {
    case EventType::fold_nu:
    case EventType::fold_parameter:
      return at_fold({problem, parameter, circle, member}, circle);
    case EventType::ellipse:
      return at_ellipse({problem, parameter, Circle::xi_zeta, member}, Circle::xi_zeta);
    case EventType::ellipse_23:
    case EventType::ellipse_13:
      if (volume_varies) return std::nullopt;
      return at_ellipse({problem, parameter, broken_circle(type), member}, broken_circle(type));
    case EventType::tilt:
      if (volume_varies) return std::nullopt;
      return at_tilt({problem, parameter, circle, member}, problem.branch(), member);
    default:
      return std::nullopt;
  }
}

}  // namespace stationary
