// Whether a model's coefficients lie in its domain.
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace stationary {

/// Throws std::invalid_argument with the first inequality that does not hold.
template <class Model>
void require_domain(const Model& model) {
  const auto coefficients = model.coefficients();
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    if (!std::isfinite(coefficients[k]))
      throw std::invalid_argument(std::string(Model::parameters[k]) + " finite");
  }
  const auto holds = model.in_domain();
  for (std::size_t k = 0; k < holds.size(); ++k) {
    if (!holds[k]) throw std::invalid_argument(std::string(Model::domain[k]));
  }
}

}  // namespace stationary
