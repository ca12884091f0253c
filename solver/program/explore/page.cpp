#include "solver/program/explore/page.hpp"

#include <algorithm>
#include <utility>

#include "solver/program/explore/page_template.hpp"
#include "solver/program/explore/page_text.hpp"

namespace stationary {

std::string filled_page(std::span<const std::string_view> pieces, const PageContent& content) {
  std::string form;
  for (const std::string_view piece : pieces) form += piece;
  std::string live;
  for (const std::string_view piece : content.live) live += piece;
  const std::pair<std::string_view, std::string> places[] = {
      {title_place, html_text(content.title)},
      {data_place, packed(content.data)},
      {live_policy_place, live.empty() ? "" : " 'wasm-unsafe-eval'; worker-src blob:"},
      {live_place, live}};
  std::string out;
  std::size_t at = 0;
  while (true) {
    const auto* const next = std::ranges::min_element(
        places, {}, [&](const auto& place) { return form.find(place.first, at); });
    const std::size_t found = form.find(next->first, at);
    out += std::string_view(form).substr(at, found - at);
    if (found == std::string::npos) return out;
    out += next->second;
    at = found + next->first.size();
  }
}

}  // namespace stationary
