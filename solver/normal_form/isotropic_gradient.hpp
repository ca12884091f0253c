// The gradient, in x = ln (xi, zeta, rho) and an angle s, of the reduced energy of an isotropic body
// about an event (reduction.hpp),
//
//   F = V - |nu|^2 n.I n/2,   n = cos(phi + s) e_a + sin(phi + s) e_b,
//   F_s = |nu|^2 sin(phi + s) cos(phi + s) (m_b - m_a),   m_k = J_k x_k^2,  I_k = sum m - m_k,
//
// of a spin about a material axis a (phi = 0, s no unknown), or of a tilted axis between a and axis 3.
// At given |pi| it is that of V + |pi|^2/(2 n.I n). Where the volume is held, rho in I is C/(xi zeta)
// (held_volume.hpp).
#pragma once

#include <array>

#include "lib/body/circle.hpp"
#include "solver/motion/problem.hpp"
#include "solver/motion/varied_balance.hpp"
#include "solver/normal_form/reduction.hpp"

namespace stationary {

/// What is varied as p: the family's parameter, or |pi|, nu = |pi|/I following it.
enum class Varied { parameter, momentum };

/// Places of the axis among the material ones, and its direction.
struct NearAxis {
  std::size_t own;
  std::size_t other;
  Interval cosine = 1.0;
  Interval sine = 0.0;
  bool turns = false;  ///< s is an unknown, the fourth

  static NearAxis along(Branch branch);
  /// Of a member of a tilted family in |nu|.
  static NearAxis tilted(const Body& body, const Potential& potential, TiltPlane plane,
                         const Member& member);
};

class IsotropicGradient {
 public:
  /// circle: one that the stretches are on.
  IsotropicGradient(const Body& body, const Potential& potential, const FamilyParameter& parameter,
                    const NearAxis& axis, Circle circle, const Member& member,
                    Varied varied = Varied::parameter);

  std::size_t dimension() const { return axis_.turns ? 4 : 3; }
  std::vector<AlongLine> operator()(const IntervalVector& d, double c) const;
  /// F_vv of that angle, where s is no unknown: |nu|^2 (m_b - m_a).
  AlongLine turning(const IntervalVector& d, double c) const;

 private:
  /// The numbers of the problem where the parameter is p.
  struct Numbers {
    const Potential& potential;
    FamilyParameter parameter;
    AlongLine p;

    AlongLine operator()(double value, FamilyParameter::Kind kind, int index) const {
      const InputPlace at = input_place(potential, kind, index);
      return varies(parameter, at.kind, at.index) ? p : AlongLine(Interval(value));
    }
  };
  struct State {
    std::array<AlongLine, 3> x;
    Inertia3<AlongLine> J;
    AlongLine cosine;
    AlongLine sine;
    AlongLine nu_squared;
    std::array<AlongLine, 3> moments;  ///< m_k
  };
  Numbers numbers(double c) const;
  State state(const IntervalVector& d, double c) const;

  Body body_;
  Potential potential_;
  FamilyParameter parameter_;
  NearAxis axis_;
  Varied varied_;
  double nu_;
  std::array<Interval, 3> x_;
  NearParameter p_;
};

}  // namespace stationary
