#include "solver/program/explore/page_text.hpp"

#include <zlib.h>

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

namespace stationary {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

/// Bytes that are not UTF-8 replaced, by the library that writes all our JSON.
std::string valid_text(std::string_view text) {
  using Json = nlohmann::json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace))
      .get<std::string>();
}

std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t left = bytes.size() - at;
    const unsigned group = static_cast<unsigned>(bytes[at]) << 16U |
                           (left > 1 ? static_cast<unsigned>(bytes[at + 1]) << 8U : 0U) |
                           (left > 2 ? static_cast<unsigned>(bytes[at + 2]) : 0U);
    out += digits[group >> 18U];
    out += digits[group >> 12U & 63U];
    out += left > 1 ? digits[group >> 6U & 63U] : '=';
    out += left > 2 ? digits[group & 63U] : '=';
  }
  return out;
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : valid_text(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      case '\t':
      case '\n':
      case '\r':
        out += c;
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
          out += replacement;
        else
          out += c;
    }
  }
  return out;
}

std::string packed(std::string_view text) {
  uLongf size = compressBound(static_cast<uLong>(text.size()));
  std::vector<unsigned char> out(size);
  // zlib only reads it.
  const auto* const from = reinterpret_cast<const Bytef*>(text.data());
  if (compress2(out.data(), &size, from, static_cast<uLong>(text.size()), Z_BEST_COMPRESSION) !=
      Z_OK)
    throw std::runtime_error("packing the page's data failed: out of memory");
  out.resize(size);
  return base64(out);
}

}  // namespace stationary
