// The table [curve] of a case: an event and the two numbers of the case (case_parameter.hpp) in
// whose plane its curve lies. The event is one of the case's family in the first of them.
//
//   [curve]
//   event = "tilt"
//   parameters = ["nu", "body.J.1"]
//   from = [0.0, 0.5]
//   to = [1.5, 2.0]
#pragma once

#include <array>
#include <optional>
#include <string>

#include "solver/motion/event.hpp"
#include "solver/program/case/case_toml.hpp"
#include "solver/program/text/faults.hpp"

namespace stationary {

struct FamilyParameters;

struct CaseCurve {
  EventType event = EventType::none;
  std::array<std::string, 2> parameters;
  std::array<double, 2> from{};
  std::array<double, 2> to{};
  double tolerance = 1e-8;
};

/// Nothing where the case has no such table, or something is wrong with it. family: nullptr where
/// something is wrong with the case's body, potential or motion.
std::optional<CaseCurve> read_curve(const CaseTree& tree, const FamilyParameters* family,
                                    Faults& faults);

}  // namespace stationary
