// Solves per second, and the error against 50 digits, of the same sweep by
//   sweep            the reduced Newton of this library, corrected in extended precision
//   sweep-bounded    the same with an error bound on every point
//   newton-4x4       plain Newton on all of (alpha, xi, zeta, rho), Eigen's partialPivLu, analytic
//                    Jacobian, from the point before, until the step is at rounding
//   newton-4x4-para  the same from the sweep's own predictor, stopped one step earlier, where
//   quadratic
//                    convergence has done the rest
//   tiny-solver      ceres::TinySolver on the same four equations, derivatives by Jets
//   ceres            ceres::Solve on the same
// in one run, repetitions interleaved at random. All but the plain newton-4x4 get the same
// predictor (the parabola through the last three points); each is asked for all the accuracy double
// gives. Ends with ratios to newton-4x4: a rate alone says more about the machine's neighbours than
// about the code.
#include <benchmark/benchmark.h>
#include <ceres/ceres.h>
#include <ceres/tiny_solver.h>
#include <ceres/tiny_solver_autodiff_function.h>

#include <Eigen/LU>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "solver/sweep.hpp"
#include "tests/support/high_precision.hpp"

namespace stationary {
namespace {

using Vector = Vector4<double>;

struct Case {
  std::string label;
  Problem problem;
  std::vector<double> nu;
  Equilibrium first;
};

Case make_case(const std::string& model, Branch branch) {
  const double plane[2] = {1.0, 2.0};
  const double thickness[2] = {1.0, 3.0};
  Problem problem(Body(1.0, 1.7, 0.6),
                  Potential(Potential::planar(model, plane),
                            Potential::thickness("reciprocal-quadratic", thickness)),
                  branch);
  constexpr int points = 10000;
  constexpr double last_nu = 0.5;
  std::vector<double> nu(points);
  for (int k = 0; k < points; ++k) nu[static_cast<std::size_t>(k)] = last_nu * (k + 1) / points;
  const Equilibrium first = solve(problem, nu.front());
  return {model + "/" + std::string(name(branch)), problem, nu, first};
}

/// Parabola through the last points of a sweep, shared by the peers.
class Predictor {
 public:
  explicit Predictor(const Vector& start) : x_{start, start, start} {}
  Vector next() const {
    return known_ >= 3   ? Vector(3.0 * (x_[0] - x_[1]) + x_[2])
           : known_ == 2 ? Vector(2.0 * x_[0] - x_[1])
                         : x_[0];
  }
  const Vector& last() const { return x_[0]; }
  void push(const Vector& x) {
    x_[2] = x_[1];
    x_[1] = x_[0];
    x_[0] = x;
    ++known_;
  }

 private:
  std::array<Vector, 3> x_;
  int known_ = 0;
};

/// F(q) of four equations, for Ceres.
template <class Model>
struct FourResiduals {
  const Body& body;
  const Model& model;
  Vector3<double> nu;

  template <class T>
  bool operator()(const T* const q, T* out) const {
    const BasicStretch<T> stretch{q[0], q[1], q[2], q[3]};
    const Vector3<T> rate = nu.cast<T>();
    const Vector4<T> F = balance_residual(body, model, stretch, rate);
    for (int i = 0; i < 4; ++i) out[i] = F[i];
    return true;
  }
};

/// Runs `method(nu, x)` along the sweep; false stops it as failed.
template <class Method>
bool march(const Case& c, std::vector<Vector>& out, const Method& method, bool predict = true) {
  Predictor predictor(c.first.q.vector());
  for (std::size_t k = 0; k < c.nu.size(); ++k) {
    Vector x = predict ? predictor.next() : predictor.last();
    if (!method(angular_velocity(c.problem.branch(), c.nu[k]), x)) return false;
    predictor.push(x);
    out[k] = x;
  }
  return true;
}

bool newton_4x4(const Case& c, std::vector<Vector>& out, bool predict, double tolerance) {
  return c.problem.potential().visit([&](const auto& model) {
    return march(
        c, out,
        [&](const Vector3<double>& nu, Vector& x) {
          const Matrix4<double> C = centrifugal_matrix(c.problem.body(), nu);
          for (int step = 0; step < 20; ++step) {
            const auto v = potential_derivatives<2>(model, Stretch::from(x));
            const Vector F = v.gradient - C * x;
            const Vector delta = (v.hessian - C).partialPivLu().solve(F);
            x -= delta;
            if (delta.cwiseAbs().maxCoeff() <= tolerance) return true;
          }
          return false;
        },
        predict);
  });
}

bool tiny_solver(const Case& c, std::vector<Vector>& out) {
  return c.problem.potential().visit([&](const auto& model) {
    using Residuals = FourResiduals<std::decay_t<decltype(model)>>;
    using Function = ceres::TinySolverAutoDiffFunction<Residuals, 4, 4>;
    ceres::TinySolver<Function> solver;
    solver.options.gradient_tolerance = 1e-30;
    solver.options.parameter_tolerance = 1e-14;
    solver.options.cost_threshold = 1e-32;
    solver.options.initial_trust_region_radius = 1e12;
    return march(c, out, [&](const Vector3<double>& nu, Vector& x) {
      const Residuals residuals{c.problem.body(), model, nu};
      solver.Solve(Function(residuals), &x);
      return x.allFinite();
    });
  });
}

bool ceres_solve_4(const Case& c, std::vector<Vector>& out) {
  return c.problem.potential().visit([&](const auto& model) {
    using Residuals = FourResiduals<std::decay_t<decltype(model)>>;
    return march(c, out, [&](const Vector3<double>& nu, Vector& x) {
      ceres::Problem problem;
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Residuals, 4, 4>(
                                   new Residuals{c.problem.body(), model, nu}),
                               nullptr, x.data());
      ceres::Solver::Options options;
      options.linear_solver_type = ceres::DENSE_QR;
      options.function_tolerance = 1e-30;
      options.gradient_tolerance = 1e-30;
      options.parameter_tolerance = 1e-14;
      options.logging_type = ceres::SILENT;
      ceres::Solver::Summary summary;
      ceres::Solve(options, &problem, &summary);
      return summary.IsSolutionUsable();
    });
  });
}

bool sweep(const Case& c, bool bounded, std::vector<SweepPoint>& points, std::vector<Vector>& out) {
  Sweep run(c.problem, c.first, {bounded});
  run.run(c.nu, points);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (points[k].status != SolveStatus::solved) return false;
    out[k] = {0.0, points[k].xi, points[k].zeta, points[k].rho};
  }
  return true;
}

