// What it costs a warm solve that the potential is written out: the same sweep of 10,000 nu with
// each built-in model and with its expression, in turns, in processor time.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "solver/batch/sweep.hpp"
#include "solver/program/case/case_file.hpp"
#include "tests/bench/measurement.hpp"
#include "tests/support/bodies/written_out.hpp"

namespace stationary::bench {
namespace {

constexpr std::size_t count = 10000;
constexpr int repeats = 15;

std::string table(const std::vector<std::string_view>& names, std::array<double, 2> values) {
  std::string out;
  for (std::size_t k = 0; k < 2; ++k)
    out += ", " + std::string(names[k]) + " = " + std::to_string(values[k]);
  return out;
}

Problem problem_of(const testing::WrittenOut& each, std::string_view branch, bool written) {
  std::string text = "[body]\nJ = [1.0, 1.7, 0.6]\n[motion]\nbranch = \"" + std::string(branch) +
                     "\"\nnu = 0.0\n[potential]\n";
  text += each.coupled ? "coupled = { " : "plane = { ";
  text += written
              ? "expression = \"" + std::string(each.expression) + "\"" +
                    table(each.renamed, {1.0, 2.0})
              : "model = \"" + std::string(each.model) + "\"" + table(each.parameters, {1.0, 2.0});
  text += " }\n";
  if (!each.coupled) {
    text += written ? "thickness = { expression = \"a/rho + b/2*rho^2\", a = 1.0, b = 3.0 }\n"
                    : "thickness = { model = \"reciprocal-quadratic\", a = 1.0, b = 3.0 }\n";
  }
  return make_case(CaseTree::parse(text, "bench")).problem();
}

/// Processor seconds a solve, least of the repeats.
class Swept {
 public:
  explicit Swept(const Problem& problem) : problem_(problem), start_(solve(problem, 0.0)) {
    for (std::size_t k = 0; k < count; ++k)
      nu_[k] = 0.5 * static_cast<double>(k + 1) / static_cast<double>(count);
  }
  void once() {
    Sweep sweep(problem_, start_, SweepOptions{});
    const double from = processor_seconds();
    sweep.run(nu_, points_);
    least_ = std::min(least_, (processor_seconds() - from) / static_cast<double>(count));
  }
  double least() const { return least_; }
  std::size_t solved() const {
    return static_cast<std::size_t>(
        std::ranges::count(points_, SolveStatus::solved, &SweepPoint::status));
  }

 private:
  Problem problem_;
  Equilibrium start_;
  std::vector<double> nu_ = std::vector<double>(count);
  std::vector<SweepPoint> points_ = std::vector<SweepPoint>(count);
  double least_ = 1e9;
};

void compare(const testing::WrittenOut& each, std::string_view branch) {
  Swept named(problem_of(each, branch, false));
  Swept written(problem_of(each, branch, true));
  for (int k = 0; k < repeats; ++k) {
    named.once();
    written.once();
  }
  std::printf("%-24s %-4s %9.1f %9.1f %7.2f%s\n", std::string(each.model).c_str(),
              std::string(branch).c_str(), 1e9 * named.least(), 1e9 * written.least(),
              written.least() / named.least(),
              named.solved() == written.solved() ? "" : "  not the same points solved");
}

}  // namespace
}  // namespace stationary::bench

int main() {
  std::printf("ns a warm solve          branch  built in   written   ratio\n");
  for (const auto& each : stationary::testing::written_out_models())
    for (const std::string_view branch : {"i", "iii"}) stationary::bench::compare(each, branch);
}
