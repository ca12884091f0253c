// What a page shows, as it holds it: JSON.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "solver/program/explore/page_table.hpp"

namespace stationary {

/// A case file that a page opens with, for its solver to compute.
struct PageCase {
  std::string file;  ///< without its folder
  std::string text;
};

/// JSON of all that the page shows; the metadata without what depends on the run.
std::string page_data(std::span<const PageTable> tables, std::string_view title,
                      std::string_view version, const std::optional<PageCase>& opened = {});

}  // namespace stationary
