// Where the events of a family of a potential that is not isotropic lie (anisotropic_family.hpp): the
// balance in the family's coordinates and what vanishes at the event, equations in x and the
// parameter, in any number type; and the test functions whose signs give the events away.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "lib/body/inertia.hpp"
#include "lib/number/elementary.hpp"
#include "lib/number/interval_functions.hpp"
#include "solver/motion/event.hpp"
#include "solver/motion/event_equations.hpp"
#include "solver/motion/event_functions.hpp"
#include "solver/motion/family_parameter.hpp"
#include "solver/motion/oriented_system.hpp"

namespace stationary {

/// Of the coefficient that the parameter is, among all of the potential; of nu none, of J the one of
/// gravity or none: -1.
inline int coefficient_place(const AnisotropicPotential& V, const FamilyParameter& parameter) {
  using Kind = FamilyParameter::Kind;
  switch (parameter.kind) {
    case Kind::nu:
      return -1;
    case Kind::inertia:  // that of its gravity
      return V.body().gravitates ? V.gravity_place() + 1 + parameter.index : -1;
    case Kind::thickness:
      return V.thickness_place() + parameter.index;
    case Kind::fibre:
      return V.fibre_place() + parameter.index;
    default:
      break;
  }
  // Of the body's own as the others' (body_model.hpp).
  if (parameter.index == static_cast<int>(BodyModel<>::g_place)) return V.gravity_place();
  if (parameter.index == static_cast<int>(BodyModel<>::volume_place)) return V.volume_place();
  return parameter.index;
}

/// The coefficients of a potential in T, in their order: the parameter p, the others by `number`.
template <class T, class Number>
struct VariedCoefficients {
  int varied;  ///< place of the parameter; -1: none of them
  T p;
  Number number;
  mutable int next = 0;

  T operator()(double c) const {
    const int k = next++;
    return k == varied ? p : number(c, static_cast<std::size_t>(k));
  }
  Direction<T> direction(double degrees) const {
    const T angle = (*this)(degrees);
    if constexpr (requires { angle.value.lo; }) {
      return over_box(angle);
    } else {
      return near_middle(angle);
    }
  }

 private:
  static Direction<T> over_box(const T& degrees) {
    const double near = leading(degrees);
    const Direction<Interval> at =
        direction_interval(near, (degrees.value - Interval(near)).magnitude());
    const Interval per_degree = interval_half_pi / Interval(90.0);
    Direction<T> out{T(at.cosine), T(at.sine)};
    for (std::size_t k = 0; k < degrees.slope.size(); ++k) {
      out.cosine.slope[k] = -(at.sine * (per_degree * degrees.slope[k]));
      out.sine.slope[k] = at.cosine * (per_degree * degrees.slope[k]);
    }
    return out;
  }
  static Direction<T> near_middle(const T& degrees) {
    const double near = leading(degrees);
    const Direction<DoubleDouble> at = stationary::direction(near);
    const T rest = (degrees - near) * (std::numbers::pi / 180.0);
    if constexpr (std::is_same_v<T, Conditioned>) {
      const double spread = rest.condition;
      const double cosine = double(at.cosine);
      const double sine = double(at.sine);
      return {{cosine, std::abs(sine) * spread}, {sine, std::abs(cosine) * spread}};
    } else {
      const T bend = 1.0 - 0.5 * square(rest);
      return {at.cosine * bend - at.sine * rest, at.sine * bend + at.cosine * rest};
    }
  }
};

/// A spinning body of which one number, the parameter, is an unknown.
class VariedSpin {
 public:
  using Kind = FamilyParameter::Kind;

  /// place: of the coefficient that varies.
  VariedSpin(const AnisotropicPotential& potential, const Body& body, double nu,
             const FamilyParameter& parameter, int place)
      : potential_(&potential),
        J_{body.J1, body.J2, body.J3},
        nu_(nu),
        parameter_(parameter),
        place_(place) {}

  std::size_t inputs() const {
    return 4 + static_cast<std::size_t>(potential_->coefficient_count());
  }
  bool has_decimals() const { return potential_->model().has_decimals(); }

  template <class T>
  struct Numbers {
    Inertia3<T> J;
    T nu;
    AnisotropicModel<T> model;
  };
  /// p: the parameter. number(value, k): any other, J, nu and the coefficients in this order.
  template <class T, class Number>
  Numbers<T> at(const T& p, const Number& number) const {
    const auto inertia = [&](int k) {
      const bool varied = parameter_.kind == Kind::inertia && parameter_.index == k;
      const auto at = static_cast<std::size_t>(k);
      return varied ? p : number(J_[at], at);
    };
    const Inertia3<T> J{inertia(0), inertia(1), inertia(2)};
    const T nu = parameter_.kind == Kind::nu ? p : number(nu_, 3);
    const auto coefficient = [&](double c, std::size_t k) { return number(c, k + 4); };
    return {
        J, nu,
        potential_->model(VariedCoefficients<T, decltype(coefficient)>{place_, p, coefficient})};
  }

