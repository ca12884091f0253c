// The bodies that are measured: one inertia, any planar model with the coefficients (1, 2), the
// thickness a/rho + b rho^2/2.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "solver/motion/problem.hpp"

namespace stationary::bench {

constexpr std::string_view planar_models[] = {"reciprocal-determinant",
                                              "saint-venant-kirchhoff",
                                              "biot",
                                              "biot-log",
                                              "neo-hookean",
                                              "hencky"};

inline Problem problem_of(std::string_view model, Branch branch) {
  const double plane[2] = {1.0, 2.0};
  const double thickness[2] = {1.0, 3.0};
  return {Body(1.0, 1.7, 0.6),
          Potential(Potential::planar(model, plane),
                    Potential::thickness("reciprocal-quadratic", thickness)),
          branch};
}

inline std::string label_of(std::string_view model, Branch branch) {
  return std::string(model) + "/" + std::string(name(branch));
}

/// Calls f with the model of such a body, as its own type. Potential::visit would have the compiler
/// make every peer for every pair of a planar and a thickness model.
template <class F>
decltype(auto) visit(const Problem& problem, F&& f) {
  const Potential& potential = problem.potential();
  return std::visit(
      [&](const auto& plane) -> decltype(auto) {
        return f(Separable<std::decay_t<decltype(plane)>, ReciprocalQuadratic<>>{
            plane, std::get<ReciprocalQuadratic<>>(potential.thickness())});
      },
      potential.plane());
}

}  // namespace stationary::bench
