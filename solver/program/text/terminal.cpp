#include "solver/program/text/terminal.hpp"

#include <fmt/color.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

namespace stationary {

bool has_colours(int descriptor) {
  if (isatty(descriptor) != 1 || std::getenv("NO_COLOR") != nullptr) return false;
  const char* const terminal = std::getenv("TERM");
  return terminal != nullptr && std::string_view(terminal) != "dumb";
}

std::string heading(std::string_view text) { return fmt::format(fmt::emphasis::bold, "{}", text); }

std::string alarm(std::string_view text) {
  return fmt::format(fmt::emphasis::bold | fmt::fg(fmt::terminal_color::red), "{}", text);
}

std::string rough_duration(double seconds) {
  constexpr double minute = 60.0;
  constexpr double hour = 3600.0;
  // To the next unit only from two of it on: "90 s" says more than "2 min".
  if (seconds < 2 * minute) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 2 * hour) return fmt::format("{:.0f} min", seconds / minute);
  return fmt::format("{:.0f} h", seconds / hour);
}

}  // namespace stationary
