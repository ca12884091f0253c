#include "solver/program/plot/diagram_names.hpp"

#include <filesystem>
#include <utility>

#include "solver/program/diagram/axis_name.hpp"

namespace stationary {

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
  return table_letters(table) + "  " + std::filesystem::path(diagram.tables[table]).stem().string();
}

}  // namespace stationary
