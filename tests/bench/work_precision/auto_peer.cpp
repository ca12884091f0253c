#include "tests/bench/work_precision/auto_peer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "lib/number/double_double_functions.hpp"
#include "solver/continuation/continuation.hpp"
#include "tests/bench/bodies.hpp"
#include "tests/bench/work_precision/auto_output.hpp"

namespace stationary::bench {
namespace {

namespace fs = std::filesystem;

const std::string equations_name = "auto_balance";

/// Seconds in user mode of a program run to its end, in a directory, without a word.
double run(std::vector<std::string> words, const fs::path& in) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, in.c_str());
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_WRONLY, 0);
  ::pid_t process = 0;
  const int reason =
      ::posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), ::environ);
  posix_spawn_file_actions_destroy(&actions);
  if (reason != 0) throw std::system_error(reason, std::generic_category(), words[0]);
  int status = 0;
  rusage used{};
  while (::wait4(process, &status, 0, &used) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), words[0]);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error(words[0] + " has failed");
  return static_cast<double>(used.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(used.ru_utime.tv_usec);
}

bool is_auto(const fs::path& directory) { return fs::exists(directory / "cmds" / "cmds.make"); }

/// Where AUTO is installed. Its command `auto` stands in its folder bin.
std::optional<fs::path> auto_directory() {
  if (const char* given = std::getenv("AUTO_DIR"); given != nullptr && is_auto(given))
    return fs::absolute(given);
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code none;
    const fs::path command = fs::canonical(fs::path(folder) / "auto", none);
    if (!none && is_auto(command.parent_path().parent_path()))
      return command.parent_path().parent_path();
  }
  return std::nullopt;
}

/// Its list of changes begins with it.
std::string version_in(const fs::path& directory) {
  std::ifstream file(directory / "CHANGELOG");
  std::string line;
  std::getline(file, line);
  const std::string out = line.substr(0, line.find(':'));
  return out.empty() ? "unknown" : out;
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path.string() + " cannot be written");
}

/// The curve of a body, to be followed in steps of at most `step`.
struct AutoRun {
  fs::path directory;
  int unknowns;
  bool events;
  double step;
  std::string body;  ///< auto_balance.dat

  /// The constants of AUTO, in the older of its formats: of that a program runs as many as it gets.
  std::string constants() const {
    const int detect = events ? 1 : 0;
    std::string out;
    out += fmt::format("{} 0 0 {}\n", unknowns, detect);              // NDIM IPS IRS ILP
    out += "1 1\n";                                                   // NICP ICP
    out += fmt::format("1 4 3 {} 1 2 0 0\n", detect);                 // NTST NCOL IAD ISP ISW IPLT
    out += fmt::format("9999999 -1 {} -99 {}\n", last_nu,             // NMX RL0 RL1 A0 A1
                       std::log(ContinuationOptions{}.max_stretch));  // A: U(2), ln zeta
    out += "0 0 0 9 9 3 1\n";                      // NPR MXBF IID ITMX ITNW NWTN JAC
    out += "1e-10 1e-10 1e-7\n";                   // EPSL EPSU EPSS
    out += fmt::format("{0} 1e-9 {0} 1\n", step);  // DS DSMIN DSMAX IADS
    return out + "0\n0\n0\n";                      // NTHL NTHU NUZR
  }

  double seconds(long passes) const {
    write(directory / (equations_name + ".dat"), body);
    std::string all;
    for (long k = 0; k < passes; ++k) all += constants();
    write(directory / "fort.2", all);
    return run({(directory / (equations_name + ".exe")).string()}, directory);
  }

  std::vector<AutoPoint> points() const {
    seconds(1);
    std::ifstream file(directory / "fort.7");
    std::vector<AutoPoint> out = auto_points(std::string(std::istreambuf_iterator<char>(file), {}));
    constexpr int as_far_as_asked = 9;
    if (out.empty() || out.back().type != as_far_as_asked)
      throw std::runtime_error("AUTO-07p has not followed the curve to its end");
    return out;
  }
};

