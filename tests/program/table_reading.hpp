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
inline double number(const Row& row, const std::string& column) { return number(row.at(column)); }

/// Of the vector whose components are columns, as of "pi" in pi1, pi2, pi3.
double length(const Row& row, const std::string& vector);

/// The rows that are events.
std::vector<Row> events_of(const std::vector<Row>& rows);

/// The rows of an atlas, sheet by sheet.
std::vector<std::vector<Row>> sheets_of(const std::vector<Row>& rows);

}  // namespace stationary::testing
