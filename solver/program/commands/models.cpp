// stationary models [NAME]: the built-in potentials.
#include <memory>

#include "solver/program/commands/model_list.hpp"
#include "solver/program/session/command.hpp"

namespace stationary::cli {

void add_models(CLI::App& program, Session& session) {
  CLI::App& command =
      add_command(program, "models", "List the potentials: formula, parameters, domain");
  const auto only = std::make_shared<std::string>();
  command.add_option("NAME", *only, "One model alone");
  command.callback([only, &session] {
    session.action = [only] {
      print(model_list(*only));
      return ExitCode::done;
    };
  });
}

}  // namespace stationary::cli
