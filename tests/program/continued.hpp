// `continue` as tests ask for it: a case with overrides, and its events in the table that comes out.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "solver/motion/event.hpp"
#include "tests/program/program.hpp"
#include "tests/program/table_reading.hpp"

namespace stationary::testing {

/// "continue", a case and overrides of it.
inline std::vector<std::string> continue_command(const std::string& case_file,
                                                 const std::vector<std::string>& overrides) {
  std::vector<std::string> out{"continue", case_file};
  for (const std::string& each : overrides) {
    out.emplace_back("--set");
    out.push_back(each);
  }
  return out;
}

inline Outcome continued(const std::string& case_file,
                         const std::vector<std::string>& overrides = {},
                         const std::string& target = "-") {
  auto arguments = continue_command(case_file, overrides);
  arguments.insert(arguments.end(), {"-o", target});
  return run_program(arguments);
}

/// The case's range in nu, in place of whatever it has.
inline std::vector<std::string> along_nu(const std::string& from, const std::string& to) {
  return {"continuation.parameter=nu", "continuation.from=" + from, "continuation.to=" + to};
}

inline bool is_end_name(const std::string& event) {
  for (const EventType end : {EventType::collapse, EventType::escape, EventType::limit,
                              EventType::closed, EventType::stalled})
    if (event == name(end)) return true;
  return false;
}

/// "limit tilt ... escape"
inline std::string names_of_events(const std::vector<Row>& rows) {
  std::string out;
  for (const Row& row : rows)
    if (!row.at("event").empty()) out += (out.empty() ? "" : " ") + row.at("event");
  return out;
}

inline std::size_t index_of(const std::vector<Row>& rows, const std::string& event) {
  std::size_t k = 0;
  while (k < rows.size() && rows[k].at("event") != event) ++k;
  EXPECT_LT(k, rows.size()) << "no " << event;
  return k;
}

}  // namespace stationary::testing
