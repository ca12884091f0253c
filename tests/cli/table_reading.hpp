// A table as a reader outside sees it.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace stationary::testing {

/// The header line, without its end.
std::string_view header_of(std::string_view csv);

/// The one row of a table, by column; a failure if there are more or fewer.
std::map<std::string, std::string> only_row(const std::string& csv);

/// The number of a cell, all of it; a failure if it is none.
double number(const std::string& text);

}  // namespace stationary::testing
