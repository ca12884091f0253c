#include "solver/tube/curve_cover.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <deque>

namespace stationary {
namespace {

constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Around a point where curves cross boxes are not halved further than to this.
constexpr double at_crossing = 0x1p-16;

template <int N>
class Cover {
 public:
  Cover(const CurveEquations<N>& equations, const CurveRegion<N>& region,
        const CoverOptions& options, TubeSet<N>& tubes)
      : equations_(equations), region_(region), options_(options), tubes_(tubes) {}

  CurveCover run() {
    queue_.push_back(region_.hull());
    while (!queue_.empty()) {
      if (stopped()) break;
      if (out_.boxes >= options_.max_boxes) {
        for (const CurveBox<N>& each : queue_) out_.undecided.push_back(each[at(N)]);
        break;
      }
      const CurveBox<N> box = queue_.front();
      queue_.pop_front();
      examine(box);
    }
    out_.undecided = merged(std::move(out_.undecided));
    if (!stopped()) out_.breaks = curve_breaks(equations_, region_, tubes_, options_.stop);
    out_.interrupted = stopped();
    out_.tubes = static_cast<long>(tubes_.tubes().size());
    return std::move(out_);
  }

 private:
  bool stopped() const {
    return options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed);
  }
  static double width(const CurveBox<N>& box) {
    double out = 0.0;
    for (const Interval& side : box) out = std::max(out, side.hi - side.lo);
    return out;
  }

  void examine(CurveBox<N> box) {
    ++out_.boxes;
    constexpr int passes = 8;
    CurveLinearized<N> over;
    for (int pass = 0; pass < passes; ++pass) {
      for (const Interval& each : equations_.conditions(box))
        if (each.negative()) return;
      if (equations_.excludes(box)) return;
      if (pass == 0 && !equations_.contract(box)) return;
      if (tubes_.holds(box)) return;
      if (!solve_for_q(box)) return;
      over = equations_.linearize(box);
      for (const Interval& g : over.g)
        if (!g.may_be(0.0)) return;
      if (options_.differences && rows_differ(over, box)) return;
      double kept = 1.0;
      if (!narrow(over, box, kept)) return;
      if (kept > 0.75) break;
    }
    if (tubes_.holds(box)) return;
    if (width(box) < at_crossing && near_stuck(middle_of<N>(box), at_crossing)) {
      out_.undecided.push_back(box[at(N)]);
      return;
    }
    constexpr double small = 0.25;
    if (options_.follow && width(box) < small && begins_curve(box) && tubes_.holds(box)) return;
    split(box, over);
  }

  /// Whether some G_i - G_j has one sign: where a slope of it has one, at the end of that side that
  /// it is nearest to zero at, along the others by their mean value form.
  bool rows_differ(const CurveLinearized<N>& over, const CurveBox<N>& box) const {
    for (std::size_t i = 0; i + 1 < at(N); ++i)
      for (std::size_t j = i + 1; j < at(N); ++j) {
        CurveBox<N> least = box;
        CurveBox<N> most = box;
        Interval along;
        for (std::size_t k = 0; k < box.size(); ++k) {
          const Interval slope = over.slope[i][k] - over.slope[j][k];
          const Interval low(box[k].lo);
          const Interval high(box[k].hi);
          if (slope.lo >= 0.0 || slope.hi <= 0.0) {
            least[k] = slope.lo >= 0.0 ? low : high;
            most[k] = slope.lo >= 0.0 ? high : low;
          } else {
            least[k] = most[k] = Interval(box[k].mid());
            along += slope * (box[k] - least[k]);
          }
        }
        if (!along.bounded()) continue;
        const auto difference = [&](const CurveBox<N>& corner) {
          const auto g = equations_.forces(corner).g;
          return g[i] - g[j] + along;
        };
        if (difference(least).positive() || difference(most).negative()) return true;
      }
    return false;
  }

  /// G = E - q P: each row bounds q by the ranges of E and P. False where nothing is left.
  bool solve_for_q(CurveBox<N>& box) const {
    CurveBox<N> at_rest = box;
    at_rest[at(N)] = 0.0;
    const CurveForces<N> elastic = equations_.forces(at_rest);
    Interval& q = box[at(N)];
    for (int i = 0; i < N; ++i) {
      const Interval solved = -elastic.g[at(i)] / elastic.by_q[at(i)];
      if (!solved.bounded()) continue;
      if (solved.apart_from(q)) return false;
      q = common(q, solved);
    }
    return true;
  }