/// What auto_balance.f90 reads.
std::string body_of(const Curve& of) {
  const Problem problem = problem_of(of.model, of.branch);
  const auto number = [&]() -> int {
    if (of.model == "reciprocal-determinant") return 1;
    if (of.model == "neo-hookean") return 2;
    if (of.model == "hencky") return 3;
    throw std::runtime_error("auto_balance.f90 has no " + of.model);
  };
  const auto coefficients = [](const auto& part) {
    return std::visit(
        [](const auto& model) { return fmt::format("{}", fmt::join(model.coefficients(), " ")); },
        part);
  };
  const CentrifugalRates<double> rates = problem.rates(1.0);
  return fmt::format("{}\n{}\n{}\n{} {} {}\n{} {} {}\n", number(),
                     coefficients(problem.potential().plane()),
                     coefficients(problem.potential().thickness()), rates.xi, rates.zeta, rates.rho,
                     std::log(of.rest.xi), std::log(of.rest.zeta), std::log(of.rest.rho));
}

/// Its unknowns are logarithms; rho where it is not among them stays what it is at rest.
CurveRow row_of(const Curve& of, const AutoPoint& at) {
  const auto stretch = [&](std::size_t k) { return exp(DoubleDouble(at.unknowns.at(k))); };
  return {{stretch(0), stretch(1), at.unknowns.size() > 2 ? stretch(2) : DoubleDouble(of.rest.rho)},
          at.parameter};
}

}  // namespace

AutoPeer::AutoPeer(const fs::path& equations) {
  const std::optional<fs::path> home = auto_directory();
  if (!home) {
    missing_ = "AUTO-07p was not found (AUTO_DIR, or auto on PATH)";
    return;
  }
  std::string pattern = (fs::temp_directory_path() / "auto-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), pattern);
  directory_ = pattern;
  fs::copy_file(equations, directory_ / (equations_name + ".f90"));
  try {  // its makefile goes on where a compiler fails
    run({"make", "-f", (*home / "cmds" / "cmds.make").string(), "AUTO_DIR=" + home->string(),
         "EQUATION_NAME=" + equations_name, equations_name + ".exe"},
        directory_);
  } catch (const std::exception&) {
  }
  if (fs::exists(directory_ / (equations_name + ".exe")))
    version_ = version_in(*home);
  else
    missing_ = "AUTO-07p was found, but its makefile made no program of the equations";
}

AutoPeer::~AutoPeer() {
  std::error_code left;
  if (!directory_.empty()) fs::remove_all(directory_, left);
}

void AutoPeer::add(const Curve& of, std::vector<Entry>& out) const {
  // Beside them the start of a process is nothing, and so is the system's rounding of its time.
  constexpr std::size_t least_points = 10'000;
  constexpr double step_of_rows = 0.01;
  const int unknowns = of.branch == Branch::iii ? 2 : 3;
  for (const bool events : {false, true}) {
    for (const double step : {0.1, 0.03, 0.01, 0.003}) {
      const AutoRun run{directory_, unknowns, events, step, body_of(of)};
      const std::size_t count = run.points().size();
      const long copies = static_cast<long>(least_points / count) + 1;
      const auto seconds = [run, copies](long passes) {
        return run.seconds(passes * copies) / static_cast<double>(copies);
      };
      const auto add = [&](const char* what, const auto& errors) {
        out.push_back({what, events ? "auto-events" : "auto", of.model, of.branch, step, count,
                       seconds, [run, errors, &of] {
                         std::vector<CurveRow> rows;
                         for (const AutoPoint& at : run.points()) rows.push_back(row_of(of, at));
                         return errors(of, rows);
                       }});
      };
      add("curve", errors_between);
      if (step == step_of_rows) add("curve-rows", errors_at);
    }
  }
}

}  // namespace stationary::bench
