// Where the events of a tilted family lie: the balance of a tilted axis (tilted_balance.hpp) and what
// vanishes at the event, three equations in (xi, zeta, |nu|), in any number type:
//
//   fold               det dG/d ln x
//   momentum           det of that bordered by dG/d ln |nu| and d ln I
//   inertia            J1 xi^2 - J2 zeta^2
//   in_plane, normal   one of the squares of nu's components: an end of the family
//   shear              W_t: motions with alpha != 0 begin, their axis in no plane
#pragma once

#include "solver/motion/event.hpp"
#include "solver/motion/event_equations.hpp"
#include "solver/motion/event_functions.hpp"
#include "solver/motion/varied_balance.hpp"

namespace stationary {

class TiltedEventSystem {
 public:
  static constexpr int dimension = 3;
  enum class Kind { fold, momentum, inertia, in_plane, normal, shear };

  TiltedEventSystem(const Body& body, const Potential& potential, TiltPlane plane, Kind kind)
      : J_{body.J1, body.J2, body.J3}, plane_(plane), kind_(kind), elastic_(potential, {}) {}

  std::size_t inputs() const { return J_.size() + elastic_.inputs(); }
  bool has_decimals() const { return elastic_.has_decimals(); }

  ExtendedVector<3> values(const ExtendedVector<3>& y, const InputChange& change) const {
    const Inertia3<DoubleDouble> J{change(J_[0], 0), change(J_[1], 1), change(J_[2], 2)};
    const DoubleDouble square_nu = square(y[2]);
    return equations(kind_, J, y,
                     elastic_.tilted(plane_, J, y[0], y[1], square_nu, change.from(3)));
  }
  std::array<Conditioned, 3> conditioned(const std::array<Conditioned, 3>& y, bool exact) const {
    const auto number = [&](double x) { return exact ? Conditioned(x) : Conditioned::input(x); };
    const Inertia3<Conditioned> J{number(J_[0]), number(J_[1]), number(J_[2])};
    const Conditioned square_nu = square(y[2]);
    return equations(kind_, J, y, elastic_.tilted(plane_, J, y[0], y[1], square_nu, exact));
  }

  /// parts: at y.
  template <class T>
  static std::array<T, 3> equations(Kind kind, const Inertia3<T>& J, const std::array<T, 3>& y,
                                    const TiltedParts<T>& parts) {
    const LogBalance<T>& at = parts.balance;
    const T m_xi = J.J1 * square(y[0]);
    const T m_zeta = J.J2 * square(y[1]);
    const SquareArray<T, 2> jacobian{{{at.uu, at.uv}, {at.uv, at.vv}}};
    const auto vanishing = [&]() -> T {
      switch (kind) {
        case Kind::fold:
          return determinant(jacobian);
        case Kind::inertia:
          return m_zeta - m_xi;
        case Kind::momentum:
          return momentum_turn(jacobian, {-2.0 * parts.pull[0], -2.0 * parts.pull[1]},
                               {2.0 * m_xi, 2.0 * m_zeta}, T(m_xi + m_zeta));
        case Kind::in_plane:
          return parts.squares.in_plane;
        case Kind::shear:
          return parts.trace_force;
        default:
          return parts.squares.normal;
      }
    };
    return {at.g_xi, at.g_zeta, vanishing()};
  }

 private:
  std::array<double, 3> J_;
  TiltPlane plane_;
  Kind kind_;
  VariedElastic elastic_;
};

/// The test functions of a tilted family.
KindEvents tilted_events();

/// What vanishes at an event of this type near a located member; nothing where there are no
/// equations for it.
std::optional<TiltedEventSystem::Kind> vanishing_at(EventType type, const Member& near);

}  // namespace stationary
