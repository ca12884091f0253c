// What is certain of a curve up to a point: the sign that each test function had last, and what the
// parameter was between since.
//
// Signs are kept as bits, function k at bit k: on most steps none changes, and that is one
// comparison.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "solver/motion/event.hpp"

namespace stationary {

/// Of functions, one at each bit.
using FunctionBits = std::uint32_t;
static_assert(TestValues::count < 32);

constexpr FunctionBits bit_of(std::size_t function) {
  return FunctionBits{1} << static_cast<unsigned>(function);
}
/// f(function) of each, in ascending order.
template <class F>
void for_each_function(FunctionBits functions, const F& f) {
  for (; functions != 0; functions &= functions - 1)
    f(static_cast<std::size_t>(std::countr_zero(functions)));
}
/// Those that compare two blocks' Lambdas, of which TestValues::opposite has the signatures.
constexpr FunctionBits crossing_bits(std::uint32_t opposite) {
  return opposite << static_cast<unsigned>(TestValues::crossings);
}
constexpr FunctionBits all_functions = bit_of(TestValues::count) - 1;
/// Those of one curve by itself, and those that compare two blocks.
constexpr FunctionBits own_functions = bit_of(TestValues::crossings) - 1;
constexpr FunctionBits all_crossings = all_functions & ~own_functions;

/// The signs of the functions at a point.
struct SignBits {
  FunctionBits positive = 0;  ///< certain
  FunctionBits negative = 0;
  FunctionBits absent = 0;  ///< NaN: it has no meaning

  static SignBits of(const TestValues& at) {
    SignBits out;
    for (std::size_t k = 0; k < TestValues::count; ++k) {
      out.positive |= at.value[k] > 0.0 ? bit_of(k) : 0;
      out.negative |= at.value[k] < 0.0 ? bit_of(k) : 0;
      out.absent |= std::isnan(at.value[k]) ? bit_of(k) : 0;
    }
    out.positive &= ~at.uncertain;
    out.negative &= ~at.uncertain;
    return out;
  }
  /// Functions whose signs are certain and alike here and there.
  FunctionBits shared_with(const SignBits& other) const {
    return (positive & other.positive) | (negative & other.negative);
  }
  /// Those that have a value, and not its sign for certain.
  FunctionBits open() const { return ~(positive | negative | absent); }
  /// +1, -1; else 0.
  int of(std::size_t k) const {
    return static_cast<int>((positive >> static_cast<unsigned>(k)) & 1U) -
           static_cast<int>((negative >> static_cast<unsigned>(k)) & 1U);
  }
};

/// What the parameter was between on a part of the curve.
struct ParameterRange {
  double least = 0.0;
  double most = 0.0;

  static ParameterRange at(double p) { return {p, p}; }
  void add(double p) {
    least = std::min(least, p);
    most = std::max(most, p);
  }
};

struct KnownSigns {
  FunctionBits positive = 0;  ///< the last sign that was certain
  FunctionBits negative = 0;
  std::array<ParameterRange, TestValues::count> since{};

  int sign(std::size_t k) const { return SignBits{positive, negative}.of(k); }
  /// Those functions have the signs they have at a point.
  void set(FunctionBits functions, const SignBits& at, double parameter) {
    positive = (positive & ~functions) | (at.positive & functions);
    negative = (negative & ~functions) | (at.negative & functions);
    for_each_function(functions, [&](std::size_t k) { since[k] = ParameterRange::at(parameter); });
  }
  /// Function k has this sign at a point.
  void set(std::size_t k, int sign, double parameter) {
    set(bit_of(k), {sign > 0 ? ~FunctionBits{0} : 0, sign < 0 ? ~FunctionBits{0} : 0}, parameter);
  }
};

}  // namespace stationary
