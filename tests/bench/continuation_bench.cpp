// Continuation, on one core: points per second
// as outputs are switched on one by one, each with those before it:
//   curve         equilibria with their error bounds
//   residual      the balance recomputed in lib
//   energy
//   events        those that need no spectrum, located
//   spectrum      modes, signatures, class
//   all-events    those of the spectrum too
//   proven        each row certified, and its class
//   table         all but the proofs, written as a CSV table in a temporary file, start included
// of the rest sheet of one body, followed until it escapes or nu = 3; with everything on, in memory,
// of tilted and oblique families and of a body with fibres about axis 3; then, for tolerances
// 1e-3 ... 1e-13, the number of rows and the true curve error: how far a cubic through four
// successive rows is from the curve.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/kind/kind.hpp"
#include "solver/program/rows/curve_table.hpp"
#include "solver/program/rows/equilibrium_row.hpp"
#include "tests/bench/bodies.hpp"
#include "tests/support/curve_error.hpp"

namespace stationary::bench {
namespace {

using namespace testing;

constexpr double last_nu = 3.0;

struct Case {
  std::string label;
  Problem problem;
  Stretch rest;

  AnyFamily family(bool spectrum, bool errors = true, bool energy = true) const {
    return axis_family(
        problem,
        {.nu = 0.0, .parameter = {}, .spectrum = spectrum, .errors = errors, .energy = energy});
  }
};

Case make_case(std::string_view model, Branch branch) {
  const Problem problem = problem_of(model, branch);
  return {label_of(model, branch), problem, solve(problem, 0.0).q};
}

/// Takes every row and keeps none.
class Counted final : public CurveSink {
 public:
  void row(const Member& member, EventType) override {
    ++rows;
    benchmark::DoNotOptimize(member.nu);
  }
  long rows = 0;
};

EventSet plain_events() {
  EventSet out = EventSet::none();
  for (const EventType each : {EventType::fold_nu, EventType::fold_momentum, EventType::tilt,
                               EventType::inertia_exchange, EventType::ellipse})
    out.add(each);
  return out;
}

void in_memory(benchmark::State& state, const Case& c, const AnyFamily& family, EventSet events) {
  FollowOptions options = range(0.0, last_nu, 1e-10);
  options.events = events;
  Counted sink;
  for (auto _ : state) follow(family, c.rest, 0.0, options, sink);
  state.SetItemsProcessed(sink.rows);
}

/// A family of another kind through a motion, over a range of |nu|.
struct OtherCase {
  std::string label;
  std::unique_ptr<Kind> kind;
  double nu, from, to;
};

void other_in_memory(benchmark::State& state, const OtherCase& c) {
  const Equilibrium start = c.kind->solve({});
  if (start.status != SolveStatus::solved) throw std::runtime_error(c.label + ": no motion");
  const AnyFamily family = c.kind->family({}, {}, start.q);
  Counted sink;
  for (auto _ : state) follow(family, start.q, c.nu, range(c.from, c.to, 1e-10), sink);
  state.SetItemsProcessed(sink.rows);
}

std::vector<OtherCase> other_cases() {
  const Body body(1.0, 1.7, 0.6);
  const ReciprocalQuadratic<> thickness{1.0, 3.0};
  const Potential isotropic{ReciprocalDeterminant<>{1.0, 2.0}, thickness};
  const Potential fibred(AnisotropicPotential(NeoHookean<>{1.0, 2.0}, thickness, {{0.4, 30.0}}));
  std::vector<OtherCase> out;
  out.push_back({"tilted", kind_of(body, isotropic, TiltedMotion{TiltPlane::one_three, 1.07}), 1.07,
                 1.0, 1.1});
  out.push_back(
      {"oblique", kind_of(body, fibred, ObliqueRotation{0.5, Branch::i}), 0.5, 0.0, 0.785});
  out.push_back(
      {"fibred/iii", kind_of(body, fibred, AxisRotation{Branch::iii, 0.5}), 0.5, 0.0, 0.79});
  return out;
}

void proven(benchmark::State& state, const Case& c) {
  const AnyFamily family = c.family(true);
  const FollowOptions options = range(0.0, last_nu, 1e-10);
  long rows = 0;
  for (auto _ : state) {
    CurveTable table(name(c.problem.branch()), nullptr);
    const Problem& problem = c.problem;
    table.prove(
        [&problem](double nu) {
          return kind_of(problem.body(), problem.potential(), AxisRotation{problem.branch(), nu});
        },
        {});
    rows += follow(family, c.rest, 0.0, options, table).points;
  }
  state.SetItemsProcessed(rows);
}

class TemporaryFile final : public ByteSink {
 public:
  void write(std::string_view bytes) override {
    if (!file_ || std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size())
      throw std::runtime_error("the temporary file cannot be written");
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{std::tmpfile(), &std::fclose};
};

void to_table(benchmark::State& state, const Case& c) {
  const FollowOptions options = range(0.0, last_nu, 1e-10);
  const std::vector<Column> columns = equilibrium_columns({.events = true, .spectrum = true});
  TemporaryFile file;
  long rows = 0;
  for (auto _ : state) {
    TableWriter writer(file, columns);
    CurveTable table(name(c.problem.branch()), &writer);
    rows += follow(c.family(true), c.rest, 0.0, options, table).points;
    writer.flush();
  }
  state.SetItemsProcessed(rows);
}

void print_curve_errors(const std::vector<Case>& cases) {
  std::printf("\nrows with all stretches in 1e-3 ... 1e3, and curve error, by tolerance\n%-28s",
              "case");
  for (int digits = 3; digits <= 13; digits += 2) std::printf("            1e-%02d", digits);
  std::printf("\n");
  for (const Case& c : cases) {
    std::printf("%-28s", c.label.c_str());
    for (int digits = 3; digits <= 13; digits += 2) {
      const AnyFamily family = c.family(false);
      const Followed sheet =
          followed(family, c.rest, 0.0, range(0.0, last_nu, std::pow(10.0, -digits)));
      const auto rows = std::ranges::count_if(
          sheet.rows, [](const FollowedRow& row) { return is_moderate(row.member.q); });
      const double error = std::visit(
          [&](const auto& f) { return interpolation_error(*f, sheet.rows, last_nu); }, family);
      std::printf(" %6ld %9.1e", static_cast<long>(rows), error);
    }
    std::printf("\n");
  }
}

template <class Body>
void register_one(const std::string& label, const Body& body) {
  benchmark::RegisterBenchmark(label.c_str(), body)
      ->Unit(benchmark::kMicrosecond)
      ->Repetitions(7)
      ->ReportAggregatesOnly(true)
      ->MinTime(0.05);
}

void register_case(const Case& c) {
  const auto add = [&](const char* what, const auto& body) {
    register_one(c.label + "|" + what, body);
  };
  const auto add_in_memory = [&](const char* what, bool spectrum, bool errors, bool energy,
                                 EventSet events) {
    add(what, [=, &c](benchmark::State& state) {
      in_memory(state, c, c.family(spectrum, errors, energy), events);
    });
  };
  add_in_memory("curve", false, false, false, EventSet::none());
  add_in_memory("residual", false, true, false, EventSet::none());
  add_in_memory("energy", false, true, true, EventSet::none());
  add_in_memory("events", false, true, true, plain_events());
  add_in_memory("spectrum", true, true, true, plain_events());
  add_in_memory("all-events", true, true, true, {});
  add("proven", [&c](benchmark::State& state) { proven(state, c); });
  add("table", [&c](benchmark::State& state) { to_table(state, c); });
}

}  // namespace
}  // namespace stationary::bench

int main(int argc, char** argv) {
  using stationary::Branch;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  static std::vector<stationary::bench::Case> cases;
  for (const std::string_view model : stationary::bench::planar_models) {
    for (const Branch branch : {Branch::i, Branch::iii})
      cases.push_back(stationary::bench::make_case(model, branch));
  }
  for (const auto& c : cases) stationary::bench::register_case(c);
  static const std::vector<stationary::bench::OtherCase> others = stationary::bench::other_cases();
  for (const auto& c : others)
    stationary::bench::register_one(c.label + "|all-events", [&c](benchmark::State& state) {
      stationary::bench::other_in_memory(state, c);
    });
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  stationary::bench::print_curve_errors(cases);
  return 0;
}
