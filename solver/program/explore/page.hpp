// The explorer's page: the template with a title and the tables in their places.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "solver/program/explore/page_table.hpp"

namespace stationary {

/// JSON of all that the page shows; the metadata without what depends on the run.
std::string page_data(std::span<const PageTable> tables, std::string_view title,
                      std::string_view version);

/// title: escaped here; data: packed here. Each place of the template is filled, and what fills it is not searched for
/// places again.
std::string page(std::span<const std::string_view> pieces, std::string_view title,
                 std::string_view data);

}  // namespace stationary
