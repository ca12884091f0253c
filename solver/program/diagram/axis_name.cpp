#include "solver/program/diagram/axis_name.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace stationary {
namespace {

using Name = std::pair<std::string_view, std::string_view>;

constexpr Name names[] = {{"nu", "ν"},
                          {"nu1", "ν₁"},
                          {"nu2", "ν₂"},
                          {"nu3", "ν₃"},
                          {"alpha", "α"},
                          {"xi", "ξ"},
                          {"zeta", "ζ"},
                          {"rho", "ϱ"},
                          {"lambda", "λ"},
                          {"mu", "μ"},
                          {"angle", "principal angle θ"},
                          {"pi1", "π₁"},
                          {"pi2", "π₂"},
                          {"pi3", "π₃"},
                          {"energy", "energy E"},
                          {"growth", "growth rate"},
                          {"negative", "negative directions"},
                          {"error_bound", "error bound of S"},
                          {"omega", "ω"},
                          {"theta_dot", "dθ/dt"},
                          {"s3", "s₃"},
                          {"p_theta", "p_θ"},
                          {"body.J.0", "J₁"},
                          {"body.J.1", "J₂"},
                          {"body.J.2", "J₃"},
                          {"body.volume", "held volume C"},
                          {"gravity.g", "strength of gravity g"},
                          {"gravity.pi_G_rho", "πGϱ of gravity"},
                          {"motion.nu", "ν"},
                          {"motion.omega", "ω"},
                          {"motion.theta_dot", "dθ/dt"},
                          {"motion.s3", "s₃"},
                          {"motion.p_theta", "p_θ"},
                          {"potential.fibre.degrees", "fibre angle/°"},
                          {"potential.second_fibre.degrees", "second fibre angle/°"},
                          {"potential.fibre.k", "fibre stiffness k"},
                          {"potential.second_fibre.k", "second fibre stiffness k"}};

/// "c of the plane" for potential.plane.c.
std::string coefficient(std::string_view key) {
  constexpr std::array<Name, 3> parts{{{"potential.plane.", " of the plane"},
                                       {"potential.thickness.", " of the thickness"},
                                       {"potential.coupled.", " of V"}}};
  for (const auto& [prefix, of] : parts) {
    if (!key.starts_with(prefix) || key.size() == prefix.size()) continue;
    const std::string name = axis_name(key.substr(prefix.size()));
    return name + std::string(of);
  }
  return std::string(key);
}

}  // namespace

std::string axis_name(std::string_view key) {
  const auto* const at = std::ranges::find(names, key, &Name::first);
  if (at != std::end(names)) return std::string(at->second);
  const std::size_t slash = key.find('/');
  if (slash != std::string_view::npos && key.find('/', slash + 1) == std::string_view::npos)
    return axis_name(key.substr(0, slash)) + '/' + axis_name(key.substr(slash + 1));
  return coefficient(key);
}

}  // namespace stationary
