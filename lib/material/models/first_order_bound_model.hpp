// A potential whose coefficients are inputs of a Conditioned computation: a coefficient that is
// added (w_tt = mu, w_ll = lambda - mu d) then counts like one multiplied in, which a double does
// not.
#pragma once

#include "lib/material/models/model_coefficients.hpp"
#include "lib/number/first_order_bound.hpp"

namespace stationary {

template <class Model>
auto conditioned_model(const Model& model) {
  return with_coefficients(model, Conditioned::input);
}

}  // namespace stationary
