// The elementary functions of doubles: within what their header states of 100 digits, and the special
// values of <cmath>.
#include "lib/number/elementary.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/support/bodies/random_states.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace support;

constexpr double infinite = std::numeric_limits<double>::infinity();

double unit_in_the_last_place(double x) {
  const double size = std::abs(x);
  return std::nextafter(size, infinite) - size;
}

double units_off(double actual, const Real100& expected) {
  const double nearest = expected.convert_to<double>();
  return Real100(abs(Real100(actual) - expected) / unit_in_the_last_place(nearest))
      .convert_to<double>();
}

struct TriedInDoubles {
  std::string name;
  double (*actual)(double);
  std::function<Real100(const Real100&)> expected;
  double least;  ///< |x|, of either sign but of log and log10
  double largest;
  double units;
};

const std::vector<TriedInDoubles>& functions_in_doubles() {
  using Wide = const Real100&;
  static const Real100 log_ten = log(Real100(10));
  static const std::vector<TriedInDoubles> all{
      {"exp", exp, [](Wide x) { return Real100(exp(x)); }, 1e-6, 700.0, 0.52},
      {"log", log, [](Wide x) { return Real100(log(x)); }, 1e-300, 1e300, 0.53},
      {"log near 1", log, [](Wide x) { return Real100(log(x)); }, 0.5, 2.0, 0.53},
      {"log1p", log1p, [](Wide x) { return Real100(log(Real100(1 + x))); }, 1e-15, 0.9, 1.1},
      {"log10", log10, [](Wide x) { return Real100(log(x) / log_ten); }, 1e-300, 1e300, 0.501},
      {"sin", sin, [](Wide x) { return Real100(sin(x)); }, 1e-9, 1e8, 0.8},
      {"sin, small", sin, [](Wide x) { return Real100(sin(x)); }, 0.1, 0.8, 0.8},
      {"cos", cos, [](Wide x) { return Real100(cos(x)); }, 1e-9, 1e8, 0.8},
      {"cos, small", cos, [](Wide x) { return Real100(cos(x)); }, 0.1, 0.8, 0.8},
      {"tan", tan, [](Wide x) { return Real100(tan(x)); }, 1e-9, 1e8, 0.8},
      {"tanh", tanh, [](Wide x) { return Real100(tanh(x)); }, 1e-9, 25.0, 0.52},
      {"asin", asin, [](Wide x) { return Real100(asin(x)); }, 1e-6, 1.0, 2.0},
      {"acos", acos, [](Wide x) { return Real100(acos(x)); }, 1e-6, 1.0, 2.0},
      {"atan", atan, [](Wide x) { return Real100(atan(x)); }, 1e-9, 1e12, 0.7}};
  return all;
}

TEST(Elementary, IsWithinWhatIsStated) {
  for (const TriedInDoubles& f : functions_in_doubles()) {
    Random random(921);
    const bool positive = f.name.starts_with("log") && f.name != "log1p";
    for (int trial = 0; trial < 1500; ++trial) {
      const double size = random.log_uniform(f.least, f.largest);
      const double x = positive ? size : random.sign() * size;
      ASSERT_LE(units_off(f.actual(x), f.expected(Real100(x))), f.units) << f.name << ' ' << x;
    }
  }
}

TEST(Elementary, SineBesideItsZerosKeepsItsDigits) {
  for (int k = 1; k < 400; ++k) {
    const double x = 0x1.921fb54442d18p+0 * k;
    ASSERT_LE(units_off(sin(x), Real100(sin(Real100(x)))), 0.8) << x;
    ASSERT_LE(units_off(cos(x), Real100(cos(Real100(x)))), 0.8) << x;
  }
}

