#include "solver/program/text/written_number.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>

#include "lib/number/double_double.hpp"

namespace stationary {
namespace {

constexpr int most_digits = 18;  ///< of a 64-bit number, whatever they are

/// What tells a number apart whose digits do not fit (S. C. Noll's and others' FNV-1a).
expression::Decimal too_long(std::string_view text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return {.digits = 0, .power = static_cast<int>(hash >> 1) + 1};
}

/// The digits without zeros at either end; none where they are too many.
expression::Decimal decimal_of(std::string_view text) {
  expression::Decimal out;
  int count = 0;
  int zeros = 0;  ///< since the last other digit
  bool point = false;
  std::size_t at = 0;
  for (; at < text.size() && text[at] != 'e' && text[at] != 'E'; ++at) {
    if (text[at] == '.') {
      point = true;
      continue;
    }
    if (point) --out.power;
    if (text[at] == '0') {
      if (count > 0) ++zeros;
      continue;
    }
    count += zeros + 1;
    if (count > most_digits) return too_long(text);
    for (; zeros > 0; --zeros) out.digits *= 10;
    out.digits = 10 * out.digits + static_cast<std::uint64_t>(text[at] - '0');
  }
  out.power += zeros;
  if (at < text.size()) {
    int power = 0;
    const char* begin = text.data() + at + (text[at + 1] == '+' ? 2 : 1);
    const char* end = text.data() + text.size();
    constexpr int largest = 100000;
    if (std::from_chars(begin, end, power).ec != std::errc() || std::abs(power) > largest)
      return too_long(text);
    out.power += power;
  }
  return out;
}

/// D = value 10^n or value = D 10^n, both checked exactly; longer numbers count as rounded.
bool is_exactly(double value, const expression::Decimal& decimal) {
  constexpr std::uint64_t exact = std::uint64_t{1} << 53;
  constexpr int largest_power = 22;  // 10^22 is the last that is a double
  if (decimal.digits > exact || std::abs(decimal.power) > largest_power) return false;
  const auto digits = static_cast<double>(decimal.digits);
  double scale = 1.0;
  for (int k = 0; k < std::abs(decimal.power); ++k) scale *= 10.0;
  const bool below = decimal.power < 0;
  const DoubleDouble product = two_product(below ? value : digits, scale);
  return product.hi == (below ? digits : value) && product.lo == 0.0;
}

}  // namespace

std::optional<WrittenNumber> written_number(std::string_view text) {
  WrittenNumber out;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out.value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  out.decimal = decimal_of(text);
  out.is_double = out.value == 0.0 || (out.decimal.known() && is_exactly(out.value, out.decimal));
  return out;
}

std::string number_text(double value) { return fmt::format("{}", value == 0.0 ? 0.0 : value); }

}  // namespace stationary
