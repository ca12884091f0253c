// The spins about a material axis of a body whose volume is held (held_plane.hpp) as curves in
// (ln xi, ln zeta): rho = C/d, ln rho = ln C - l.
#pragma once

#include <optional>
#include <vector>

#include "lib/material/gravitating/held_plane.hpp"
#include "solver/tube/curve_equations.hpp"

namespace stationary {

/// Where the thickness is wanted that a held volume leaves; nothing where none is held.
struct HeldThickness {
  std::optional<Interval> log_volume;
  LogRange rho;

  /// Positive where it is; l = ln d.
  void add_conditions(const Interval& l, std::vector<Interval>& to) const {
    if (!log_volume) return;
    const Interval log_rho = *log_volume - l;
    to.push_back(log_rho - rho.lower);
    to.push_back(rho.upper - log_rho);
  }
  void place(const AlongCurve& l, PlacedMotions& motions) const {
    if (log_volume) motions.rho = exp(AlongCurve(*log_volume) - l);
  }
};

class HeldCurves final : public CurveEquations<2> {
 public:
  HeldCurves(const HeldPlane<>& model, const CentrifugalRates<Interval>& rates,
             const HeldThickness& thickness, Inputs inputs)
      : model_(interval_model(model, inputs)), rates_(rates), thickness_(thickness) {}

  CurveLinearized<2> linearize(const CurveBox<2>& y) const override {
    const auto [b, by_q] = at<2>(y);
    return {{b.g_xi, b.g_zeta}, {{{b.uu, b.uv, by_q[0]}, {b.uv, b.vv, by_q[1]}}}};
  }
  CurveForces<2> forces(const CurveBox<2>& y) const override {
    const auto [b, by_q] = at<1>(y);
    return {{b.g_xi, b.g_zeta}, by_q};
  }
  std::vector<Interval> conditions(const CurveBox<2>& y) const override {
    std::vector<Interval> out;
    thickness_.add_conditions(y[0] + y[1], out);
    return out;
  }
  bool excludes(const CurveBox<2>& y) const override {
    return defined_nowhere(model_, exp(y[0]), exp(y[1]));
  }
  void place(const CurveCoordinates<2>& y, PlacedMotions& motions) const override {
    motions.xi = exp(y[0]);
    motions.zeta = exp(y[1]);
    thickness_.place(y[0] + y[1], motions);
  }

 private:
  struct Balance {
    LogBalance<Interval> rows;
    Box<2> by_q;
  };
  template <int order>
  Balance at(const CurveBox<2>& y) const {
    const Interval xi = exp(y[0]);
    const Interval zeta = exp(y[1]);
    const Interval pull_of_rho = rates_.rho * square(model_.thickness(xi, zeta));
    return {balance_of<order>(model_, xi, zeta, y[2] * rates_.xi, y[2] * rates_.zeta,
                              y[2] * rates_.rho),
            {pull_of_rho - rates_.xi * square(xi), pull_of_rho - rates_.zeta * square(zeta)}};
  }

  HeldPlane<Interval> model_;
  CentrifugalRates<Interval> rates_;
  HeldThickness thickness_;
};

}  // namespace stationary
