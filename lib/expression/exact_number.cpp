#include "lib/expression/exact_number.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "lib/expression/graph.hpp"
#include "lib/number/interval_functions.hpp"

namespace stationary::expression {
namespace {

constexpr std::uint64_t power_symbol = 1;
constexpr std::uint64_t logarithm_symbol = 2;

Interval whole_power(const Interval& x, int n) {
  if (n < 0) return Interval(1.0) / whole_power(x, -n);
  if (n == 0) return Interval(1.0);
  const Interval half = whole_power(x, n / 2);
  return n % 2 == 0 ? square(half) : square(half) * x;
}

Residue whole_power(const Residue& x, int n) {
  if (n < 0) {
    const std::optional<Residue> below = reciprocal(x);
    if (!below) throw NotNormal("a division by what is 0");
    return whole_power(*below, -n);
  }
  if (n == 0) return {1, 1};
  const Residue half = whole_power(x, n / 2);
  return n % 2 == 0 ? half * half : half * half * x;
}

}  // namespace

ExactNumber ExactNumber::whole(int n) {
  // 1 + 1 + ... by doubling.
  Residue key;
  for (unsigned bit = 1U << 30; bit != 0; bit >>= 1) {
    key = key + key;
    if (static_cast<unsigned>(std::abs(n)) & bit) key = key + Residue{1, 1};
  }
  return {Interval(n), n < 0 ? -key : key};
}

std::optional<int> as_whole(const ExactNumber& x) {
  static const auto keys = [] {
    std::array<Residue, 2 * Graph::largest_exponent + 1> out;
    for (int n = 0; n <= 2 * Graph::largest_exponent; ++n)
      out[static_cast<std::size_t>(n)] = ExactNumber::whole(n - Graph::largest_exponent).key;
    return out;
  }();
  const double nearest = std::round(x.value.mid());
  if (!(std::abs(nearest) <= Graph::largest_exponent)) return std::nullopt;
  const int n = static_cast<int>(nearest);
  if (keys[static_cast<std::size_t>(n + Graph::largest_exponent)] != x.key || !x.value.may_be(n))
    return std::nullopt;
  return n;
}

ExactNumber snapped(const ExactNumber& x) {
  if (x.value.lo == x.value.hi) return x;
  const auto n = as_whole(x);
  return n ? ExactNumber{Interval(*n), x.key} : x;
}

ExactNumber operator+(const ExactNumber& x, const ExactNumber& y) {
  if (x.is_zero()) return y;
  if (y.is_zero()) return x;
  return snapped({x.value + y.value, x.key + y.key});
}
ExactNumber operator-(const ExactNumber& x) { return {-x.value, -x.key}; }
ExactNumber operator*(const ExactNumber& x, const ExactNumber& y) {
  if (x.is_one()) return y;
  if (y.is_one()) return x;
  return snapped({x.value * y.value, x.key * y.key});
}

ExactNumber power(const ExactNumber& x, int n) {
  if (n == 1 || x.is_one()) return x;
  return snapped({whole_power(x.value, n), whole_power(x.key, n)});
}

ExactNumber power(const ExactNumber& x, const ExactNumber& r) {
  if (x.is_one()) return x;
  if (const auto n = as_whole(r)) return power(x, *n);
  return {pow(x.value, r.value), symbol(power_symbol, x.key, r.key)};
}

ExactNumber logarithm(const ExactNumber& x) {
  return {log(x.value), symbol(logarithm_symbol, x.key)};
}

ExactNumber magnitude(const ExactNumber& x) {
  if (x.value.positive()) return x;
  if (x.value.negative()) return -x;
  throw NotNormal("a coefficient whose sign is not known");
}

std::strong_ordering compare(const ExactNumber& x, const ExactNumber& y) {
  if (x.key == y.key) return std::strong_ordering::equal;
  const double a = x.value.mid();
  const double b = y.value.mid();
  if (a != b) return a < b ? std::strong_ordering::less : std::strong_ordering::greater;
  return x.key <=> y.key;
}

}  // namespace stationary::expression
