// Families of stationary ellipsoids about an axis in no material plane (spatial_balance.hpp), stated
// by their equations alone (stated_family.hpp): in xi, zeta and e^a at |nu|. They begin where W_t = 0
// on a tilted family, alpha being 0 there (`shear`).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/balance/spatial_balance.hpp"
#include "lib/material/models/model_coefficients.hpp"
#include "lib/material/potential.hpp"
#include "solver/family/stated_family.hpp"
#include "solver/newton/newton.hpp"

namespace stationary {

struct SpatialEquations {
  static constexpr int dimension = 3;
  static constexpr int shear_place = 2;
  /// Of alpha over sqrt(xi zeta), tanh a, against the bound of ln x.
  static constexpr double bound_factor = 2.0;
  using X = ReducedVector<3>;

  Body body;
  Potential potential;  ///< of a held volume, isotropic but for its gravity
  bool spectrum = false;

  SpatialEquations(const Body& of, const Potential& with, bool with_spectrum);

  template <class T, class Number>
  SpatialState<T> state(const std::array<T, 3>& x, const Number& number) const {
    const auto model = with_indexed_coefficients(
        *potential.body_model(), [&](double c, std::size_t) { return T(number(c)); });
    return spatial_state<T>({T(number(body.J1)), T(number(body.J2)), T(number(body.J3))}, model,
                            x[0], x[1], x[2]);
  }
  template <class T, class Number>
  std::array<T, 3> balance(const std::array<T, 3>& x, const T& p, const Number& number) const {
    return spatial_balance<T>(state(x, number), square(p));
  }
  /// About the axis, an eigenvector of S J S with tau: J3 rho^2 + trace B - tau.
  template <class T>
  T spin_inertia(const std::array<T, 3>& x) const {
    return state(x, [](double c) { return T(c); }).moment;
  }
  X unknowns(const Stretch& q) const { return {q.xi, q.zeta, shear_coordinate(q)}; }
  Branch branch() const { return Branch::iii; }
  KindEvents events() const;
  std::optional<int> mirrored() const { return shear_place; }
  std::vector<ConditionValue> conditions(const X& x) const;
  /// Where alpha is 0, near x and p.
  std::optional<Member> mirror_point(const X& x, double p) const;
  bool has_spectrum() const { return spectrum; }
  /// nu1 >= 0 and nu3 >= 0.
  Member member(const X& x, const X& tail, double p, double error_bound) const;
};

/// Why a body has no such motions, whatever |nu|; nothing where it may.
std::optional<std::string> no_spatial_motion(const Body& body, const Potential& potential);

/// Throws std::invalid_argument where no_spatial_motion() says why.
std::unique_ptr<Family<3>> spatial_family(const Body& body, const Potential& potential,
                                          bool spectrum);

}  // namespace stationary
