// CaseTree::override_key: --set key=value on the parsed tree.
#include <charconv>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "solver/program/case/case_toml.hpp"
#include "solver/program/text/ascii.hpp"
#include "solver/program/text/toml_depth.hpp"
#include "solver/program/text/utf8.hpp"

namespace stationary {
namespace {

bool is_key_character(char c) { return is_letter(c) || is_digit(c) || c == '-'; }

/// One override while it is applied: its place for messages, and what it says.
struct Assignment {
  Origin origin;
  std::string key;
  std::vector<std::string> path;
  std::string value;

  [[noreturn]] void refuse(std::string found, std::string allowed, std::string remedy) const {
    throw InputError(origin, printable(key), std::move(found), std::move(allowed),
                     std::move(remedy));
  }
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

Assignment split(std::string_view text, const Origin& where) {
  Assignment out;
  out.origin = where;
  if (where.text().empty()) out.origin.option = "--set " + std::string(text);
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos)
    out.refuse("found no \"=\"", "key=value", "for example --set motion.nu=0.3");
  out.key = trimmed(text.substr(0, equals));
  out.value = trimmed(text.substr(equals + 1));
  std::string segment;
  for (const char c : out.key + '.') {
    if (c == '.') {
      if (segment.empty())
        out.refuse("found an empty name in the key", "a dotted key such as motion.nu", {});
      out.path.push_back(std::exchange(segment, {}));
    } else if (is_key_character(c)) {
      segment += c;
    } else {
      out.refuse("found the character " + in_quotes({&c, 1}) + " in the key",
                 "a dotted key such as motion.nu", {});
    }
  }
  if (out.path.size() > static_cast<std::size_t>(largest_key_parts)) {
    out.refuse("found a key of " + std::to_string(out.path.size()) + " parts",
               "at most " + std::to_string(largest_key_parts), {});
  }
  if (out.value.empty())
    out.refuse("found no value", "key=value", "an empty text is written '" + out.key + "=\"\"'");
  return out;
}

/// The value as a table of one key "value": a node cannot be moved out of its tree without it.
toml::table parse_value(const Assignment& assignment) {
  // Parts of a key count only where there may be one: in a table, or on a line of its own.
  const bool may_nest = assignment.value.find_first_of("[{\n") != std::string::npos;
  if (may_nest && too_deep(assignment.value)) {
    assignment.refuse("found a value that nests more deeply than a case does",
                      "at most " + std::to_string(largest_toml_depth) + " brackets in one another",
                      {});
  }
  try {
    toml::table out = toml::parse("value = " + assignment.value);
    if (out.size() == 1) return out;
    assignment.refuse("found more than one value", "one TOML value", {});
  } catch (const toml::parse_error& error) {
    // true, false, inf and nan have parsed; what else begins with a letter, or as a path does, is a bare word.
    const char first = assignment.value.front();
    if ((is_letter(first) || first == '.' || first == '/' || first == '~') &&
        assignment.value.find('\n') == std::string::npos && is_utf8(assignment.value)) {
      toml::table out;
      out.insert("value", assignment.value);
      return out;
    }
    assignment.refuse("found " + in_quotes(assignment.value), "a TOML value",
                      printable(error.description()));
  }
}

/// The element of an array a path segment names.
std::size_t element(const Assignment& assignment, const toml::array& array,
                    const std::string& segment) {
  std::size_t index = 0;
  const char* end = segment.data() + segment.size();
  const auto parsed = std::from_chars(segment.data(), end, index);
  if (parsed.ec != std::errc() || parsed.ptr != end || index >= array.size()) {
    const std::string last = array.empty()
                                 ? "none, the array is empty"
                                 : "an index from 0 to " + std::to_string(array.size() - 1);
    assignment.refuse("found the index " + in_quotes(segment), last, {});
  }
  return index;
}

}  // namespace

void CaseTree::override_key(std::string_view text, const Origin& where) {
  const Assignment assignment = split(text, where);
  toml::table parsed = parse_value(assignment);
  toml::node* at = &root_;
  std::string key;
  for (std::size_t k = 0; k < assignment.path.size(); ++k) {
    const bool last = k + 1 == assignment.path.size();
    const std::string& segment = assignment.path[k];
    if (toml::table* table = at->as_table()) {
      key = dotted(key, segment);
      if (last) {
        std::move(*parsed.get("value")).visit([&](auto&& value) {
          table->insert_or_assign(segment, std::forward<decltype(value)>(value));
        });
      } else if (!table->contains(segment)) {
        table->insert(segment, toml::table());
        set_origin(key, assignment.origin);
      }
      at = table->get(segment);
    } else if (toml::array* array = at->as_array()) {
      const std::size_t index = element(assignment, *array, segment);
      key = dotted(key, std::to_string(index));
      const auto place = array->begin() + static_cast<std::ptrdiff_t>(index);
      if (last) {
        std::move(*parsed.get("value")).visit([&](auto&& value) {
          array->replace(place, std::forward<decltype(value)>(value));
        });
      }
      at = array->get(index);
    } else {
      assignment.refuse(key + " is " + describe(*at),
                        "a table or an array above " + in_quotes(segment), {});
    }
  }
  set_origin(key, assignment.origin);
  const std::string below = key + '.';  // these are no more
  for (auto it = overrides_.lower_bound(below);
       it != overrides_.end() && it->first.starts_with(below);)
    it = overrides_.erase(it);
  overrides_[key] = where.text().empty() ? assignment.origin.option : assignment.origin.text();
}

void CaseTree::erase(std::string_view path, std::string_view name) {
  toml::node* at = &root_;
  while (!path.empty() && at != nullptr) {
    const std::size_t dot = path.find('.');
    toml::table* table = at->as_table();
    at = table == nullptr ? nullptr : table->get(path.substr(0, dot));
    path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
  }
  if (at != nullptr && at->is_table()) at->as_table()->erase(name);
}

}  // namespace stationary
