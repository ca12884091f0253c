// Operands for DoubleDouble: ordinary ones, and the ones its error analysis turns on.
#pragma once

#include <cmath>
#include <utility>

#include "lib/number/double_double.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary::support {

class Operands {
 public:
  explicit Operands(std::uint64_t seed) : random_(seed) {}

  /// Any sign; magnitude 2^-400 to 2^400; tails full, short, far below, or none.
  DoubleDouble one() {
    const double span = random_.integer(0, 3) == 0 ? 400.0 : 4.0;
    const int exponent = static_cast<int>(random_.uniform(-span, span));
    double mantissa = random_.uniform(1.0, 2.0);
    switch (random_.integer(0, 5)) {
      case 0:
        mantissa = 1.0;
        break;
      case 1:
        mantissa = 2.0 - 0x1p-52;
        break;
      case 2:
        mantissa = 1.0 + 0x1p-52;
        break;
      default:
        break;
    }
    const double head = random_.sign() * std::ldexp(mantissa, exponent);
    return with_tail(head);
  }

  /// Also pairs that cancel: to the tails, to the last place, or in part.
  std::pair<DoubleDouble, DoubleDouble> pair() {
    const DoubleDouble x = one();
    switch (random_.integer(0, 4)) {
      case 0:
        return {x, with_tail(-x.hi)};
      case 1:
        return {x, with_tail(-std::nextafter(x.hi, 0.0))};
      case 2:
        return {x, with_tail(-x.hi * (1.0 + random_.sign() * random_.log_uniform(0x1p-52, 0.5)))};
      case 3:
        return {x, with_tail(x.hi * random_.log_uniform(0x1p-110, 1.0))};
      default:
        return {x, one()};
    }
  }

 private:
  DoubleDouble with_tail(double head) {
    const double half_ulp =
        0.5 * (std::nextafter(std::abs(head), HUGE_VAL) - std::abs(head)) * (1.0 - 0x1p-52);
    switch (random_.integer(0, 4)) {
      case 0:
        return head;
      case 1:
        return normal(head, random_.sign() * half_ulp);
      case 2:
        return normal(head, random_.sign() * half_ulp * random_.log_uniform(0x1p-60, 1.0));
      default:
        return normal(head, random_.uniform(-1.0, 1.0) * half_ulp);
    }
  }
  /// At a power of two the lower neighbour is nearer than half a unit above.
  static DoubleDouble normal(double head, double tail) {
    return head + tail == head ? DoubleDouble(head, tail) : DoubleDouble(head, 0.25 * tail);
  }

  Random random_;
};

}  // namespace stationary::support
