#include "lib/number/elementary.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "lib/number/double_double_functions.hpp"
#include "lib/number/quarter_turns.hpp"

namespace stationary {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double to_integer = 0x1.8p52;  // added and taken away it rounds to an integer

/// log 2, its head of 33 bits, so that a product with an exponent is exact.
constexpr double log_two_leading = 0x1.62e42fefp-1;
constexpr double log_two_rest = 0x1.473de6af278edp-34;
constexpr double half_pi[3] = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54,
                               -0x1.f1976b7ed8fbcp-110};

/// x 2^k, rounded once.
double scaled(double x, int k) {
  const auto power = [](int of) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + of) << 52);
  };
  if (k > 1000) return x * power(k - 1000) * 0x1p1000;
  if (k < -960) return x * power(k + 120) * 0x1p-120;
  return x * power(k);
}

/// x without the lower half of its digits: products of two of these are exact.
double upper_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xfffffffff8000000);
}

/// 1/n!, from n = `first`.
template <std::size_t count>
constexpr std::array<double, count> reciprocal_factorials(int first, int step) {
  std::array<double, count> out{};
  double factorial = 1.0;  // exact up to 22!
  int n = 1;
  for (std::size_t k = 0; k < count; ++k) {
    for (const int last = first + static_cast<int>(k) * step; n <= last; ++n) factorial *= n;
    out[k] = 1.0 / factorial;
  }
  return out;
}

/// c[0] + c[1] x + ..., neighbours first (Estrin): a shorter chain than Horner's.
template <std::size_t count>
double polynomial(const std::array<double, count>& c, double x) {
  if constexpr (count == 1) {
    return c[0];
  } else {
    std::array<double, (count + 1) / 2> pairs;
    for (std::size_t k = 0; k < pairs.size(); ++k)
      pairs[k] = 2 * k + 1 < count ? c[2 * k] + c[2 * k + 1] * x : c[2 * k];
    return polynomial(pairs, x * x);
  }
}

/// 2^(i/128) = head + tail, head as its bits without the i that is added to its exponent.
struct PowerRow {
  std::uint64_t head;
  double tail_share;  ///< tail/head
};

constexpr int steps = 128;  // of the exponent's table to a factor of 2

constexpr std::array<PowerRow, steps> power_table() {
  constexpr DoubleDouble root{0x1.0163da9fb3335p+0, 0x1.b61299ab8cdb7p-54};  // 2^(1/128)
  std::array<PowerRow, steps> out{};
  DoubleDouble power(1.0);
  for (std::uint64_t i = 0; i < steps; ++i) {
    out[i] = {std::bit_cast<std::uint64_t>(power.hi) - (i << 45), power.lo / power.hi};
    power = renormalized(power * root);
  }
  return out;
}

constexpr std::array<PowerRow, steps> power_rows = power_table();

/// e^x = 2^(k/128) e^r, |r| < 0.0028: e^r - 1 = r + r^2/2 + ... of `order` terms.
struct ReducedPower {
  std::int64_t k;
  DoubleDouble r;
  double rest;  ///< e^r - 1 - r
};

template <int order>
[[gnu::always_inline]] inline ReducedPower reduced_power(double head, double tail) {
  static constexpr auto series = reciprocal_factorials<order - 1>(2, 1);
  const double shifted = head * (steps * 0x1.71547652b82fep+0) + to_integer;
  const double k = shifted - to_integer;
  const DoubleDouble r =
      two_sum(head - k * (log_two_leading / steps), tail - k * (log_two_rest / steps));
  return {std::bit_cast<std::int64_t>(shifted) - std::bit_cast<std::int64_t>(to_integer), r,
          r.hi * r.hi * polynomial(series, r.hi)};
}

/// Of a pair.
[[gnu::always_inline]] inline double exponential(double head, double tail) {
  const bool far = !(std::abs(head) < 708.0);
  if (far) {
    if (!(head < 709.8)) return head != head ? head : infinity;
    if (head < -745.2) return 0.0;
  }
  const auto [k, r, rest] = reduced_power<5>(head, tail);
  const auto bits = static_cast<std::uint64_t>(k);
  const PowerRow& row = power_rows[bits % steps];
  const double share = r.hi + (row.tail_share + rest);
  if (far) {
    const double power = std::bit_cast<double>(row.head + ((bits % steps) << 45));
    return scaled(power + power * share, static_cast<int>(k >> 7));
  }
  const double power = std::bit_cast<double>(row.head + (bits << 45));
  return power + power * share;
}

