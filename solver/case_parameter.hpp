// The numbers of a case that may be varied along a family, by their dotted keys: nu, body.J.0 ...
// body.J.2 and every coefficient of the case's models (potential.plane.c).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/case_file.hpp"

namespace stationary {

/// What a parameter acts on.
struct FamilyParameters {
  Body body;
  std::vector<ModelChoice> models;
  double nu;
};

/// Valid keys for these models, "nu" first.
std::vector<std::string> case_parameters(const std::vector<ModelChoice>& models);

/// With the parameter at a value. Throws std::invalid_argument with the violated inequality of
/// body or model, or for a key that is not one of case_parameters().
FamilyParameters with_parameter(FamilyParameters family, std::string_view key, double value);

}  // namespace stationary
