// A potential whose coefficients are inputs of a Conditioned computation: a coefficient that is
// added (w_tt = mu, w_ll = lambda - mu d) then counts like one multiplied in, which a double does
// not.
#pragma once

#include "lib/conditioned.hpp"
#include "lib/potential.hpp"

namespace stationary {

template <template <class> class Model>
Model<Conditioned> conditioned_model(const Model<double>& model) {
  const auto c = model.coefficients();
  return {Conditioned::input(c[0]), Conditioned::input(c[1])};
}

template <class Plane, class Thickness>
auto conditioned_model(const Separable<Plane, Thickness>& model) {
  const auto plane = conditioned_model(model.plane);
  const auto thickness = conditioned_model(model.thickness);
  return Separable<std::remove_cv_t<decltype(plane)>, std::remove_cv_t<decltype(thickness)>>{
      plane, thickness};
}

}  // namespace stationary
