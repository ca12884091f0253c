// Families that are made up, so that what continuation must find on their curves is known.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "solver/motion/event.hpp"
#include "solver/motion/family.hpp"

namespace stationary::testing {

/// p = value(ln xi), zeta = 1.
struct Graph {
  std::function<double(double)> value;
  std::function<double(double)> slope;
};

/// A curve that is a graph over ln xi; a refinement at fixed p is refused, as at a turn.
class GraphFamily final : public Family<2> {
 public:
  GraphFamily(Graph graph, double perturbation)
      : graph_(std::move(graph)), perturbation_(perturbation) {}
  Branch branch() const override { return Branch::iii; }
  bool along_nu() const override { return true; }
  bool material_symmetry() const override { return false; }
  FamilyLinearization<2> linearize(const ReducedVector<2>& x, double p) const override {
    FamilyLinearization<2> out;
    const double u = std::log(x[0]);
    out.g << p - graph_.value(u), std::log(x[1]);
    out.jacobian << -graph_.slope(u), 0.0, 0.0, 1.0;
    out.slope << 1.0, 0.0;
    out.nu_slope = out.slope;
    return out;
  }
  Refined refine_at(ReducedVector<2>&, ReducedVector<2>&, double) const override { return {}; }
  ReducedVector<2> extended_residual(const ReducedVector<2>& x, double p) const override {
    return linearize(x, p).g;
  }
  ReducedVector<2> input_perturbation(const ReducedVector<2>&, double) const override {
    return {perturbation_, 0.0};
  }
  Member member(const ReducedVector<2>& x, const ReducedVector<2>&, double p,
                double error_bound) const override {
    Member out;
    out.parameter = out.nu = p;
    out.q = {0.0, x[0], x[1], 1.0};
    out.error_bound = error_bound;
    return out;
  }

 private:
  Graph graph_;
  double perturbation_;
};

/// xi = zeta = e^p, a straight line in y. All that events are found by is given.
struct Line {
  std::function<double(double)> turn = {};         ///< Member::turn
  std::function<double(double)> error_bound = {};  ///< of x
  std::function<std::optional<Spectrum>(double)> spectrum = {};
  std::function<double(double)> condition = {};  ///< > 0 in the domain
  std::optional<double> tilt = std::nullopt;     ///< where its own equations have it
};

class LineFamily final : public Family<2> {
 public:
  explicit LineFamily(Line line) : line_(std::move(line)) {}
  Branch branch() const override { return Branch::iii; }
  bool along_nu() const override { return true; }
  bool material_symmetry() const override { return false; }
  std::vector<ConditionValue> conditions(const ReducedVector<2>&, double p) const override {
    if (!line_.condition) return {};
    return {{&condition_, line_.condition(p)}};
  }
  FamilyLinearization<2> linearize(const ReducedVector<2>& x, double p) const override {
    FamilyLinearization<2> out;
    out.g << std::log(x[0]) - p, std::log(x[1]) - p;
    out.jacobian.setIdentity();
    out.slope << -1.0, -1.0;
    out.nu_slope = out.slope;
    return out;
  }
  Refined refine_at(ReducedVector<2>& x, ReducedVector<2>& tail, double p) const override {
    x.setConstant(std::exp(p));
    tail.setZero();
    Refined out;
    out.converged = true;
    out.first_correction = 0.0;
    out.error_bound = line_.error_bound ? line_.error_bound(p) : 1e-15;
    return out;
  }
  ReducedVector<2> extended_residual(const ReducedVector<2>& x, double p) const override {
    return linearize(x, p).g;
  }
  ReducedVector<2> input_perturbation(const ReducedVector<2>&, double) const override {
    return ReducedVector<2>::Constant(1e-16);
  }
  std::optional<ExtendedEvent<2>> event_at(EventType type, Circle, const Member&) const override {
    if (type != EventType::tilt || !line_.tilt) return std::nullopt;
    const double x = std::exp(*line_.tilt);
    return ExtendedEvent<2>{{x, x}, *line_.tilt, 1e-15, 1e-15};
  }
  Member member(const ReducedVector<2>& x, const ReducedVector<2>&, double p,
                double error_bound) const override {
    Member out;
    out.parameter = out.nu = p;
    // The locked inertias about axes 1 and 3 are equal where e^2p = J3/J1, or nowhere.
    out.body = line_.tilt ? Body(1.0, 40.0, std::exp(2.0 * *line_.tilt)) : Body(1.0, 2.0, 40.0);
    out.angular_velocity = {0.0, 0.0, p};
    out.q = {0.0, x[0], x[1], 1.0};
    out.error_bound = error_bound;
    out.turn = line_.turn ? line_.turn(p) : 1.0;
    if (line_.spectrum) out.spectrum = line_.spectrum(p);
    return out;
  }

 private:
  static inline const expression::TapeCondition condition_{"made up", true};
  Line line_;
};

}  // namespace stationary::testing
