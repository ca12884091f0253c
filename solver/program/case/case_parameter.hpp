// The numbers of a case that may be varied along a family, by their dotted keys: those of its
// motion (nu; motion.omega ... of a two-polar one), body.J.0 ... body.J.2 and every coefficient of
// the case's models (potential.plane.c). A two-polar body keeps its J1 = J2; a tilted family is
// followed in nu alone.
//
// A parameter is one of these, or the ratio of two: "body.J.1/body.J.0" varies the first, the second
// held, and its values are those of the ratio. The second is positive.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/family/axis_family.hpp"
#include "solver/program/case/case_file.hpp"

namespace stationary {

class Kind;

/// What a parameter acts on.
struct FamilyParameters {
  Body body;
  std::vector<ModelChoice> models;
  Motion motion;
};

/// Those of the case itself.
FamilyParameters own_numbers(const Case& input);

/// The motion's kind. Throws std::invalid_argument for numbers outside the domain of body or model.
std::unique_ptr<Kind> kind_of(const FamilyParameters& at);

/// A number too large or too small beside the others for what is computed with it, the powers of a
/// spectrum and their extended precision included: these must stay within 1e-300 ... 1e300.
struct OutOfScale {
  std::string key;
  std::string found;
  std::string allowed;
  std::string hint = "choose units in which J and V are of order one";
};
std::optional<OutOfScale> out_of_scale(const FamilyParameters& family);

/// Valid keys for this motion and these models, in that order.
std::vector<std::string> case_parameters(const Motion& motion,
                                         const std::vector<ModelChoice>& models);

/// Those of them that the motion's family is followed in.
std::vector<std::string> followed_parameters(const Motion& motion,
                                             const std::vector<ModelChoice>& models);

/// The two numbers of a ratio; second is empty where the parameter is one number.
struct ParameterParts {
  std::string_view first;
  std::string_view second;
};
ParameterParts parts_of(std::string_view parameter);

/// The parameter as the case names it ("nu" for motion.nu, in a ratio too). Throws InputError at the
/// key where it is none of the valid numbers, nor a ratio of two of them; or_ratio: whether it says so.
std::string read_parameter_name(const CaseTree& tree, const std::string& key, std::string found,
                                const std::vector<std::string>& valid, bool or_ratio = true);

/// The number that the first of a ratio is at the ratio 1: the second; else 1.
double parameter_unit(const FamilyParameters& family, std::string_view parameter);

/// With the parameter at a value. Throws std::invalid_argument with the violated inequality of
/// body or model, for a number out of scale, or for a key that is not one of case_parameters().
FamilyParameters with_parameter(FamilyParameters family, std::string_view key, double value);

/// A parameter and the value it gets.
struct ParameterValue {
  std::string_view parameter;
  double value;
};
/// Likewise of several parameters, none of which varies what another one does, whether or not some of them alone
/// would be in the domain. A ratio is to the second number's new value.
FamilyParameters with_parameters(FamilyParameters family, std::span<const ParameterValue> values);
/// Which of those that with_parameters() refuses to blame: the first that is not allowed beside the family's
/// other numbers, or the last.
std::size_t refused_of(const FamilyParameters& family, std::span<const ParameterValue> values);

/// The parameter's own value. Throws std::invalid_argument for a key that is not one of them.
double parameter_value(FamilyParameters family, std::string_view key);

/// The parameter as the motion's family knows it, of a ratio the number that varies.
FamilyParameter family_parameter(std::string_view parameter,
                                 const std::vector<ModelChoice>& models);

}  // namespace stationary
