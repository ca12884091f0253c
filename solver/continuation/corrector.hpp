// From a predicted y = (ln x, p/scale) back onto the curve G(x; p) = 0, in the plane across a given
// direction (the border):
//
//   [ dG/d ln x   scale dG/dp ] [ d ln x     ]     [ G ]
//   [        border^T         ] [ dp / scale ] = - [ 0 ]     nonsingular at a simple turn of p
//
// then, p fixed at the double it has come to, the extended-precision correction every solve ends in
// (refine.hpp). At a turn of p itself, or where p has an asymptote, where that is singular, the
// bordered system once more, with the extended residual.
//
// Nothing is accepted that a jump to another sheet could have produced: the first correction must
// be small against the step, the corrections must contract, and the sign of the bordered
// determinant and the angle between tangents are handed to the caller to compare.
#pragma once

#include <Eigen/LU>
#include <limits>
#include <optional>

#include "lib/matrix/elimination.hpp"
#include "lib/number/elementary.hpp"
#include "solver/continuation/hermite_arc.hpp"
#include "solver/continuation/jump_guard.hpp"

namespace stationary {

enum class CorrectorStatus {
  converged,
  not_finite,     ///< G or its derivatives left the domain
  too_far,        ///< the first correction is too large for the step
  slow,           ///< the corrections do not contract as Newton's should
  not_converged,  ///< max_iterations
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

template <int N>
struct Corrected {
  CorrectorStatus status = CorrectorStatus::not_finite;
  ArcPoint<N> point;
  ArcVector<N> correction;        ///< all of it, in y
  double first_correction = 0.0;  ///< length in y
  int linearizations = 0;
};

/// x with A x = 0 by its cofactors, which change sign with A and never with a normalization.
template <int N>
ArcVector<N> kernel_by_cofactors(const Eigen::Matrix<double, N, N + 1>& A) {
  ArcVector<N> out;
  Eigen::Matrix<double, N, N> minor;
  for (int k = 0; k <= N; ++k) {
    for (int j = 0, column = 0; j <= N; ++j)
      if (j != k) minor.col(column++) = A.col(j);
    out[k] = ((N - k) % 2 == 0 ? 1.0 : -1.0) * minor.determinant();
  }
  return out;
}

template <int N>
class Corrector {
 public:
  /// circle: the curve stays in it (xi = zeta, say); where ellipses branch off, G is singular along
  /// the difference of the two, which a curve of circles has no part in.
  /// pinned: the one p of a vertical curve, which every point of it gets.
  Corrector(const Family<N>& family, double scale, Circle circle,
            std::optional<double> pinned = std::nullopt)
      : family_(&family), scale_(scale), circle_(circle), pinned_(pinned) {}

  double scale() const { return scale_; }
  Circle circle() const { return circle_; }
  bool vertical() const { return pinned_.has_value(); }

  /// max_correction: bound of the first correction, in y.
  Corrected<N> correct(const ReducedVector<N>& x, double p, const ArcVector<N>& border,
                       double max_correction) const {
    Corrected<N> out;
    out.point.x = x;
    out.point.p = p;
    out.correction.setZero();
    out.status = iterate(border, max_correction, out);
    if (out.status == CorrectorStatus::converged) finish(border, out);
    return out;
  }

  /// As correct(), but p stays what the bordered system makes it: no tangent, no error bound.
  Corrected<N> correct_freely(const ReducedVector<N>& x, double p, const ArcVector<N>& border,
                              double max_correction) const {
    Corrected<N> out;
    out.point.x = x;
    out.point.p = p;
    out.correction.setZero();
    out.status = iterate(border, max_correction, out);
    if (out.status == CorrectorStatus::converged) correct_onto_curve(border, out);
    return out;
  }

  /// The direction of the curve near x, p: the kernel of [dG/d ln x  scale dG/dp].
  ArcVector<N> direction_near(const ReducedVector<N>& x, double p) const {
    Eigen::Matrix<double, N, N + 1> A;
    const FamilyLinearization<N> at = linearize(x, p);
    A.template leftCols<N>() = at.jacobian;
    A.col(N) = scale_ * at.slope;
    return kernel_by_cofactors<N>(A).normalized();
  }

  /// At a fixed p, from a near x; oriented along `ahead`.
  Corrected<N> correct_at(const ReducedVector<N>& x, double p, const ArcVector<N>& ahead) const {
    Corrected<N> out;
    out.point.x = x;
    out.point.p = p;
    out.correction.setZero();
    out.status = CorrectorStatus::converged;
    finish(ahead, out);
    return out;
  }

  FamilyLinearization<N> linearize(const ReducedVector<N>& x, double p) const {
    FamilyLinearization<N> at = family_->linearize(x, p);
    if (circle_ != Circle::none) keep_to_circle(at);
    return at;
  }

