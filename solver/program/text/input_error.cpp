#include "solver/program/text/input_error.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

#include "solver/program/text/utf8.hpp"

namespace stationary {
namespace {

std::string compose(const Origin& origin, std::string_view key, std::string_view found,
                    std::string_view allowed, std::string_view remedy) {
  std::string out = origin.text();
  const auto add = [&out](std::string_view separator, std::string_view part) {
    if (part.empty()) return;
    if (!out.empty()) out += separator;
    out += part;
  };
  add(": ", printable(key));
  add(": ", found);
  add("; expected ", allowed);
  add("; ", remedy);
  return out;
}

}  // namespace

namespace {

std::string lines(const std::vector<InputError>& several) {
  std::string out;
  for (const InputError& each : several) {
    if (!out.empty()) out += '\n';
    out += each.what();
  }
  return out;
}

}  // namespace

InputError::InputError(const std::vector<InputError>& several)
    : std::runtime_error(lines(several)),
      origin_(several.front().origin_),
      key_(several.front().key_),
      found_(several.front().found_),
      allowed_(several.front().allowed_),
      remedy_(several.front().remedy_) {}

Origin Origin::in_file(std::string file, int line, int column) {
  Origin out;
  out.file = std::move(file);
  out.line = line;
  out.column = column;
  return out;
}

Origin Origin::of_option(std::string option) {
  Origin out;
  out.option = std::move(option);
  return out;
}

std::string Origin::text() const {
  if (!option.empty()) return printable(option);
  if (line <= 0) return printable(file);
  return fmt::format("{}:{}:{}", printable(file), line, column);
}

InputError::InputError(Origin origin, std::string key, std::string found, std::string allowed,
                       std::string remedy)
    : std::runtime_error(compose(origin, key, found, allowed, remedy)),
      origin_(std::move(origin)),
      key_(std::move(key)),
      found_(std::move(found)),
      allowed_(std::move(allowed)),
      remedy_(std::move(remedy)) {}

namespace {

/// U+0080 ... U+009F, which a terminal obeys, and the separators of lines and paragraphs, U+2028 and U+2029.
bool is_control(std::string_view character) {
  return (character.size() == 2 && character[0] == '\xC2' &&
          static_cast<unsigned char>(character[1]) < 0xA0U) ||
         character == "\xE2\x80\xA8" || character == "\xE2\x80\xA9";
}

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::size_t longest = 200;
  std::string out;
  for (std::size_t k = 0; k < text.size();) {
    if (k >= longest) {  // cut between characters
      out += "...";
      break;
    }
    const std::size_t length = character_length(text.substr(k));
    const auto byte = static_cast<unsigned char>(text[k]);
    if (length > 1 && is_control(text.substr(k, length))) {
      for (const char each : text.substr(k, length))
        out += fmt::format("\\x{:02X}", static_cast<unsigned char>(each));
    } else if (length == 0 || byte < 0x20U || byte == 0x7FU) {
      out += fmt::format("\\x{:02X}", byte);
    } else {
      out += text.substr(k, length);
    }
    k += length == 0 ? 1 : length;
  }
  return out;
}

std::string in_quotes(std::string_view text) { return '"' + printable(text) + '"'; }

std::string listed(std::span<const std::string_view> names) {
  std::string out;
  for (const std::string_view each : names) {
    if (!out.empty()) out += ", ";
    out += in_quotes(each);
  }
  return out;
}

}  // namespace stationary
