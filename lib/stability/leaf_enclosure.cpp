#include "lib/stability/leaf_enclosure.hpp"

#include <array>
#include <cstddef>
#include <tuple>
#include <type_traits>

#include "lib/stability/enclosure_collector.hpp"

namespace stationary {
namespace {

/// With the axis as it is known, which pi = |pi| axis knows less of.
LeafForm<Interval> whole_of(const EnclosedMotion& at) {
  const auto& a = at.axis;
  const Vector3<Interval> nu{at.speed * a[0], at.speed * a[1], at.speed * a[2]};
  return second_variation(
      at.J, at.q, nu, at.parts.shape(), at.V_qq, [&](const std::array<Interval, 3>& pi) {
        LeafSpin<Interval> out{leaf_frame(std::array{a[0], a[1], a[2]}), at.speed};
        out.frame.size = a[0] * pi[0] + a[1] * pi[1] + a[2] * pi[2];
        return out;
      });
}

class Parts {
 public:
  template <std::size_t m>
  void add(const SquareForm<Interval, m>& E) {
    constexpr std::size_t n = m / 2;
    const bool definite = counted(E);
    if constexpr (n == 1) {
      out_.add_real(square(E[0][1]) - E[0][0] * E[1][1], proven_sign(E[0][0]));
    } else {  // imaginary all of them where E'' is definite
      for (const RootEnclosure& root : enclose_roots(in_squares<n>(E), definite))
        out_.add(root, definite ? 1 : unknown, definite);
    }
  }

  /// Of one coordinate and its momentum: a rate > 0, whose enclosure may hold 0, times E.
  void add_times(const Interval& rate, const SquareForm<Interval, 2>& E) {
    counted(E);
    const Interval lambda = square(E[0][1]) - E[0][0] * E[1][1];
    const int sign = proven_sign(lambda);
    if (sign == unknown) {
      out_.add_real(square(rate) * lambda, unknown);
    } else {
      out_.add_of_sign(square(rate) * lambda, sign, proven_sign(E[0][0]));
    }
  }

  SpectrumEnclosure finish(const Spectrum& approximate) {
    if (definite_) out_.set_definite();
    return out_.finish(approximate);
  }

 private:
  /// Counts its negative directions; whether it is definite.
  template <std::size_t m>
  bool counted(const SquareForm<Interval, m>& E) {
    const std::optional<int> negative = negative_directions(E);
    out_.negative.add(negative);
    if (negative.value_or(0) > 0) out_.set_indefinite();
    definite_ = definite_ && negative == 0;
    return negative == 0;
  }

  EnclosureCollector out_;
  bool definite_ = true;
};

}  // namespace

SpectrumEnclosure enclose_leaf_spectrum(const EnclosedMotion& motion, const Spectrum& approximate) {
  const LeafForm<Interval> whole = whole_of(motion);
  const std::size_t pairs = motion.parts.shape().pairs();
  Parts parts;
  for_each_leaf_part(motion.parts, [&](Block block, const auto& coordinates) {
    if constexpr (std::tuple_size_v<std::decay_t<decltype(coordinates)>> == 1) {
      // E'' of b is |nu| times one of directions alone.
      if (block == Block::odd && !motion.speed.positive()) {
        EnclosedMotion of_one = motion;
        of_one.speed = Interval(1.0);
        parts.add_times(motion.speed, leaf_part(whole_of(of_one), pairs, coordinates));
        return;
      }
    }
    parts.add(leaf_part(whole, pairs, coordinates));
  });
  return parts.finish(approximate);
}

}  // namespace stationary