  /// |change of y| that half a unit in the last place of every input makes: across the curve, and
  /// along it where x is that of the row's rounded p.
  double curve_error(const ArcPoint<N>& point) const {
    const Bordered inverse = inverted(bordered(point.at, point.tangent));
    const ReducedVector<N> perturbation = family_->input_perturbation(point.x, point.p);
    const double across = (inverse.template leftCols<N>().cwiseAbs() * perturbation).maxCoeff();
    const double along =
        point.at_turn ? 0.0 : 0x1p-53 * std::abs(point.p / (scale_ * point.tangent[N]));
    return across + along + 0x1p-53;
  }

  /// What of a correction is the rounding of G in double precision: some units of its magnitude.
  double correction_rounding(const ArcPoint<N>& point) const {
    const Bordered inverse = inverted(bordered(point.at, point.tangent));
    return 0x1p-50 * inverse.template leftCols<N>().cwiseAbs().rowwise().sum().maxCoeff();
  }

 private:
  using Bordered = Eigen::Matrix<double, N + 1, N + 1>;

  Bordered bordered(const FamilyLinearization<N>& at, const ArcVector<N>& border) const {
    Bordered A;
    A.template topLeftCorner<N, N>() = at.jacobian;
    A.template topRightCorner<N, 1>() = scale_ * at.slope;
    A.row(N) = border.transpose();
    return A;
  }

  /// By elimination where there are four or more: the cofactors of a body that is far stiffer in
  /// volume than in shape cancel twice.
  static Bordered inverted(const Bordered& A) {
    if constexpr (N < 3) {
      return A.inverse();
    } else {
      return Elimination<N + 1>(A).inverse();
    }
  }

  /// G restricted to the circle, the difference of the two stretches given the eigenvalue 1.
  void keep_to_circle(FamilyLinearization<N>& at) const {
    auto& J = at.jacobian;
    const auto [a, b, c] = places(circle_);
    const double along = 0.5 * (J(a, a) + J(a, b) + J(b, a) + J(b, b));
    J(a, a) = J(b, b) = 0.5 * (along + 1.0);
    J(a, b) = J(b, a) = 0.5 * (along - 1.0);
    if constexpr (N == 3) {
      J(a, c) = J(b, c) = 0.5 * (J(a, c) + J(b, c));
      J(c, a) = J(c, b) = 0.5 * (J(c, a) + J(c, b));
    }
    for (auto* column : {&at.g, &at.slope, &at.nu_slope}) make_equal(*column);
  }
  /// Of a vector in (ln x[, p]) or of G, the part that keeps the circle.
  template <class Vector>
  void make_equal(Vector& y) const {
    const auto [a, b, c] = places(circle_);
    y[a] = y[b] = 0.5 * (y[a] + y[b]);
  }

  void move(ArcVector<N> delta, Corrected<N>& out) const {
    symmetrize(delta);
    out.point.x = moved<N>(out.point.x, ReducedVector<N>(delta.template head<N>()));
    out.point.p += scale_ * delta[N];
    out.correction += delta;
  }

  /// Rounding must not leave the circle: the predictor would make it grow.
  void symmetrize(ArcVector<N>& y) const {
    if (circle_ != Circle::none) make_equal(y);
  }

  CorrectorStatus iterate(const ArcVector<N>& border, double max_correction,
                          Corrected<N>& out) const {
    constexpr int max_iterations = 8;
    double previous = 0.0;
    for (int k = 0; k < max_iterations; ++k) {
      const FamilyLinearization<N> at = linearize(out.point.x, out.point.p);
      ++out.linearizations;
      const ArcVector<N> delta = inverted(bordered(at, border)).template leftCols<N>() * -at.g;
      const double size = delta.norm();
      if (!std::isfinite(size)) return CorrectorStatus::not_finite;
      if (k == 0) {
        out.first_correction = size;
        if (size > max_correction) return CorrectorStatus::too_far;
      } else if (!contracts(size, previous)) {
        return CorrectorStatus::slow;
      }
      move(delta, out);
      previous = size;
      if (size <= 1e-7) return CorrectorStatus::converged;  // the next is at rounding
    }
    return CorrectorStatus::not_converged;
  }

