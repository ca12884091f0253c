// A command: one file each, which adds its options to the program and, if chosen, leaves its
// action.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "solver/program/case/case_file.hpp"
#include "solver/program/session/exit_code.hpp"
#include "solver/program/session/run.hpp"
#include "solver/program/session/table_output.hpp"

namespace stationary::cli {

class Crew;

struct Session {
  std::vector<std::string> command_line;
  Crew* crew = nullptr;  ///< processes that compute together (tiles/crew.hpp); null: this one alone
  std::function<ExitCode()> action;  ///< of the command chosen; empty if none was
};

void add_solve(CLI::App& program, Session& session);
void add_continue(CLI::App& program, Session& session);
void add_atlas(CLI::App& program, Session& session);
void add_map(CLI::App& program, Session& session);
void add_study(CLI::App& program, Session& session);
void add_curve(CLI::App& program, Session& session);
void add_sensitivity(CLI::App& program, Session& session);
void add_check(CLI::App& program, Session& session);
void add_models(CLI::App& program, Session& session);
void add_plot(CLI::App& program, Session& session);
void add_explore(CLI::App& program, Session& session);
/// The program's version, its compiler and its libraries, a line each.
std::string version_text();
/// Listed among the commands; help() answers before the others' options are read.
void add_help(CLI::App& program);
ExitCode help(const CLI::App& program, const std::string& name);

/// CASE and --set.
struct CaseOptions {
  std::string path;
  std::vector<std::string> overrides;

  void add_to(CLI::App& command);
  Case read() const { return read_case(path, overrides); }
};

/// What every computing command takes beside.
struct ComputeOptions : CaseOptions {
  std::string output;  ///< empty: no table; "-": CSV on standard output, and no summary
  bool certify = false;
  bool quiet = false;
  int threads = 1;

  void add_to(CLI::App& command);
  Case read() const;
  /// Standard output is for a person, unless it takes the table.
  bool shows_summary() const { return !quiet && output != "-"; }
};

/// Reads nothing of the case itself: computation(target, run) does, and its table goes where the
/// options say (null: there is none). Tells a person on standard error what there is to tell, prints
/// the summary where one is asked for, and gives the exit code. From here on Ctrl-C ends the
/// computation, not the program.
ExitCode compute(const ComputeOptions& options, const Session& session,
                 const std::function<Outcome(TableTarget* target, const Run& run)>& computation);

/// As many threads as the machine has processors.
int all_processors();

/// A check of an option that names a file: what is wrong, or nothing.
std::string not_empty(const std::string& name);
/// Likewise of one that names a row of a table.
std::string not_empty_row(const std::string& name);

/// A command with the options all have in common.
CLI::App& add_command(CLI::App& program, const std::string& name, const std::string& description);

/// One line on standard error, after the program's name.
void complain(const std::string& message);

/// One block of text on standard output. Throws std::runtime_error where it cannot be written.
void print(const std::string& text);

/// The message for arguments CLI11 refused, with the nearest command or option.
std::string refusal(const CLI::App& program, const CLI::ParseError& error);

}  // namespace stationary::cli
