#include "lib/matrix/scaled_rows.hpp"

#include <limits>

namespace stationary {
namespace {

template <int N>
using Vector = Eigen::Matrix<double, N, 1>;

template <int N>
typename ScaledRows<N>::Numbers none() {
  typename ScaledRows<N>::Numbers out;
  out.fill(std::numeric_limits<double>::quiet_NaN());
  return out;
}

template <int N>
typename ScaledRows<N>::Numbers numbers(const Vector<N>& x) {
  typename ScaledRows<N>::Numbers out;
  Eigen::Map<Vector<N>>(out.data()) = x;
  return out;
}

}  // namespace

template <int N>
void ScaledRows<N>::eliminate(const std::array<Numbers, static_cast<std::size_t>(N)>& columns) {
  Eigen::Matrix<double, N, N> A;
  for (int k = 0; k < N; ++k)
    A.col(k) = Eigen::Map<const Vector<N>>(columns[static_cast<std::size_t>(k)].data());
  for (int i = 0; i < N; ++i) {
    scale_[i] = 1.0 / A.row(i).cwiseAbs().maxCoeff();
    A.row(i) *= scale_[i];
  }
  lu_.setThreshold(0.0);  // columns are of any size: an event may hang on the last digits of J
  lu_.compute(A);
  // Of what is not finite it finds no pivot, and then solves everything by 0.
  regular_ = A.allFinite() && lu_.isInvertible();
}

template <int N>
typename ScaledRows<N>::Numbers ScaledRows<N>::solve(const Numbers& b) const {
  if (!regular_) return none<N>();
  return numbers<N>(lu_.solve(Eigen::Map<const Vector<N>>(b.data()).cwiseProduct(scale_)));
}

template <int N>
typename ScaledRows<N>::Numbers ScaledRows<N>::largest(const Numbers& scaled_b) const {
  if (!regular_) return none<N>();
  const Eigen::Matrix<double, N, N> inverse = lu_.inverse().cwiseAbs();
  return numbers<N>(inverse * Eigen::Map<const Vector<N>>(scaled_b.data()));
}

template class ScaledRows<2>;
template class ScaledRows<3>;
template class ScaledRows<4>;
template class ScaledRows<5>;
template class ScaledRows<6>;

}  // namespace stationary
