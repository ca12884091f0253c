#include "solver/family/normal_form_reduction.hpp"

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

std::optional<NormalForm> fold_form(const Interval& F_vvv, const Interval& F_vp) {
  if (!certain(F_vp) || !certain(F_vvv)) return std::nullopt;
  const Interval turned = F_vp.positive() ? -F_vvv : F_vvv;
  return form_of(turned, turned.positive());
}

std::optional<NormalForm> breaking_form(const Breaking& F, const IntervalMatrix& K,
                                        const IntervalVector& slope) {
  IntervalVector pull;
  for (const Interval& each : slope) pull.push_back(-each);
  const auto bent = solved(K, F.vv_slope);
  const auto moved = solved(K, pull);
  if (!bent || !moved) return std::nullopt;
  Interval a = F.vvvv;
  Interval e = F.vv_parameter;
  for (std::size_t k = 0; k < slope.size(); ++k) {
    a -= 3.0 * (F.vv_slope[k] * (*bent)[k]);
    e += F.vv_slope[k] * (*moved)[k];
  }
  if (!certain(a) || !certain(e)) return std::nullopt;
  return form_of(a, a.positive() != e.positive());
}

}  // namespace stationary
