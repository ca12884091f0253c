// All curves of a region, by branch and prune over (x, q): a box of it is
//
//   empty      where a condition is negative, where some G_i = E_i - q P_i excludes 0 over it, or
//              no q of it is among the E_i/P_i, or where the mean value form G(c) + dG/dy (y - c)
//              cannot vanish, row by row or preconditioned with the inverse of the N columns of
//              dG/dy that move G most over the box; asked for, where some G_i - G_j, by the corners
//              of the box that it is least and largest at, does not;
//   covered    where it lies wholly in one tube (tube_set.hpp): its points are that curve's;
//   narrowed   by that form in those N coordinates, or split where G moves most over it;
//   undecided  where it is as narrow as min_width, or the boxes allowed are used up.
//
// Where a small box is neither, the nearest point of the curve is sought, and its curve followed by
// tubes if it is new. So the curves need not be known before: one that closes upon itself between
// any two nu is found as well. Largest boxes first.
#pragma once

#include <atomic>
#include <vector>

#include "solver/tube/curve_breaks.hpp"

namespace stationary {

struct CoverOptions {
  double min_width = 0x1p-36;
  long max_boxes = 50'000;
  long max_arcs = 50'000;  ///< pieces of curves whose class is asked for
  bool follow = true;      ///< curves that are come upon; else what has any is undecided
  /// What is common to two rows, as a large ln det S is, leaves large boxes open, and not their
  /// difference.
  bool differences = false;
  TubeOptions tube;
  const std::atomic<bool>* stop = nullptr;
};

struct CurveCover {
  std::vector<CurveBreak> breaks;
  /// q at which boxes are left: what is there is not known. Ascending, touching ones merged.
  std::vector<Interval> undecided;
  long boxes = 0;  ///< examined
  long tubes = 0;
  bool interrupted = false;
};

/// tubes: none yet; then all that were proven.
template <int N>
CurveCover cover_curves(const CurveEquations<N>& equations, const CurveRegion<N>& region,
                        const CoverOptions& options, TubeSet<N>& tubes);

template <int N>
CurveCover cover_curves(const CurveEquations<N>& equations, const CurveRegion<N>& region,
                        const CoverOptions& options = {}) {
  TubeSet<N> tubes(equations, region, options.tube);
  return cover_curves(equations, region, options, tubes);
}

}  // namespace stationary
