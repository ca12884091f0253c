// Thickness potentials V_rho(rho), derivatives in r = ln rho:
//   reciprocal-quadratic:  a/rho + (b/2) rho^2         (the paper's V_rho)
//   harmonic:              (k/2) (rho - rest)^2
// and the one balance they enter: V_rho'(rho) = m rho, m = J3 nu^2 in (i), (ii) and 0 in (iii). As
// for the plane, log_balance(rho, m) gives it with the centrifugal term gathered with the elastic
// one: LogBalance::g_rho and ww.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "lib/material/models/model_derivatives.hpp"
#include "lib/number/elementary.hpp"

namespace stationary {

template <class C = double>
struct ReciprocalQuadratic {
  C a;
  C b;

  static constexpr std::string_view name = "reciprocal-quadratic";
  static constexpr std::string_view formula = "a/rho + (b/2) rho^2";
  static constexpr std::array<std::string_view, 2> parameters{"a", "b"};
  static constexpr std::array<std::string_view, 2> domain{"a > 0", "b > 0"};
  /// Where V' = m rho has a solution (then exactly one), as a reason to print where it has none.
  static constexpr std::string_view existence = "J3 nu^2 < b";

  std::array<C, 2> coefficients() const { return {a, b}; }
  std::array<bool, 2> in_domain() const { return {a > 0.0, b > 0.0}; }

  /// rho^3 = a/(b - m), to double precision; NaN unless m < b. m is extended: b - m may cancel.
  double balanced(const DoubleDouble& m) const {
    const double stiffness = double(leading(b) - m);
    return stiffness > 0.0 ? cube_root(leading(a) / stiffness) : poison<double>();
  }

  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& rho, const S& m) const {
    const auto reciprocal = a / rho;
    const auto stiff = (b - m) * square(rho);
    return {.g_rho = stiff - reciprocal, .ww = 2.0 * stiff + reciprocal};
  }

  template <int order, class S>
  ThicknessDerivatives<Product<C, S>> evaluate(const S& rho) const {
    ThicknessDerivatives<Product<C, S>> out;
    const auto reciprocal = a / rho;
    const auto square = b * (rho * rho);
    out.v = reciprocal + 0.5 * square;
    if constexpr (order >= 1) out.v_r = square - reciprocal;
    if constexpr (order >= 2) out.v_rr = 2.0 * square + reciprocal;
    return out;
  }
};

template <class C = double>
struct Harmonic {
  C k;
  C rest;

  static constexpr std::string_view name = "harmonic";
  static constexpr std::string_view formula = "(k/2) (rho - rest)^2";
  static constexpr std::array<std::string_view, 2> parameters{"k", "rest"};
  static constexpr std::array<std::string_view, 2> domain{"k > 0", "rest > 0"};
  static constexpr std::string_view existence = "J3 nu^2 < k";

  std::array<C, 2> coefficients() const { return {k, rest}; }
  std::array<bool, 2> in_domain() const { return {k > 0.0, rest > 0.0}; }

  /// rho = k rest/(k - m); NaN unless m < k.
  double balanced(const DoubleDouble& m) const {
    const double stiffness = double(leading(k) - m);
    return stiffness > 0.0 ? leading(k) * leading(rest) / stiffness : poison<double>();
  }

  template <class S>
  LogBalance<Product<C, S>> log_balance(const S& rho, const S& m) const {
    const auto stiff = (k - m) * rho;
    const Product<C, S> load = Product<C, S>(k) * rest;  // S may be more precise
    return {.g_rho = rho * (stiff - load), .ww = rho * (2.0 * stiff - load)};
  }

  template <int order, class S>
  ThicknessDerivatives<Product<C, S>> evaluate(const S& rho) const {
    ThicknessDerivatives<Product<C, S>> out;
    const auto elongation = rho - rest;
    const auto force = k * elongation;
    out.v = 0.5 * force * elongation;
    if constexpr (order >= 1) out.v_r = force * rho;
    if constexpr (order >= 2) out.v_rr = (force + k * rho) * rho;
    return out;
  }
};

}  // namespace stationary