  /// The extended-precision correction, tangent and orientation.
  void finish(const ArcVector<N>& ahead, Corrected<N>& out) const {
    ArcPoint<N>& point = out.point;
    ReducedVector<N> x = point.x;
    Refined refined;
    if (!pinned_) refined = family_->refine_at(x, point.tail, point.p);
    if (pinned_) {
      correct_onto_curve(ahead, out);
      point.p = *pinned_;
      point.tail.setZero();
    } else if (refined.converged && refined.first_correction < 1e-3) {
      if (circle_ != Circle::none) {
        const auto [a, b, c] = places(circle_);
        x[b] = x[a];
        point.tail[b] = point.tail[a];
      }
      // Near an asymptote the rounding of p is a move along the curve.
      for (int i = 0; i < N; ++i) out.correction[i] += log1p((x[i] - point.x[i]) / point.x[i]);
      point.x = x;
      point.error_bound = refined.error_bound;
    } else {
      point.tail.setConstant(std::numeric_limits<double>::quiet_NaN());
      correct_at_turn(ahead, out);
    }
    point.at = linearize(point.x, point.p);
    ++out.linearizations;
    const Bordered A = bordered(point.at, ahead);
    Bordered inverse = Bordered::Zero();
    double determinant = 0.0;
    bool invertible = false;
    if constexpr (N < 3) {
      A.computeInverseAndDetWithCheck(inverse, determinant, invertible, 0.0);
    } else {
      const Elimination<N + 1> lu(A);
      determinant = lu.determinant();
      invertible = determinant != 0.0;
      inverse = lu.inverse();
    }
    point.tangent = inverse.col(N);
    symmetrize(point.tangent);
    if (pinned_) point.tangent[N] = 0.0;
    point.tangent.normalize();
    point.positive = determinant > 0.0;
    if (!invertible || !point.tangent.allFinite()) out.status = CorrectorStatus::not_finite;
    if (pinned_) point.error_bound = curve_error(point);
  }

  /// Two bordered corrections with the extended residual; p is what it comes to.
  void correct_onto_curve(const ArcVector<N>& border, Corrected<N>& out) const {
    out.point.at_turn = true;
    for (int k = 0; k < 2; ++k) {
      const FamilyLinearization<N> at = linearize(out.point.x, out.point.p);
      ReducedVector<N> g = family_->extended_residual(out.point.x, out.point.p);
      if (circle_ != Circle::none) make_equal(g);
      const ArcVector<N> delta = inverted(bordered(at, border)).template leftCols<N>() * -g;
      if (!(delta.norm() < 1e-3)) {
        out.status = CorrectorStatus::left_curve;
        return;
      }
      move(delta, out);
    }
  }

  /// Where p hardly changes along the curve. The bound is that of x at the row's p: half a unit of
  /// p and what the inputs may do to it, D, is a distance s along the curve,
  ///   a turn:        |p''| s^2/2 = |p'| s + D   about the square root of D,
  ///   an asymptote:  |p'| s = D                  without bound where a double does not resolve p.
  void correct_at_turn(const ArcVector<N>& border, Corrected<N>& out) const {
    correct_onto_curve(border, out);
    out.point.error_bound = std::numeric_limits<double>::infinity();
    const ArcVector<N> along = direction_near(out.point.x, out.point.p);
    if (!along.allFinite()) return;
    const FamilyLinearization<N> at = linearize(out.point.x, out.point.p);
    const Bordered inverse = inverted(bordered(at, along));
    const auto absolute = inverse.template leftCols<N>().cwiseAbs().eval();
    const ArcVector<N> moved_by = absolute * family_->input_perturbation(out.point.x, out.point.p);
    const double across = moved_by.template head<N>().maxCoeff();
    const double D = moved_by[N] + 0x1p-53 * std::abs(out.point.p) / scale_;
    // In double, with its rounding.
    const double rounding = 0x1p-50 * absolute.rowwise().sum().maxCoeff();
    const double slope = std::abs(inverse(N, N) / inverse.col(N).norm());
    constexpr double h = 1e-3;
    const double bend = std::abs(slope_at(out, along, h) - slope_at(out, along, -h)) / (2.0 * h);
    double s = std::numeric_limits<double>::infinity();
    if (bend > 8.0 * rounding / h) {
      const double steep = slope + rounding;
      s = 2.0 * (steep + std::sqrt(steep * steep + bend * D)) / bend;  // p'' may be half as large
      if (s > 10.0 * h) s = std::numeric_limits<double>::infinity();
    }
    if (const double left = slope - rounding; left > 0.0) {
      const double straight = 2.0 * D / left;
      if (straight * bend < 0.5 * left && straight < s) s = straight;
    }
    out.point.error_bound = across + s + 0x1p-53;
  }

  /// dp/ds of the curve at a distance along it.
  double slope_at(const Corrected<N>& out, const ArcVector<N>& along, double distance) const {
    const ReducedVector<N> x =
        moved<N>(out.point.x, ReducedVector<N>(distance * along.template head<N>()));
    const FamilyLinearization<N> at = linearize(x, out.point.p + distance * scale_ * along[N]);
    const ArcVector<N> tangent = inverted(bordered(at, along)).col(N);
    return tangent[N] / tangent.norm();
  }

  const Family<N>* family_;
  double scale_;
  Circle circle_;
  std::optional<double> pinned_;
};

}  // namespace stationary
