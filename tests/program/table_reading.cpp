#include "tests/program/table_reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>

namespace stationary::testing {
namespace {

/// RFC 4180, a row a line.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (c == '"' && quoted && k + 1 < line.size() && line[k + 1] == '"') {
      out.back() += line[++k];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      out.emplace_back();
    } else {
      out.back() += c;
    }
  }
  return out;
}

}  // namespace

std::string_view header_of(std::string_view csv) { return csv.substr(0, csv.find('\n')); }

std::vector<Row> rows_of(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  const auto keys = cells(line);
  std::vector<Row> out;
  while (std::getline(lines, line)) {
    const auto entries = cells(line);
    EXPECT_EQ(keys.size(), entries.size()) << line;
    Row& row = out.emplace_back();
    for (std::size_t k = 0; k < std::min(keys.size(), entries.size()); ++k)
      row[keys[k]] = entries[k];
  }
  return out;
}

Row only_row(const std::string& csv) {
  const std::vector<Row> rows = rows_of(csv);
  EXPECT_EQ(rows.size(), 1U);
  return rows.empty() ? Row() : rows.front();
}

double number(const std::string& text) {
  double value = std::nan("");
  const auto end = text.data() + text.size();
  EXPECT_EQ(std::from_chars(text.data(), end, value).ptr, end) << text;
  return value;
}

double length(const Row& row, const std::string& vector) {
  double square = 0.0;
  for (const char* k : {"1", "2", "3"}) {
    const double part = number(row.at(vector + k));
    square += part * part;
  }
  return std::sqrt(square);
}

std::vector<Row> events_of(const std::vector<Row>& rows) {
  std::vector<Row> out;
  std::ranges::copy_if(rows, std::back_inserter(out),
                       [](const Row& row) { return !row.at("event").empty(); });
  return out;
}

std::vector<std::vector<Row>> sheets_of(const std::vector<Row>& rows) {
  std::vector<std::vector<Row>> out;
  for (const Row& row : rows) {
    if (out.empty() || out.back().back().at("sheet") != row.at("sheet")) out.emplace_back();
    out.back().push_back(row);
  }
  return out;
}

}  // namespace stationary::testing
