#include "lib/double_double.hpp"

#include <bit>
#include <cstdint>

#include "lib/double_double_log_table.hpp"

namespace stationary {
namespace {

constexpr DoubleDouble log_two{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr std::uint64_t first_interval =
    0x3fe6000000000000;  // 0.6875, so that x = 1 needs no table

}  // namespace

DoubleDouble log(const DoubleDouble& x) {
  if (!(x.hi >= std::numeric_limits<double>::min()) ||
      !(x.hi <= std::numeric_limits<double>::max())) {
    return std::log(x.hi);  // zero, negative, subnormal, infinite, NaN
  }
  const auto bits = std::bit_cast<std::uint64_t>(x.hi);
  const std::uint64_t offset = bits - first_interval;
  const auto exponent = static_cast<int>(static_cast<std::int64_t>(offset) >> 52);
  const LogRow& coarse = coarse_rows[(offset >> 45) & 127];
  const double m = std::bit_cast<double>(bits - (offset & 0xfff0000000000000));
  const double m_tail = std::ldexp(x.lo, -exponent);

  // m r1 = 1 + z1, |z1| < 2^-7; then (1 + z1) r2 = 1 + z, |z| < 2^-14.9.
  const DoubleDouble p1 = two_product(m, coarse.reciprocal);
  const double p1_tail = p1.lo + m_tail * coarse.reciprocal;
  const auto j = static_cast<int>(std::lrint((p1.hi - 1.0) * 0x1p14));
  const LogRow& fine = fine_rows[j + 128];
  const DoubleDouble p2 = two_product(p1.hi, fine.reciprocal);
  const DoubleDouble z = two_sum(p2.hi - 1.0, p2.lo + p1_tail * fine.reciprocal);

  // log(1 + z) = z - z^2/2 + z^3 (1/3 - z/4 + z^2/5 - z^3/6 + ...): the cube is below 2^-46.
  const double h = z.hi;
  const double cubic = h * h * h * (1.0 / 3.0 - h * (0.25 - h * (0.2 - h * (1.0 / 6.0))));
  const DoubleDouble square = z * z;
  const DoubleDouble logarithm_1p = z + DoubleDouble(-0.5 * square.hi, -0.5 * square.lo) + cubic;
  const DoubleDouble table =
      DoubleDouble(coarse.head, coarse.tail) + DoubleDouble(fine.head, fine.tail);
  if (exponent == 0) return table + logarithm_1p;
  return log_two * static_cast<double>(exponent) + (table + logarithm_1p);
}

}  // namespace stationary
