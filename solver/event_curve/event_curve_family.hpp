// The events of one type as a family in the second parameter (family.hpp), with the unknowns
//
//   x = (xi, zeta, rho, |p1|, ...),
//
// those of the event's equations (event_equations.hpp), whose signs are those of the event it starts
// at. The slopes are central differences of values in extended precision, h = 2^-27, and as accurate
// as a double.
#pragma once

#include <vector>

#include "solver/event_curve/event_curve_system.hpp"

namespace stationary {

template <int N>
class EventCurveFamily final : public Family<N> {
 public:
  static constexpr int first = ExtendedEventEquations<N>::parameter;  ///< the place of p1 in x
  using X = ReducedVector<N>;

  /// scale: of p2, as of its range.
  EventCurveFamily(EventCurveSystem<N> system, double scale);

  const EventCurveSystem<N>& system() const { return system_; }

  Branch branch() const override { return system_.branch; }
  bool along_nu() const override { return false; }
  bool material_symmetry() const override { return false; }
  KindEvents events() const override;
  SpinInertia<N> spin_inertia(const Member&) const override { return {1.0, X::Zero()}; }
  /// Of the event it starts at, and of no other.
  X coordinates(const Stretch& q, double p) const override;
  std::vector<ConditionValue> conditions(const X& x, double p) const override;

  FamilyLinearization<N> linearize(const X& x, double p) const override;
  Refined refine_at(X& x, X& tail, double p) const override;
  X extended_residual(const X& x, double p) const override;
  X input_perturbation(const X& x, double p) const override;
  /// The stretches alone.
  Member member(const X& x, const X& tail, double p, double error_bound) const override;

  X signed_unknowns(const X& x) const { return sign_.cwiseProduct(x); }
  double first_parameter(const X& x) const { return sign_[first] * x[first]; }

 private:
  ExtendedVector<N> unknowns(const X& x) const;
  /// dG/d ln x and one over the size of each of its rows, p2 held.
  struct Slopes {
    Eigen::Matrix<double, N, N> jacobian;
    X scale;
  };
  Slopes slopes(const ExtendedVector<N>& y, double p) const;

  EventCurveSystem<N> system_;
  double scale_;
  X start_;
  X sign_;
};

extern template class EventCurveFamily<5>;
extern template class EventCurveFamily<6>;

}  // namespace stationary
