// How many motions of one kind there are at each nu of a range, and of which classes, proven: its
// curves are covered (curve_cover.hpp), their breaks and what is undecided divide the range, and
// between two of these the number of motions is constant; between two class gaps (class_gaps.hpp) the
// class of each. What they are, a search at one nu in between says.
#pragma once

#include <optional>
#include <vector>

#include "solver/motion/problem.hpp"
#include "solver/search/search.hpp"
#include "solver/tube/class_gaps.hpp"

namespace stationary {

struct CoverOptions;
struct CurveFactor;

/// A part of the range at which the number of motions is not told: an interval of nu, and why.
struct NuGap {
  Interval nu;
  bool turns = false;      ///< sheets turn there: all of them are known
  bool crosses = false;    ///< a sheet leaves the box: likewise
  bool ends = false;       ///< a sheet ends in the box: likewise
  bool mirrors = false;    ///< ellipses part from circles: likewise
  bool undecided = false;  ///< not covered
};

struct KindCover {
  std::vector<NuGap> gaps;  ///< ascending, apart from each other
  /// Where the class of a motion is not proven, and may change. Ascending, apart from each other.
  /// Nothing where classes were not asked for.
  std::optional<std::vector<Interval>> class_gaps;
  long boxes = 0;
  long class_arcs = 0;  ///< whose class was asked for
  long tubes = 0;
  bool interrupted = false;
};

/// factors: of the kind (axis_curves.hpp), with nu_end = to. class_over: none where classes are not
/// asked for.
KindCover cover_kind(const std::vector<CurveFactor>& factors, double to,
                     const CoverOptions& options, const ClassOver& class_over);

/// Of an isotropic body's spins about the problem's axis, 0 <= from < to.
KindCover cover_axis(const Problem& problem, double from, double to, const SearchOptions& options,
                     bool classes = true);

/// Of its motions about an axis tilted in the plane.
KindCover cover_tilted(const Body& body, const Potential& potential, TiltPlane plane, double from,
                       double to, const SearchOptions& options, bool classes = true);

/// Whether it is proven that no motion of these, at any nu of the range, has a stretch outside the box,
/// between 10^-50 and 10^50.
bool none_outside(const Problem& problem, double from, double to, const SearchOptions& options);

/// Of a body that need not be isotropic (oriented_curves.hpp); nothing of five unknowns.
std::optional<KindCover> cover_oriented(const Problem& problem, bool oblique, double from,
                                        double to, const SearchOptions& options,
                                        bool classes = true);

}  // namespace stationary
