#include "solver/program/plot/diagram_names.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "solver/program/diagram/axis_name.hpp"
#include "solver/program/text/utf8.hpp"

namespace stationary {
namespace {

/// Of a text of more characters than these its beginning and its end.
std::string shortened(const std::string& text, std::size_t most) {
  std::vector<std::string_view> characters;
  for (std::string_view rest = text; !rest.empty(); rest.remove_prefix(characters.back().size()))
    characters.push_back(rest.substr(0, std::max<std::size_t>(1, character_length(rest))));
  if (characters.size() <= most) return text;
  const std::size_t begin = most / 2;
  const std::size_t end = characters.size() - (most - 1 - begin);
  std::string out;
  for (std::size_t k = 0; k < characters.size(); ++k) {
    if (k == begin) out += "…";
    if (k < begin || k >= end) out += characters[k];
  }
  return out;
}

}  // namespace

std::string panel_title(std::string_view branch) {
  constexpr std::pair<std::string_view, std::string_view> titles[] = {
      {"i", "about axis 1 (i)"}, {"ii", "about axis 2 (ii)"}, {"iii", "about axis 3 (iii)"},
      {"tilted", "tilted axis"}, {"oblique", "oblique axis"}, {"two-polar", "two-polar"}};
  for (const auto& [name, title] : titles)
    if (name == branch) return std::string(title);
  return std::string(branch);
}

std::vector<std::string> series_names(const Diagram& diagram) {
  std::vector<std::string> out;
  if (diagram.of_energy_and_momentum) {
    for (const DiagramBranch& each : diagram.branches) out.push_back(panel_title(each.name));
  } else {
    for (const std::string& each : diagram.columns) out.push_back(axis_name(each));
  }
  return out;
}

std::string ordinate_name(const Diagram& diagram) {
  if (diagram.of_stretches()) return "principal stretch";
  std::string out;
  for (const std::string& each : diagram.columns)
    out += (out.empty() ? "" : ", ") + axis_name(each);
  return out;
}

std::string table_name(const Diagram& diagram, std::size_t table) {
  const std::string letters = table_letters(table) + "  ";
  return letters + shortened(std::filesystem::path(diagram.tables[table]).stem().string(),
                             longest_legend_line - letters.size());
}

}  // namespace stationary
