// stationary atlas CASE: every sheet, as atlas_case.hpp finds them.
#include "solver/atlas/atlas.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "solver/program/case/case_atlas.hpp"
#include "solver/program/computation/atlas_case.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/tiles/journal.hpp"

namespace stationary::cli {
namespace {

struct AtlasCommand : ComputeOptions {
  std::optional<int> checkpoints;
  bool resume = false;
  bool complete = false;
};

}  // namespace

void add_atlas(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "atlas",
                  "Find and follow every sheet over the case's range of nu, connected or not");
  const auto options = std::make_shared<AtlasCommand>();
  options->threads = all_processors();
  options->add_to(command);
  command
      .add_option("--checkpoints", options->checkpoints,
                  fmt::format("Values of nu at which every solution is found, with proof (default "
                              "{}, of an anisotropic body {})",
                              AtlasOptions{}.checkpoints, few_checkpoints))
      ->check(CLI::Range(1, 1'000'000));
  command.add_flag("--complete", options->complete,
                   "Prove for every nu of the range how many sheets there are, not at the "
                   "checkpoints alone");
  command.add_flag("--resume", options->resume,
                   "Go on with the interrupted atlas at -o FILE: no search is made twice");
  command.callback([options, &session] {
    session.action = [options, &session] {
      AtlasRun asked{options->checkpoints, std::nullopt, options->resume, options->complete};
      if (options->resume || has_journal(options->output)) asked.journal = options->output;
      return compute(*options, session, [&](TableTarget* target, const Run& run) {
        return atlas_case(options->read(), asked, target, run);
      });
    };
  });
}

}  // namespace stationary::cli
