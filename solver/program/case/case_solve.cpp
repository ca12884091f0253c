#include "solver/program/case/case_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "solver/program/case/case_motion.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/text/named.hpp"

namespace stationary {
namespace {

/// solve.box: one range for each of the three stretches.
std::optional<std::array<Interval, 3>> read_box(const CaseTree& tree) {
  constexpr std::string_view key = "solve.box";
  const toml::node* node = find(tree, key);
  if (node == nullptr) return std::nullopt;
  const toml::array& given = *node->as_array();
  const bool pairs = given.front().is_array();
  std::array<Interval, 3> out;
  for (std::size_t k = 0; k < out.size(); ++k) {
    const toml::array& pair = pairs ? *given[k].as_array() : given;
    const double least = pair[0].value<double>().value_or(0.0);
    const double most = pair[1].value<double>().value_or(0.0);
    if (!(least >= 1e-100 && least < most && most <= 1e100))
      throw fault_at(tree, pairs ? fmt::format("{}.{}", key, k) : std::string(key),
                     fmt::format("found [{}, {}]", least, most),
                     "[min, max] with 1e-100 <= min < max <= 1e100");
    out[k] = {least, most};
  }
  return out;
}

/// Of a motion that the method finds. straight: alpha is no unknown.
void require_method(const CaseTree& tree, Method method, const Motion& motion, bool isotropic,
                    bool straight) {
  const bool two_polar = std::holds_alternative<TwoPolarMotion>(motion);
  const bool tilted = name(motion) == tilted_name;
  if (two_polar && method != Method::automatic && method != Method::nlopt) {
    throw fault_at(
        tree, "solve.method",
        fmt::format("found the string {} with branch \"two-polar\"", in_quotes(name(method))),
        "\"auto\" or \"nlopt\"", "two-polar motions are searched for globally, then corrected");
  }
  if (tilted && method != Method::automatic && method != Method::newton) {
    throw fault_at(
        tree, "solve.method",
        fmt::format("found the string {} with branch \"tilted\"", in_quotes(name(method))),
        "\"auto\" or \"newton\"",
        "tilted motions are had by Newton from solve.start, or by following the family");
  }
  if (!straight && method != Method::automatic && method != Method::newton) {
    throw fault_at(
        tree, "solve.method",
        fmt::format("found the string {} {}", in_quotes(name(method)),
                    isotropic ? "where alpha is an unknown" : "with an anisotropic potential"),
        "\"auto\" or \"newton\"",
        "with alpha unknown motions are had by Newton from solve.start, or by following "
        "the family from rest");
  }
}

std::optional<Stretch> read_start(const CaseTree& tree, bool two_polar) {
  const std::vector<double> start = numbers(tree, "solve.start");
  if (start.empty()) return std::nullopt;
  const Stretch out{start[0], start[1], start[2], start[3]};
  const std::string_view parts[] = {"alpha", two_polar ? "lambda" : "xi", two_polar ? "mu" : "zeta",
                                    "rho"};
  const auto refuse = [&](std::size_t k, std::string_view allowed, std::string_view remedy) {
    throw fault_at(tree, fmt::format("solve.start.{}", k),
                   fmt::format("found {} = {}", parts[k], start[k]), std::string(allowed),
                   std::string(remedy));
  };
  if (two_polar && start[1] == start[2])
    refuse(2, "lambda != mu", "on the circle the two-polar balance is singular");
  for (std::size_t k = 1; k < 4; ++k)
    if (!(start[k] > 0.0)) refuse(k, fmt::format("{} > 0", parts[k]), "S is positive definite");
  if (const char* inequality = violated_inequality(out))
    throw fault_at(tree, "solve.start", "found S not positive definite", inequality);
  return out;
}

}  // namespace

void require_alpha(const CaseTree& tree, const std::optional<Stretch>& start, const Motion& motion,
                   const Potential& potential) {
  if (!start || start->alpha == 0.0 || may_have_alpha(motion, potential)) return;
  throw fault_at(tree, "solve.start.0", fmt::format("found alpha = {}", start->alpha), "alpha = 0",
                 "of an isotropic potential alpha = 0, but for an axis in no plane and, where "
                 "gravity lets it, "
                 "one oblique or along axis 3");
}

Case::Solve read_solve(const CaseTree& tree, const std::optional<Motion>& motion,
                       const std::optional<std::vector<ModelChoice>>& models, Faults& faults) {
  const bool two_polar = motion && std::holds_alternative<TwoPolarMotion>(*motion);
  const bool isotropic = models && !anisotropic(*models);
  Case::Solve out;
  if (faults.sound("solve.method")) {
    const std::string method = value_or<std::string>(tree, "solve.method", "auto");
    out.method = named<Method>(method_names, method).value();
  }
  out.all = value_or(tree, "solve.all", false);
  if (faults.sound("solve.box")) faults.collect([&] { out.box = read_box(tree); });
  if (faults.sound("solve.start")) faults.collect([&] { out.start = read_start(tree, two_polar); });
  if (faults.sound("solve.method") && motion && models) {
    const bool straight =
        isotropic && name(*motion) != oblique_name && !(out.start && out.start->alpha != 0.0);
    faults.collect([&] { require_method(tree, out.method, *motion, isotropic, straight); });
  }
  return out;
}

}  // namespace stationary
