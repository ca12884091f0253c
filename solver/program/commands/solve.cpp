// stationary solve CASE: what solve_case.hpp finds of it.
#include <memory>

#include "solver/program/computation/solve_case.hpp"
#include "solver/program/session/command.hpp"

namespace stationary::cli {

void add_solve(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "solve", "Find the stationary ellipsoid of a case, and its spectrum");
  const auto options = std::make_shared<ComputeOptions>();
  options->add_to(command);
  command.callback([options, &session] {
    session.action = [options, &session] {
      return compute(*options, session, [&](TableTarget* target, const Run& run) {
        return solve_case(options->read(), target, run);
      });
    };
  });
}

}  // namespace stationary::cli
