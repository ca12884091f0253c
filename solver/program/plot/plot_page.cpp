#include "solver/program/plot/plot_page.hpp"

#include <fmt/format.h>

namespace stationary {

std::string on_page(const PageSize& size, double x, double y) {
  return fmt::format("screen {:.6g}, screen {:.6g}", x / size.width, y / size.height);
}

std::string panel_margins(const PageSize& size, const PageArea& area) {
  return fmt::format(
      "set lmargin at screen {:.6g}\nset rmargin at screen {:.6g}\n"
      "set bmargin at screen {:.6g}\nset tmargin at screen {:.6g}\n",
      area.left / size.width, area.right / size.width, area.bottom / size.height,
      area.top / size.height);
}

}  // namespace stationary
