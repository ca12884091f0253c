// stationary --version: the version, then the compiler and the libraries that the program was made
// with. What is loaded when the program starts says itself which version it is.
#include <fmt/format.h>
#include <oneapi/tbb/version.h>
#include <toml++/toml.h>
#include <zlib.h>

#include <Eigen/Core>
#include <array>
#include <boost/version.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <tao/pegtl/version.hpp>

#include "solver/newton/ceres_solve.hpp"
#include "solver/newton/nlopt_seed.hpp"
#include "solver/program/session/command.hpp"
#include "solver/program/table/column_file.hpp"

namespace stationary::cli {
namespace {

std::string dotted(int major, int minor, int patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

std::string or_without(const std::string& version, std::string_view what) {
  return version.empty() ? fmt::format("built without; {}", what) : version;
}

/// What it says of itself: "5.4 patchlevel 4".
std::string gnuplot() {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen("gnuplot --version 2>/dev/null", "r"),
                                                   pclose);
  std::array<char, 200> line{};
  if (!pipe || fgets(line.data(), line.size(), pipe.get()) == nullptr)
    return "not found; the command plot needs it";
  std::string text = line.data();
  text.erase(text.find_last_not_of(" \n") + 1);
  return text.starts_with("gnuplot ") ? text.substr(text.find(' ') + 1) : text;
}

}  // namespace

std::string version_text() {
  const std::pair<const char*, std::string> parts[] = {
      {"compiler", STATIONARY_COMPILER},
      {"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"Ceres Solver", or_without(version_of_ceres(), "its method is this program's own")},
      {"NLopt", or_without(version_of_nlopt(), "a grid is sampled in its place")},
      {"HDF5", or_without(hdf5_version(), "tables are CSV")},
      {"zlib", zlibVersion()},
      {"oneTBB", TBB_runtime_version()},
      {"Boost", dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"CLI11", CLI11_VERSION},
      {"fmt", dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"toml++", dotted(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
      {"nlohmann-json", dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                               NLOHMANN_JSON_VERSION_PATCH)},
      {"PEGTL", TAO_PEGTL_VERSION},
      {"gnuplot", gnuplot()},
  };
  std::string out = "stationary " STATIONARY_VERSION "\n";
  for (const auto& [name, version] : parts) out += fmt::format("{:<15}{}\n", name, version);
  out.pop_back();  // the end of the line is added by who prints it
  return out;
}

}  // namespace stationary::cli
