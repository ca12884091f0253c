// Any text as a case file, through everything that is done before a computation: TOML, overrides
// (lines "#--set key=value"), the Case, its plan, and its metadata, which must be those of the
// case. Either it is read or InputError says what is wrong with it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "solver/program/case/case_file.hpp"
#include "solver/program/rows/metadata.hpp"
#include "solver/program/session/computation_plan.hpp"

namespace {

using namespace stationary;

void apply_overrides(std::string_view text, CaseTree& tree) {
  constexpr std::string_view mark = "#--set ";
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at)) {
    at += mark.size();
    tree.override_key(text.substr(at, text.find('\n', at) - at));
  }
}

void read(std::string_view text) {
  CaseTree tree = CaseTree::parse(text, "fuzz.toml");
  apply_overrides(text, tree);
  const Case input = make_case(std::move(tree));
  cli::ComputationPlan plan = cli::computation_plan(input, true, cli::PlanOf::check);
  Metadata metadata;
  metadata.version = "fuzz";
  metadata.input = &input;
  metadata.plan = std::move(plan.computed);
  metadata.skipped = std::move(plan.skipped);
  const std::string json = metadata_json(metadata);
  if (input.continuation && !is_of_case(json, input)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read({reinterpret_cast<const char*>(data), size});
  } catch (const stationary::InputError&) {
  }
  return 0;
}
