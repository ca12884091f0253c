#include "solver/normal_form/reduction.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

namespace stationary {
namespace {

/// A x = b by elimination; nothing where a pivot may vanish.
std::optional<IntervalVector> solved(IntervalMatrix A, IntervalVector b) {
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

bool certain(const Interval& x) { return x.positive() || x.negative(); }

NormalForm form_of(const Interval& coefficient, bool after) {
  const double middle = coefficient.mid();
  return {middle, std::max(coefficient.hi - middle, middle - coefficient.lo),
          after ? EventSide::after : EventSide::before};
}

Interval dot(const IntervalVector& a, const IntervalVector& b) {
  Interval out;
  for (std::size_t k = 0; k < a.size(); ++k) out += a[k] * b[k];
  return out;
}
IntervalVector of_order(const std::vector<AlongLine>& g, int k) {
  IntervalVector out;
  for (const AlongLine& each : g) out.push_back(each.derivative(k));
  return out;
}
IntervalVector parts_of(const std::vector<IntervalVector>& basis, const IntervalVector& x) {
  IntervalVector out;
  for (const IntervalVector& each : basis) out.push_back(dot(each, x));
  return out;
}
IntervalVector slope_in_parameter(const GradientAlong& gradient, std::size_t dimension) {
  return of_order(gradient(IntervalVector(dimension), 1.0), 1);
}

/// F_vvvv, the gradient of F_vv in the directions that keep the symmetry, and its derivative in p
/// at fixed x.
struct Breaking {
  Interval vvvv;
  IntervalVector vv_slope;
  Interval vv_parameter;
};

std::optional<NormalForm> reduced(const GradientAlong& gradient,
                                  const std::vector<IntervalVector>& kept, const Breaking& F) {
  const IntervalMatrix K = stiffness(gradient, kept);
  IntervalVector pull = parts_of(kept, slope_in_parameter(gradient, kept.front().size()));
  for (Interval& each : pull) each = -each;
  const auto bent = solved(K, F.vv_slope);
  const auto moved = solved(K, pull);
  if (!bent || !moved) return std::nullopt;
  const Interval a = F.vvvv - 3.0 * dot(F.vv_slope, *bent);
  const Interval e = F.vv_parameter + dot(F.vv_slope, *moved);
  if (!certain(a) || !certain(e)) return std::nullopt;
  return form_of(a, a.positive() != e.positive());
}

}  // namespace

/// The eigenvector w in the middle, |w - v| <= |K w|/gap.
std::optional<IntervalVector> null_vector(const IntervalMatrix& K) {
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
  IntervalVector out;
  for (const double part : w) out.emplace_back(part - radius, part + radius);
  return out;
}

std::vector<IntervalVector> along_coordinates(const std::vector<std::size_t>& places,
                                              std::size_t dimension) {
  std::vector<IntervalVector> out;
  for (const std::size_t k : places) out.emplace_back(dimension)[k] = 1.0;
  return out;
}

IntervalMatrix stiffness(const GradientAlong& gradient, const std::vector<IntervalVector>& basis) {
  IntervalMatrix out(basis.size());
  for (const IntervalVector& each : basis) {
    const IntervalVector column = parts_of(basis, of_order(gradient(each, 0.0), 1));
    for (std::size_t i = 0; i < basis.size(); ++i) out[i].push_back(column[i]);
  }
  return out;
}

std::optional<NormalForm> fold_form(const GradientAlong& gradient,
                                    const std::vector<IntervalVector>& kept) {
  const auto parts = null_vector(stiffness(gradient, kept));
  if (!parts) return std::nullopt;
  IntervalVector v(kept.front().size());
  for (std::size_t k = 0; k < kept.size(); ++k)
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += kept[k][i] * (*parts)[k];
  const Interval F_vvv = dot(v, of_order(gradient(v, 0.0), 2));
  const Interval F_vp = dot(v, slope_in_parameter(gradient, v.size()));
  if (!certain(F_vp) || !certain(F_vvv)) return std::nullopt;
  const Interval turned = F_vp.positive() ? -F_vvv : F_vvv;
  return form_of(turned, turned.positive());
}

std::optional<NormalForm> breaking_form(const GradientAlong& gradient, const IntervalVector& v,
                                        const std::vector<IntervalVector>& kept) {
  const std::vector<AlongLine> g = gradient(v, 0.0);
  // The second derivative of F_v along v s, p + c s: what is odd in c is 2 c F_vvp.
  const Interval up = dot(v, of_order(gradient(v, 1.0), 2));
  const Interval down = dot(v, of_order(gradient(v, -1.0), 2));
  return reduced(gradient, kept,
                 {dot(v, of_order(g, 3)), parts_of(kept, of_order(g, 2)), 0.25 * (up - down)});
}

std::optional<NormalForm> turning_form(const GradientAlong& gradient, const NumberAlong& F_vv,
                                       const std::vector<IntervalVector>& kept) {
  Breaking out{Interval(0.0), {}, F_vv(IntervalVector(kept.front().size()), 1.0)[1]};
  for (const IntervalVector& each : kept) out.vv_slope.push_back(F_vv(each, 0.0)[1]);
  return reduced(gradient, kept, out);
}

bool is_known(const Member& member) {
  constexpr double least = 1e-6;
  return member.error_bound < least && std::isfinite(member.parameter) &&
         (member.nu != 0.0 || member.two_polar);
}

}  // namespace stationary