 private:
  const AnisotropicPotential* potential_;
  std::array<double, 3> J_;
  double nu_;
  FamilyParameter parameter_;
  int place_;
};

/// N equations of such a body, Own::equations(y, number), as extended_root.hpp asks for them.
template <class Own, int N>
class SpinSystem {
 public:
  static constexpr int dimension = N;
  template <class T>
  using Values = std::array<T, static_cast<std::size_t>(N)>;

  explicit SpinSystem(const VariedSpin& spin) : spin_(spin) {}

  std::size_t inputs() const { return spin_.inputs(); }
  bool has_decimals() const { return spin_.has_decimals(); }

  Values<DoubleDouble> values(const Values<DoubleDouble>& y, const InputChange& change) const {
    return own().equations(y, [&](double x, std::size_t k) { return change(x, k); });
  }
  Values<Conditioned> conditioned(const Values<Conditioned>& y, bool exact) const {
    return own().equations(
        y, [&](double x, std::size_t) { return exact ? Conditioned(x) : Conditioned::input(x); });
  }

 protected:
  VariedSpin spin_;

 private:
  const Own& own() const { return static_cast<const Own&>(*this); }
};

/// The equations, of which there are one more than unknowns.
template <class Layout>
class OrientedEventSystem : public SpinSystem<OrientedEventSystem<Layout>, Layout::dimension + 1> {
  using Base = SpinSystem<OrientedEventSystem<Layout>, Layout::dimension + 1>;

 public:
  static constexpr std::size_t unknowns = Layout::places.size();
  template <class T>
  using Values = typename Base::template Values<T>;

  /// function: as of TestValues.
  OrientedEventSystem(const VariedSpin& spin, Branch branch, std::size_t function)
      : Base(spin), branch_(branch), function_(function) {}

  template <class T, class Number>
  std::array<T, unknowns + 1> equations(const std::array<T, unknowns + 1>& y,
                                        const Number& number) const {
    const auto [J, nu, model] = this->spin_.at(y[unknowns], number);
    const T nu_squared = square(nu);
    std::array<T, unknowns> x;
    std::copy_n(y.begin(), unknowns, x.begin());
    const auto all = all_coordinates<Layout>(x, T(1.0));
    const auto balance = balance_at<Layout, 2>(J, model, branch_, nu_squared, all);
    Values<T> out;
    for (std::size_t i = 0; i < unknowns; ++i) out[i] = balance.g[Layout::places[i]];
    if (function_ == TestValues::fold || function_ == TestValues::momentum) {
      SquareArray<T, unknowns> jacobian;
      for (std::size_t i = 0; i < unknowns; ++i)
        for (std::size_t j = 0; j < unknowns; ++j)
          jacobian[i][j] = balance.slope[Layout::places[i]][Layout::places[j]];
      out[unknowns] = function_ == TestValues::fold
                          ? determinant(jacobian)
                          : turning(J, model, nu_squared, all, balance, jacobian);
    } else if (function_ == TestValues::turn) {
      out[unknowns] = turn(J, model, nu_squared, all);
    } else {
      out[unknowns] = difference_of_inertias(J, all);
    }
    return out;
  }

 private:
  template <class T>
  T turning(const Inertia3<T>& J, const AnisotropicModel<T>& model, const T& nu_squared,
            const std::array<T, 5>& y, const OrientedBalance<T>& balance,
            const SquareArray<T, unknowns>& jacobian) const {
    const auto at_rest = balance_at<Layout, 1>(J, model, branch_, T(0.0), y);
    std::array<T, unknowns> pull;  // -d(q^T C q/2), of the axis nothing
    for (std::size_t i = 0; i < unknowns; ++i) {
      const std::size_t row = Layout::places[i];
      pull[i] = row == oriented::phi ? T(0.0) : balance.g[row] - at_rest.g[row];
    }
    std::array<T, unknowns> nu_slope;
    std::array<T, unknowns> inertia_slope;
    for (std::size_t i = 0; i < unknowns; ++i) {
      nu_slope[i] = 2.0 * pull[i];
      inertia_slope[i] = -2.0 * pull[i];
    }
    const Vector4<T> q = oriented_stretch(y[0], y[1], y[2], y[3]).q.vector();
    const Vector4<T> force = centrifugal_matrix(J, spin(nu_squared, y)) * q;
    T own(0.0);
    for (int i = 0; i < 4; ++i) own += q[i] * force[i];
    return momentum_turn(jacobian, nu_slope, inertia_slope, own);
  }

  /// At alpha = 0 (oriented_stability.hpp's turn_of()).
  template <class T>
  T turn(const Inertia3<T>& J, const AnisotropicModel<T>& model, const T& nu_squared,
         const std::array<T, 5>& y) const {
    const BasicStretch<T> q = oriented_stretch(y[0], y[1], y[2], y[3]).q;
    const T V_aa = shear_stiffness<T>(potential_derivatives<2>(model, q).hessian(0, 0),
                                      model.body.volume.has_value(), branch_, J.J3, nu_squared, q);
    if (branch_ == Branch::iii) return V_aa - (J.J1 + J.J2) * nu_squared;
    const T along_2 = J.J2 * square(q.zeta) - J.J1 * square(q.xi);
    const T inertias = branch_ == Branch::i ? along_2 : -along_2;
    const T own = branch_ == Branch::i ? J.J1 : J.J2;
    return (V_aa - own * nu_squared) * inertias - square(J.J1 * q.xi + J.J2 * q.zeta) * nu_squared;
  }

