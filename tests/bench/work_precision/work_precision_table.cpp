#include "tests/bench/work_precision/work_precision_table.hpp"

#include <ceres/version.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <nlopt.hpp>
#include <thread>

namespace stationary::bench {
namespace {

using Json = nlohmann::ordered_json;

/// Empty for what there is not.
std::string cell(std::optional<double> x) {
  return x && !std::isnan(*x) ? fmt::format("{}", *x) : std::string();
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

#ifdef __clang__
constexpr const char* compiler = "clang++ " __clang_version__;
#else
constexpr const char* compiler = "g++ " __VERSION__;
#endif

bool is_of_the_library(const std::string& method) {
  return method.starts_with("sweep") || method.starts_with("reduced");
}

bool same_case(const Entry& a, const Entry& b) {
  return a.what == b.what && a.model == b.model && a.branch == b.branch;
}

/// The fastest of those that `takes` takes and whose error, nowhere failed, is at most `error`.
template <class Takes>
const Measured* fastest(const std::vector<Measured>& results, double error, const Takes& takes) {
  const Measured* out = nullptr;
  for (const Measured& m : results) {
    if (!takes(*m.entry) || m.failed > 0 || !(m.error_worst <= error)) continue;
    if (out == nullptr || m.seconds < out->seconds) out = &m;
  }
  return out;
}

/// A method's fastest setting on the case of `entry` among those whose worst error is within a
/// factor of two of the method's least: tighter tolerances than that buy nothing.
const Measured* setting_of(const std::vector<Measured>& results, const Entry& entry) {
  const auto of_the_method = [&](const Entry& e) {
    return same_case(e, entry) && e.method == entry.method;
  };
  double least = std::numeric_limits<double>::infinity();
  for (const Measured& m : results)
    if (of_the_method(*m.entry) && m.failed == 0) least = std::min(least, m.error_worst);
  return fastest(results, 2.0 * least, of_the_method);
}

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  void add(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  }
};

}  // namespace

std::string table_csv(const std::vector<Measured>& results) {
  std::string out =
      "what,method,model,branch,tolerance,seconds,seconds_min,seconds_max,error_worst,"
      "error_median,count,failed\n";
  for (const Measured& m : results) {
    const Entry& e = *m.entry;
    out += fmt::format("{},{},{},{},{},{:.4g},{:.4g},{:.4g},{},{},{},{}\n", e.what, e.method,
                       e.model, name(e.branch), cell(e.tolerance), m.seconds, m.seconds_min,
                       m.seconds_max, cell(m.error_worst), cell(m.error_median), e.items, m.failed);
  }
  return out;
}

std::string table_metadata(const Run& run) {
  int major = 0;
  int minor = 0;
  int bugfix = 0;
  nlopt_version(&major, &minor, &bugfix);
  Json libraries{{"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION,
                                       EIGEN_MINOR_VERSION)},
                 {"Ceres", CERES_VERSION_STRING},
                 {"NLopt", fmt::format("{}.{}.{}", major, minor, bugfix)},
                 {"cminpack", STATIONARY_CMINPACK_VERSION},
                 {"Boost", BOOST_LIB_VERSION}};
  for (const auto& [library, version] : run.scipy) libraries[library] = version;
  if (!run.auto_version.empty()) libraries["AUTO-07p"] = run.auto_version;
  Json skipped = Json::array();
  if (run.scipy.empty())
    skipped.push_back({{"method", "scipy-hybr"}, {"why", "python3 with SciPy was not found"}});
  if (run.auto_version.empty()) {
    for (const char* method : {"auto", "auto-events"})
      skipped.push_back({{"method", method}, {"why", run.auto_missing}});
  }
  const Json out{{"date", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
                 {"processor", processor()},
                 {"processors", std::thread::hardware_concurrency()},
                 {"compiler", compiler},
                 {"flags", STATIONARY_FLAGS},
                 {"libraries", libraries},
                 {"repeats", run.repeats},
                 {"rows", run.rows},
                 {"seconds", std::round(run.seconds)},
                 {"skipped", skipped}};
  return out.dump(2) + '\n';
}

std::string comparison(const std::vector<Measured>& results) {
  struct Peer {
    Range error;
    Range to_fastest;
    Range to_sweep;
  };
  std::map<std::pair<std::string, std::string>, Peer> peers;
  for (const Measured& m : results) {
    const Entry& e = *m.entry;
    if (!e.what.starts_with("warm") || is_of_the_library(e.method)) continue;
    if (setting_of(results, e) != &m) continue;
    const auto own = [&](bool sweep_alone) {
      return fastest(results, m.error_worst, [&](const Entry& other) {
        return same_case(other, e) &&
               (sweep_alone ? other.method == "sweep" : is_of_the_library(other.method));
      });
    };
    Peer& peer = peers[{e.what, e.method}];
    peer.error.add(m.error_worst);
    if (const Measured* at = own(false)) peer.to_fastest.add(m.seconds / at->seconds);
    if (const Measured* at = own(true)) peer.to_sweep.add(m.seconds / at->seconds);
  }
  std::string out =
      "| sweep | peer | its worst errors | slower than the fastest | than the corrected sweep |\n"
      "|---|---|---|---|---|\n";
  for (const auto& [key, peer] : peers) {
    out +=
        fmt::format("| {} | {} | {:.1e} to {:.1e} | {:.1f} to {:.1f} | {:.1f} to {:.1f} |\n",
                    key.first, key.second, peer.error.least, peer.error.most, peer.to_fastest.least,
                    peer.to_fastest.most, peer.to_sweep.least, peer.to_sweep.most);
  }
  return out;
}

std::string comparison_of_curves(const std::vector<Measured>& results) {
  struct Method {
    Range rate;
    Range error;
    Range point;           ///< its time against that of `follow`,
    Range spectral_point;  ///< of `follow-spectra`
    Range curve;
    Range spectral_curve;
  };
  std::map<std::string, Method> methods;
  const auto curve_seconds = [](const Measured& m) {
    return m.seconds * static_cast<double>(m.entry->items);
  };
  for (const Measured& m : results) {
    const Entry& e = *m.entry;
    if (!e.what.starts_with("curve")) continue;
    Method& method = methods[e.method];
    const bool of_rows = e.what == "curve-rows";
    if (of_rows) {
      method.rate.add(1.0 / m.seconds);
      method.error.add(m.error_worst);
    }
    for (const bool spectra : {false, true}) {
      double least = std::numeric_limits<double>::infinity();
      for (const Measured& other : results) {
        if (!same_case(*other.entry, e)) continue;
        if (other.entry->method != (spectra ? "follow-spectra" : "follow")) continue;
        if (of_rows)
          least = other.seconds;
        else if (other.error_worst <= m.error_worst)
          least = std::min(least, curve_seconds(other));
      }
      if (of_rows)
        (spectra ? method.spectral_point : method.point).add(m.seconds / least);
      else
        (spectra ? method.spectral_curve : method.curve).add(curve_seconds(m) / least);
    }
  }
  std::string out =
      "| curve | points a second | worst errors of its rows | slower than follow, a point | "
      "a curve | than follow-spectra, a point | a curve |\n|---|---|---|---|---|---|---|\n";
  for (const auto& [name, method] : methods) {
    out += fmt::format("| {} | {:.3g} to {:.3g} million | {:.1e} to {:.1e} |", name,
                       1e-6 * method.rate.least, 1e-6 * method.rate.most, method.error.least,
                       method.error.most);
    for (const Range* range :
         {&method.point, &method.curve, &method.spectral_point, &method.spectral_curve})
      out += fmt::format(" {:.1f} to {:.1f} |", range->least, range->most);
    out += '\n';
  }
  return out;
}

}  // namespace stationary::bench
