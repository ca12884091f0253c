// A case as the module holds it: validated, and never changed.
#pragma once

#include <memory>

#include "solver/program/case/case_file.hpp"

namespace stationary::python {

/// What messages call a case of a dict.
inline constexpr const char* case_name = "Case";

/// The file that keys were read from, which is not to be replaced; empty of those of a dict.
std::string file_of(const CaseTree& keys);

}  // namespace stationary::python
