// A kind of motion as the curves of
//
//   G(y) = 0,   N equations in y = (x_1, ..., x_N, q),   nu^2 = q nu_end^2,
//
// x a chart of the stretches (mostly their logarithms, else what the curves are regular in). G is
// linear in nu^2, and in it curves are smooth down to rest. That is all that tubes and covers know of a kind; whatever it is,
// they are the same code, for a virtual call is nothing beside an evaluation over a box.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "lib/number/dual.hpp"
#include "solver/proof/box_balance.hpp"

namespace stationary {

/// Intervals of x_1, ..., x_N and q.
template <int N>
using CurveBox = Box<N + 1>;

template <int N>
using TubePoint = Eigen::Matrix<double, N + 1, 1>;

/// Over a place: every G(y) and every dG/dy, y in it, whatever values the inputs have in theirs.
template <int N>
struct CurveLinearized {
  Box<N> g;
  std::array<CurveBox<N>, static_cast<std::size_t>(N)> slope;  ///< rows
};

/// Likewise G(y) and dG/dq alone.
template <int N>
struct CurveForces {
  Box<N> g;
  Box<N> by_q;
};

/// A model's balance; of order 1 without slopes, where it can leave them out.
template <int order, class Model, class... Arguments>
auto balance_of(const Model& model, const Arguments&... arguments) {
  if constexpr (requires { model.template log_balance<order>(arguments...); }) {
    return model.template log_balance<order>(arguments...);
  } else {
    return model.log_balance(arguments...);
  }
}

/// A number along a piece of a curve: its range and that of its slope.
using AlongCurve = Dual<Interval, 1>;

template <int N>
using CurveCoordinates = std::array<AlongCurve, static_cast<std::size_t>(N + 1)>;

/// The motions of a piece of a curve, without their nu.
struct PlacedMotions {
  AlongCurve xi;
  AlongCurve zeta;
  AlongCurve rho;
  AlongCurve alpha;
  std::array<AlongCurve, 2> axis;  ///< oblique: nu/|nu| along axes 1 and 2
  bool circle = false;             ///< xi = zeta exactly, about axis 3
  bool has_slopes = true;          ///< else ranges alone
};

/// Ascending; those that touch as one.
inline std::vector<Interval> merged(std::vector<Interval> all) {
  std::ranges::sort(all, {}, &Interval::lo);
  std::vector<Interval> out;
  for (const Interval& each : all) {
    if (out.empty() || each.lo > out.back().hi) {
      out.push_back(each);
    } else {
      out.back().hi = std::max(out.back().hi, each.hi);
    }
  }
  return out;
}

/// nu of q, outward.
inline Interval nu_of(const Interval& q, double nu_end) {
  const Interval bounded(std::max(q.lo, 0.0), std::min(std::max(q.hi, 0.0), 1.0));
  const Interval out = Interval(nu_end) * sqrt(bounded);
  return {std::max(out.lo, 0.0), std::min(out.hi, nu_end)};
}

template <int N>
class CurveEquations {
 public:
  static constexpr int dimension = N;

  CurveEquations() = default;
  CurveEquations(const CurveEquations&) = delete;
  CurveEquations& operator=(const CurveEquations&) = delete;
  virtual ~CurveEquations() = default;

  virtual CurveLinearized<N> linearize(const CurveBox<N>& y) const = 0;
  virtual CurveForces<N> forces(const CurveBox<N>& y) const {
    const CurveLinearized<N> all = linearize(y);
    CurveForces<N> out{all.g, {}};
    for (std::size_t i = 0; i < out.g.size(); ++i)
      out.by_q[i] = all.slope[i][static_cast<std::size_t>(N)];
    return out;
  }

  /// Functions of y that are positive at the solutions sought, beside the sides of a region: over a
  /// place, where they need to hold at solutions only.
  virtual std::vector<Interval> conditions(const CurveBox<N>&) const { return {}; }
  /// How many of them, the first, are those of the motions: where one changes its sign motions end. The
  /// others are sides of a box.
  virtual std::size_t ends() const { return 0; }
  /// No solution there by more than G and its slopes.
  virtual bool excludes(const CurveBox<N>&) const { return false; }
  /// Narrows a place likewise; false where nothing is left.
  virtual bool contract(CurveBox<N>&) const { return true; }
  /// Adds what coordinates along a curve tell of its motions. Nothing of curves that are no motions'.
  virtual void place(const CurveCoordinates<N>&, PlacedMotions&) const {}
};

/// Bounds of the logarithm of a stretch, as enclosures.
struct LogRange {
  Interval lower;
  Interval upper;
};

/// Where curves are wanted: bounds of each x, as enclosures, and the range of q.
template <int N>
struct CurveRegion {
  Box<N> lower;
  Box<N> upper;
  Interval q;
  /// A coordinate in which curves are even, pass 0 into their mirror images and are wanted from 0 on.
  std::optional<std::size_t> mirror = {};

  /// Holds all of it.
  CurveBox<N> hull() const {
    CurveBox<N> out;
    for (std::size_t i = 0; i < std::size_t(N); ++i) out[i] = {lower[i].lo, upper[i].hi};
    out[std::size_t(N)] = q;
    return out;
  }
};

/// Whether points of a curve are in the region and fulfil the conditions.
enum class Within { all, none, unclear };

template <int N>
Within within_region(const CurveEquations<N>& equations, const CurveRegion<N>& region,
                     const CurveBox<N>& y) {
  if (y[std::size_t(N)].apart_from(region.q)) return Within::none;
  bool all = true;
  const auto require = [&](const Interval& positive) {
    all = all && positive.positive();
    return !positive.negative();
  };
  for (std::size_t i = 0; i < std::size_t(N); ++i)
    if (!require(y[i] - region.lower[i]) || !require(region.upper[i] - y[i])) return Within::none;
  for (const Interval& each : equations.conditions(y))
    if (!require(each)) return Within::none;
  return all ? Within::all : Within::unclear;
}

}  // namespace stationary
