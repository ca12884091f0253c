// Motions of a family at many values of its parameter p, on a curve that was followed once: between
// two rows p is met on the cubic through both with their tangents (hermite_arc.hpp), and from there
// the family's correction at p leads onto the curve.
#pragma once

#include <algorithm>
#include <atomic>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "lib/matrix/elementwise.hpp"
#include "solver/continuation/corrector.hpp"
#include "solver/family/follow_sheet.hpp"

namespace stationary {

/// How far the cubic between two rows may be off, in (ln x, p over the scale).
constexpr double curve_tolerance = 1e-7;

template <int N>
struct CurveRow {
  ReducedVector<N> x;
  double p;
};

/// The rows of a sheet in its family's coordinates.
template <int N>
class CoordinateRows final : public CurveSink {
 public:
  explicit CoordinateRows(const Family<N>& family) : family_(family) {}

  void row(const Member& member, EventType) override {
    rows_.push_back({family_.coordinates(member.q, member.parameter), member.parameter});
  }
  const std::vector<CurveRow<N>>& rows() const { return rows_; }

 private:
  const Family<N>& family_;
  std::vector<CurveRow<N>> rows_;
};

/// Points of a walk to a motion. A longer one creeps along an end of its sheet; the search finds
/// what is beyond it.
constexpr long longest_walk = 10'000;

/// What a sheet is followed with whose rows are to be gone between; turns of p are rows too.
inline FollowOptions curve_options(double from, double to, const std::atomic<bool>* stop) {
  FollowOptions out;
  out.continuation.from = from;
  out.continuation.to = to;
  out.continuation.step.tolerance = curve_tolerance;
  out.events = EventSet::none().add(EventType::fold_nu).add(EventType::fold_parameter);
  out.max_points = longest_walk;
  out.stop = stop;
  return out;
}

template <int N>
class CurvePoints {
 public:
  /// A place on the curve between two rows.
  struct Near {
    std::size_t row;  ///< the later of the two
    double p;
    ReducedVector<N> x;
    double steepness;  ///< of x against p over the scale, along the curve
    bool positive;     ///< det dG/d ln x there
  };

  /// scale: of p, as the rows were followed with it. The family must outlive this.
  CurvePoints(const Family<N>& family, std::vector<CurveRow<N>> rows, double scale)
      : family_(family), rows_(std::move(rows)), scale_(scale) {}

  const std::vector<CurveRow<N>>& rows() const { return rows_; }

  /// p: between row - 1 and row, or one of theirs.
  Near near(std::size_t row, double p) {
    if (arc_row_ != row) enter(row);
    const CurveRow<N>& a = rows_[row - 1];
    const CurveRow<N>& b = rows_[row];
    const auto ahead = [&](double u) { return (a.p - p) + scale_ * arc_.at(u)[N]; };
    double u = std::abs(p - a.p) < std::abs(p - b.p) ? 0.0 : 1.0;
    if (p != a.p && p != b.p && ahead(0.0) * ahead(1.0) < 0.0) {
      std::uintmax_t evaluations = 60;
      const auto [low, high] = boost::math::tools::toms748_solve(
          ahead, 0.0, 1.0, boost::math::tools::eps_tolerance<double>(52), evaluations);
      u = 0.5 * (low + high);
    }
    return {.row = row,
            .p = p,
            .x = u == 0.0   ? a.x
                 : u == 1.0 ? b.x
                            : moved<N>(a.x, ReducedVector<N>(arc_.at(u).template head<N>())),
            .steepness = 1.0 / std::max(std::abs(arc_.direction(u)[N]), 1e-3),
            .positive = positive_};
  }

  /// Whether what a correction came to is at its place on the curve. positive: det dG/d ln x there.
  static bool stays(const Near& near, const ReducedVector<N>& x, bool positive) {
    // At this p, and not across the curve: the steeper the curve the farther.
    constexpr double few = 8.0;
    const double moved_by = ((x - near.x).array() / near.x.array()).abs().maxCoeff();
    return positive == near.positive && moved_by <= few * curve_tolerance * near.steepness;
  }

 private:
  void enter(std::size_t row) {
    const Corrector<N> corrector(family_, scale_, Circle::none);
    const CurveRow<N>& a = rows_[row - 1];
    const CurveRow<N>& b = rows_[row];
    ArcVector<N> chord;
    chord.template head<N>() = logarithms(b.x.array() / a.x.array()).matrix();
    chord[N] = (b.p - a.p) / scale_;
    double largest = 0.0;
    const auto ahead = [&](const CurveRow<N>& at) {
      const FamilyLinearization<N> here = corrector.linearize(at.x, at.p);
      // At a turn of p it is zero, and rounding has given it its sign.
      const double determinant = here.jacobian.determinant();
      if (std::abs(determinant) >= largest) positive_ = determinant > 0.0;
      largest = std::max(largest, std::abs(determinant));
      const ArcVector<N> along = corrector.direction_of(here);
      return along.dot(chord) < 0.0 ? ArcVector<N>(-along) : along;
    };
    const ArcVector<N> leaving = ahead(a);
    arc_ = Arc<N>(chord, leaving, ahead(b));
    arc_row_ = row;
  }

  const Family<N>& family_;
  std::vector<CurveRow<N>> rows_;
  double scale_;
  Arc<N> arc_;
  std::size_t arc_row_ = 0;  ///< the row that it ends at; 0: none yet
  bool positive_ = true;
};

}  // namespace stationary
