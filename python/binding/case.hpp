// A case as the module holds it: validated, and never changed.
#pragma once

#include <memory>

#include "solver/program/case/case_file.hpp"

namespace stationary::python {

/// From a dict, or what a case takes for one; name: what messages call it.
inline constexpr const char* case_name = "Case";

/// The file a case was read from, which is not to be replaced; empty of one from a dict.
std::string file_of(const Case& input);

}  // namespace stationary::python
