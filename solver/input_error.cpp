#include "solver/input_error.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

namespace stationary {
namespace {

std::string compose(const InputFault& fault) {
  std::string out = fault.origin.text();
  const auto add = [&out](std::string_view separator, std::string_view part) {
    if (part.empty()) return;
    if (!out.empty()) out += separator;
    out += part;
  };
  add(": ", fault.key);
  add(": ", fault.found);
  if (!fault.allowed.empty()) add("; ", "expected " + fault.allowed);
  add("; ", fault.remedy);
  return out;
}

}  // namespace

std::string Origin::text() const {
  if (!option.empty()) return printable(option);
  if (line <= 0) return printable(file);
  return fmt::format("{}:{}:{}", printable(file), line, column);
}

InputError::InputError(InputFault fault)
    : std::runtime_error(compose(fault)), fault_(std::move(fault)) {}

std::string printable(std::string_view text) {
  constexpr std::size_t longest = 200;
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    // Cut between characters: UTF-8 continuation bytes are 10xxxxxx.
    if (k >= longest && (static_cast<unsigned char>(text[k]) & 0xC0U) != 0x80U) {
      out += "...";
      break;
    }
    const auto byte = static_cast<unsigned char>(text[k]);
    if (byte < 0x20U || byte == 0x7FU) {
      out += fmt::format("\\x{:02X}", byte);
    } else {
      out += text[k];
    }
  }
  return out;
}

std::string in_quotes(std::string_view text) { return '"' + printable(text) + '"'; }

}  // namespace stationary
