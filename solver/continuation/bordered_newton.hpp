// Newton's method across a border, from a predicted point back onto a curve G(y) = 0 in y = (ln x, p/scale):
//
//   [ dG/dy    ]           [ G ]
//   [ border^T ] delta = - [ 0 ]     nonsingular at a simple turn of p
//
// The last column of the inverse is the kernel of dG/dy, the curve's tangent. Every path that is followed is corrected
// here and accepted by the one rule of jump_guard.hpp: the first correction small, the next ones contracting.
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>

#include "lib/matrix/elimination.hpp"
#include "solver/continuation/hermite_arc.hpp"
#include "solver/continuation/jump_guard.hpp"

namespace stationary {

enum class CorrectorStatus {
  converged,
  not_finite,     ///< G or its derivatives left the domain
  too_far,        ///< the first correction is too large for the step
  slow,           ///< the corrections do not contract as Newton's should
  not_converged,  ///< too many corrections
  left_curve      ///< the last correction moved far: not the point corrected so far
};
constexpr std::string_view corrector_status_names[] = {
    "converged",
    "left the domain",
    "the first correction was too large for the step",
    "the corrections did not contract",
    "too many corrections",
    "the last correction led elsewhere"};
constexpr std::string_view name(CorrectorStatus s) {
  return corrector_status_names[static_cast<int>(s)];
}

/// [dG/dy; border^T] and its inverse, of which no more is computed than is asked for: NaN where it
/// is singular.
template <int N>
class BorderedInverse {
 public:
  BorderedInverse() = default;
  /// slope: dG/d(p/scale).
  BorderedInverse(const Eigen::Matrix<double, N, N>& jacobian, const ReducedVector<N>& slope,
                  const ArcVector<N>& border) {
    Matrix A;
    A.template topLeftCorner<N, N>() = jacobian;
    A.template topRightCorner<N, 1>() = slope;
    A.row(N) = border.transpose();
    if constexpr (by_elimination) {
      parts_ = Elimination<N + 1>(A);
      determinant_ = parts_.determinant();
    } else {
      bool invertible = false;
      A.computeInverseAndDetWithCheck(parts_, determinant_, invertible, 0.0);
    }
  }

  /// The correction of y where the residual is g.
  ArcVector<N> correction(const ReducedVector<N>& g) const {
    ArcVector<N> right = ArcVector<N>::Zero();
    right.template head<N>() = -g;
    return solution(right);
  }
  /// y that a residual of this size in each row may be off by, at most.
  ArcVector<N> largest(const ReducedVector<N>& g) const {
    return inverse().template leftCols<N>().cwiseAbs() * g;
  }
  /// The largest sum of magnitudes in a row of what takes G to y.
  double rows() const {
    return inverse().template leftCols<N>().cwiseAbs().rowwise().sum().maxCoeff();
  }
  /// Of dG/dy, on the border's side.
  ArcVector<N> kernel() const {
    if constexpr (by_elimination) {
      return solution(ArcVector<N>::Unit(N));
    } else {
      return inverse().col(N);
    }
  }
  /// Of the matrix's determinant: with the tangent as border one sign all along a sheet.
  bool positive() const { return determinant_ > 0.0; }

 private:
  using Matrix = Eigen::Matrix<double, N + 1, N + 1>;
  /// Where there are four rows or more: the cofactors of a body that is far stiffer in volume than
  /// in shape cancel twice.
  static constexpr bool by_elimination = N >= 3;
  static constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

  bool singular() const { return !(std::abs(determinant_) > 0.0); }
  ArcVector<N> solution(const ArcVector<N>& right) const {
    if (singular()) return ArcVector<N>::Constant(not_a_number);
    if constexpr (by_elimination) {
      return parts_.template solution<1>(right);
    } else {
      return parts_ * right;
    }
  }
  Matrix inverse() const {
    if (singular()) return Matrix::Constant(not_a_number);
    if constexpr (by_elimination) {
      return parts_.inverse();
    } else {
      return parts_;
    }
  }

  std::conditional_t<by_elimination, Elimination<N + 1>, Matrix> parts_;  ///< else its inverse
  double determinant_ = 0.0;
};

/// What the corrections showed.
template <int N>
struct NewtonCourse {
  CorrectorStatus status = CorrectorStatus::not_converged;
  double first_correction = 0.0;  ///< length in y
  int linearizations = 0;
  BorderedInverse<N> last;  ///< at the point the last correction started from
};

/// The next after one as short is at rounding.
constexpr double last_correction = 1e-7;

/// linearize() gives g, jacobian = dG/d ln x and slope = dG/d(p/scale) where the point is now, move(delta) moves it.
/// max_correction: of the first, see longest_first_correction().
template <int N, class Linearize, class Move>
NewtonCourse<N> bordered_newton(const ArcVector<N>& border, double max_correction,
                                const Linearize& linearize, const Move& move) {
  constexpr int max_iterations = 8;
  NewtonCourse<N> out;
  double previous = 0.0;
  for (int k = 0; k < max_iterations; ++k) {
    const auto at = linearize();
    ++out.linearizations;
    out.last = BorderedInverse<N>(at.jacobian, at.slope, border);
    const ArcVector<N> delta = out.last.correction(at.g);
    const double size = delta.norm();
    if (!std::isfinite(size)) {
      out.status = CorrectorStatus::not_finite;
      return out;
    }
    if (k == 0) {
      out.first_correction = size;
      if (size > max_correction) {
        out.status = CorrectorStatus::too_far;
        return out;
      }
    } else if (!contracts(size, previous)) {
      out.status = CorrectorStatus::slow;
      return out;
    }
    move(delta);
    previous = size;
    if (size <= last_correction) {
      out.status = CorrectorStatus::converged;
      return out;
    }
  }
  return out;
}

}  // namespace stationary
