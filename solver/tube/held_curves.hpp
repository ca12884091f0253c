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
    const Interval xi = exp(y[0]);
    const Interval zeta = exp(y[1]);
    const auto b =
        model_.log_balance(xi, zeta, y[2] * rates_.xi, y[2] * rates_.zeta, y[2] * rates_.rho);
    const Interval pull_of_rho = rates_.rho * square(model_.thickness(xi, zeta));
    CurveLinearized<2> out;
    out.g = {b.g_xi, b.g_zeta};
    out.slope[0] = {b.uu, b.uv, pull_of_rho - rates_.xi * square(xi)};
    out.slope[1] = {b.uv, b.vv, pull_of_rho - rates_.zeta * square(zeta)};
    return out;
  }
  CurveForces<2> forces(const CurveBox<2>& y) const override {
    const Interval xi = exp(y[0]);
    const Interval zeta = exp(y[1]);
    const auto b =
        balance_alone(model_, xi, zeta, y[2] * rates_.xi, y[2] * rates_.zeta, y[2] * rates_.rho);
    const Interval pull_of_rho = rates_.rho * square(model_.thickness(xi, zeta));
    return {{b.g_xi, b.g_zeta},
            {pull_of_rho - rates_.xi * square(xi), pull_of_rho - rates_.zeta * square(zeta)}};
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
  HeldPlane<Interval> model_;
  CentrifugalRates<Interval> rates_;
  HeldThickness thickness_;
};

}  // namespace stationary
