// Whether a model's coefficients lie in its domain.
#pragma once

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace stationary {

/// Of a built-in model, or of one whose parameters are known at run time.
template <class Model>
std::string_view parameter_name(const Model& model, std::size_t k) {
  if constexpr (requires { Model::parameters[k]; }) {
    return Model::parameters[k];
  } else {
    return model.parameters()[k];
  }
}

/// Throws std::invalid_argument with the first inequality that does not hold.
template <class Model>
void require_domain(const Model& model) {
  const auto& coefficients = model.coefficients();
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    if (!std::isfinite(coefficients[k]))
      throw std::invalid_argument(std::string(parameter_name(model, k)) + " finite");
  }
  if constexpr (requires { model.in_domain(); }) {
    const auto holds = model.in_domain();
    for (std::size_t k = 0; k < holds.size(); ++k) {
      if (!holds[k]) throw std::invalid_argument(std::string(Model::domain[k]));
    }
  }
}

}  // namespace stationary
