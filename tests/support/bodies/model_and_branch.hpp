// Tests of every model on every branch: what they are called.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <string_view>
#include <tuple>

#include "lib/body/motion.hpp"

namespace stationary {

inline void PrintTo(const Branch& branch, std::ostream* out) { *out << name(branch); }

}  // namespace stationary

namespace stationary::support {

using ModelAndBranch = std::tuple<std::string_view, Branch>;

inline std::string model_and_branch(const ::testing::TestParamInfo<ModelAndBranch>& info) {
  const auto& [model, branch] = info.param;
  std::string out(model);
  for (char& c : out)
    if (c == '-') c = '_';
  return out + "_" + std::string(name(branch));
}

}  // namespace stationary::support
