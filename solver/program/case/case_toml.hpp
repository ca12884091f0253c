// A case file as parsed, before its meaning is looked at: the TOML tree with overrides applied, and
// for each dotted key where it was written.
#pragma once

#include <toml++/toml.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/text/input_error.hpp"

namespace stationary {

class CaseTree {
 public:
  /// Reads a file. Throws InputError: unreadable, no regular text, larger than 1 MiB, not TOML.
  static CaseTree read(const std::string& path);

  /// From text; `name` is what messages call it. Throws InputError.
  static CaseTree parse(std::string_view text, const std::string& name);

  /// Of keys and values that no text was read for; overrides: as overrides() has them.
  static CaseTree of(toml::table root, const std::string& name,
                     std::map<std::string, std::string, std::less<>> overrides = {});

  /// Applies one `key=value` of --set: value in TOML, a bare word counts as a string; a key may end
  /// in the index of an array, from 0. where: what messages call its place, an empty one the option.
  /// Throws InputError.
  void override_key(std::string_view assignment, const Origin& where = {});
  /// Takes the key `name` out of the table at a dotted key.
  void erase(std::string_view path, std::string_view name);

  const toml::table& root() const { return root_; }
  const std::string& name() const { return name_; }

  /// Where a key's value was written; of an absent key, where its nearest parent was.
  const Origin& origin(std::string_view key) const { return nearest(values_, key); }
  /// Likewise, of the key itself.
  const Origin& key_origin(std::string_view key) const { return nearest(keys_, key); }

  /// Where every override stands, as text, by key, in the order of keys.
  const std::map<std::string, std::string, std::less<>>& overrides() const { return overrides_; }

 private:
  using Origins = std::map<std::string, Origin, std::less<>>;

  /// whole: where the root is.
  static CaseTree with_origins(toml::table root, const std::string& name, const Origin& whole);
  void locate(const toml::node& node, const std::string& key);
  void set_origin(const std::string& key, const Origin& origin);
  static const Origin& nearest(const Origins& origins, std::string_view key);

  toml::table root_;
  std::string name_;
  Origins values_;
  Origins keys_;
  std::map<std::string, std::string, std::less<>> overrides_;
};

/// The node at a dotted key of tables, or nullptr.
const toml::node* find(const CaseTree& tree, std::string_view path);

/// The value at a key, or the default; its type has been checked.
template <class T>
T value_or(const CaseTree& tree, std::string_view path, T otherwise) {
  const toml::node* node = find(tree, path);
  return node == nullptr ? otherwise : node->value<T>().value_or(otherwise);
}

/// Those of an array at a key, empty where there is none.
std::vector<double> numbers(const CaseTree& tree, std::string_view path);

/// What a node is, for a message: `the string "fast"`, `the number nan`, `an array of 2 values`.
std::string describe(const toml::node& node);

/// prefix.name, or name at the top.
std::string dotted(std::string_view prefix, std::string_view name);

}  // namespace stationary