/// Worst relative error of (xi, zeta, rho) over every 97th point.
double worst_error(const Case& c, const std::vector<Vector>& x) {
  double worst = 0.0;
  for (std::size_t k = 0; k < x.size(); k += 97) {
    const Stretch q = Stretch::from(x[k]);
    worst = std::max(
        worst, testing::relative_error(q, testing::reference_solution(c.problem, c.nu[k], q)));
  }
  return worst;
}

template <class Method>
void run(benchmark::State& state, const Case& c, Method method) {
  std::vector<Vector> x(c.nu.size());
  for (auto _ : state) {
    if (!method(x)) {
      state.SkipWithError("did not converge");
      return;
    }
    benchmark::DoNotOptimize(x.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(c.nu.size()));
  state.counters["error"] = worst_error(c, x);
}

/// The usual table, then the ratios of the median rates.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.error_occurred || run.aggregate_name != "median") continue;
      const auto rate = run.counters.find("items_per_second");
      const auto error = run.counters.find("error");
      if (rate == run.counters.end() || error == run.counters.end()) continue;
      const std::string& full = run.run_name.function_name;
      const auto cut = full.find('|');
      table_[full.substr(0, cut)][full.substr(cut + 1)] = {rate->second.value, error->second.value};
    }
  }
  void Finalize() override {
    ConsoleReporter::Finalize();
    std::printf("\n%-28s %-16s %14s %12s %10s\n", "case", "method", "solves/s", "to 4x4", "error");
    for (const auto& [label, methods] : table_) {
      const auto base = methods.find("newton-4x4");
      for (const auto& [method, m] : methods) {
        std::printf("%-28s %-16s %14.0f %12.2f %10.2g\n", label.c_str(), method.c_str(), m.rate,
                    base == methods.end() ? 0.0 : m.rate / base->second.rate, m.error);
      }
    }
  }

 private:
  struct Measured {
    double rate;
    double error;
  };
  std::map<std::string, std::map<std::string, Measured>> table_;
};

void register_case(const Case& c) {
  const auto add = [&](const char* method, auto body) {
    benchmark::RegisterBenchmark((c.label + "|" + method).c_str(),
                                 [&c, body](benchmark::State& state) { run(state, c, body); })
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(7)
        ->ReportAggregatesOnly(true)
        ->MinTime(0.02);
  };
  add("sweep", [&c, points = std::vector<SweepPoint>(c.nu.size())](auto& x) mutable {
    return sweep(c, false, points, x);
  });
  add("sweep-bounded", [&c, points = std::vector<SweepPoint>(c.nu.size())](auto& x) mutable {
    return sweep(c, true, points, x);
  });
  add("newton-4x4", [&c](auto& x) { return newton_4x4(c, x, false, 1e-14); });
  add("newton-4x4-para", [&c](auto& x) { return newton_4x4(c, x, true, 1e-9); });
  add("tiny-solver", [&c](auto& x) { return tiny_solver(c, x); });
  add("ceres", [&c](auto& x) { return ceres_solve_4(c, x); });
}

}  // namespace
}  // namespace stationary

int main(int argc, char** argv) {
  using stationary::Branch;
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  static std::vector<stationary::Case> cases;
  for (const char* model : {"reciprocal-determinant", "saint-venant-kirchhoff", "biot", "biot-log",
                            "neo-hookean", "hencky"}) {
    for (const Branch branch : {Branch::i, Branch::iii})
      cases.push_back(stationary::make_case(model, branch));
  }
  for (const auto& c : cases) stationary::register_case(c);
  stationary::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  return 0;
}
