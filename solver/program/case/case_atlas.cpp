#include "solver/program/case/case_atlas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/program/case/case_schema.hpp"

namespace stationary {

AtlasOptions atlas_options(const Case& input, std::optional<int> checkpoints, bool with_spectrum) {
  if (!input.continuation) {
    throw fault_at(input.source, "continuation", "found no such key", "a table with from and to",
                   "add [continuation]");
  }
  const Case::Continuation& asked = *input.continuation;
  if (asked.parameter != "nu") {
    throw fault_at(input.source, "continuation.parameter", fmt::format("found {}", asked.parameter),
                   "\"nu\" for an atlas", "`continue` follows one sheet in other parameters");
  }
  AtlasOptions out;
  // nu and -nu are one.
  out.from =
      asked.from < 0.0 && asked.to > 0.0 ? 0.0 : std::min(std::abs(asked.from), std::abs(asked.to));
  out.to = std::max(std::abs(asked.from), std::abs(asked.to));
  out.step.tolerance = asked.tolerance;
  out.step.first = asked.step;
  out.unit = input.unit_stretch();
  out.max_points = static_cast<long>(asked.max_points);
  out.spectrum = with_spectrum;
  const int by_symmetry =
      input.potential.is_isotropic() ? AtlasOptions{}.checkpoints : few_checkpoints;
  out.checkpoints = checkpoints.value_or(input.atlas.checkpoints.value_or(by_symmetry));
  out.complete = input.atlas.complete;
  out.search.box = input.solve.box;
  return out;
}

}  // namespace stationary
