// The last correction of every solve: Newton in ln x with the residual in extended precision and
// the Jacobian in double,
//
//   delta = -J(x)^-1 G_ext(x),   x <- x exp(delta),
//
// which rounds x correctly to about half a unit in the last place, and an error bound:
//
//   e <= |J^-1| ( 2^-53 sum_p |p dG/dp|     inputs given as decimals: half a unit of each; where that is much,
//                                           2^-53 sum_p |J^-1 p dG/dp| in its place
//               + 2^-80 magnitude )         extended-precision residual
//        + kappa (delta^2 + 2^-50 |delta|)  what the step leaves: curvature, J in double
//        + 2^-53                            rounding x
//   kappa = |J^-1| magnitude,   then e <- e + kappa e^2 solved for e (near a fold e ~ sqrt); never
//                                          below the first, which kappa may overrate
//
// Accepted only when kappa delta^2 <= 2^-56: near a fold kappa is large and another step is taken.
// Beside a border or a pole of a formula G bends far more than the size of its terms says; there a
// step is accepted only where it is below 2^-44, or what the next one measures has come into the
// bound in kappa's place: delta of a step over the square of that before it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "lib/number/elementary.hpp"
#include "lib/number/first_order_bound.hpp"
#include "solver/newton/reduced_system.hpp"

