// `map` as tests ask for it: the shipped map on fewer cells, with overrides.
#pragma once

#include <string>
#include <vector>

#include "tests/program/program.hpp"

namespace stationary::testing {

inline const std::string map_case = STATIONARY_CASES "/map_biot_log.toml";

/// map of the shipped case on 13 by 9 cells, with more overrides.
inline std::vector<std::string> map_command(const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> out{"map", map_case};
  std::vector<std::string> all{"map.x.count=13", "map.y.count=9"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  for (const std::string& each : all) {
    out.emplace_back("--set");
    out.push_back(each);
  }
  return out;
}

inline Outcome mapped(const std::vector<std::string>& overrides = {},
                      const std::vector<std::string>& options = {"-o", "-"}) {
  auto arguments = map_command(overrides);
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_program(arguments);
}

}  // namespace stationary::testing