/// e^x - 1 for 0 <= x < 50.
DoubleDouble exponential_minus_one(double x) {
  const auto [k, r, rest] = reduced_power<7>(x, 0.0);
  if (k == 0) return quick_two_sum(r.hi, rest + r.lo);
  const auto bits = static_cast<std::uint64_t>(k);
  const PowerRow& row = power_rows[bits % steps];
  const double power = std::bit_cast<double>(row.head + (bits << 45));
  const DoubleDouble less = two_sum(power, -1.0);
  const DoubleDouble first = two_product(power, r.hi);
  const DoubleDouble sum = two_sum(less.hi, first.hi);
  return quick_two_sum(sum.hi, sum.lo + (first.lo + less.lo +
                                         power * (row.tail_share * (1.0 + r.hi) + r.lo + rest)));
}

/// log x = head + tail + lo - z^2/2 + cubic, 0 < x < infinity: x = 2^k m, m r = 1 + z with r from a
/// table, |z| < 2^-7; lo is that of z, cubic = z^3/3 - z^4/4 + ... of `terms`.
struct Logarithm {
  double head;
  double tail;
  DoubleDouble z;
  double cubic;
};

template <std::size_t terms>
[[gnu::always_inline]] inline Logarithm logarithm(double x) {
  constexpr std::uint64_t first_interval = 0x3fe6000000000000;  // 0.6875, so that 1 needs no table
  static constexpr auto series = [] {
    std::array<double, terms> out{};
    for (std::size_t n = 0; n < terms; ++n)
      out[n] = (n % 2 == 0 ? 1.0 : -1.0) / static_cast<double>(n + 3);
    return out;
  }();
  double k = 0.0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    k = -54.0;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t offset = bits - first_interval;
  k += static_cast<double>(static_cast<std::int64_t>(offset) >> 52);
  const LogRow& row = coarse_rows[(offset >> 45) & 127];
  const double m = std::bit_cast<double>(bits - (offset & 0xfff0000000000000));
  const double m_head = upper_half(m);
  const double r_head = upper_half(row.reciprocal);
  // In each pair the first is the larger, or a multiple of the other's last place.
  const DoubleDouble z = quick_two_sum(
      m_head * r_head - 1.0, m_head * (row.reciprocal - r_head) + (m - m_head) * row.reciprocal);
  const DoubleDouble first = quick_two_sum(k * log_two_leading, row.head);
  const DoubleDouble second = quick_two_sum(first.hi, z.hi);
  return {second.hi, (k * log_two_rest + row.tail) + (first.lo + second.lo), z,
          (z.hi * z.hi) * z.hi * polynomial(series, z.hi)};
}

/// sin and cos of r, |r| < 0.79.
SineCosine<DoubleDouble> small_sine_cosine(const DoubleDouble& r) {
  static constexpr auto sines = reciprocal_factorials<9>(3, 2);
  static constexpr auto cosines = reciprocal_factorials<9>(4, 2);
  const DoubleDouble z = two_product(r.hi, r.hi);
  const double sine = -r.hi * z.hi * polynomial(sines, -z.hi);
  const DoubleDouble head = quick_two_sum(1.0, -0.5 * z.hi);
  const double cosine = z.hi * z.hi * polynomial(cosines, -z.hi);
  return {quick_two_sum(r.hi, sine + r.lo * (1.0 - 0.5 * z.hi)),
          quick_two_sum(head.hi, head.lo + (cosine - 0.5 * z.lo - r.hi * r.lo))};
}

/// x = k pi/2 + r.
SineCosine<DoubleDouble> pair_sine_cosine(double x) {
  if (!(std::abs(x) <= 0x1p30)) return {not_a_number, not_a_number};
  if (std::abs(x) < 0.78) return small_sine_cosine(x);
  const double k = (x * 0x1.45f306dc9c883p-1 + to_integer) - to_integer;
  const DoubleDouble head = two_product(k, half_pi[0]);
  const DoubleDouble tail = two_product(k, half_pi[1]);
  const DoubleDouble first = two_sum(x - head.hi, -head.lo);
  const DoubleDouble second = two_sum(first.hi, -tail.hi);
  const double least = first.lo + (second.lo - tail.lo - k * half_pi[2]);
  const auto [sine, cosine] = small_sine_cosine(quick_two_sum(second.hi, least));
  return after_quarter_turns(k, sine, cosine);
}

/// atan of t, 0 <= t <= 1: a polynomial to 2e-8 (M. Abramowitz, I. Stegun, Handbook of Mathematical
/// Functions, 4.4.49), and what tan of it lacks.
DoubleDouble small_arctangent(const DoubleDouble& t) {
  if (t.hi < 0x1p-30) return t;
  static constexpr std::array<double, 9> series{1.0,          -.3333314528, .1999355085,
                                                -.1420889944, .1065626393,  -.0752896400,
                                                .0429096138,  -.0161657367, .0028662257};
  const double near = t.hi * polynomial(series, t.hi * t.hi);
  const auto [sine, cosine] = small_sine_cosine(near);
  const double lacks = double(t * cosine - sine) / (cosine.hi + t.hi * sine.hi);
  return quick_two_sum(near, lacks);
}