namespace stationary {

struct Refined {
  bool converged = false;
  int steps = 0;
  bool positive = false;  ///< det J > 0 at the last step
  double first_correction = std::numeric_limits<double>::quiet_NaN();  ///< max |delta| of step 1
  /// What the last step did to J^-1, relative to itself: kappa max |delta|.
  double last_change = std::numeric_limits<double>::quiet_NaN();
  double error_bound = std::numeric_limits<double>::quiet_NaN();  ///< relative, max over x
};

/// x exp(d) of a small d, as a series.
template <class Number>
[[gnu::always_inline]] inline Number moved_little(const Number& x, const Number& d) {
  return x + x * (d + d * d * (0.5 + d / 6.0));
}

/// x exp(scale delta), the exponential by its series where its argument is small.
template <int N>
ReducedVector<N> moved(const ReducedVector<N>& x, const ReducedVector<N>& delta,
                       double scale = 1.0) {
  ReducedVector<N> out;
  for (int i = 0; i < N; ++i) {
    const double d = scale * delta[i];
    out[i] = std::abs(d) < 0x1p-13 ? moved_little(x[i], d) : x[i] * exp(d);
  }
  return out;
}

template <int N>
ReducedVector<N> ones() {
  ReducedVector<N> out;
  for (int i = 0; i < N; ++i) out[i] = 1.0;
  return out;
}

/// Whether G may bend far more than the size of its terms says.
template <class Model>
bool may_be_steep_model(const Model& model) {
  if constexpr (requires {
                  model.plane;
                  model.thickness;
                }) {
    return may_be_steep_model(model.plane) || may_be_steep_model(model.thickness);
  } else if constexpr (requires { model.has_conditions(); }) {
    return model.has_conditions();
  } else {
    return false;
  }
}
template <class System>
bool may_be_steep(const System& system) {
  if constexpr (requires { system.models->plain; }) {
    return may_be_steep_model(system.models->plain);
  } else if constexpr (requires { system.elastic.model; }) {
    return may_be_steep_model(system.elastic.model);
  } else if constexpr (requires { system.model; }) {
    return may_be_steep_model(system.model);
  } else {
    return true;  // nothing is known of it
  }
}

/// Of x in extended precision, and what inputs do to it, where at = linearize(x) is known: systems
/// that divide their rows have the divisors from there.
template <class System, class X, class At>
auto extended_residual(const System& system, const X& x, const At& at) {
  if constexpr (requires { system.extended_residual(x, at.scale); }) {
    return system.extended_residual(x, at.scale);
  } else {
    return system.extended_residual(x);
  }
}
template <class System, class X, class At>
auto input_sensitivity(const System& system, const X& x, const At& at) {
  if constexpr (requires { system.input_sensitivity(x, at.scale); }) {
    return system.input_sensitivity(x, at.scale);
  } else {
    return system.input_sensitivity(x);
  }
}

/// Of one motion: near a fold several are taken.
constexpr int most_corrections = 8;

template <class System>
using LinearizedOf = std::decay_t<decltype(std::declval<const System&>().linearize(
    std::declval<const ReducedVector<System::dimension>&>()))>;

/// Whether it says what each of its inputs does by itself.
template <class System>
constexpr bool takes_inputs_apart = requires(const System& system,
                                             const ReducedVector<System::dimension>& x) {
  system.for_each_input(x, [](const ReducedVector<System::dimension>&) {});
};

/// What half a unit of each input does to the solution, input by input, with what J^-1 may be off by. sum: the same
/// of the sum of their magnitudes.
template <class System, class Inverse>
double moved_by_each_input(const System& system, const ReducedVector<System::dimension>& x,
                           const Inverse& inverse, double kappa, double sum) {
  constexpr int N = System::dimension;
  ReducedVector<N> moved = ReducedVector<N>::Zero();
  system.for_each_input(x, [&](const ReducedVector<N>& slope) {
    const ReducedVector<N> by = inverse * slope;
    for (int i = 0; i < N; ++i) moved[i] += std::abs(by[i]);
  });
  return 0x1p-53 * largest_magnitude<N>(moved) + 0x1p-48 * (1.0 + kappa) * sum;
}

/// Corrects x in place. bound = false leaves error_bound NaN and evaluates nothing for it.
/// tail: what rounding x left of the solution, to about 2^-86; NaN where that is not known.
/// last: linearize() before the last step.
/// Not converged: x is the last iterate, or unchanged where the Jacobian is singular, also only to
/// rounding, or the residual not finite.
template <bool bound = true, class System>
Refined refine(const System& system, ReducedVector<System::dimension>& x,
               int max_steps = most_corrections, ReducedVector<System::dimension>* tail = nullptr,
               LinearizedOf<System>* last = nullptr) {
  constexpr int N = System::dimension;
  Refined out;
  if (tail != nullptr) tail->setConstant(std::numeric_limits<double>::quiet_NaN());
  const bool steep = may_be_steep(system);
  double before = 0.0;  // size of the step before
  while (out.steps < max_steps) {
    const auto at = system.linearize(x);
    const ReducedVector<N> g = extended_residual(system, x, at);
    const auto inverse = at.jacobian.inverse();
    const auto absolute = inverse.absolute();
    const ReducedVector<N> step = inverse * g;  // minus delta
    const double size = largest_magnitude<N>(step);
    if (!(size < 0.5)) return out;  // NaN included: no correction is that large
    // A Jacobian that is singular to rounding may be inverted to next to nothing.
    if (largest_magnitude<N>(g) > 64.0 * at.magnitude * size) return out;
    if (out.steps++ == 0) out.first_correction = size;
    out.positive = at.jacobian.determinant() > 0.0;
    const ReducedVector<N> corrected = moved<N>(x, step, -1.0);
    const double kappa = largest_magnitude<N>(absolute * ones<N>()) * at.magnitude;
    constexpr double fine = 0x1p-44;
    const bool measured = !steep || size <= fine || out.steps == max_steps;
    if (kappa * size * size <= 0x1p-56 && measured) {
      const double bend =
          steep && before > fine ? std::max(kappa, size / (before * before)) : kappa;
      out.converged = true;
      out.last_change = bend * size;
      if (last != nullptr) *last = at;
      if constexpr (bound) {
        const ReducedVector<N> sensitivity = input_sensitivity(system, x, at);
        ReducedVector<N> perturbation;
        for (int i = 0; i < N; ++i)
          perturbation[i] = 0x1p-53 * sensitivity[i] + 0x1p-80 * at.magnitude;
        const double step_leaves = bend * size * (size + 0x1p-50);
        double linear = largest_magnitude<N>(absolute * perturbation) + step_leaves + 0x1p-53;
        if constexpr (takes_inputs_apart<System>) {
          // Of long, thin bodies that is far too much.
          constexpr double coarse = 0x1p-40;
          if (linear > coarse)
            linear = std::min(linear, moved_by_each_input(system, x, inverse, kappa, linear) +
                                          0x1p-80 * kappa + step_leaves + 0x1p-53);
        }
        // Without such an e, that of a fold: below `linear` where kappa is far above the curvature.
        out.error_bound = std::fmax(linear, with_curvature(linear, kappa));
      }
      if (tail != nullptr && bend * size * (size + 0x1p-50) <= 0x1p-86) {
        for (int i = 0; i < N; ++i) {
          const DoubleDouble sum = two_sum(x[i], -x[i] * step[i]);
          (*tail)[i] = (sum.hi - corrected[i]) + sum.lo;
        }
      }
      x = corrected;
      return out;
    }
    x = corrected;
    before = size;
  }
  return out;
}

/// x with the correction its extended residual asks for, unrounded.
template <class System>
std::array<DoubleDouble, System::dimension> extended_solution(
    const System& system, const ReducedVector<System::dimension>& x) {
  constexpr int N = System::dimension;
  const auto at = system.linearize(x);
  const ReducedVector<N> step = at.jacobian.inverse() * extended_residual(system, x, at);
  std::array<DoubleDouble, N> out;
  for (int i = 0; i < N; ++i) {
    const double correction = -x[i] * step[i];
    // A correction beyond the last place says the Jacobian is useless here: keep the double.
    out[static_cast<std::size_t>(i)] =
        std::abs(step[i]) < 1e-10 ? two_sum(x[i], correction) : DoubleDouble(x[i]);
  }
  return out;
}

}  // namespace stationary
