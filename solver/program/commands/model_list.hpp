// The built-in potentials, for a person.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/material/potential.hpp"

namespace stationary::cli {

/// Isotropic ones first.
std::vector<ModelDescription> all_models();

/// What is assumed of it.
std::string_view assumption(const ModelDescription& model);

/// Formula, parameters, domain and assumptions of all of them, or of one. Throws InputError for a name
/// that none has.
std::string model_list(const std::string& only);

}  // namespace stationary::cli
