// Elementary functions of packs (simd_pack.hpp) and of pairs of them beyond sqrt and log, as a
// potential written out may contain them. Lane by lane, each as of a double or an extended number:
// only + - * /, sqrt and log run in all lanes at once.
#pragma once

#include <cmath>

#include "lib/number/double_double_functions.hpp"
#include "lib/number/simd_pack.hpp"

namespace stationary {

/// f of each lane of the packs.
template <int bytes, class F, class... Packs>
inline Pack<bytes> lane_by_lane(const F& f, const Pack<bytes>& x, const Packs&... more) {
  Pack<bytes> out;
  for (int i = 0; i < Pack<bytes>::half; ++i) {
    out.a[i] = f(x.a[i], more.a[i]...);
    out.b[i] = f(x.b[i], more.b[i]...);
  }
  return out;
}

/// f of each lane of pairs, as of DoubleDouble.
template <int bytes, class F, class... Pairs>
inline Pair<Pack<bytes>> lane_by_lane(const F& f, const Pair<Pack<bytes>>& x,
                                      const Pairs&... more) {
  Pair<Pack<bytes>> out;
  for (int i = 0; i < Pack<bytes>::half; ++i) {
    const DoubleDouble first =
        f(DoubleDouble(x.hi.a[i], x.lo.a[i]), DoubleDouble(more.hi.a[i], more.lo.a[i])...);
    const DoubleDouble second =
        f(DoubleDouble(x.hi.b[i], x.lo.b[i]), DoubleDouble(more.hi.b[i], more.lo.b[i])...);
    out.hi.a[i] = first.hi;
    out.lo.a[i] = first.lo;
    out.hi.b[i] = second.hi;
    out.lo.b[i] = second.lo;
  }
  return out;
}

/// Packs and pairs of packs.
template <class P>
struct LanesOf {
  static constexpr bool are = false;
};
template <int bytes>
struct LanesOf<Pack<bytes>> {
  static constexpr bool are = true;
};
template <int bytes>
struct LanesOf<Pair<Pack<bytes>>> {
  static constexpr bool are = true;
};
template <class P>
concept Lanes = LanesOf<P>::are;

template <Lanes P>
inline P exp(const P& x) {
  return lane_by_lane([](const auto& lane) { return exp(lane); }, x);
}
template <Lanes P>
inline P sin(const P& x) {
  return lane_by_lane([](const auto& lane) { return sin(lane); }, x);
}
template <Lanes P>
inline P cos(const P& x) {
  return lane_by_lane([](const auto& lane) { return cos(lane); }, x);
}
template <Lanes P>
inline P tan(const P& x) {
  return lane_by_lane([](const auto& lane) { return tan(lane); }, x);
}
template <Lanes P>
inline P tanh(const P& x) {
  return lane_by_lane([](const auto& lane) { return tanh(lane); }, x);
}
template <Lanes P>
inline P atan(const P& x) {
  return lane_by_lane([](const auto& lane) { return atan(lane); }, x);
}
template <Lanes P>
inline P pow(const P& x, const P& p) {
  return lane_by_lane([](const auto& lane, const auto& by) { return pow(lane, by); }, x, p);
}

}  // namespace stationary