/// That of a / b, a and b positive and finite.
DoubleDouble arctangent(double a, double b) {
  const double larger = std::max(a, b);
  const double unit = larger > 0x1p500 ? 0x1p-600 : larger < 0x1p-400 ? 0x1p500 : 1.0;
  const bool steep = a > b;
  const double over = unit * std::min(a, b);
  const double under = unit * larger;
  // Whose products would underflow: t itself is small enough.
  const DoubleDouble t = over < 0x1p-60 * under ? DoubleDouble(std::min(a, b) / larger)
                                                : DoubleDouble(over) / DoubleDouble(under);
  const DoubleDouble angle = small_arctangent(renormalized(t));
  return steep ? DoubleDouble(half_pi[0], half_pi[1]) - angle : angle;
}

/// The rounded arctangent() of a / b < 1/32 by its series, of which all but the first term is in
/// double; NaN where that leaves the rounding open, which is rare, or a product may not be
/// exact.
double quick_arctangent(double a, double b) {
  if (!(a > 0x1p-400) || !(b < 0x1p500)) return not_a_number;
  const DoubleDouble t = renormalized(DoubleDouble(a) / DoubleDouble(b));
  if (t.hi < 0x1p-30) return not_a_number;  // t itself (small_arctangent)
  static constexpr std::array<double, 6> series{-1.0 / 3.0, 1.0 / 5.0,   -1.0 / 7.0,
                                                1.0 / 9.0,  -1.0 / 11.0, 1.0 / 13.0};
  const double z = t.hi * t.hi;
  const double rest = t.hi * (z * polynomial(series, z));
  const double tail = (t.lo - t.lo * z) + rest;
  const double error = 0x1p-49 * std::abs(rest) + 0x1p-70 * t.hi;
  const double angle = t.hi + (tail + error);
  return angle == t.hi + (tail - error) ? angle : not_a_number;
}

bool is_whole(double p) { return std::floor(p) == p; }
bool is_odd(double p) { return is_whole(p) && std::floor(0.5 * p) != 0.5 * p; }

}  // namespace

double exp(double x) noexcept { return exponential(x, 0.0); }

double log(double x) noexcept {
  if (!(x > 0.0) || x == infinity) return x == 0.0 ? -infinity : x > 0.0 ? x : not_a_number;
  const Logarithm of = logarithm<6>(x);
  return of.head + ((of.tail + of.z.lo) + (of.cubic - 0.5 * (of.z.hi * of.z.hi)));
}

/// log of the rounded 1 + x, and what the rounding left.
double log1p(double x) noexcept {
  const DoubleDouble sum = two_sum(1.0, x);
  if (sum.hi == 1.0) return x;
  if (!(sum.hi > 0.0) || sum.hi == infinity) return log(sum.hi);
  return log(sum.hi) + sum.lo / sum.hi;
}

double log10(double x) noexcept {
  if (!(x > 0.0) || x == infinity) return log(x);
  constexpr DoubleDouble log_ten_reciprocal{0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57};
  return double(log(DoubleDouble(x)) * log_ten_reciprocal);
}

double pow(double x, double p) noexcept {
  if (p == 0.0 || x == 1.0) return 1.0;
  if (x != x || p != p) return not_a_number;
  const double sign = std::signbit(x) && is_odd(p) ? -1.0 : 1.0;
  const double size = std::abs(x);
  if (size == 0.0 || size == infinity) return sign * ((size == 0.0) == (p > 0.0) ? 0.0 : infinity);
  if (x < 0.0 && !is_whole(p)) return not_a_number;
  if (size == 1.0) return sign;
  const Logarithm of = logarithm<9>(size);  // p makes an error larger
  const double z = of.z.hi;
  const double z_head = upper_half(z);
  const DoubleDouble head = quick_two_sum(of.head, -0.5 * (z_head * z_head));
  const double tail = (of.tail + (of.z.lo - z * of.z.lo)) - 0.5 * ((z - z_head) * (z + z_head));
  const DoubleDouble logarithm = quick_two_sum(head.hi, head.lo + (tail + of.cubic));
  const double rough = p * logarithm.hi;
  if (!(std::abs(rough) < 800.0)) return sign * (rough > 0.0 ? infinity : 0.0);
  if (std::abs(rough) < 0x1p-60) return sign;
  const double p_head = upper_half(p);
  const double logarithm_head = upper_half(logarithm.hi);
  const double rest = p * ((logarithm.hi - logarithm_head) + logarithm.lo);
  return sign * exponential(p_head * logarithm_head, rest + (p - p_head) * logarithm_head);
}

