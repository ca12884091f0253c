#include "solver/program/text/toml_depth.hpp"

#include <algorithm>

namespace stationary {
namespace {

/// Past the string that begins at `at`, or past the text where it does not end.
std::size_t past_string(std::string_view toml, std::size_t at) {
  const char quote = toml[at];
  const char three[] = {quote, quote, quote};
  const std::string_view delimiter(three, 3);
  const bool long_string = toml.substr(at, 3) == delimiter;
  const std::size_t size = long_string ? 3 : 1;
  for (std::size_t k = at + size; k < toml.size(); ++k) {
    if (toml[k] == '\\' && quote == '"') {
      ++k;
    } else if (toml.substr(k, size) == delimiter.substr(0, size)) {
      return k + size;
    } else if (!long_string && toml[k] == '\n') {
      return k;  // the parser's to refuse
    }
  }
  return toml.size();
}

}  // namespace

std::optional<std::size_t> too_deep(std::string_view toml) {
  int parts = 1;  // of the key that may be here
  int depth = 0;
  for (std::size_t k = 0; k < toml.size();) {
    const char c = toml[k];
    if (c == '"' || c == '\'') {
      k = past_string(toml, k);
      continue;
    }
    if (c == '#') {
      k = std::min(toml.find('\n', k), toml.size());
      continue;
    }
    if (c == '.') {
      if (++parts > largest_key_parts) return k;
    } else if (c == '\n' || c == '=' || c == ',' || c == '[' || c == '{' || c == ']' || c == '}') {
      parts = 1;
    }
    if ((c == '[' || c == '{') && ++depth > largest_toml_depth) return k;
    if (c == ']' || c == '}') depth = std::max(depth - 1, 0);
    ++k;
  }
  return std::nullopt;
}

}  // namespace stationary
