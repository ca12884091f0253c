// The numbers of a case that may be varied along a family, by their dotted keys: those of its
// motion (nu; motion.omega ... of a two-polar one), body.J.0 ... body.J.2 and every coefficient of
// the case's models (potential.plane.c). A two-polar body keeps its J1 = J2; a tilted family is one
// in nu.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "solver/axis_family.hpp"
#include "solver/case_file.hpp"

namespace stationary {

/// What a parameter acts on.
struct FamilyParameters {
  Body body;
  std::vector<ModelChoice> models;
  Case::Motion motion;
};

/// Valid keys for this motion and these models, in that order.
std::vector<std::string> case_parameters(const Case::Motion& motion,
                                         const std::vector<ModelChoice>& models);

/// With the parameter at a value. Throws std::invalid_argument with the violated inequality of
/// body or model, or for a key that is not one of case_parameters().
FamilyParameters with_parameter(FamilyParameters family, std::string_view key, double value);

/// The parameter's own value. Throws std::invalid_argument for a key that is not one of them.
double parameter_value(FamilyParameters family, std::string_view key);

/// The parameter as the motion's family knows it; the key is one of case_parameters().
FamilyParameter family_parameter(std::string_view key, const std::vector<ModelChoice>& models);

}  // namespace stationary
