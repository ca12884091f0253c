// From a predicted y = (ln x, p/scale) back onto the curve G(x; p) = 0 of a family, in the plane across a given
// direction (bordered_newton.hpp); then, p fixed at the double it has come to, the extended-precision correction every solve ends in
// (refine.hpp). At a turn of p itself, or where p has an asymptote, where that is singular, the
// bordered system once more, with the extended residual.
//
// The sign of the bordered determinant and the tangent are handed to the caller to compare.
#pragma once

#include <limits>
#include <optional>

#include "lib/matrix/elimination.hpp"
#include "lib/number/elementary.hpp"
#include "solver/continuation/bordered_newton.hpp"
#include "solver/continuation/circle_part.hpp"

namespace stationary {

template <int N>
struct Corrected {
  CorrectorStatus status = CorrectorStatus::not_finite;
  ArcPoint<N> point;
  ArcVector<N> correction;        ///< all of it, in y
  double first_correction = 0.0;  ///< length in y
  int linearizations = 0;
};

/// What Newton's method has G from. In doubles its rounding may be much: of bodies that are far longer than
/// thick, or far stiffer in volume than in shape.
enum class ResidualIn { doubles, pairs };

/// log(1 + x), of a small x by its series.
inline double logarithm_of_one_and(double x) {
  return std::abs(x) < 0x1p-18 ? x - 0.5 * x * x : log1p(x);
}

/// x with A x = 0 by its cofactors, which change sign with A and never with a normalization.
template <int N>
ArcVector<N> kernel_by_cofactors(const Eigen::Matrix<double, N, N + 1>& A) {
  ArcVector<N> out;
  Eigen::Matrix<double, N, N> minor;
  for (int k = 0; k <= N; ++k) {
    for (int j = 0, column = 0; j <= N; ++j)
      if (j != k) minor.col(column++) = A.col(j);
    out[k] = ((N - k) % 2 == 0 ? 1.0 : -1.0) * determinant<N>(minor);
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
                       double max_correction, ResidualIn residual = ResidualIn::doubles) const {
    Corrected<N> out = iterated(x, p, border, max_correction, residual);
    if (out.status == CorrectorStatus::converged) finish(border, out);
    return out;
  }

  /// As correct(), but p stays what the bordered system makes it: no tangent, no error bound.
  Corrected<N> correct_freely(const ReducedVector<N>& x, double p, const ArcVector<N>& border,
                              double max_correction) const {
    Corrected<N> out = iterated(x, p, border, max_correction);
    if (out.status == CorrectorStatus::converged) correct_onto_curve(border, out);
    return out;
  }

  /// The direction of the curve near x, p: the kernel of [dG/d ln x  scale dG/dp].
  ArcVector<N> direction_near(const ReducedVector<N>& x, double p) const {
    return direction_of(linearize(x, p));
  }
  ArcVector<N> direction_of(const FamilySlopes<N>& at) const {
    Eigen::Matrix<double, N, N + 1> A;
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
    keep_to_circle<N>(circle_, at, family_->volume_row());
    return at;
  }

  /// |change of y| that half a unit in the last place of every input makes: across the curve, and
  /// along it where x is that of the row's rounded p.
  double curve_error(const ArcPoint<N>& point) const {
    const double across = inverse(point.slopes, point.tangent)
                              .largest(family_->input_perturbation(point.x, point.p))
                              .maxCoeff();
    const double along =
        point.at_turn ? 0.0 : 0x1p-53 * std::abs(point.p / (scale_ * point.tangent[N]));
    return across + along + 0x1p-53;
  }

  /// What of a correction is the rounding of G in double precision: some units of its magnitude.
  double correction_rounding(const ArcPoint<N>& point) const {
    return rounding_of(inverse(point.slopes, point.tangent));
  }

 private:
  BorderedInverse<N> inverse(const FamilySlopes<N>& at, const ArcVector<N>& border) const {
    return BorderedInverse<N>(at.jacobian, scale_ * at.slope, border);
  }

  void move(ArcVector<N> delta, Corrected<N>& out) const {
    make_equal(circle_, delta);
    out.point.x = moved<N>(out.point.x, ReducedVector<N>(delta.template head<N>()));
    out.point.p += scale_ * delta[N];
    out.correction += delta;
  }

  /// By Newton's method from x, p; where that failed by corrections that G's rounding may be, once more without
  /// it.
  Corrected<N> iterated(const ReducedVector<N>& x, double p, const ArcVector<N>& border,
                        double max_correction, ResidualIn residual = ResidualIn::doubles) const {
    Corrected<N> out;
    out.point.x = x;
    out.point.p = p;
    out.correction.setZero();
    const auto scaled = [&] {
      FamilyLinearization<N> at = linearize(out.point.x, out.point.p);
      if (residual == ResidualIn::pairs) at.g = extended_residual(out.point.x, out.point.p);
      at.slope *= scale_;
      return at;
    };
    const NewtonCourse<N> course = bordered_newton<N>(
        border, max_correction, scaled, [&](const ArcVector<N>& delta) { move(delta, out); });
    out.first_correction = course.first_correction;
    out.linearizations += course.linearizations;
    out.status = course.status;
    if (residual == ResidualIn::pairs || !may_be_rounding(course)) return out;
    Corrected<N> again = iterated(x, p, border, max_correction, ResidualIn::pairs);
    again.linearizations += out.linearizations;
    return again;
  }

  /// Whether corrections failed that may be nothing else.
  static bool may_be_rounding(const NewtonCourse<N>& course) {
    switch (course.status) {
      case CorrectorStatus::slow:
        return rounding_of(course.last) > contracted;
      case CorrectorStatus::too_far:
        return rounding_of(course.last) > 0.1 * course.first_correction;
      default:
        return false;
    }
  }
  static double rounding_of(const BorderedInverse<N>& inverse) { return 0x1p-50 * inverse.rows(); }

  /// G at a point as the rows of linearize() have it, but for its rounding.
  ReducedVector<N> extended_residual(const ReducedVector<N>& x, double p) const {
    ReducedVector<N> g = family_->extended_residual(x, p);
    make_rows_equal(circle_, family_->volume_row(), g);
    return g;
  }

  /// Whether Newton's method at a fixed p came to the point it began at: where p turns it may go far by small
  /// steps, and to another.
  static bool is_near(const ReducedVector<N>& from, const ReducedVector<N>& to,
                      const Refined& refined) {
    if (!refined.converged || !(refined.first_correction < 1e-3)) return false;
    const double most = 4.0 * refined.first_correction + 0x1p-40;
    for (int i = 0; i < N; ++i)
      if (!(std::abs(to[i] - from[i]) <= most * std::abs(from[i]))) return false;
    return true;
  }

  /// The extended-precision correction, tangent and orientation: by the slopes that the correction was
  /// made with where these are the point's too.
  void finish(const ArcVector<N>& ahead, Corrected<N>& out) const {
    ArcPoint<N>& point = out.point;
    ReducedVector<N> x = point.x;
    Refined refined;
    std::optional<FamilySlopes<N>> slopes;
    if (!pinned_) refined = family_->refine_with_slopes(x, point.tail, point.p, slopes);
    if (pinned_) {
      correct_onto_curve(ahead, out);
      point.p = *pinned_;
      point.tail.setZero();
    } else if (is_near(point.x, x, refined)) {
      if (circle_ != Circle::none) {
        const auto [a, b, c] = places(circle_);
        x[b] = x[a];
        point.tail[b] = point.tail[a];
      }
      // Near an asymptote the rounding of p is a move along the curve.
      for (int i = 0; i < N; ++i)
        out.correction[i] += logarithm_of_one_and((x[i] - point.x[i]) / point.x[i]);
      point.x = x;
      point.error_bound = refined.error_bound;
    } else {
      point.tail.setConstant(std::numeric_limits<double>::quiet_NaN());
      correct_at_turn(ahead, out);
      slopes.reset();
    }
    if (slopes) {
      keep_to_circle<N>(circle_, *slopes, family_->volume_row());
      point.slopes = *slopes;
      point.slopes_error = refined.last_change;
    } else {
      point.slopes = linearize(point.x, point.p);
      ++out.linearizations;
    }
    const BorderedInverse<N> at_end = inverse(point.slopes, ahead);
    point.tangent = at_end.kernel();
    make_equal(circle_, point.tangent);
    if (pinned_) point.tangent[N] = 0.0;
    point.tangent.normalize();
    point.positive = at_end.positive();
    if (!point.tangent.allFinite()) out.status = CorrectorStatus::not_finite;
    if (pinned_) point.error_bound = curve_error(point);
  }

  /// Two bordered corrections with the extended residual; p is what it comes to.
  void correct_onto_curve(const ArcVector<N>& border, Corrected<N>& out) const {
    out.point.at_turn = true;
    for (int k = 0; k < 2; ++k) {
      const FamilyLinearization<N> at = linearize(out.point.x, out.point.p);
      const ArcVector<N> delta =
          inverse(at, border).correction(extended_residual(out.point.x, out.point.p));
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
    const BorderedInverse<N> inverted = inverse(at, along);
    const ArcVector<N> moved_by =
        inverted.largest(family_->input_perturbation(out.point.x, out.point.p));
    const double across = moved_by.template head<N>().maxCoeff();
    const double D = moved_by[N] + 0x1p-53 * std::abs(out.point.p) / scale_;
    // In double, with its rounding.
    const double rounding = rounding_of(inverted);
    const ArcVector<N> kernel = inverted.kernel();
    const double slope = std::abs(kernel[N] / kernel.norm());
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
    const ArcVector<N> tangent = inverse(at, along).kernel();
    return tangent[N] / tangent.norm();
  }

  const Family<N>* family_;
  double scale_;
  Circle circle_;
  std::optional<double> pinned_;
};

}  // namespace stationary
