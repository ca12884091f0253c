// The family with alpha = 0 about a material axis that sheared and oblique families branch off, as far
// as they ask for it: where it turns away from the axis, which is where Turn's value is 0
// (oriented_stability.hpp). And what every family of an anisotropic body has at one parameter.
#pragma once

#include <memory>
#include <optional>

#include "solver/family/oriented_events.hpp"
#include "solver/motion/family.hpp"
#include "solver/motion/oriented_stability.hpp"

namespace stationary {

struct OrientedSetting {
  Body body;
  std::shared_ptr<const OrientedModels> models;
  double nu;
};

/// The setting of a family at each value of its parameter.
class OrientedSettings {
 public:
  OrientedSettings(const Body& body, const AnisotropicPotential& potential,
                   const AxisFamilyOptions& options)
      : body_(body),
        models_(std::make_shared<const OrientedModels>(potential)),
        nu_(options.nu),
        parameter_(options.parameter) {}

  OrientedSetting at(double p) const;
  /// Of the parameter, as far as it is one of the potential: of J that of gravity.
  int coefficient_place() const {
    return stationary::coefficient_place(models_->potential, parameter_);
  }
  VariedSpin varied() const {
    return {models_->potential, body_, nu_, parameter_, coefficient_place()};
  }

  /// As the case has them, whatever the parameter is.
  const Body& body() const { return body_; }
  const OrientedModels& models() const { return *models_; }

 private:
  Body body_;
  std::shared_ptr<const OrientedModels> models_;
  double nu_;
  FamilyParameter parameter_;
  /// Where a coefficient is followed, those of its last value.
  mutable std::shared_ptr<const OrientedModels> varied_;
  mutable double varied_at_ = 0.0;
};

/// At alpha = 0; V_aa: V's second derivative in alpha at q.
Turn turn_at(const OrientedSetting& at, Branch branch, double V_aa, const Stretch& q);

class ShearFreeFamily {
 public:
  struct TurningPoint {
    ReducedVector<3> x;  ///< xi, zeta, rho
    ReducedVector<3> tail;
    double parameter;
    double error_bound;
  };

  /// settings outlive it.
  ShearFreeFamily(const OrientedSettings& settings, Branch branch)
      : settings_(&settings), branch_(branch) {}

  Branch branch() const { return branch_; }

  /// Near x and p, by the equations of the event alone.
  std::optional<ExtendedEvent<3>> located(const ReducedVector<3>& x, double p) const;
  /// The nearest by the turn's sign along the family, then by its equations; nothing where the sign
  /// does not change, or the family ends.
  std::optional<TurningPoint> turning_point(const ReducedVector<3>& near, double p) const;

 private:
  struct Point {
    ReducedVector<3> x;
    double turn;
    double error_bound;
  };
  std::optional<Point> point(const ReducedVector<3>& near, double p) const;

  const OrientedSettings* settings_;
  Branch branch_;
};

}  // namespace stationary
