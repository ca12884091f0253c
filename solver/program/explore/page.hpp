// The explorer's page: the template with a title, the tables and the solver in their places.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace stationary {

/// What a page is made of beside its template.
struct PageContent {
  std::string_view title;  ///< escaped here
  std::string_view data;   ///< packed here
  /// The solver as live_solver() has it, packed already; empty: the page's policy lets nothing compute.
  std::span<const std::string_view> live = {};
};

/// Each place of the template is filled, and what fills it is not searched for places again.
std::string filled_page(std::span<const std::string_view> pieces, const PageContent& content);

}  // namespace stationary
