#include "tests/program/program.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace stationary::testing {
namespace {

namespace fs = std::filesystem;

/// The child's part; only async-signal-safe calls.
[[noreturn]] void become_program(char* const* arguments, const std::string& out,
                                 const std::string& err, const RunOptions& options) {
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
  const int out_file = ::open(out.c_str(), flags, 0600);
  const int err_file = ::open(err.c_str(), flags, 0600);
  if (out_file < 0 || err_file < 0) ::_exit(127);
  ::dup2(out_file, STDOUT_FILENO);
  ::dup2(err_file, STDERR_FILENO);
  if (!options.directory.empty() && ::chdir(options.directory.c_str()) != 0) ::_exit(127);
  if (options.file_size_limit >= 0) {
    const auto bytes = static_cast<rlim_t>(options.file_size_limit);
    const ::rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  for (const int signal : {options.pending_signal, options.other_pending_signal}) {
    if (signal == 0) continue;
    sigset_t blocked;
    sigemptyset(&blocked);
    sigaddset(&blocked, signal);
    sigprocmask(SIG_BLOCK, &blocked, nullptr);
    ::raise(signal);
  }
  for (const std::string& each : options.environment) ::putenv(const_cast<char*>(each.c_str()));
  ::execvp(options.program.empty() ? program_path() : arguments[0], arguments);
  ::_exit(127);
}

/// A temporary file of the target (atomic_file.hpp) that is not empty.
bool is_being_written(const fs::path& target) {
  const std::string begin = "." + target.filename().string() + ".";
  std::error_code gone;
  for (const auto& entry : fs::directory_iterator(target.parent_path())) {
    if (entry.path().filename().string().starts_with(begin) && entry.file_size(gone) > 0 && !gone)
      return true;
  }
  return false;
}

}  // namespace

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> out;
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

const char* program_of(const char* variable, const char* compiled) {
  const char* const named = std::getenv(variable);
  return named != nullptr ? named : compiled;
}

Outcome run_program(const std::vector<std::string>& arguments, const RunOptions& options) {
  const TemporaryDirectory streams;
  const std::string out =
      options.standard_output.empty() ? streams / "out" : options.standard_output;
  const std::string err = streams / "err";
  std::vector<std::string> all =
      options.program.empty() ? std::vector<std::string>{"stationary"} : options.program;
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  pointers.reserve(all.size() + 1);
  for (std::string& each : all) pointers.push_back(each.data());
  pointers.push_back(nullptr);

  const pid_t child = ::fork();
  if (child == 0) become_program(pointers.data(), out, err, options);
  if (child < 0) throw std::runtime_error("fork");
  if (options.kill_after_ms >= 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(options.kill_after_ms));
    ::kill(child, SIGKILL);
  }
  int status = 0;
  if (!options.interrupt_once_written.empty()) {
    siginfo_t ended{};
    while (!is_being_written(options.interrupt_once_written) && ended.si_pid == 0)
      ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    ::kill(child, SIGINT);
  }
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  Outcome outcome;
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (options.standard_output.empty()) outcome.out = text_of(out);
  outcome.err = text_of(err);
  return outcome;
}

TemporaryDirectory::TemporaryDirectory() {
  std::string pattern = (fs::temp_directory_path() / "stationary-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("mkdtemp");
  path_ = pattern;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string TemporaryDirectory::file(const std::string& name, const std::string& text) const {
  std::string path = *this / name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::vector<std::string> TemporaryDirectory::names() const {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(path_))
    out.push_back(entry.path().filename().string());
  std::ranges::sort(out);
  return out;
}

const char* const good_case = R"(title = "A case"

[body]
J = [1.0, 1.7, 0.6]

[potential]
plane     = { model = "neo-hookean", mu = 1.0, lambda = 2.0 }
thickness = { model = "reciprocal-quadratic", a = 1.0, b = 3.0 }

[motion]
branch = "i"
nu = 0.5
)";

}  // namespace stationary::testing
