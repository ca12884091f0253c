// A potential with its models, as a case file's [potential] writes them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lib/body/motion.hpp"
#include "solver/motion/problem.hpp"
#include "solver/program/case/case_potential.hpp"

namespace stationary::python {

struct Material {
  std::vector<ModelChoice> models;
  Potential potential;
};

/// By its name; throws InputError with the names there are.
Branch branch_named(const std::string& name);

}  // namespace stationary::python
