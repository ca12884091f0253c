#include "solver/search/search_message.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace stationary {

void require_box(const SearchOptions& options) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval range = options.range(k);
    if (!(range.lo >= 1e-100 && range.lo < range.hi && range.hi <= 1e100))
      throw std::invalid_argument("1e-100 <= min_stretch < max_stretch <= 1e100");
  }
}

std::string found_by_search(bool proven) {
  return proven ? "exhaustive search: proven to exist"
                : "found by Newton's method where an exhaustive search is undecided: not proven";
}

std::string unproven_text(std::size_t unproven) {
  if (unproven == 0) return {};
  return "; " + std::to_string(unproven) + " found by Newton's method there, not proven";
}

std::string range_text(const SearchOptions& options, const std::array<std::string_view, 3>& names) {
  std::ostringstream text;
  text.precision(10);
  const std::array ranges{options.range(0), options.range(1), options.range(2)};
  const bool alike = std::ranges::all_of(ranges, [&](const Interval& each) {
    return each.lo == ranges[0].lo && each.hi == ranges[0].hi;
  });
  for (std::size_t k = 0; k < (alike ? 1 : ranges.size()); ++k)
    text << (k > 0 ? ", " : "") << (alike ? "stretches" : names[k]) << " in [" << ranges[k].lo
         << ", " << ranges[k].hi << "]";
  return text.str();
}

std::string search_message(const SearchOptions& options, SearchStatus status, std::size_t proven,
                           const std::vector<StretchBox>& undecided, std::string_view may_be,
                           const std::array<std::string_view, 3>& names) {
  if (status == SearchStatus::interrupted) return "interrupted";
  std::ostringstream text;
  text.precision(10);
  text << range_text(options, names) << ": ";
  if (undecided.empty()) {
    text << (proven == 0 ? "proven that there is none" : "proven to be all");
    return text.str();
  }
  text << proven << " proven; not decided whether there are more in";
  constexpr std::size_t listed = 4;
  for (std::size_t k = 0; k < std::min(listed, undecided.size()); ++k) {
    const StretchBox& box = undecided[k];
    const std::array sides{box.xi, box.zeta, box.rho};
    if (k > 0) text << ",";
    for (std::size_t i = 0; i < sides.size(); ++i)
      text << " " << names[i] << " [" << sides[i].lo << ", " << sides[i].hi << "]";
  }
  if (undecided.size() > listed) text << " and " << undecided.size() - listed << " more boxes";
  text << " (" << may_be << ")";
  return text.str();
}

}  // namespace stationary
