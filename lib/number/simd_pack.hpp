// Many doubles as one number: two registers of the instruction set a file is compiled for, so that
// the templates of this library (potentials, balances, pairs) run in all lanes at once.
//
// Each operation rounds as that of double does, lane by lane, and nothing is contracted: a lane's
// result is the same whatever its neighbours are and whichever instruction set computes it. Two
// registers, because a Newton step is a chain of operations that one alone would wait for.
//
// A file that uses Pack<64> must be compiled for AVX-512, Pack<32> for AVX2 with FMA; Pack<16> asks for
// no instructions by name and is SSE2 on x86-64, NEON on aarch64. The width is part of every name built
// from it, so that the linker cannot take code of one file for another's.
#pragma once

#include <bit>
#include <cstdint>

#ifdef __SSE2__
#include <immintrin.h>
#endif

#include "lib/number/double_double.hpp"

namespace stationary {

template <int bytes>
struct PackRegister;
template <>
struct PackRegister<16> {
  using Double [[gnu::vector_size(16)]] = double;
  using Integer [[gnu::vector_size(16)]] = std::int64_t;
  using Unsigned [[gnu::vector_size(16)]] = std::uint64_t;
};
#ifdef __AVX2__
template <>
struct PackRegister<32> {
  using Double [[gnu::vector_size(32)]] = double;
  using Integer [[gnu::vector_size(32)]] = std::int64_t;
  using Unsigned [[gnu::vector_size(32)]] = std::uint64_t;
};
#endif
#ifdef __AVX512F__
template <>
struct PackRegister<64> {
  using Double [[gnu::vector_size(64)]] = double;
  using Integer [[gnu::vector_size(64)]] = std::int64_t;
  using Unsigned [[gnu::vector_size(64)]] = std::uint64_t;
};
#endif

/// Which lanes; of a comparison.
template <int bytes>
struct PackMask {
  using Register = typename PackRegister<bytes>::Integer;
  Register a;
  Register b;

  [[gnu::always_inline]] friend PackMask operator&(const PackMask& x, const PackMask& y) {
    return {x.a & y.a, x.b & y.b};
  }
  [[gnu::always_inline]] friend PackMask operator|(const PackMask& x, const PackMask& y) {
    return {x.a | y.a, x.b | y.b};
  }
  [[gnu::always_inline]] friend PackMask operator~(const PackMask& x) { return {~x.a, ~x.b}; }

  [[gnu::always_inline]] friend bool any(const PackMask& x) {
    const Register both = x.a | x.b;
#ifdef __AVX512F__
    if constexpr (bytes == 64) {
      const auto bits = std::bit_cast<__m512i>(both);
      return _mm512_test_epi64_mask(bits, bits) != 0;
    }
#endif
#ifdef __AVX2__
    if constexpr (bytes == 32) return _mm256_movemask_pd(std::bit_cast<__m256d>(both)) != 0;
#endif
    if constexpr (bytes == 16) return (both[0] | both[1]) != 0;
  }
};

template <int bytes>
struct Pack {
  using Register = typename PackRegister<bytes>::Double;
  using Mask = PackMask<bytes>;
  static constexpr int half = bytes / 8;
  static constexpr int lanes = 2 * half;

  Register a;
  Register b;

  Pack() = default;
  [[gnu::always_inline]] Pack(double x)  // NOLINT(google-explicit-constructor)
      : a(x - Register{}), b(x - Register{}) {}
  [[gnu::always_inline]] Pack(Register first, Register second) : a(first), b(second) {}

  /// `lanes` doubles; no alignment asked for.
  [[gnu::always_inline]] static Pack load(const double* from) {
    Pack out;
    __builtin_memcpy(&out.a, from, bytes);
    __builtin_memcpy(&out.b, from + half, bytes);
    return out;
  }
  [[gnu::always_inline]] void store(double* to) const {
    __builtin_memcpy(to, &a, bytes);
    __builtin_memcpy(to + half, &b, bytes);
  }

  [[gnu::always_inline]] friend Pack operator+(const Pack& x, const Pack& y) {
    return {x.a + y.a, x.b + y.b};
  }
  [[gnu::always_inline]] friend Pack operator-(const Pack& x, const Pack& y) {
    return {x.a - y.a, x.b - y.b};
  }
  [[gnu::always_inline]] friend Pack operator*(const Pack& x, const Pack& y) {
    return {x.a * y.a, x.b * y.b};
  }
  [[gnu::always_inline]] friend Pack operator/(const Pack& x, const Pack& y) {
    return {x.a / y.a, x.b / y.b};
  }
  [[gnu::always_inline]] friend Pack operator-(const Pack& x) { return {-x.a, -x.b}; }
  [[gnu::always_inline]] friend Pack& operator+=(Pack& x, const Pack& y) { return x = x + y; }
  [[gnu::always_inline]] friend Pack& operator-=(Pack& x, const Pack& y) { return x = x - y; }

