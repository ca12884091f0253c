// stationary check CASE: what check_case.hpp tells of it.
#include <memory>

#include "solver/program/computation/check_case.hpp"
#include "solver/program/session/command.hpp"

namespace stationary::cli {

void add_check(CLI::App& program, Session& session) {
  CLI::App& command = add_command(
      program, "check", "Validate a case; print the model and what will be computed and skipped");
  const auto options = std::make_shared<CaseOptions>();
  options->add_to(command);
  command.callback([options, &session] {
    session.action = [options] {
      print(check_case(options->read()));
      return ExitCode::done;
    };
  });
}

}  // namespace stationary::cli
