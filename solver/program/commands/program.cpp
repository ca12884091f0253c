#include "solver/program/commands/program.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "solver/program/text/input_error.hpp"

namespace stationary::cli {
namespace {

/// Usage comes first, then what it is.
class UsageFirst final : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    if (mode == CLI::AppFormatMode::Sub) return make_expanded(app);
    const std::string usage = make_usage(app, std::move(name));
    return usage.substr(usage.find_first_not_of('\n')) + '\n' + make_description(app) +
           make_positionals(app) + make_groups(app, mode) + make_subcommands(app, mode) + '\n' +
           make_footer(app);
  }
};

ExitCode run(const Program& of, int argc, char** argv) {
  CLI::App program(of.description, of.name);
  program.formatter(std::make_shared<UsageFirst>());  // commands take it over
  program.set_version_flag("--version", version_text, "Print the versions and exit");
  program.footer(
      "Exit codes: 0 done; 2 the input is wrong; 3 no stationary ellipsoid exists or was found; "
      "4 a failure; 130 interrupted.");
  Session session{{argv, argv + argc}, of.crew, {}};
  of.add_commands(program, session);
  add_help(program);
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  // Its own options are left to the parser.
  if (!words.empty() && words[0] == "help" && (words.size() == 1 || !words[1].starts_with('-'))) {
    constexpr std::size_t most = 2;
    if (words.size() > most) {
      complain("help takes one command; found " + in_quotes(words[most]) + " after " +
               in_quotes(words[1]));
      return ExitCode::wrong_input;
    }
    return help(program, words.size() < most ? "" : words[1]);
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help, --version
      std::ostringstream text;
      program.exit(error, text, text);
      print(text.str());
      return ExitCode::done;
    }
    complain(refusal(program, error));
    return ExitCode::wrong_input;
  }
  if (!session.action) {
    complain("no command given\n");
    std::fputs(program.help().c_str(), stderr);
    return ExitCode::wrong_input;
  }
  try {
    return session.action();
  } catch (const InputError& error) {
    std::istringstream lines(error.what());  // one for each fault
    for (std::string line; std::getline(lines, line);) complain(line);
    return ExitCode::wrong_input;
  }
}

/// A file opened first would get the number of a standard stream that the parent has closed, and
/// messages would go into it. What stands in its place can be neither read nor written.
void hold_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0)
      (void)::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void tell_out_of_memory() { std::fputs("stationary: out of memory\n", stderr); }

std::terminate_handler usual_end = std::abort;

/// Exceptions that cannot be caught. A JSON value takes memory to go (nlohmann's destructor), which there
/// may be none left of; a thread of TBB's begins another one, which the system may refuse.
[[noreturn]] void end_by_exception() {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    tell_out_of_memory();
    ::_exit(static_cast<int>(ExitCode::failure));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stationary: failed: %s\n", error.what());
    ::_exit(static_cast<int>(ExitCode::failure));
  } catch (...) {  // as without this handler
  }
  usual_end();
  std::abort();
}

}  // namespace

int run_program(const Program& of, int argc, char** argv) {
  hold_standard_streams();
  usual_end = std::set_terminate(end_by_exception);
  // A limit on the size of files is then met as a full disk is.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return static_cast<int>(run(of, argc, argv));
  } catch (const std::bad_alloc&) {
    tell_out_of_memory();
  } catch (const std::exception& error) {
    complain(std::string("failed: ") + error.what());
  } catch (...) {
    std::fputs("stationary: failed for an unknown reason\n", stderr);
  }
  return static_cast<int>(ExitCode::failure);
}

}  // namespace stationary::cli
