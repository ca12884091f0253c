// stationary help [COMMAND]: what the program takes, or one command of it.
#include <string>
#include <vector>

#include "solver/program/session/command.hpp"
#include "solver/program/text/input_error.hpp"
#include "solver/program/text/nearest_name.hpp"

namespace stationary::cli {

void add_help(CLI::App& program) {
  // Its word is read before the parser is asked (program.cpp).
  add_command(program, "help", "What the program takes, or one command of it")
      .add_option("COMMAND", "One of the program's commands");
}

ExitCode help(const CLI::App& program, const std::string& name) {
  if (name.empty()) {
    print(program.help());
    return ExitCode::done;
  }
  std::vector<std::string> names;
  for (const CLI::App* each : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (each->get_name() == name) {
      print(each->help(program.get_name()));
      return ExitCode::done;
    }
    names.push_back(each->get_name());
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  std::string remedy = did_you_mean(nearest_name(name, candidates));
  if (!remedy.empty()) remedy = "; " + remedy;
  complain("unknown command " + in_quotes(name) + remedy);
  return ExitCode::wrong_input;
}

}  // namespace stationary::cli
