// How the quantities, classes, rates and events of a diagram are drawn, in gnuplot's terms.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

#include "lib/stability/spectrum.hpp"
#include "solver/program/diagram/rate_tracks.hpp"
#include "solver/program/plot/strokes.hpp"

namespace stationary {

/// Curves of a panel; as many branches are told apart where these share a panel. The first three
/// are of lightness 13, 44 and 64 of 100: apart in grey too.
constexpr std::array<std::string_view, 6> series_colours{"#14213d", "#c2410c", "#58a6a6",
                                                         "#7c3aed", "#b8860b", "#94a3b8"};

/// The dash says the class, in whatever colour.
struct ClassStyle {
  std::string_view name;
  std::string_view title;  ///< in the legend
  double width;
  std::span<const Dash> dashes;
};
constexpr Dash unstable_dashes[] = {{0.0, dash_gap_begins}};
constexpr Dash oscillatory_dashes[] = {{0.0, 7.5}, {10.5, dash_gap_begins}};
constexpr Dash marginal_dashes[] = {{0.0, 2.0}, {5.5, 7.5}, {11.0, dash_gap_begins}};
constexpr std::array<ClassStyle, std::size(stability_names)> class_styles{
    {{"stable", "stable", 2.8, {}},
     {"elliptic", "elliptic", 1.2, {}},
     {"unstable", "unstable", 1.7, unstable_dashes},
     {"oscillatory", "oscillatory", 1.7, oscillatory_dashes},
     {"marginal", "marginal", 1.7, marginal_dashes}}};
constexpr ClassStyle no_class_style{"no_class", "no class", 1.8, {}};
constexpr std::string_view class_key_colour = "#404040";

constexpr const ClassStyle& style(std::optional<StabilityClass> verdict) {
  return verdict ? class_styles[static_cast<std::size_t>(*verdict)] : no_class_style;
}

/// A curve is so much wider for each that lies on it, drawn later: its colour is seen at both edges.
constexpr double width_of_lower = 2.4;

struct RateStyle {
  std::string_view name;
  std::string_view title;
  std::string_view colour;
  double width;
};
/// By RateKind; of lightness 76, 61, 24 and 33 of 100, and of different widths.
constexpr std::array<RateStyle, rate_kinds.size()> rate_styles{
    {{"negative", "frequency, Krein −", "#f2b134", 3.4},
     {"undetermined", "frequency", "#8b95a5", 1.4},
     {"positive", "frequency, Krein +", "#1f3a5f", 1.2},
     {"growth", "growth rate", "#991b1b", 2.2}}};
constexpr const RateStyle& style(RateKind kind) {
  return rate_styles[static_cast<std::size_t>(kind)];
}

constexpr std::string_view guide_style = "lc rgb '#9ca3af' lw 0.6 dt (2,4)";

/// gnuplot's point types: filled and open circle, square, triangles, diamond, pentagon,
/// crosses; and, these being used up, characters.
struct EventStyle {
  std::string_view name;
  std::string_view point_type;
};
constexpr EventStyle event_styles[] = {
    {"fold-nu", "7"},        {"fold-momentum", "6"},     {"tilt", "5"},
    {"oblique", "4"},        {"ellipse", "13"},          {"shear", "12"},
    {"krein-pass", "10"},    {"hamiltonian-hopf", "11"}, {"escape", "8"},
    {"real-collision", "9"}, {"collapse", "15"},         {"inertia-exchange", "2"},
    {"unexplained", "3"},    {"domain", "14"},           {"fold-parameter", "'<'"},
    {"ellipse-23", "'#'"},   {"ellipse-13", "'%'"},      {"zero-momentum", "'0'"}};

constexpr std::string_view point_type(std::string_view event) {
  constexpr std::string_view other = "1";
  const auto* const at = std::ranges::find(event_styles, event, &EventStyle::name);
  return at == std::end(event_styles) ? other : at->point_type;
}

/// The end of the asked range, or of a closed curve, happens to nobody: it is not marked.
constexpr bool is_marked(std::string_view event) { return event != "limit" && event != "closed"; }

}  // namespace stationary