TEST(Elementary, PowersAndAnglesOfTwoNumbers) {
  Random random(923);
  for (int trial = 0; trial < 3000; ++trial) {
    const double range = trial % 2 == 0 ? 10.0 : 1e250;
    const double x = random.log_uniform(1.0 / range, range);
    // To the ends of the doubles: log_uniform of the exponent's size.
    const double p = random.sign() * random.log_uniform(1e-3, 700.0) / (1.0 + std::abs(log(x)));
    ASSERT_LE(units_off(pow(x, p), Real100(pow(Real100(x), Real100(p)))), 0.52) << x << ' ' << p;
    const double a = random.sign() * random.log_uniform(1.0 / range, range);
    const double b = random.sign() * random.log_uniform(1.0 / range, range);
    const Real100 angle = atan2(Real100(a), Real100(b));
    if (abs(angle) > std::numeric_limits<double>::min()) {
      ASSERT_LE(units_off(atan2(a, b), angle), 0.7) << a << ' ' << b;
    }
  }
  // Beside 1, where a large exponent shows what the logarithm lacks.
  for (int trial = 0; trial < 3000; ++trial) {
    const double x = 1.0 + random.sign() * random.log_uniform(1e-6, 0.03);
    const double p = random.sign() * random.log_uniform(100.0, 700.0) / std::abs(log(x));
    ASSERT_LE(units_off(pow(x, p), Real100(pow(Real100(x), Real100(p)))), 0.52) << x << ' ' << p;
  }
  for (int k = 0; k <= 22; ++k) {
    EXPECT_EQ(log10(pow(10.0, k)), k);
    EXPECT_EQ(pow(10.0, k), std::stod("1e" + std::to_string(k)));
  }
}

TEST(Elementary, HypotenusesAndCubeRootsAreRounded) {
  Random random(917);
  for (int trial = 0; trial < 2000; ++trial) {
    const double range = trial % 2 == 0 ? 10.0 : 1e300;
    const double x = random.sign() * random.log_uniform(1.0 / range, range);
    const double y = random.sign() * random.log_uniform(1.0 / range, range);
    const Real100 square = Real100(x) * Real100(x) + Real100(y) * Real100(y);
    EXPECT_EQ(hypotenuse(x, y), Real100(sqrt(square)).convert_to<double>()) << x << ' ' << y;
    const Real100 root = pow(Real100(std::abs(x)), Real100(1) / 3);
    EXPECT_EQ(cube_root(x), std::copysign(root.convert_to<double>(), x)) << x;
  }
  EXPECT_EQ(hypotenuse(2.0, -3.0, 6.0), 7.0);
  EXPECT_EQ(hypotenuse(0.0, -0.0), 0.0);
  EXPECT_EQ(hypotenuse(-3e-310, 4e-310), 5e-310);
  EXPECT_EQ(hypotenuse(3e307, -4e307), 5e307);
  EXPECT_EQ(cube_root(-27.0), -3.0);
  EXPECT_EQ(cube_root(0x1p-1071), 0x1p-357);
}

/// The same number with the same sign, or both NaN; of other numbers within two units.
bool agree(double x, double y) {
  if (std::isnan(x) || std::isnan(y)) return std::isnan(x) && std::isnan(y);
  if (std::signbit(x) != std::signbit(y)) return false;
  return x == y || std::abs(x - y) <= 2.0 * unit_in_the_last_place(y);
}

TEST(Elementary, SpecialValuesAreThoseOfTheStandard) {
  const double nan = std::nan("");
  const std::vector<double> special{0.0,     -0.0,   1.0,      -1.0,      0.5,   -0.5,   2.0,
                                    -2.0,    3.0,    -3.0,     22.5,      1e-20, 1e-310, 5e-324,
                                    -5e-324, 1e308,  -1e308,   1e-200,    709.7, 709.79, -745.0,
                                    -745.2,  -720.3, infinite, -infinite, nan};
  const std::vector<std::pair<double (*)(double), double (*)(double)>> of_one{
      {exp, std::exp},     {log, std::log},   {log1p, std::log1p},
      {log10, std::log10}, {tanh, std::tanh}, {asin, std::asin},
      {acos, std::acos},   {atan, std::atan}, {cube_root, std::cbrt}};
  const std::vector<std::pair<double (*)(double), double (*)(double)>> periodic{
      {sin, std::sin}, {cos, std::cos}, {tan, std::tan}};
  const std::vector<std::pair<double (*)(double, double), double (*)(double, double)>> of_two{
      {pow, std::pow},
      {atan2, std::atan2},
      {[](double x, double y) { return hypotenuse(x, y); }, std::hypot}};
  for (const double x : special) {
    for (std::size_t k = 0; k < of_one.size(); ++k)
      EXPECT_TRUE(agree(of_one[k].first(x), of_one[k].second(x))) << k << ' ' << x;
    for (std::size_t k = 0; k < periodic.size(); ++k) {
      const double actual = periodic[k].first(x);
      EXPECT_TRUE(std::abs(x) <= 0x1p30 ? agree(actual, periodic[k].second(x)) : std::isnan(actual))
          << k << ' ' << x;
    }
    for (const double y : special)
      for (std::size_t k = 0; k < of_two.size(); ++k)
        EXPECT_TRUE(agree(of_two[k].first(x, y), of_two[k].second(x, y)))
            << k << ' ' << x << ' ' << y;
  }
}

