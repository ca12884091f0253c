// The interpreter of tape.hpp, in any number type: double and ceres::Jet, extended precision,
// intervals, wide numbers, ... A type needs the functions an expression may contain, found by
// argument-dependent lookup.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <memory>
#include <type_traits>

#include "lib/number/double_double_functions.hpp"
#include "lib/number/dual.hpp"
#include "lib/number/elementary.hpp"
#include "lib/number/first_order_bound_functions.hpp"
#include "lib/number/interval_functions.hpp"
#include "lib/number/number.hpp"
#include "lib/tape/kernel_value.hpp"
#include "lib/tape/tape.hpp"

namespace stationary::expression {

/// Numbers without their constructors being run where that is allowed: a workspace is large, and
/// few of its places are used.
template <class R, std::size_t n>
class Workspace {
 public:
  R* data() {
    if constexpr (plain) {
      return reinterpret_cast<R*>(storage_.data());
    } else {
      return storage_.data();
    }
  }

 private:
  static constexpr bool plain =
      std::is_trivially_copyable_v<R> && std::is_trivially_destructible_v<R>;
  alignas(
      R) std::conditional_t<plain, std::array<std::byte, n * sizeof(R)>, std::array<R, n>> storage_;
};

/// Multiprecision numbers.
template <class R>
concept Wide = requires(const R& x) {
  x.template convert_to<double>();
};

/// Intervals, and dual numbers over them.
template <class R>
consteval bool over_intervals() {
  if constexpr (Wide<R>) {
    return false;
  } else {
    return std::is_constructible_v<R, Interval>;
  }
}

/// Of DoubleDouble and pairs of packs.
template <class R>
R pair_of(const DoubleDouble& x) {
  using Part = decltype(R::hi);
  return R(Part(x.hi), Part(x.lo));
}

template <class R>
R pi_of() {
  if constexpr (Wide<R>) {
    return R(4.0) * atan(R(1.0));
  } else if constexpr (over_intervals<R>()) {
    return R(Interval(double_double_pi.hi, above(double_double_pi.hi)));
  } else if constexpr (requires(R x) { x.hi, x.lo; }) {
    return pair_of<R>(double_double_pi);
  } else {
    return R(double_double_pi.hi);
  }
}

template <class R>
R euler_of() {
  if constexpr (Wide<R>) {
    return exp(R(1.0));
  } else if constexpr (over_intervals<R>()) {
    return R(Interval(double_double_e.hi, above(double_double_e.hi)));
  } else if constexpr (requires(R x) { x.hi, x.lo; }) {
    return pair_of<R>(double_double_e);
  } else {
    return R(double_double_e.hi);
  }
}

/// The constants of `c` for parameters of type R.
template <class R>
void compute_constants(const Coefficients& c, const R* parameters, R* constants);

/// Runs a program: place holds the inputs and has room for largest_place_count numbers.
template <class R>
void run(const Program& program, const double* literals, const R* constants, R* place);

/// |x| and the smaller of two, of coefficients: numbers whose sign is known (see
/// interval_functions.hpp for those where it may not be).
template <class R>
R absolute(const R& x) {
  if constexpr (Packed<R>) {
    return lane_by_lane([](const auto& lane) { return absolute(lane); }, x);
  } else {
    if constexpr (over_intervals<R>()) {
      if (!(x.value.lo >= 0.0) && !(x.value.hi <= 0.0)) return x * R(Interval::entire());
    }
    return leading(x) < 0.0 ? -x : x;
  }
}
template <class R>
R smaller(const R& x, const R& y) {
  if constexpr (Packed<R>) {
    return lane_by_lane([](const auto& a, const auto& b) { return smaller(a, b); }, x, y);
  } else {
    if constexpr (over_intervals<R>()) {
      if (!x.value.apart_from(y.value)) return (x + y) * R(Interval::entire());
    }
    return leading(y) < leading(x) ? y : x;
  }
}

template <class R>
R coefficient_step(const Instruction& at, const double* literals, const R* parameters,
                   const R* value) {
  using std::sqrt;
  const R* a = value + at.a;
  switch (at.operation) {
    case Operation::add:
      return *a + value[at.b];
    case Operation::multiply:
      return *a * value[at.b];
    case Operation::divide:
      return *a / value[at.b];
    case Operation::sqrt:
      return sqrt(*a);
    case Operation::exp:
      return exp(*a);
    case Operation::log:
      return log(*a);
    case Operation::sin:
      return sin(*a);
    case Operation::cos:
      return cos(*a);
    case Operation::tan:
      return tan(*a);
    case Operation::tanh:
      return tanh(*a);
    case Operation::atan:
      return atan(*a);
    case Operation::power:
      return pow(*a, value[at.b]);
    case Operation::literal:
      return R(literals[at.a]);
    case Operation::decimal:
      if constexpr (over_intervals<R>()) {
        return R(Interval::decimal(literals[at.a]));
      } else if constexpr (std::is_same_v<R, Conditioned>) {
        return Conditioned::input(literals[at.a]);
      } else {
        return R(literals[at.a]);
      }
    case Operation::parameter:
      return parameters[at.a];
    case Operation::pi:
      return pi_of<R>();
    case Operation::euler:
      return euler_of<R>();
    case Operation::absolute:
      return absolute(*a);
    case Operation::minimum:
      return smaller(*a, value[at.b]);
    case Operation::maximum:
      return -smaller(-*a, -value[at.b]);
    default:
      return poison<R>();
  }
}

template <class R>
void compute_constants(const Coefficients& c, const R* parameters, R* constants) {
  Workspace<R, largest_coefficient_steps> workspace;
  R* value = workspace.data();
  const double* literals = c.literals.data();
  for (std::size_t k = 0; k < c.steps.size(); ++k)
    value[k] = coefficient_step(c.steps[k], literals, parameters, value);
  for (std::size_t k = 0; k < c.constants.size(); ++k) constants[k] = value[c.constants[k]];
}

template <class R>
void run(const Program& program, const double* literals, const R* constants, R* place) {
  using std::sqrt;
  for (const Instruction& at : program.code) {
    R& out = place[at.out];
    const R& a = place[at.a];
    switch (at.operation) {
      case Operation::add:
        out = a + place[at.b];
        break;
      case Operation::subtract:
        out = a - place[at.b];
        break;
      case Operation::multiply:
        out = a * place[at.b];
        break;
      case Operation::add_constant:
        out = a + constants[at.b];
        break;
      case Operation::multiply_constant:
        out = constants[at.b] * a;
        break;
      case Operation::constant:
        out = constants[at.b];
        break;
      case Operation::add_scaled:
        out = a + constants[at.c] * place[at.b];
        break;
      case Operation::add_literal:
        out = a + literals[at.b];
        break;
      case Operation::multiply_literal:
        out = literals[at.b] * a;
        break;
      case Operation::add_literal_scaled:
        out = a + literals[at.c] * place[at.b];
        break;
      case Operation::square:
        out = square(a);
        break;
      case Operation::negate:
        out = -a;
        break;
      case Operation::divide:
        out = a / place[at.b];
        break;
      case Operation::reciprocal:
        out = R(1.0) / a;
        break;
      case Operation::log:
        out = log(a);
        break;
      case Operation::exp:
        out = exp(a);
        break;
      case Operation::sqrt:
        out = sqrt(a);
        break;
      case Operation::power:
        out = pow(a, constants[at.b]);
        break;
      case Operation::sin:
        out = sin(a);
        break;
      case Operation::cos:
        out = cos(a);
        break;
      case Operation::tan:
        out = tan(a);
        break;
      case Operation::tanh:
        out = tanh(a);
        break;
      case Operation::atan:
        out = atan(a);
        break;
      case Operation::kernel: {
        const KernelCall& call = program.kernels[at.a];
        out = kernel_value(call.function, call.index, place[call.a], place[call.y],
                           place[call.norm], constants + call.exponent);
        break;
      }
      default:
        out = poison<R>();
    }
  }
}

/// With a slope for each parameter of a formula.
using PerParameter = Dual<double, largest_parameter_count>;

// Compiled once, in tape_run.cpp.
extern template void compute_constants(const Coefficients&, const double*, double*);
extern template void compute_constants(const Coefficients&, const DoubleDouble*, DoubleDouble*);
extern template void compute_constants(const Coefficients&, const Interval*, Interval*);
extern template void compute_constants(const Coefficients&, const Conditioned*, Conditioned*);
extern template void compute_constants(const Coefficients&, const PerParameter*, PerParameter*);
extern template void compute_constants(const Coefficients&, const Dual<double, 5>*,
                                       Dual<double, 5>*);
extern template void compute_constants(const Coefficients&, const Dual<Interval, 4>*,
                                       Dual<Interval, 4>*);
extern template void run(const Program&, const double*, const double*, double*);
extern template void run(const Program&, const double*, const DoubleDouble*, DoubleDouble*);
extern template void run(const Program&, const double*, const Interval*, Interval*);
extern template void run(const Program&, const double*, const Conditioned*, Conditioned*);
extern template void run(const Program&, const double*, const PerParameter*, PerParameter*);
extern template void run(const Program&, const double*, const Dual<double, 5>*, Dual<double, 5>*);
extern template void run(const Program&, const double*, const Dual<Interval, 4>*,
                         Dual<Interval, 4>*);
extern template void run(const Program&, const double*, const Dual<Interval, 3>*,
                         Dual<Interval, 3>*);

}  // namespace stationary::expression
