#include "solver/program/case/case_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "solver/program/case/case_parameter.hpp"
#include "solver/program/case/case_schema.hpp"
#include "solver/program/text/named.hpp"

namespace stationary {
namespace {

std::string element(std::string_view key, int k) { return fmt::format("curve.{}.{}", key, k); }

void read_parameters(const CaseTree& tree, const FamilyParameters& family, CaseCurve& out) {
  const toml::array& named = *find(tree, "curve.parameters")->as_array();
  if (named.size() != 2) {
    throw fault_at(tree, "curve.parameters",
                   fmt::format("found {} name{}", named.size(), named.size() == 1 ? "" : "s"),
                   std::string(find_case_key("curve.parameters")->allowed));
  }
  const std::vector<std::string> valid = case_parameters(family.motion, family.models);
  for (const int k : {0, 1}) {
    out.parameters[static_cast<std::size_t>(k)] =
        read_parameter_name(tree, element("parameters", k),
                            named[static_cast<std::size_t>(k)].as_string()->get(), valid);
  }
  if (out.parameters[0] == out.parameters[1]) {
    throw fault_at(tree, element("parameters", 1),
                   "found " + in_quotes(out.parameters[1]) + " twice", "two numbers of the case");
  }
  // What varies the one must leave the other alone.
  for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
    const auto [number, held] = parts_of(out.parameters[k]);
    const ParameterParts other = parts_of(out.parameters[1 - k]);
    if (number != other.first && number != other.second) continue;
    throw fault_at(tree, element("parameters", static_cast<int>(k)),
                   fmt::format("found {} beside {}", in_quotes(out.parameters[k]),
                               in_quotes(out.parameters[1 - k])),
                   "two parameters, each of which leaves the other as it is");
  }
}

/// The domains are convex, so the corners answer for all of the rectangle.
void require_domain(const CaseTree& tree, const FamilyParameters& family, const CaseCurve& curve) {
  for (const double first : {curve.from[0], curve.to[0]}) {
    for (const double second : {curve.from[1], curve.to[1]}) {
      const std::array corner{ParameterValue{curve.parameters[0], first},
                              ParameterValue{curve.parameters[1], second}};
      try {
        (void)with_parameters(family, corner);
      } catch (const std::invalid_argument& error) {
        const std::size_t k = refused_of(family, corner);
        throw fault_at(
            tree, element(corner[k].value == curve.from[k] ? "from" : "to", static_cast<int>(k)),
            fmt::format("found {} = {}", corner[k].parameter, corner[k].value), error.what());
      }
    }
  }
}

}  // namespace

std::optional<CaseCurve> read_curve(const CaseTree& tree, const FamilyParameters* family,
                                    Faults& faults) {
  if (find(tree, "curve") == nullptr) return std::nullopt;
  CaseCurve out;
  const auto has = [&](std::string_view key) {
    return find(tree, key) != nullptr && faults.sound(key);
  };
  if (has("curve.event"))
    out.event =
        named<EventType>(event_names, value_or<std::string>(tree, "curve.event", "")).value();
  if (has("curve.from") && has("curve.to")) {
    const std::vector<double> from = numbers(tree, "curve.from");
    const std::vector<double> to = numbers(tree, "curve.to");
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
      out.from[k] = from[k];
      out.to[k] = to[k];
      if (from[k] < to[k]) continue;
      faults.add(fault_at(tree, element("to", static_cast<int>(k)),
                          fmt::format("found the empty range from {} to {}", from[k], to[k]),
                          "from < to"));
    }
  }
  out.tolerance = value_or(tree, "curve.tolerance", out.tolerance);
  if (has("curve.tolerance") && !(out.tolerance > 0.0 && out.tolerance <= 1.0)) {
    faults.add(fault_at(tree, "curve.tolerance", fmt::format("found {}", out.tolerance),
                        "a number > 0 and <= 1"));
  }
  if (family != nullptr && has("curve.parameters") &&
      faults.collect([&] { read_parameters(tree, *family, out); }) && faults.sound("curve"))
    faults.collect([&] { require_domain(tree, *family, out); });
  if (!faults.sound("curve")) return std::nullopt;
  return out;
}

}  // namespace stationary
