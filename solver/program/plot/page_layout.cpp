#include "solver/program/plot/page_layout.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "solver/program/plot/diagram_names.hpp"
#include "solver/program/plot/plot_style.hpp"

namespace stationary {
namespace {

constexpr double rates_gap = 16.0;       ///< between the curves and the rates below
constexpr double row_gap = 58.0;         ///< between rows of panels
constexpr double high_row_gap = 72.0;    ///< where a title would meet the axis' name above
constexpr double title_character = 7.2;  ///< of a panel's title
constexpr double title_space = 16.0;     ///< for the titles of the first row of panels
constexpr double column_gap = 66.0;      ///< between the curves and the rates beside
constexpr double share_of_rates = 0.4;   ///< of both panels, one above the other
constexpr double beside_legend = 10.0;   ///< between the panels and the legend
constexpr double least_panel_width = 200.0;
constexpr double least_column_width = 150.0;  ///< of two panels beside one another
constexpr double least_height = 200.0;        ///< of one panel, or two, one above the other
constexpr double least_row_height = 100.0;

bool has_rows(const Diagram& diagram) {
  return diagram.branches.size() > 1 && !diagram.of_energy_and_momentum;
}

double width_of_legend(const Diagram& diagram) {
  constexpr double symbols = 46.0;
  std::size_t longest = diagram.of_energy_and_momentum ? 12 : 18;  // "frequency, Krein +"
  for (const std::string& each : series_names(diagram)) longest = std::max(longest, each.size());
  for (std::size_t k = 0; diagram.tables.size() > 1 && k < diagram.tables.size(); ++k)
    longest = std::max(longest, table_name(diagram, k).size());
  return symbols +
         page::character_width * static_cast<double>(std::min(longest, longest_legend_line));
}

/// How high the name of the ordinate stands beside its panel.
double ordinate_height(const Diagram& diagram) {
  return page::character_width * static_cast<double>(ordinate_name(diagram).size());
}

}  // namespace

std::size_t most_legend_lines(const Diagram& diagram) {
  std::set<std::optional<StabilityClass>> classes;
  std::set<RateKind> kinds;
  std::set<std::string> events;
  for (const DiagramPoint& point : diagram.points) {
    classes.insert(point.verdict);
    if (!has_rates(diagram)) continue;
    if (point.growth > 0.0) kinds.insert(RateKind::growth);
    for (std::size_t k = 0; k < point.frequency.size(); ++k)
      if (point.frequency[k] > 0.0) kinds.insert(rate_kind(point.krein[k]));
  }
  for (const DiagramEvent& event : diagram.events)
    if (is_marked(event.name)) events.insert(event.name);
  const std::size_t tables = diagram.tables.size() > 1 ? diagram.tables.size() : 0;
  std::size_t out = 0;
  for (const std::size_t part :
       {series_names(diagram).size(), classes.size(), kinds.size(), events.size(), tables})
    if (part > 0) out += part + (out > 0 ? 1 : 0);
  return out;
}

PageSize least_page(const Diagram& diagram) {
  const auto rows = static_cast<double>(diagram.branches.size());
  const double legend = page::margin + page::title_height + title_space +
                        page::legend_line * static_cast<double>(most_legend_lines(diagram)) +
                        page::margin;
  double width = least_panel_width;
  double height = std::max(least_height, 60.0 + ordinate_height(diagram));
  if (has_rows(diagram)) {
    const double pitch =
        std::max(least_row_height + high_row_gap, ordinate_height(diagram) + page::character_width);
    height = title_space + rows * pitch - high_row_gap;
    if (has_rates(diagram)) width = 2.0 * least_column_width + column_gap;
  }
  return {std::ceil(page::left + width + beside_legend + width_of_legend(diagram)),
          std::ceil(std::max(legend, page::margin + page::title_height + page::bottom + height))};
}

void lay_out(const Diagram& diagram, const PageChoice& choice, DiagramPicture& picture) {
  constexpr double width_of_rows = 1000.0;
  constexpr double row_height = 170.0;
  const auto n = static_cast<double>(picture.panels.size());
  if (has_rows(diagram)) {
    picture.size = {width_of_rows, page::margin + page::title_height + page::bottom +
                                       n * row_height + (n - 1.0) * row_gap + title_space};
  }
  const PageSize least = least_page(diagram);
  picture.size.width = std::max(picture.size.width, least.width);
  picture.size.height = std::max(picture.size.height, least.height);
  if (choice.size) picture.size = *choice.size;
  const double top = picture.size.height - page::margin - page::title_height -
                     (has_rows(diagram) ? title_space : 4.0);
  picture.legend_left = picture.size.width - width_of_legend(diagram);
  const double right = picture.legend_left - beside_legend;
  if (!has_rows(diagram)) {
    DiagramPanel& panel = picture.panels.front();
    panel.area = {page::left, right, page::bottom, top};
    panel.rate_area = panel.area;
    if (!has_rates(diagram)) return;
    panel.rate_area.top = page::bottom + share_of_rates * (top - page::bottom);
    panel.area.bottom = panel.rate_area.top + rates_gap;
    return;
  }
  const double middle = has_rates(diagram) ? 0.5 * (page::left + right) : right + 0.5 * column_gap;
  const double half_panel = 0.5 * (middle - 0.5 * column_gap - page::left);
  const bool titles_meet_names =
      std::ranges::any_of(picture.panels, [&](const DiagramPanel& panel) {
        return title_character * static_cast<double>(panel.title.size()) > half_panel - 10.0;
      });
  const double between = titles_meet_names ? high_row_gap : row_gap;
  const double height = (top - page::bottom - (n - 1.0) * between) / n;
  for (std::size_t k = 0; k < picture.panels.size(); ++k) {
    const double upper = top - static_cast<double>(k) * (height + between);
    picture.panels[k].area = {page::left, middle - 0.5 * column_gap, upper - height, upper};
    picture.panels[k].rate_area = {middle + 0.5 * column_gap, right, upper - height, upper};
  }
}

}  // namespace stationary