double sin(double x) noexcept {
  if (std::abs(x) < 0x1p-30) return x;
  return double(pair_sine_cosine(x).sine);
}

double cos(double x) noexcept { return double(pair_sine_cosine(x).cosine); }

double tan(double x) noexcept {
  if (std::abs(x) < 0x1p-30) return x;
  const auto [sine, cosine] = pair_sine_cosine(x);
  return double(sine / cosine);
}

double tanh(double x) noexcept {
  const double size = std::abs(x);
  if (size < 0x1p-30 || x != x) return x;
  if (size > 22.0) return std::copysign(1.0, x);
  const DoubleDouble e = exponential_minus_one(2.0 * size);
  return std::copysign(double(e / renormalized(e + 2.0)), x);
}

double asin(double x) noexcept { return atan2(x, std::sqrt((1.0 - x) * (1.0 + x))); }
double acos(double x) noexcept { return atan2(std::sqrt((1.0 - x) * (1.0 + x)), x); }
double atan(double x) noexcept { return atan2(x, 1.0); }

double atan2(double y, double x) noexcept {
  if (x != x || y != y) return not_a_number;
  if (std::abs(x) == infinity || std::abs(y) == infinity) {
    const auto direction = [](double of) {
      return std::copysign(std::abs(of) == infinity ? 1.0 : 0.0, of);
    };
    return atan2(direction(y), direction(x));
  }
  if (y == 0.0) return std::signbit(x) ? std::copysign(2.0 * half_pi[0], y) : y;
  if (x == 0.0) return std::copysign(half_pi[0], y);
  if (std::abs(y) < 0x1p-5 * x) {
    const double quick = quick_arctangent(std::abs(y), x);
    if (quick == quick) return std::copysign(quick, y);
  }
  DoubleDouble angle = arctangent(std::abs(y), std::abs(x));
  if (x < 0.0) angle = double_double_pi - angle;
  return std::copysign(double(angle), y);
}

double hypotenuse(double x, double y, double z) noexcept {
  const double size = std::fmax(std::fmax(std::abs(x), std::abs(y)), std::abs(z));
  // Where all but one are zero, or nothing beside it.
  if ((std::abs(x) + std::abs(y)) + std::abs(z) == size) return size;
  if (size == infinity) return infinity;
  if (x != x || y != y || z != z) return not_a_number;
  const double unit = size > 0x1p400 ? 0x1p-600 : size < 0x1p-400 ? 0x1p600 : 1.0;
  DoubleDouble sum;
  for (const double part : {x, y, z}) sum += two_product(part * unit, part * unit);
  return double(sqrt(sum)) / unit;
}

/// A third of the exponent, then Newton's steps, the last one in extended precision.
double cube_root(double x) noexcept {
  double size = std::abs(x);
  if (!(size > 0.0) || size == infinity) return x;
  const bool small = size < 0x1p-900;
  if (small) size *= 0x1p600;
  double root = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) / 3 + 0x2a9f7893782da1ce);
  for (int step = 0; step < 4; ++step) root -= (root - size / (root * root)) / 3.0;
  const DoubleDouble square = two_product(root, root);
  root -= double(square * root - size) / (3.0 * square.hi);
  return std::copysign(small ? 0x1p-200 * root : root, x);
}

/// By the larger part of w (R. L. Smith, Comm. ACM 5 (1962) 435).
std::complex<double> quotient(const std::complex<double>& z,
                              const std::complex<double>& w) noexcept {
  if (std::abs(w.real()) >= std::abs(w.imag())) {
    const double ratio = w.imag() / w.real();
    const double under = w.real() + w.imag() * ratio;
    return {(z.real() + z.imag() * ratio) / under, (z.imag() - z.real() * ratio) / under};
  }
  const double ratio = w.real() / w.imag();
  const double under = w.real() * ratio + w.imag();
  return {(z.real() * ratio + z.imag()) / under, (z.imag() * ratio - z.real()) / under};
}

std::complex<double> square_root(const std::complex<double>& z) noexcept {
  const double size = modulus(z);
  if (size == 0.0) return {0.0, z.imag()};
  const double larger = std::sqrt(0.5 * (size + std::abs(z.real())));
  const double other = 0.5 * z.imag() / larger;
  if (z.real() >= 0.0) return {larger, other};
  return {std::abs(other), std::copysign(larger, z.imag())};
}

}  // namespace stationary
