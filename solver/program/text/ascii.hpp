// The characters of a name, and those of a text in UTF-8, in which a character is one byte or
// several: a first one and continuation bytes 10xxxxxx.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace stationary {

/// What a name begins with: ASCII letters and the stroke.
constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A letter, then letters and digits.
constexpr bool is_name(std::string_view text) {
  return !text.empty() && is_letter(text[0]) &&
         std::ranges::all_of(text, [](char c) { return is_letter(c) || is_digit(c); });
}

/// Whether a byte goes on with the character that the bytes before it began.
constexpr bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// How many characters (code points) a text has, as columns of a file are counted.
constexpr std::size_t character_count(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, is_continuation));
}

}  // namespace stationary