  [[gnu::always_inline]] friend Mask operator<(const Pack& x, const Pack& y) {
    return {x.a < y.a, x.b < y.b};
  }
  [[gnu::always_inline]] friend Mask operator<=(const Pack& x, const Pack& y) {
    return {x.a <= y.a, x.b <= y.b};
  }
  [[gnu::always_inline]] friend Mask operator==(const Pack& x, const Pack& y) {
    return {x.a == y.a, x.b == y.b};
  }

  /// x where the mask is set, y elsewhere.
  [[gnu::always_inline]] friend Pack select(const Mask& where, const Pack& x, const Pack& y) {
    return {where.a ? x.a : y.a, where.b ? x.b : y.b};
  }
  [[gnu::always_inline]] friend Pack abs(const Pack& x) {
    const auto magnitude = [](Register r) {
      using Integer = typename PackRegister<bytes>::Integer;
      return std::bit_cast<Register>(std::bit_cast<Integer>(r) & INT64_MAX);
    };
    return {magnitude(x.a), magnitude(x.b)};
  }
  /// The larger; y where x is NaN.
  [[gnu::always_inline]] friend Pack larger(const Pack& x, const Pack& y) {
    return select(y < x, x, y);
  }
  /// NaN below 0.
  [[gnu::always_inline]] friend Pack sqrt(const Pack& x) {
#ifdef __AVX512F__
    // With a mask of all lanes: the unmasked one is a false alarm of GCC 12 (uninitialized).
    if constexpr (bytes == 64)
      return {_mm512_maskz_sqrt_pd(0xff, x.a), _mm512_maskz_sqrt_pd(0xff, x.b)};
#endif
#ifdef __AVX2__
    if constexpr (bytes == 32) return {_mm256_sqrt_pd(x.a), _mm256_sqrt_pd(x.b)};
#endif
    if constexpr (bytes == 16) {
      const auto root = [](Register r) {
        return Register{__builtin_sqrt(r[0]), __builtin_sqrt(r[1])};
      };
      return {root(x.a), root(x.b)};
    }
  }
};

#ifdef __AVX2__
[[gnu::always_inline]] inline __m256d multiply_subtract(__m256d a, __m256d b, __m256d c) {
  return _mm256_fmsub_pd(a, b, c);
}
#endif
#ifdef __AVX512F__
[[gnu::always_inline]] inline __m512d multiply_subtract(__m512d a, __m512d b, __m512d c) {
  return _mm512_fmsub_pd(a, b, c);
}
#endif

/// fl(a b) and its rounding error, as of doubles.
template <int bytes>
[[gnu::always_inline]] inline Pair<Pack<bytes>> two_product(const Pack<bytes>& x,
                                                            const Pack<bytes>& y) {
  if constexpr (bytes == 16) {
    return split_product(x, y);
  } else {
    const Pack<bytes> p = x * y;
    return {p, Pack<bytes>(multiply_subtract(x.a, y.a, p.a), multiply_subtract(x.b, y.b, p.b))};
  }
}

/// Of pairs, as of doubles (double_double.hpp).
template <int bytes>
[[gnu::always_inline]] inline Pair<Pack<bytes>>& operator+=(Pair<Pack<bytes>>& x,
                                                            const Pair<Pack<bytes>>& y) {
  return x = x + y;
}
template <int bytes>
[[gnu::always_inline]] inline Pair<Pack<bytes>>& operator-=(Pair<Pack<bytes>>& x,
                                                            const Pair<Pack<bytes>>& y) {
  return x = x - y;
}
template <int bytes>
[[gnu::always_inline]] inline Pack<bytes> leading(const Pair<Pack<bytes>>& x) {
  return x.hi + x.lo;
}
template <int bytes>
[[gnu::always_inline]] inline Pair<Pack<bytes>> renormalized(const Pair<Pack<bytes>>& x) {
  return two_sum(x.hi, x.lo);
}
template <int bytes>
[[gnu::always_inline]] inline Pair<Pack<bytes>> select(const PackMask<bytes>& where,
                                                       const Pair<Pack<bytes>>& x,
                                                       const Pair<Pack<bytes>>& y) {
  return {select(where, x.hi, y.hi), select(where, x.lo, y.lo)};
}
/// 0 where x is not positive.
template <int bytes>
[[gnu::always_inline]] inline Pair<Pack<bytes>> sqrt(const Pair<Pack<bytes>>& y) {
  using P = Pack<bytes>;
  const Pair<P> x = renormalized(y);
  const auto positive = P(0.0) < x.hi;
  const P r = sqrt(select(positive, x.hi, P(1.0)));
  const Pair<P> square = two_product(r, r);
  const P tail = (((x.hi - square.hi) - square.lo) + x.lo) / (2.0 * r);
  return {select(positive, r, P(0.0)), select(positive, tail, P(0.0))};
}

/// x = 2^k m with m in [0.6875, 1.375), for normal positive x.
template <int bytes>
struct PackExponent {
  using Integer = typename PackRegister<bytes>::Integer;
  Pack<bytes> m;
  Pack<bytes> k;
  Pack<bytes> scale;  ///< 2^-k
  Integer row_a;      ///< of coarse_rows, that of m
  Integer row_b;
};

template <int bytes>
[[gnu::always_inline]] inline PackExponent<bytes> split_exponent(const Pack<bytes>& x) {
  using Double = typename PackRegister<bytes>::Double;
  using Integer = typename PackRegister<bytes>::Integer;
  using Unsigned = typename PackRegister<bytes>::Unsigned;
  constexpr std::uint64_t first_interval = 0x3fe6000000000000;  // 0.6875
  constexpr std::uint64_t exponent_bits = 0xfff0000000000000;
  constexpr std::uint64_t one = 0x3ff0000000000000;
  PackExponent<bytes> out;
  const auto part = [](Double r, Double& m, Double& k, Double& scale, Integer& row) {
    const Unsigned offset = std::bit_cast<Unsigned>(r) - first_interval;
    row = std::bit_cast<Integer>((offset >> 45) & 127U);
    m = std::bit_cast<Double>(std::bit_cast<Unsigned>(r) - (offset & exponent_bits));
    scale = std::bit_cast<Double>(one - (offset & exponent_bits));
    // k + 2048 in the low bits of 2^52: a conversion that every instruction set has.
    const Unsigned raised = (offset + 0x8000000000000000U) >> 52;
    k = std::bit_cast<Double>(raised | 0x4330000000000000U) - (0x1p52 + 2048.0);
  };
  part(x.a, out.m.a, out.k.a, out.scale.a, out.row_a);
  part(x.b, out.m.b, out.k.b, out.scale.b, out.row_b);
  return out;
}

/// log x for normal positive x, to 2^-51 (1 + |log x|): anything elsewhere. No table:
/// log m = 2 atanh s, s = (m - 1)/(m + 1), |s| <= 3/16.
template <int bytes>
[[gnu::always_inline]] inline Pack<bytes> log(const Pack<bytes>& x) {
  using P = Pack<bytes>;
  const PackExponent<bytes> split = split_exponent(x);
  const P s = (split.m - 1.0) / (split.m + 1.0);
  const P z = s * s;
  const P z2 = z * z;
  const P z4 = z2 * z2;
  const P low = (1.0 / 3.0 + z * (1.0 / 5.0)) + z2 * (1.0 / 7.0 + z * (1.0 / 9.0));
  const P high = (1.0 / 11.0 + z * (1.0 / 13.0)) + z2 * (1.0 / 15.0 + z * (1.0 / 17.0));
  return split.k * double_double_log_two.hi +
         2.0 * (s + s * (z * (low + z4 * (high + z4 * (1.0 / 19.0)))));
}

/// One number a lane of a table's rows.
template <int bytes, class Member>
[[gnu::always_inline]] inline Pack<bytes> gathered(const PackExponent<bytes>& at, Member member) {
  Pack<bytes> out;
  for (int i = 0; i < Pack<bytes>::half; ++i) {
    out.a[i] = coarse_rows[at.row_a[i]].*member;
    out.b[i] = coarse_rows[at.row_b[i]].*member;
  }
  return out;
}

/// log x of a pair with normal positive head, to 2^-70 (1 + |log x|): shorter than that of
/// DoubleDouble, with one table of its two.
template <int bytes>
[[gnu::always_inline]] inline Pair<Pack<bytes>> log(const Pair<Pack<bytes>>& x) {
  using P = Pack<bytes>;
  const PackExponent<bytes> split = split_exponent(x.hi);
  const P m_tail = x.lo * split.scale;
  const P reciprocal = gathered(split, &LogRow::reciprocal);
  const Pair<P> product = two_product(split.m, reciprocal);
  const Pair<P> z = two_sum(product.hi - 1.0, product.lo + m_tail * reciprocal);
  const P h = z.hi;
  const P series =
      1.0 / 3.0 -
      h * (0.25 - h * (0.2 - h * (1.0 / 6.0 - h * (1.0 / 7.0 - h * (0.125 - h * (1.0 / 9.0))))));
  const Pair<P> square = z * z;
  const Pair<P> logarithm_1p =
      z + Pair<P>(-0.5 * square.hi, -0.5 * square.lo) + Pair<P>(h * h * h * series);
  const Pair<P> table(gathered(split, &LogRow::head), gathered(split, &LogRow::tail));
  const Pair<P> exponent =
      Pair<P>(P(double_double_log_two.hi), P(double_double_log_two.lo)) * Pair<P>(split.k);
  return exponent + (table + logarithm_1p);
}

}  // namespace stationary
