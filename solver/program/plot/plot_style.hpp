// How the quantities, classes and events of a diagram are drawn, in gnuplot's terms.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>

#include "lib/stability/spectrum.hpp"
#include "solver/program/plot/diagram.hpp"

namespace stationary {

/// Colours of lightness 13, 44 and 64 of 100: apart in grey too.
struct QuantityStyle {
  std::string_view symbol;
  std::string_view colour;
};
constexpr std::array<QuantityStyle, stretch_columns.size()> stretch_styles{
    {{"λ", "#14213d"}, {"μ", "#c2410c"}, {"ϱ", "#58a6a6"}}};

/// The dash says the class, in whatever colour.
struct ClassStyle {
  std::string_view name;
  std::string_view line;
};
constexpr std::array<ClassStyle, std::size(stability_names)> class_styles{
    {{"stable", "lw 2.8 dt solid"},
     {"elliptic", "lw 1.2 dt solid"},
     {"unstable", "lw 1.6 dt (13,7)"},
     {"oscillatory", "lw 1.6 dt (16,5,3,5)"},
     {"marginal", "lw 1.6 dt (2,5)"}}};
constexpr ClassStyle no_class_style{"no_class", "lw 1.8 dt solid"};
constexpr std::string_view class_key_colour = "#404040";

struct RateStyle {
  std::string_view colour;
  std::string_view line;
};
constexpr RateStyle frequency_style{"#6b7280", "lw 1.2 dt solid"};
constexpr RateStyle growth_style{"#991b1b", "lw 2.8 dt solid"};

constexpr std::string_view leader_style = "lc rgb '#9ca3af' lw 0.8";

constexpr const ClassStyle& style(std::optional<StabilityClass> verdict) {
  return verdict ? class_styles[static_cast<std::size_t>(*verdict)] : no_class_style;
}

/// gnuplot's point types: filled and open circle, square, triangles, diamond, pentagon, star.
struct EventStyle {
  std::string_view name;
  int point_type;
};
constexpr EventStyle event_styles[] = {
    {"fold-nu", 7},     {"fold-momentum", 6},    {"tilt", 5},
    {"ellipse", 13},    {"shear", 12},           {"oblique", 4},
    {"krein-pass", 10}, {"hamiltonian-hopf", 9}, {"inertia-exchange", 14},
    {"unexplained", 3}, {"collapse", 11},        {"escape", 8}};

constexpr int point_type(std::string_view event) {
  constexpr int other = 2;
  const auto at = std::ranges::find(event_styles, event, &EventStyle::name);
  return at == std::end(event_styles) ? other : at->point_type;
}

}  // namespace stationary
