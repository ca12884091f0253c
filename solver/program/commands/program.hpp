// A program of commands: reads its arguments, runs the one chosen, and turns what it throws into exit
// codes.
#pragma once

#include <functional>
#include <string>

#include "solver/program/session/command.hpp"

namespace stationary::cli {

struct Program {
  std::string name;
  std::string description;
  std::function<void(CLI::App& program, Session& session)> add_commands;
  Crew* crew = nullptr;
};

/// Its exit code; nothing is thrown.
int run_program(const Program& of, int argc, char** argv);

}  // namespace stationary::cli
