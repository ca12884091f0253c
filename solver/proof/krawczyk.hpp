// Krawczyk's operator in logarithmic coordinates about a double x: for solutions x e^d, d in D,
//
//   K(D) = -Y G(x) + (1 - Y J(x e^D)) D,   J = dG/d ln x,   Y about the inverse of J.
//
// If K(D) lies in the interior of D, there is exactly one solution with d in D, and its d is in
// K(D); for every value the inputs have in their intervals. Any solution with d in D has it in
// K(D). Source: R. Krawczyk, Computing 4 (1969) 187; A. Neumaier, Interval Methods for Systems of
// Equations (1990), theorem 5.1.8.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "solver/proof/box_balance.hpp"

namespace stationary {

template <int N>
struct Proof {
  bool proven = false;
  Box<N> unique;    ///< stretches among which there is exactly one solution
  Box<N> solution;  ///< it is in here
  /// Bound of |x_i / solution_i - 1| for the x the proof is about.
  double error_bound = std::numeric_limits<double>::quiet_NaN();
};

template <class System>
class Krawczyk {
 public:
  static constexpr int N = System::dimension;

  Krawczyk(const System& system, const ReducedVector<N>& x) : system_(system), x_(x) {
    Box<N> point;
    for (int i = 0; i < N; ++i) point[index(i)] = x[i];
    const auto at = system.linearize(point);
    inverse_ = at.middle().inverse();
    newton_ = preconditioned(at.g);
    for (Interval& d : newton_) d = -d;
  }

  /// x e^D.
  Box<N> stretches(const Box<N>& d) const {
    Box<N> out;
    for (int i = 0; i < N; ++i) out[index(i)] = x_[i] * exp(d[index(i)]);
    return out;
  }

  /// K(D); entire where something is not bounded.
  Box<N> operator()(const Box<N>& d) const {
    const auto over = system_.linearize(stretches(d));
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

  /// The stretches with |d_i| <= radius_i, if the test shows exactly one solution among them.
  std::optional<Box<N>> unique(const ReducedVector<N>& radius) const {
    Box<N> d;
    for (int i = 0; i < N; ++i) d[index(i)] = {-radius[i], radius[i]};
    return maps_inside((*this)(d), d) ? std::optional(stretches(d)) : std::nullopt;
  }

  /// The same around everything x is within a relative error of: |x_i/y_i - 1| <= error < 1/5 is
  /// |d_i| <= -ln(1 - error) < 1.25 error.
  std::optional<Box<N>> unique_within(double error) const {
    if (!(error < 0.2)) return std::nullopt;
    return unique(ReducedVector<N>::Constant(widened(error)));
  }

  /// Widens D from the Newton step until the test succeeds.
  Proof<N> prove() const {
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

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  Box<N> preconditioned(const Box<N>& g) const {
    Box<N> out;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) out[index(i)] += inverse_(i, j) * g[index(j)];
    return out;
  }

  static double widened(double radius) { return 1.25 * radius + 0x1p-60; }

  static bool maps_inside(const Box<N>& image, const Box<N>& d) {
    for (int i = 0; i < N; ++i)
      if (!image[index(i)].inside(d[index(i)])) return false;
    return true;
  }

  Proof<N> proof(const Box<N>& d, Box<N> image) const {
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

  const System& system_;
  ReducedVector<N> x_;
  decltype(std::declval<System>().linearize(Box<N>{}).middle().inverse()) inverse_;
  Box<N> newton_;
};

}  // namespace stationary
