// A family at many nu, one after the other: each solve starts from the last ones.
//
//   predictor  the parabola through the last three points (fewer at first), in nu
//   corrector  refine(): extended-precision residual, one step where the predictor was good
//   guard      a first correction above 1% that is no small part of the last move is not trusted:
//              the step in nu is halved and retried, so a neighbouring sheet is not picked up; nor
//              is a point whose Jacobian has another sign of the determinant: on a sheet that turns
//              in nu nowhere the sign is one (the circle of (iii), J1 = J2, excepted, where
//              ellipses branch off and xi = zeta is kept by symmetry); nor is a move of more than
//              2% whose middle, solved for, does not lie near the middle of its ends: across the
//              gap beyond a fold there is another sheet, if any
//
// After construction nothing allocates, and the potential is looked up once per run(). A sweep
// stays on the sheet it starts on; where that ends, points say not_found.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "solver/motion/problem.hpp"
#include "solver/newton/refine.hpp"
#include "solver/solve/solve.hpp"

namespace stationary {

struct SweepPoint {
  double nu = std::numeric_limits<double>::quiet_NaN();
  double xi = std::numeric_limits<double>::quiet_NaN();
  double zeta = std::numeric_limits<double>::quiet_NaN();
  double rho = std::numeric_limits<double>::quiet_NaN();
  double error_bound = std::numeric_limits<double>::quiet_NaN();  ///< as Equilibrium::error_bound
  int steps = 0;  ///< corrections spent on it (halved steps included)
  SolveStatus status = SolveStatus::not_run;
};

struct SweepOptions {
  bool error_bound = true;  ///< false: left NaN, and nothing is evaluated for it
};

class Sweep {
 public:
  /// start: a solved equilibrium of the same problem (std::invalid_argument otherwise).
  Sweep(const Problem& problem, const Equilibrium& start, const SweepOptions& options = {});

  /// Solves at each nu in order into out (same size; std::invalid_argument otherwise).
  void run(std::span<const double> nu, std::span<SweepPoint> out);

  /// Times rho was solved for: once where the thickness does not depend on nu.
  long thickness_solves() const { return thickness_solves_; }

 private:
  struct Past {
    double nu;
    std::array<double, 3> x;
  };
  template <class Model, bool bound>
  void run_model(const Model& model, std::span<const double> nu, std::span<SweepPoint> out);
  template <class Model, bool bound>
  void reach(const Model& model, double nu, SweepPoint& out);
  template <class Model, bool bound>
  bool attempt(const Model& model, double nu, SweepPoint& out);
  std::array<double, 3> predict(double nu) const;
  bool trusted(const Refined& refined, int unknowns) const;
  /// Whether these lie on the other side of a circle than the sheet, or the last point. xi = zeta needs equal pulls, so
  /// that a sheet without them stays on its side; where J1 and J2 are nearly equal both sides of a pitchfork that has
  /// broken lie within a step. With gravity a sheet passes xi = zeta, but by no more than J1 and J2 differ.
  bool changes_sides(double xi, double zeta) const {
    constexpr double rounding = 0x1p-40;
    if (side_ != 0.0) return (xi - zeta) * side_ < -rounding * xi;
    return std::abs(xi - zeta) > passed_ * xi &&
           (xi - zeta) * (past_[0].x[0] - past_[0].x[1]) < 0.0;
  }
  void watch_side(const Stretch& q, double stiffness);

  Problem problem_;
  SweepOptions options_;
  std::array<Past, 3> past_;  ///< newest first
  int known_ = 1;
  bool circle_ = false;
  bool positive_ = false;  ///< sign of the determinant on this sheet
  double side_ = 0.0;      ///< sign of xi - zeta on this sheet; 0: it may have either, or none
  /// Then how far a step may pass xi = zeta.
  double passed_ = std::numeric_limits<double>::infinity();
  bool constant_rho_known_ = false;
  double constant_rho_bound_ = std::numeric_limits<double>::quiet_NaN();
  long thickness_solves_ = 0;
};

}  // namespace stationary
