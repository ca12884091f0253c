// The coefficients 1/(2 k + 1) of the series of atanh and of the odd part of a logarithm.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "lib/number/double_double.hpp"

namespace stationary {

/// 1/(2 k + 1) in S, 0 <= k < 128 from a table where S is one of the solver's own types: the series
/// is in the warm path, and a division is what it would spend its time on.
template <class S>
S odd_reciprocal(int k) {
  if constexpr (std::is_same_v<S, double> || std::is_same_v<S, DoubleDouble>) {
    static constexpr auto table = [] {
      std::array<S, 128> out{};
      for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = S(1.0) / S(2.0 * static_cast<double>(i) + 1.0);
      return out;
    }();
    return table[static_cast<std::size_t>(k)];
  } else {
    return S(1.0) / S(2.0 * k + 1.0);
  }
}

}  // namespace stationary
