// What a case says, what will be computed, and what will not and why.
#pragma once

#include <string>

#include "solver/program/case/case_file.hpp"

namespace stationary::cli {

/// For a person.
std::string check_case(const Case& input);

}  // namespace stationary::cli
