#include "solver/program/session/command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>

#include "solver/program/session/interrupt.hpp"
#include "solver/program/session/progress.hpp"
#include "solver/program/table/atomic_file.hpp"
#include "solver/program/text/input_error.hpp"
#include "solver/program/text/nearest_name.hpp"
#include "solver/program/text/terminal.hpp"

namespace stationary::cli {

CLI::App& add_command(CLI::App& program, const std::string& name, const std::string& description) {
  CLI::App& command = *program.add_subcommand(name, description);
  command.set_version_flag("--version", version_text, "Print the versions and exit");
  return command;
}

void CaseOptions::add_to(CLI::App& command) {
  command.add_option("CASE", path, "Case file (TOML)")->required();
  command
      .add_option("--set", overrides,
                  "Override a key of the case, e.g. --set motion.nu=0.3 --set body.J=[1,1.7,0.6]; "
                  "repeatable, the last one counts")
      ->allow_extra_args(false)
      ->type_name("KEY=VALUE");
}

std::string not_empty(const std::string& name) {
  return name.empty() ? "found an empty name; expected a file" : "";
}

std::string not_empty_row(const std::string& name) {
  return name.empty() ? "found an empty name; expected a row of a table" : "";
}

void ComputeOptions::add_to(CLI::App& command) {
  CaseOptions::add_to(command);
  command
      .add_option("-o,--output", output,
                  "Write the table there, and FILE's .meta.json beside it: HDF5 with the suffix "
                  ".h5 or .hdf5, CSV with .csv or none; - is standard output")
      ->type_name("FILE")
      ->check(not_empty);
  command.add_flag("--certify", certify,
                   "Prove each row and its error bound, as output.certificate = true");
  command.add_flag("-q,--quiet", quiet, "No summary and no progress");
  command.add_option("--threads", threads, "Threads to use")
      ->type_name("N")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

Case ComputeOptions::read() const {
  Case out = CaseOptions::read();
  out.output.certificate = out.output.certificate || certify;
  return out;
}

ExitCode compute(const ComputeOptions& options, const Session& session,
                 const std::function<Outcome(TableTarget* target, const Run& run)>& computation) {
  ProgressBar progress;
  ProgressLines lines;
  Run run;
  run.command_line = session.command_line;
  run.threads = options.threads;
  run.stop = &stop_on_signals();  // before a file is begun, which would be left behind
  run.summary = options.shows_summary();
  run.complain = [&progress](const std::string& line) {
    progress.clear();
    complain(line);
  };
  if (session.crew != nullptr && !options.quiet) {
    // What a batch system starts has no terminal, though mpirun may give it one, and runs for hours.
    run.progress = [&lines](double fraction, const std::string& what) {
      lines.show(fraction, what);
    };
  } else if (progress.shown() && !options.quiet) {
    run.progress = [&progress](double fraction, const std::string& what) {
      progress.show(fraction, what);
    };
  }
  run.waiting = [&options](const std::string& what) -> std::shared_ptr<void> {
    return std::make_shared<WaitingSign>(what, options.quiet);
  };
  std::optional<TableOutput> output;
  if (!options.output.empty()) output.emplace(options.output, options.path, options.threads);
  const Outcome out = computation(output ? &*output : nullptr, run);
  progress.clear();
  if (!out.summary.empty()) print(out.summary);
  return out.code;
}

int all_processors() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

void complain(const std::string& message) {
  const std::string name = "stationary:";
  const std::string line = (has_colours(STDERR_FILENO) ? alarm(name) : name) + ' ' + message + '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void print(const std::string& text) { StandardOutput().write(text); }

std::string refusal(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = program.get_subcommands();
  const CLI::App& command = chosen.empty() ? program : *chosen.front();
  const std::string help =
      fmt::format("\nRun \"{}{} --help\" for what is allowed.", program.get_name(),
                  chosen.empty() ? "" : " " + command.get_name());
  // What was not understood explains more than what is missing because of it.
  const std::vector<std::string> unknown = program.remaining(true);
  if (unknown.empty()) return printable(error.what()) + help;

  const std::string& word = unknown.front();
  const bool is_option = word.starts_with('-');
  std::vector<std::string> names;
  if (is_option) {
    for (const CLI::Option* option : command.get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  } else if (chosen.empty()) {
    for (const CLI::App* each : program.get_subcommands({})) names.push_back(each->get_name());
  }
  // Met before the command, where it may be one of the command's own.
  const std::vector<std::string> before = program.remaining();
  if (is_option && !chosen.empty() && std::ranges::find(before, word) != before.end())
    return fmt::format("{} stands before the command; the options of {} stand after it{}",
                       in_quotes(word), command.get_name(), help);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  std::string remedy =
      did_you_mean(nearest_name(std::string_view(word).substr(0, word.find('=')), candidates));
  if (!remedy.empty()) remedy = "; " + remedy;
  const std::string_view what = is_option ? "option" : chosen.empty() ? "command" : "argument";
  return fmt::format("unknown {} {}{}{}", what, in_quotes(word), remedy, help);
}

}  // namespace stationary::cli
