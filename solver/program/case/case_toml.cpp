#include "solver/program/case/case_toml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <utility>

#include "solver/program/text/toml_depth.hpp"

namespace stationary {
namespace {

constexpr std::size_t largest_file = 1U << 20U;  // a case file is a page of text

[[noreturn]] void refuse_file(const std::string& path, std::string found, std::string remedy) {
  throw InputError(Origin::in_file(path), "", std::move(found), "a case file (TOML text)",
                   std::move(remedy));
}

std::string file_text(const std::string& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    refuse_file(path, "a directory", "name a file in it");
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  if (!file) {
    const int reason = errno;
    refuse_file(path, fmt::format("no readable file ({})", std::strerror(reason)),
                "check the path and its permissions");
  }
  std::string text;
  std::array<char, 16384> block{};
  while (text.size() <= largest_file) {
    const std::size_t count = std::fread(block.data(), 1, block.size(), file.get());
    text.append(block.data(), count);
    if (count < block.size()) break;
  }
  if (std::ferror(file.get()) != 0) refuse_file(path, "an error while reading", {});
  if (text.size() > largest_file) refuse_file(path, "more than 1 MiB", "is this the right file?");
  return text;
}

int position(toml::source_index index) { return static_cast<int>(index); }

}  // namespace

std::string dotted(std::string_view prefix, std::string_view name) {
  if (prefix.empty()) return std::string(name);
  return fmt::format("{}.{}", prefix, name);
}

std::string describe(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "the string " + in_quotes(node.as_string()->get());
    case toml::node_type::integer:
      return fmt::format("the integer {}{}", node.as_integer()->get(),
                         node.value<double>() ? "" : ", which no double is exactly");
    case toml::node_type::floating_point:
      return fmt::format("the number {}", node.as_floating_point()->get());
    case toml::node_type::boolean:
      return node.as_boolean()->get() ? "true" : "false";
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array: {
      const std::size_t count = node.as_array()->size();
      return fmt::format("an array of {} value{}", count, count == 1 ? "" : "s");
    }
    case toml::node_type::none:
      return "nothing";
    default:
      return "a date or time";
  }
}

CaseTree CaseTree::read(const std::string& path) { return parse(file_text(path), path); }

CaseTree CaseTree::parse(std::string_view text, const std::string& name) {
  if (const auto at = too_deep(text)) {
    const std::string_view before = text.substr(0, *at);
    const std::size_t line_begin = before.rfind('\n') + 1;  // 0 on the first line
    throw InputError(Origin::in_file(name, static_cast<int>(std::ranges::count(before, '\n')) + 1,
                                     static_cast<int>(*at - line_begin) + 1),
                     "", "found TOML that nests more deeply than a case does",
                     fmt::format("keys of at most {} parts, and at most {} brackets in one another",
                                 largest_key_parts, largest_toml_depth));
  }
  try {
    return with_origins(toml::parse(text), name, Origin::in_file(name, 1, 1));
  } catch (const toml::parse_error& error) {
    const auto& begin = error.source().begin;
    throw InputError(Origin::in_file(name, position(begin.line), position(begin.column)), "",
                     printable(error.description()), "TOML", "see https://toml.io for its syntax");
  }
}

CaseTree CaseTree::of(toml::table root, const std::string& name,
                      std::map<std::string, std::string, std::less<>> overrides) {
  CaseTree out = with_origins(std::move(root), name, Origin::in_file(name));
  for (const auto& [key, option] : overrides) out.set_origin(key, Origin::of_option(option));
  out.overrides_ = std::move(overrides);
  return out;
}

CaseTree CaseTree::with_origins(toml::table root, const std::string& name, const Origin& whole) {
  if (root.empty()) {
    throw InputError(whole, "", "found no keys", "a case: [body], [potential] and [motion]",
                     "start from one of the shipped cases");
  }
  CaseTree out;
  out.name_ = name;
  out.root_ = std::move(root);
  out.locate(out.root_, "");
  out.values_[""] = out.keys_[""] = whole;
  return out;
}

void CaseTree::locate(const toml::node& node, const std::string& key) {
  const auto place = [this](const toml::source_region& source) {
    return Origin::in_file(name_, position(source.begin.line), position(source.begin.column));
  };
  values_[key] = place(node.source());
  if (const toml::table* table = node.as_table()) {
    for (const auto& [name, child] : *table) {
      const std::string child_key = dotted(key, name.str());
      locate(child, child_key);
      keys_[child_key] = place(name.source());
    }
  } else if (const toml::array* array = node.as_array()) {
    std::size_t index = 0;
    for (const toml::node& child : *array) locate(child, dotted(key, std::to_string(index++)));
  }
}

void CaseTree::set_origin(const std::string& key, const Origin& origin) {
  const std::string below = key + '.';
  for (Origins* origins : {&values_, &keys_}) {
    auto at = origins->lower_bound(below);
    while (at != origins->end() && at->first.starts_with(below)) at = origins->erase(at);
    (*origins)[key] = origin;
  }
}

const Origin& CaseTree::nearest(const Origins& origins, std::string_view key) {
  for (;;) {
    const auto at = origins.find(key);
    if (at != origins.end()) return at->second;
    const std::size_t dot = key.rfind('.');
    key = dot == std::string_view::npos ? std::string_view() : key.substr(0, dot);
  }
}

const toml::node* find(const CaseTree& tree, std::string_view path) {
  const toml::node* at = &tree.root();
  while (!path.empty()) {
    const std::size_t dot = path.find('.');
    const toml::table* table = at->as_table();
    at = table == nullptr ? nullptr : table->get(path.substr(0, dot));
    if (at == nullptr) return nullptr;
    path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
  }
  return at;
}

std::vector<double> numbers(const CaseTree& tree, std::string_view path) {
  std::vector<double> out;
  const toml::node* node = find(tree, path);
  if (node == nullptr || !node->is_array()) return out;
  for (const toml::node& element : *node->as_array())
    out.push_back(element.value<double>().value_or(0.0));
  return out;
}

}  // namespace stationary
