// stationary sensitivity CASE: how its motion, or the events of its family, move with its numbers, as
// sensitivity_case.hpp finds it.
#include <memory>

#include "solver/program/computation/sensitivity_case.hpp"
#include "solver/program/session/command.hpp"

namespace stationary::cli {
namespace {

struct SensitivityOptions : ComputeOptions {
  bool events = false;
};

}  // namespace

void add_sensitivity(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "sensitivity",
                  "How the motion of a case and its modes move with each number of the case");
  const auto options = std::make_shared<SensitivityOptions>();
  options->add_to(command);
  command.remove_option(command.get_option("--certify"));  // a slope is estimated, not proven
  command.add_flag("--events", options->events,
                   "Of the events of the family of [continuation] instead: how each one's "
                   "parameter and stretches move");
  command.callback([options, &session] {
    session.action = [options, &session] {
      return compute(*options, session, [&](TableTarget* target, const Run& run) {
        return sensitivity_case(options->read(), options->events, target, run);
      });
    };
  });
}

}  // namespace stationary::cli
