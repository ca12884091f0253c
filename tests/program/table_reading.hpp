// A table as a reader outside sees it.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace stationary::testing {

/// The header line, without its end.
std::string_view header_of(std::string_view csv);

/// Cells by column.
using Row = std::map<std::string, std::string>;

/// All rows of a table; a failure where one has more or fewer cells than the header.
std::vector<Row> rows_of(const std::string& csv);

/// The one row of a table; a failure if there are more or fewer.
Row only_row(const std::string& csv);

/// The number of a cell, all of it; a failure if it is none.
double number(const std::string& text);

}  // namespace stationary::testing
