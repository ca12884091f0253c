// Families of stationary ellipsoids with alpha != 0 of an isotropic body with J1 != J2
// (sheared_balance.hpp), stated by their equations alone (stated_family.hpp): in xi, zeta,
// where no volume is held (N = 4) rho, and e^a, at |nu|, about axis 3 at nu. They begin where W_t = 0 on a family
// with alpha = 0: at `shear` on branch (iii) or on a tilted family, at `oblique` on (i) or (ii).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lib/balance/sheared_balance.hpp"
#include "lib/material/potential.hpp"
#include "solver/family/stated_family.hpp"

namespace stationary {

template <int N>
struct ShearedEquations {
  static constexpr int dimension = N;
  static constexpr auto size = static_cast<std::size_t>(N);
  static constexpr std::size_t rho_place = 2;  ///< of N = 4
  static constexpr int shear_place = N - 1;
  /// Of alpha over sqrt(xi zeta), tanh a, against the bound of ln x.
  static constexpr double bound_factor = 2.0;
  using X = ReducedVector<N>;

  Body body;
  Potential potential;  ///< isotropic but for its gravity
  BodyModel<> model;    ///< the same
  ShearedAxis axis;
  bool spectrum = false;

  /// Throws std::invalid_argument where no_sheared_motion() says why.
  ShearedEquations(const Body& of, const Potential& with, ShearedAxis about, bool with_spectrum);

  template <class T, class Number>
  ShearedPoint<T> state(const std::array<T, size>& x, const T& p, const Number& number) const {
    T rho(1.0);
    if constexpr (N == 4) rho = x[rho_place];
    return sheared_point<T>(axis, inertias<T>(number), model_in<T>(number), x[0], x[1], rho,
                            x[size - 1], square(p));
  }
  template <class T, class Number>
  Inertia3<T> inertias(const Number& number) const {
    return {T(number(body.J1)), T(number(body.J2)), T(number(body.J3))};
  }
  template <class T, class Number>
  BodyModel<T> model_in(const Number& number) const {
    return with_indexed_coefficients(model, [&](double c, std::size_t) { return T(number(c)); });
  }
  template <class T, class Number>
  std::array<T, size> balance(const std::array<T, size>& x, const T& p,
                              const Number& number) const {
    return sheared_balance<N, T>(axis, state(x, p, number), T(square(p)));
  }
  /// About the axis, an eigenvector of the locked inertia.
  template <class T>
  T spin_inertia(const std::array<T, size>& x) const {
    using std::sqrt;
    const ShearedPoint<T> at = state(x, T(0.0), [](double c) { return T(c); });
    if (axis != ShearedAxis::oblique) return at.moment;
    return at.tau + 0.5 * (at.moment + sqrt(T(square(at.moment) - 4.0 * at.area)));
  }
  X unknowns(const Stretch& q) const;
  Stretch stretch(const X& x) const;
  Branch branch() const { return axis == ShearedAxis::oblique ? Branch::i : Branch::iii; }
  KindEvents events() const;
  std::optional<int> mirrored() const { return shear_place; }
  std::vector<ConditionValue> conditions(const X& x) const {
    return potential.conditions_at(stretch(x));
  }
  /// Where alpha is 0, near x and p.
  std::optional<Member> mirror_point(const X& x, double p) const;
  bool has_spectrum() const { return spectrum; }
  /// nu1 >= 0 and nu3 >= 0, nu2 >= 0 where nu1 = 0; about axis 3 nu3 = p.
  Member member(const X& x, const X& tail, double p, double error_bound) const;
};

extern template struct ShearedEquations<3>;
extern template struct ShearedEquations<4>;

/// The branch that a family about axis 3 or an oblique axis leaves at this event, its end; nothing of other
/// events.
std::optional<Branch> left_at(ShearedAxis axis, EventType event, const Member& member);

/// Why a body has no such motions, whatever nu; nothing where it may.
std::optional<std::string> no_sheared_motion(const Body& body, const Potential& potential,
                                             ShearedAxis axis);

}  // namespace stationary
