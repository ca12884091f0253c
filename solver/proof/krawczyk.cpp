#include "solver/proof/krawczyk.hpp"

#include <algorithm>
#include <cmath>

#include "lib/matrix/small_symmetric.hpp"

namespace stationary {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

double widened(double radius) { return 1.25 * radius + 0x1p-60; }

template <std::size_t N>
bool maps_inside(const std::array<Interval, N>& image, const std::array<Interval, N>& d) {
  for (std::size_t i = 0; i < N; ++i)
    if (!image[i].inside(d[i])) return false;
  return true;
}

}  // namespace

template <int N>
Eigen::Matrix<double, N, N> BoxSlopes<N>::inverse() const {
  Eigen::Matrix<double, N, N> out;
  if constexpr (N <= 3) {
    if (symmetric) {
      SmallSymmetric<N> middle;
      for (int i = 0; i < N; ++i)
        for (int j = i; j < N; ++j)
          middle.entries[index(SmallSymmetric<N>::index(i, j))] = (*this)(i, j).mid();
      return middle.inverse().matrix();
    }
  }
  for (int i = 0; i < N; ++i)
    for (int j = 0; j < N; ++j) out(i, j) = (*this)(i, j).mid();
  return SmallMatrix<N>{out}.inverse().entries;
}

template <int N>
Krawczyk<N>::Krawczyk(const BoxEquations<N>& equations, const ReducedVector<N>& x)
    : equations_(equations), x_(x) {
  Box<N> point;
  for (int i = 0; i < N; ++i) point[index(i)] = x[i];
  const BoxSlopes<N> at = equations_.linearize(point);
  inverse_ = at.inverse();
  VariedResidual<N> g{at.g, {}, {}};
  const bool varies = equations_.varies();
  if (varies) g = equations_.varied(point);
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) newton_[index(i)] += inverse_(i, j) * g.at[index(j)];
    if (varies) newton_[index(i)] += g.by_number(inverse_, i);
  }
  for (Interval& d : newton_) d = -d;
}

template <int N>
Box<N> Krawczyk<N>::stretches(const Box<N>& d) const {
  Box<N> out;
  for (int i = 0; i < N; ++i) out[index(i)] = x_[i] * exp(d[index(i)]);
  return out;
}

template <int N>
Box<N> Krawczyk<N>::operator()(const Box<N>& d) const {
  // The mean value is taken between x, whose d is 0, and every d of D.
  Box<N> about = d;
  for (Interval& each : about) each = hull(each, Interval(0.0));
  const BoxSlopes<N> over = equations_.linearize(stretches(about));
  Box<N> out = newton_;
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      Interval entry(i == j ? 1.0 : 0.0);
      for (int k = 0; k < N; ++k) entry -= inverse_(i, k) * over(k, j);
      out[index(i)] += entry * d[index(j)];
    }
  }
  return out;
}

template <int N>
std::optional<Box<N>> Krawczyk<N>::unique(const ReducedVector<N>& radius) const {
  Box<N> d;
  for (int i = 0; i < N; ++i) d[index(i)] = {-radius[i], radius[i]};
  return maps_inside((*this)(d), d) ? std::optional(stretches(d)) : std::nullopt;
}

template <int N>
std::optional<Box<N>> Krawczyk<N>::unique_within(double error) const {
  if (!(error < 0.2)) return std::nullopt;
  return unique(ReducedVector<N>::Constant(widened(error)));
}

template <int N>
Proof<N> Krawczyk<N>::prove() const {
  Box<N> image = newton_;
  for (int attempt = 0; attempt < 12; ++attempt) {
    Box<N> d;
    double widest = 0.0;
    for (int i = 0; i < N; ++i) {
      const double radius = widened(image[index(i)].magnitude());
      d[index(i)] = {-radius, radius};
      widest = radius > widest || std::isnan(radius) ? radius : widest;
    }
    if (!(widest < 0.5)) break;
    image = (*this)(d);
    const Proof<N> out = proof(d, image);
    if (out.proven) return out;
  }
  return {};
}

template <int N>
Proof<N> Krawczyk<N>::proof(const Box<N>& d, Box<N> image) const {
  Proof<N> out;
  if (!maps_inside(image, d)) return out;
  out.proven = true;
  out.unique = stretches(d);
  // Narrower D, narrower K: what remains is the residual's own width.
  for (int pass = 0; pass < 3; ++pass) {
    const Box<N> next = (*this)(image);
    bool narrower = false;
    for (int i = 0; i < N; ++i) {
      const double before = image[index(i)].magnitude();
      image[index(i)] = common(image[index(i)], next[index(i)]);
      narrower = narrower || image[index(i)].magnitude() < 0.9 * before;
    }
    if (!narrower) break;
  }
  out.solution = stretches(image);
  double largest = 0.0;
  for (int i = 0; i < N; ++i) largest = std::max(largest, image[index(i)].magnitude());
  out.error_bound = (exp(Interval(largest)) - Interval(1.0)).hi;
  return out;
}

template struct BoxSlopes<1>;
template struct BoxSlopes<2>;
template struct BoxSlopes<3>;
template struct BoxSlopes<4>;
template struct BoxSlopes<5>;
template struct BoxSlopes<6>;
template struct BoxSlopes<7>;
template class Krawczyk<1>;
template class Krawczyk<2>;
template class Krawczyk<3>;
template class Krawczyk<4>;
template class Krawczyk<5>;
template class Krawczyk<6>;
template class Krawczyk<7>;

}  // namespace stationary