TEST(Elementary, ComplexQuotientsRootsAndModuli) {
  using Complex = std::complex<double>;
  Random random(924);
  const auto number = [&](double range) {
    return Complex(random.sign() * random.log_uniform(1.0 / range, range),
                   random.sign() * random.log_uniform(1.0 / range, range));
  };
  for (int trial = 0; trial < 3000; ++trial) {
    const double range = trial % 2 == 0 ? 10.0 : 1e60;
    const Complex z = number(range);
    const Complex w = number(range);
    const Real100 a(z.real());
    const Real100 b(z.imag());
    const Real100 size = sqrt(Real100(a * a + b * b));
    ASSERT_LE(units_off(modulus(z), size), 1.1) << z;
    const Complex q = quotient(z, w);
    EXPECT_LE(modulus(q * w - z), 4e-15 * modulus(z)) << z << w;
    const Complex root = square_root(z);
    EXPECT_LE(modulus(root * root - z), 2e-15 * modulus(z)) << z;
    EXPECT_GT(root.real(), 0.0) << z;
  }
  EXPECT_EQ(square_root(Complex(-4.0, 0.0)), Complex(0.0, 2.0));
  EXPECT_EQ(square_root(Complex(-4.0, -0.0)), Complex(0.0, -2.0));
  EXPECT_EQ(square_root(Complex(0.0, 0.0)), Complex(0.0, 0.0));
  EXPECT_EQ(modulus(Complex(-3e300, 4e300)), 5e300);
  EXPECT_EQ(modulus(Complex(3e-300, 4e-300)), 5e-300);
}

/// All bits of many values of each, run together: the same on every processor, by every compiler.
TEST(Elementary, BitsAreThoseOfEveryProcessor) {
  std::uint64_t state = 88172645463325252;  // G. Marsaglia, J. Stat. Software 8 (2003), 14
  const auto next = [&] {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
  };
  const auto number = [&] {  // of either sign, 2^-10 to 2^10
    const std::uint64_t sign_and_digits = next() & 0x800fffffffffffff;
    return std::bit_cast<double>(sign_and_digits | (1013 + next() % 20) << 52);
  };
  std::uint64_t sum = 14695981039346656037U;  // Fowler, Noll and Vo's
  const auto add = [&](double value) {
    sum ^= std::isnan(value) ? 0 : std::bit_cast<std::uint64_t>(value);
    sum *= 1099511628211;
    sum ^= sum >> 29;
  };
  for (int k = 0; k < 100000; ++k) {
    const double y = number();
    const double x = k % 8 == 0 ? std::bit_cast<double>(next()) : number();  // any double at all
    for (const auto& f : {exp, log1p, sin, cos, tan, tanh, asin, acos, atan, cube_root}) add(f(x));
    for (const auto& f : {log, log10}) add(f(std::abs(x)));
    for (const double value : {pow(std::abs(x), y), atan2(x, y), hypotenuse(x, y)}) add(value);
    const std::complex<double> z(x, y);
    const std::complex<double> w(y, 1.0);
    for (const std::complex<double>& value : {quotient(z, w), square_root(z)}) {
      add(value.real());
      add(value.imag());
    }
    add(modulus(z));
  }
  EXPECT_EQ(sum, 1676111696034727169U);
}

}  // namespace
}  // namespace stationary
