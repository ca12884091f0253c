// What solvers ask of a model, whether it is a function of t, d and rho or a whole body with gravity or a held
// volume: of which it is, its state of rest, and what a spin takes from its balance.
#pragma once

#include <array>

#include "lib/balance/balance.hpp"
#include "lib/material/gravitating/rest_state.hpp"
#include "lib/material/potential.hpp"

namespace stationary {

/// A model with gravity or a held volume (body_model.hpp).
template <class Model>
constexpr bool is_body_model = requires(const Model& model) {
  model.gravitates;
};

/// Whether det S is held.
template <class Model>
bool holds_volume([[maybe_unused]] const Model& model) {
  if constexpr (is_body_model<Model>) return model.volume.has_value();
  return false;
}
/// Whether V is a function of t, d and rho.
template <class Model>
bool sees_no_axes([[maybe_unused]] const Model& model) {
  if constexpr (is_body_model<Model>) return model.isotropic();
  return true;
}

/// The state of rest of a coupled model, to double precision; NaN where none was found.
template <class Model>
Stretch rest_stretch_of(const Model& model) {
  if constexpr (is_body_model<Model>) {
    const auto [xi, zeta, rho] = rest_state(model);
    return {0.0, xi, zeta, rho};
  } else {
    const double r = model.rest_stretch();
    return {0.0, r, r, model.rest_thickness()};
  }
}

/// What a spin takes from the balance: c_i x_i^2, or what is left of it along a held volume.
template <class Model>
std::array<double, 3> centrifugal_pull(const Model& model, const CentrifugalRates<double>& c,
                                       double xi, double zeta, double rho) {
  const std::array<double, 3> pull{c.xi * xi * xi, c.zeta * zeta * zeta, c.rho * rho * rho};
  if constexpr (is_body_model<Model>)
    if (model.volume) return {pull[0] - pull[2], pull[1] - pull[2], 0.0};
  return pull;
}

}  // namespace stationary