  /// False where nothing is left of the box. kept: the smallest fraction left of a side.
  bool narrow(const CurveLinearized<N>& over, CurveBox<N>& box, double& kept) const {
    using Square = Eigen::Matrix<double, N, N>;
    const TubePoint<N> center = middle_of<N>(box);
    const auto g = equations_.forces(point_box<N>(center)).g;
    CurveBox<N> offset;
    for (int j = 0; j <= N; ++j) offset[at(j)] = box[at(j)] - Interval(center[j]);
    // Row by row first: where the box is large Y says little.
    for (int i = 0; i < N; ++i) {
      IntervalSum row(g[at(i)]);
      for (int j = 0; j <= N; ++j) row.add_product(over.slope[at(i)][at(j)], offset[at(j)]);
      if (!row.value().may_be(0.0)) return false;
    }
    Eigen::Matrix<double, N, N + 1> slopes;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j <= N; ++j) {
        const Interval& side = box[at(j)];
        slopes(i, j) = over.slope[at(i)][at(j)].mid() * (side.hi - side.lo);
      }
    if (!std::isfinite(slopes.sum())) return true;
    // The columns that move G most.
    const Eigen::FullPivLU<Eigen::Matrix<double, N, N + 1>> lu(slopes);
    std::array<int, at(N)> pivot;
    for (int i = 0; i < N; ++i) pivot[at(i)] = lu.permutationQ().indices()[i];
    Square chosen;
    for (int i = 0; i < N; ++i)
      for (int j = 0; j < N; ++j) chosen(i, j) = over.slope[at(i)][at(pivot[at(j)])].mid();
    const Square Y = chosen.inverse();
    if (!std::isfinite(Y.sum())) return true;
    for (int i = 0; i < N; ++i) {
      const int own = pivot[at(i)];
      const auto entry = [&](int j) {
        IntervalSum out;
        for (int k = 0; k < N; ++k) out.add_product(Y(i, k), over.slope[at(k)][at(j)]);
        return out.value();
      };
      const Interval slope = entry(own);
      IntervalSum all_others;
      for (int k = 0; k < N; ++k) all_others.add_product(Y(i, k), g[at(k)]);
      for (int j = 0; j <= N; ++j)
        if (j != own) all_others.add_product(entry(j), offset[at(j)]);
      const Interval others = all_others.value();
      const Interval sum = others + slope * offset[at(own)];
      if (sum.positive() || sum.negative()) return false;
      if (slope.may_be(0.0) || !slope.bounded()) continue;
      const Interval solved = Interval(center[own]) - others / slope;
      if (!solved.bounded()) continue;
      Interval& side = box[at(own)];
      if (solved.apart_from(side)) return false;
      const double before = side.hi - side.lo;
      side = common(side, solved);
      kept = std::min(kept, (side.hi - side.lo) / before);
      offset[at(own)] = side - Interval(center[own]);
    }
    return true;
  }

  /// A chain of tubes ends unproven at a distance below this, as beside a point where curves cross.
  bool near_stuck(const TubePoint<N>& y, double distance) const {
    return std::ranges::any_of(tubes_.stuck(), [&](const TubePoint<N>& each) {
      return (y - each).cwiseAbs().maxCoeff() < distance;
    });
  }

  /// A curve not known yet passes near the box, and now is followed.
  bool begins_curve(const CurveBox<N>& box) {
    const TubePoint<N> middle = middle_of<N>(box);
    const auto y = corrected_point(equations_, middle);
    if (!y) return false;
    // Farther off it is another box's.
    const double near = 4.0 * width(box);
    if (!((*y - middle).cwiseAbs().maxCoeff() < near)) return false;
    // It would end there again.
    constexpr double beside = 0x1p-10;
    return !near_stuck(*y, beside) && tubes_.follow(*y);
  }

  /// Across the coordinate that moves some G_i most over the box, as a part of all that moves it.
  std::size_t coordinate_to_split(const CurveBox<N>& box, const CurveLinearized<N>& over) const {
    std::array<double, at(N + 1)> moved{};
    for (const CurveBox<N>& row : over.slope) {
      std::array<double, at(N + 1)> by;
      double sum = 0.0;
      for (std::size_t j = 0; j < by.size(); ++j) {
        by[j] = row[j].magnitude() * (box[j].hi - box[j].lo);
        sum += by[j];
      }
      for (std::size_t j = 0; j < by.size(); ++j) moved[j] = std::max(moved[j], by[j] / sum);
    }
    std::size_t most = 0;
    std::size_t widest = 0;
    for (std::size_t j = 1; j < box.size(); ++j) {
      if (moved[j] > moved[most]) most = j;
      if (box[j].hi - box[j].lo > box[widest].hi - box[widest].lo) widest = j;
    }
    const bool splits = std::isfinite(moved[most]) && moved[most] > 0.0 &&
                        box[most].hi - box[most].lo > options_.min_width;
    return splits ? most : widest;
  }

  void split(const CurveBox<N>& box, const CurveLinearized<N>& over) {
    const std::size_t chosen = coordinate_to_split(box, over);
    const Interval side = box[chosen];
    const double cut = side.mid();
    if (!(side.hi - side.lo > options_.min_width) || !(side.lo < cut && cut < side.hi)) {
      out_.undecided.push_back(box[at(N)]);
      return;
    }
    CurveBox<N> half = box;
    half[chosen] = {side.lo, cut};
    queue_.push_back(half);
    half[chosen] = {cut, side.hi};
    queue_.push_back(half);
  }

  const CurveEquations<N>& equations_;
  const CurveRegion<N>& region_;
  CoverOptions options_;
  TubeSet<N>& tubes_;
  std::deque<CurveBox<N>> queue_;
  CurveCover out_;
};

}  // namespace

template <int N>
CurveCover cover_curves(const CurveEquations<N>& equations, const CurveRegion<N>& region,
                        const CoverOptions& options, TubeSet<N>& tubes) {
  return Cover<N>(equations, region, options, tubes).run();
}

#define STATIONARY_COVER(N)                                                            \
  template CurveCover cover_curves<N>(const CurveEquations<N>&, const CurveRegion<N>&, \
                                      const CoverOptions&, TubeSet<N>&);
STATIONARY_COVER(1)
STATIONARY_COVER(2)
STATIONARY_COVER(3)
STATIONARY_COVER(4)
#undef STATIONARY_COVER

}  // namespace stationary
