// The page that a figure is drawn on. Lengths are in its units, from its lower left corner; one is a
// pixel of an SVG.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "solver/program/diagram/axis.hpp"

namespace stationary {

struct PageSize {
  double width = 800.0;
  double height = 600.0;
};

/// What the user asks of a figure beside what it shows; nothing asked is chosen by what there is.
struct PageChoice {
  std::optional<PageSize> size;
  std::optional<AxisRange> x;
  std::optional<AxisRange> y;
  std::optional<AxisRange> rate;
  std::optional<AxisRange> value;  ///< the colours of a map
};

namespace page {
constexpr double least_side = 300.0;  ///< of any figure
constexpr double margin = 14.0;
constexpr double title_height = 26.0;
constexpr double left = 74.0;
constexpr double bottom = 58.0;
constexpr double character_width = 6.7;  ///< of the legend, about
constexpr double legend_line = 16.05;    ///< its height
}  // namespace page

/// A rectangle of the page.
struct PageArea {
  double left;
  double right;
  double bottom;
  double top;

  double width() const { return right - left; }
  double height() const { return top - bottom; }
};

/// A place on the page as gnuplot takes it.
std::string on_page(const PageSize& size, double x, double y);

/// What a panel's margins are, as commands.
std::string panel_margins(const PageSize& size, const PageArea& area);

}  // namespace stationary
