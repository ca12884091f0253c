// The motions of an isotropic body, about a material axis or tilted in a plane of two, as curves
// (curve_equations.hpp) in the logarithms of the stretches and q = nu^2/nu_end^2. Of those about an
// axis what separates is taken apart: the plane, the thickness; a motion at nu is one point of each.
// With J1 = J2 in (iii) circles and ellipses are curves of their own (circle_curves.hpp).
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "solver/motion/problem.hpp"
#include "solver/search/search.hpp"
#include "solver/tube/curve_equations.hpp"

namespace stationary {

template <int N>
struct CurveSet {
  std::unique_ptr<CurveEquations<N>> equations;
  CurveRegion<N> region;
};
using AnyCurveSet = std::variant<CurveSet<1>, CurveSet<2>, CurveSet<3>, CurveSet<4>>;

/// Bounds of the coordinates and of q.
template <int N>
CurveSet<N> curve_set(std::unique_ptr<CurveEquations<N>> equations,
                      const std::vector<LogRange>& ranges, const Interval& q) {
  CurveSet<N> out{std::move(equations), {}};
  for (std::size_t k = 0; k < std::size_t(N); ++k) {
    out.region.lower[k] = ranges[k].lower;
    out.region.upper[k] = ranges[k].upper;
  }
  out.region.q = q;
  return out;
}

/// A motion at nu is one point of each factor; a factor's points are those of all its curve sets.
struct CurveFactor {
  std::vector<AnyCurveSet> sets;
};

/// 0 <= from < to; the stretches in the box of the options, with their inputs.
std::vector<CurveFactor> axis_curves(const Problem& problem, double from, double to,
                                     const SearchOptions& options);

/// Those about an axis tilted in the plane (lib/balance/tilted_balance.hpp), nu = |nu|: where one of
/// nu's components vanishes a curve goes on, and motions end.
std::vector<CurveFactor> tilted_curves(const Body& body, const Potential& potential,
                                       TiltPlane plane, double from, double to,
                                       const SearchOptions& options);

LogRange log_range(const Interval& stretch);

/// q of nu in [from, to], nu_end = to.
Interval curve_range(double from, double to);

}  // namespace stationary
