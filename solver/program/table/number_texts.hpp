// Numbers as the shortest text that is read back as the same number, of which many in a table are
// ones that were written just before: a parameter that is held, lambda and mu that are xi and zeta, a
// growth that is a mode's. Their text is copied, and not found once more.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

namespace stationary {

/// A zero's sign says nothing.
char* append_number(double value, char* at);

/// The text that each of some places has had last.
template <std::size_t places>
class NumberTexts {
 public:
  static constexpr std::size_t longest = 32;  ///< shortest round trip takes 24

  /// Of a number that is not NaN into `at`, where there is room for `longest`; the text's end. place:
  /// where it stands, likely: others that have had the same number.
  char* append(double value, std::size_t place, std::span<const std::uint8_t> likely, char* at) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    if (texts_[place].bits == bits) return copy(texts_[place], at);
    for (const std::uint8_t other : likely)
      if (texts_[other].bits == bits) return copy(texts_[other], at);
    char* const end = append_number(value, at);
    Text& own = texts_[place];
    own.bits = bits;
    own.size = static_cast<std::uint8_t>(end - at);
    std::memcpy(own.text.data(), at, longest);
    return end;
  }

 private:
  struct Text {
    std::uint64_t bits = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::quiet_NaN());
    std::uint8_t size = 0;
    std::array<char, longest> text;
  };
  /// All of it, also what is beyond its end: of one length, and overwritten.
  static char* copy(const Text& from, char* at) {
    std::memcpy(at, from.text.data(), longest);
    return at + from.size;
  }

  std::array<Text, places> texts_;
};

}  // namespace stationary