  template <class T>
  T difference_of_inertias(const Inertia3<T>& J, const std::array<T, 5>& y) const {
    using std::sqrt;
    const BasicStretch<T> q = oriented_stretch(y[0], y[1], y[2], y[3]).q;
    if constexpr (!Layout::alpha) {
      const T m[3] = {J.J1 * square(q.xi), J.J2 * square(q.zeta), J.J3 * square(q.rho)};
      if (function_ == TestValues::inertia_12) return m[1] - m[0];
      return m[2] - m[function_ == TestValues::inertia_13 ? 0 : 1];
    } else {
      const Matrix3<T> I = locked_inertia(J, q);
      T first;
      if constexpr (Layout::axis) {
        const AxisAngle<T> axis = axis_angle(y[4]);
        first = square(axis.cosine) * I(0, 0) + square(axis.sine) * I(1, 1) +
                2.0 * (axis.cosine * axis.sine * I(0, 1));
      } else {
        first =
            0.5 * (I(0, 0) + I(1, 1)) - sqrt(square(0.5 * (I(0, 0) - I(1, 1))) + square(I(0, 1)));
      }
      const T second = I(0, 0) + I(1, 1) - first;
      if (function_ == TestValues::inertia_12) return first - second;
      return I(2, 2) - (function_ == TestValues::inertia_13 ? first : second);
    }
  }

  template <class T>
  SpinProducts<T> spin(const T& nu_squared, const std::array<T, 5>& y) const {
    if constexpr (Layout::axis) {
      const AxisAngle<T> axis = axis_angle(y[4]);
      return in_plane_products(nu_squared, axis.cosine, axis.sine);
    } else {
      return axis_products(branch_, nu_squared);
    }
  }

  Branch branch_;
  std::size_t function_;
};

/// The locked inertias where alpha is an unknown, about an oblique axis too: in the plane along the
/// spin's axis and across it (in (iii) the smaller and the larger), and about axis 3. Where the
/// spin's axis is one of the plane, tilt is where its inertia equals that about axis 3.
template <bool oblique>
void set_inertia_tests(const Member& member, const TestContext&, TestValues& out) {
  const Matrix3<double> I = locked_inertia(member.body, member.q);
  const double mean = 0.5 * (I(0, 0) + I(1, 1));
  const double radius = hypotenuse(0.5 * (I(0, 0) - I(1, 1)), I(0, 1));
  double first = mean - radius;
  double second = mean + radius;
  if constexpr (oblique) {
    if (member.nu == 0.0) return;
    const Vector3<double> axis = member.angular_velocity.normalized();
    first = axis.dot(I * axis);
    second = I(0, 0) + I(1, 1) - first;
    out.value[TestValues::inertia_12] = relative_difference(first, second);
  }
  out.value[TestValues::inertia_13] = relative_difference(I(2, 2), first);
  out.value[TestValues::inertia_23] = relative_difference(I(2, 2), second);
}

template <class Layout>
KindEvents oriented_events() {
  KindEvents out = axis_events();
  if constexpr (Layout::alpha) out.set = set_inertia_tests<Layout::axis>;
  if constexpr (Layout::axis) out.may_collide = [](Block, const TestContext&) { return true; };
  out.mirror = Layout::axis ? EventType::oblique : EventType::shear;
  out.mirror_reason = Layout::axis ? "the axis has come to a material one, alpha to 0"
                                   : "alpha has come to 0; beyond are mirror images";
  return out;
}

/// What vanishes at an event of this type near a located member, of TestValues; nothing where there
/// are no equations for it.
template <class Layout>
std::optional<std::size_t> vanishing_function(EventType type, Branch branch, bool along_nu,
                                              const Member& near) {
  const TestContext context{.branch = branch,
                            .material_symmetry = false,
                            .kind = oriented_events<Layout>(),
                            .along_nu = along_nu};
  return nearest_function(type, context, test_values(near, context, 0.0, 0.0));
}

/// Of what vanishes at an event, in a family of this layout.
template <class Layout>
std::unique_ptr<ExtendedEventEquations<event_dimension<Layout::dimension>>>
oriented_event_equations(const VariedSpin& spin, Branch branch, std::size_t function) {
  constexpr auto dimension = static_cast<std::size_t>(Layout::dimension);
  using Equations = ExtendedEventEquations<event_dimension<Layout::dimension>>;
  using System = OrientedEventSystem<Layout>;
  std::array<std::size_t, dimension + 1> places;
  for (std::size_t k = 0; k < dimension; ++k) places[k] = event_place(k);
  places.back() = Equations::parameter;
  return std::make_unique<SystemEventEquations<event_dimension<Layout::dimension>, System>>(
      System(spin, branch, function), places, false,
      StretchErrorRule{.factor = Layout::bound_factor});
}

}  // namespace stationary
