// sin and cos of k pi/2 + r from those of r: a quarter turn makes cos of sin, and -sin of cos.
#pragma once

namespace stationary {

template <typename T>
struct SineCosine {
  T sine;
  T cosine;
};

/// A whole k, |k| < 2^62.
template <typename T>
SineCosine<T> after_quarter_turns(double k, const T& sine, const T& cosine) {
  switch (static_cast<int>(static_cast<long long>(k) & 3)) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

}  // namespace stationary
