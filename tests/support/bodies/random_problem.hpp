// Random families from fixed seeds: every model, every branch, J and coefficients over a given
// number of orders of magnitude, and a nu from slow to beyond what the body can hold.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "solver/motion/problem.hpp"
#include "solver/solve/solve.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary::testing {

struct Posed {
  Problem problem;
  double nu;
  std::string text;  ///< all of it, for messages
};

inline const std::vector<std::string_view>& planar_models() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> out;
    for (const ModelDescription& model : model_descriptions())
      if (model.kind == ModelDescription::Kind::planar) out.push_back(model.name);
    return out;
  }();
  return names;
}
/// The planar models and the coupled one.
inline std::vector<std::string_view> all_models() {
  auto out = planar_models();
  out.push_back("neo-hookean-3d");
  return out;
}

/// By name: "neo-hookean-3d", or a planar model under a thickness one.
inline Potential make_potential(std::string_view model, std::array<double, 2> coefficients,
                                std::string_view thickness = "reciprocal-quadratic",
                                std::array<double, 2> axial = {1.0, 3.0}) {
  if (model == "neo-hookean-3d") return Potential(Potential::coupled(model, coefficients));
  return {Potential::planar(model, coefficients), Potential::thickness(thickness, axial)};
}

/// orders: J, coefficients within 10^(-orders/2) ... 10^(orders/2). Coefficients are positive, but
/// one lambda in eight is negative (within mu + lambda > 0, 2 mu + 3 lambda > 0).
inline Posed random_problem(support::Random& random, double orders) {
  const double ratio = std::pow(10.0, 0.5 * orders);
  const auto positive = [&] { return random.log_uniform(1.0 / ratio, ratio); };
  const int kinds = static_cast<int>(planar_models().size()) + 1;
  const int kind = random.integer(0, kinds - 1);
  const std::string_view model = kind + 1 == kinds
                                     ? std::string_view("neo-hookean-3d")
                                     : planar_models()[static_cast<std::size_t>(kind)];
  std::array<double, 2> plane{positive(), positive()};
  if (model != "reciprocal-determinant" && random.integer(0, 7) == 0)
    plane[1] = -0.6 * plane[0] * random.uniform(0.0, 1.0);
  const std::string_view thickness =
      random.integer(0, 2) == 0 ? "harmonic" : "reciprocal-quadratic";
  const std::array<double, 2> axial{positive(), positive()};
  const double J1 = positive();
  // One after the other: compilers differ in the order of a call's arguments.
  const double J3 = positive();
  const double J2 = random.integer(0, 9) == 0 ? J1 : positive();
  const Body body(J1, J2, J3);
  const auto branch = static_cast<Branch>(random.integer(0, 2));
  // The speed at which the pulls match the stiffness, give or take.
  const double stiffness = model == "reciprocal-determinant" ? plane[1] : 2.0 * plane[0];
  const double J = branch == Branch::i    ? body.J2
                   : branch == Branch::ii ? body.J1
                                          : std::max(body.J1, body.J2);
  const double sign = random.sign();
  const double nu = sign * std::sqrt(stiffness / J) * random.log_uniform(1e-2, 1.5);
  std::ostringstream text;
  text.precision(17);
  text << model << " " << plane[0] << " " << plane[1] << ", " << thickness << " " << axial[0] << " "
       << axial[1] << ", J (" << body.J1 << ", " << body.J2 << ", " << body.J3 << "), ("
       << name(branch) << "), nu " << nu;
  return {Problem(body, make_potential(model, plane, thickness, axial), branch), nu, text.str()};
}

}  // namespace stationary::testing
