#include "lib/leaf/circle_momentum.hpp"

#include <cmath>

#include "lib/matrix/hessenberg.hpp"

namespace stationary {
namespace {

constexpr std::size_t size = 10;
using Form = Square<double, size>;

Form momentum_form() {
  Form P{};
  const auto set = [&](std::size_t i, std::size_t j, double value) { P[i][j] = P[j][i] = value; };
  set(0, 0, -1.0);
  set(5, 5, -1.0);
  set(2, 6, 1.0);
  set(3, 6, -1.0);
  set(1, 7, -2.0);
  set(1, 8, 2.0);
  return P;
}

/// x with x^T F x = curvature <= 0, found where Cholesky's factorization ends; curvature > 0 where
/// it does not.
struct CurvedDirection {
  std::array<double, size> x{};
  double curvature = 1.0;
};

CurvedDirection least_direction(Form F) {
  CurvedDirection out;
  Form multiplier;
  for (std::size_t k = 0; k < size; ++k) {
    if (!(F[k][k] > 0.0)) {
      out.curvature = F[k][k];
      out.x[k] = 1.0;
      for (std::size_t j = k; j-- > 0;)
        for (std::size_t i = j + 1; i <= k; ++i) out.x[j] -= multiplier[i][j] * out.x[i];
      return out;
    }
    for (std::size_t i = k + 1; i < size; ++i) {
      multiplier[i][k] = F[i][k] / F[k][k];
      for (std::size_t j = k + 1; j <= i; ++j)
        F[i][j] = F[j][i] = F[i][j] - multiplier[i][k] * F[j][k];
    }
  }
  return out;
}

}  // namespace

bool definite_with_momentum(const Leaf& leaf, double u) {
  const Form P = momentum_form();
  // x^T (E'' + c P) x is linear in c: a direction in which it is not positive cuts off all c on its
  // side.
  double low = -HUGE_VAL;
  double high = HUGE_VAL;
  double c = 0.0;
  constexpr int most = 200;
  for (int pass = 0; pass < most; ++pass) {
    Form F;
    for (std::size_t i = 0; i < size; ++i) {
      double spread = 0.0;
      for (std::size_t j = 0; j < size; ++j) {
        F[i][j] = leading(leaf.second_variation[i][j]) + c * P[i][j];
        spread += leaf.magnitude[i][j] + std::abs(c * P[i][j]);
      }
      constexpr double rounding = 2.0 * size * 0x1p-53;
      F[i][i] -= u * spread + rounding * std::abs(F[i][i]);
    }
    const CurvedDirection at = least_direction(F);
    if (at.curvature > 0.0) return true;
    double slope = 0.0;
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) slope += at.x[i] * P[i][j] * at.x[j];
    if (slope > 0.0) {
      low = std::fmax(low, c - at.curvature / slope);
    } else if (slope < 0.0) {
      high = std::fmin(high, c - at.curvature / slope);
    } else {
      return false;
    }
    if (!(low < high)) return false;
    const double next = std::isinf(high)  ? 2.0 * low + 1.0
                        : std::isinf(low) ? 2.0 * high - 1.0
                                          : 0.5 * (low + high);
    if (next == c || next == low || next == high) return false;
    c = next;
  }
  return false;
}

}  // namespace stationary
