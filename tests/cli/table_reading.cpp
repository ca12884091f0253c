#include "tests/cli/table_reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <vector>

namespace stationary::testing {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out(1);
  for (const char c : line) {
    if (c == ',') {
      out.emplace_back();
    } else {
      out.back() += c;
    }
  }
  return out;
}

}  // namespace

std::string_view header_of(std::string_view csv) { return csv.substr(0, csv.find('\n')); }

std::map<std::string, std::string> only_row(const std::string& csv) {
  std::istringstream lines(csv);
  std::string names;
  std::string values;
  std::string more;
  std::getline(lines, names);
  std::getline(lines, values);
  EXPECT_FALSE(std::getline(lines, more));
  const auto keys = cells(names);
  const auto entries = cells(values);
  EXPECT_EQ(keys.size(), entries.size());
  std::map<std::string, std::string> out;
  for (std::size_t k = 0; k < std::min(keys.size(), entries.size()); ++k) out[keys[k]] = entries[k];
  return out;
}

double number(const std::string& text) {
  double value = std::nan("");
  const auto end = text.data() + text.size();
  EXPECT_EQ(std::from_chars(text.data(), end, value).ptr, end) << text;
  return value;
}

}  // namespace stationary::testing
