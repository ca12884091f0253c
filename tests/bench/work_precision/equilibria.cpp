#include "tests/bench/work_precision/equilibria.hpp"

#include <limits>
#include <memory>

#include "solver/proof/certify.hpp"
#include "tests/bench/bodies.hpp"
#include "tests/bench/four_equations.hpp"
#include "tests/bench/march.hpp"
#include "tests/bench/work_precision/minpack_hybrj.hpp"
#include "tests/bench/work_precision/reduced_newton.hpp"
#include "tests/bench/work_precision/references.hpp"

namespace stationary::bench {
namespace {

using States = std::vector<Vector4<double>>;

const Vector4<double> failed = Vector4<double>::Constant(std::numeric_limits<double>::quiet_NaN());

/// Largest relative error of (xi, zeta, rho).
double relative_error(const Vector4<double>& q, const std::array<DoubleDouble, 3>& exact) {
  double worst = 0.0;
  for (int i = 0; i < 3; ++i) {
    const DoubleDouble& x = exact[static_cast<std::size_t>(i)];
    worst = std::max(worst, std::abs(double(q[i + 1] - x)) / x.hi);
  }
  return worst;
}

/// An entry whose pass fills the states it is given.
template <class Pass>
Entry entry(const Equilibria& of, const std::string& what, std::string method,
            std::optional<double> tolerance, Pass pass) {
  const auto found = std::make_shared<States>(of.nu.size(), failed);
  return {what,
          std::move(method),
          of.model,
          of.problem.branch(),
          tolerance,
          of.nu.size(),
          timed([found, pass]() mutable { pass(*found); }),
          [found, &of] { return of.errors(*found); }};
}

/// Adds a solver of one nu as a sweep or from rest.
class Adder {
 public:
  Adder(const Equilibria& of, const std::string& what, bool warm, std::vector<Entry>& out)
      : of_(of), what_(what), warm_(warm), out_(out) {}

  /// make(model) gives the solver, called as solve(nu, x).
  template <class Make>
  void add(const std::string& method, double tolerance, Make make, Start start = Start::parabola) {
    out_.push_back(entry(of_, what_, method, tolerance, [this_ = *this, make, start](States& x) {
      visit(this_.of_.problem, [&](const auto& model) { this_.pass(make(model), start, x); });
    }));
  }

 private:
  template <class Solve>
  void pass(Solve solve, Start start, States& x) const {
    const Branch branch = of_.problem.branch();
    if (warm_) {
      if (!march(branch, of_.nu, of_.first.q.vector(), start, solve, x)) x.assign(x.size(), failed);
      return;
    }
    const Vector4<double> rest = of_.rest.vector();
    for (std::size_t k = 0; k < x.size(); ++k) {
      Vector4<double> q = rest;
      x[k] = solve(angular_velocity(branch, of_.nu[k]), q) ? q : failed;
    }
  }

  const Equilibria& of_;
  std::string what_;
  bool warm_;
  std::vector<Entry>& out_;
};

/// What both kinds of start have: the reduced Newton and the solvers of four equations.
void add_solvers(const Equilibria& of, Adder& to) {
  const Problem& problem = of.problem;
  for (const double tolerance : {1e-2, 1e-4, 1e-8, 1e-12}) {
    for (const Finish finish : {Finish::in_double, Finish::corrected}) {
      to.add(finish == Finish::corrected ? "reduced-corrected" : "reduced-newton", tolerance,
             [&problem, tolerance, finish]<class P, class T>(const Separable<P, T>& model) {
               return ReducedNewton<P, T>{problem, model, tolerance, finish};
             });
    }
  }
  const Body& body = problem.body();
  for (const double tolerance : {1e-2, 1e-4, 1e-9, 1e-14}) {
    to.add("newton-4x4", tolerance, [&body, tolerance]<class M>(const M& model) {
      return Newton4x4<M>{body, model, tolerance};
    });
  }
  for (const double tolerance : {1e-4, 1e-8, 1e-14}) {
    to.add("tiny-solver", tolerance, [&body, tolerance]<class M>(const M& model) {
      return TinySolver<M>{body, model, tolerance, 0.0};
    });
    to.add("ceres", tolerance, [&body, tolerance]<class M>(const M& model) {
      return CeresSolve<M>{body, model, tolerance};
    });
  }
  to.add("tiny-solver-default", 1e-14, [&body]<class M>(const M& model) {
    return TinySolver<M>{body, model, 1e-14};
  });
  // Below 1e-12 hybrj goes on for many steps that gain nothing.
  for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
    to.add("minpack-hybrj", tolerance, [&body, tolerance]<class M>(const M& model) {
      return MinpackHybrj<M>{body, model, tolerance};
    });
  }
}

}  // namespace

std::vector<double> Equilibria::errors(std::span<const Vector4<double>> found) const {
  std::vector<double> out;
  for (std::size_t k = 0; k < found.size(); ++k) {
    out.push_back(found[k].allFinite() ? relative_error(found[k], exact[k])
                                       : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

Equilibria equilibria(std::string_view model, Branch branch, int count) {
  constexpr double last_nu = 0.5;
  const Problem problem = problem_of(model, branch);
  std::vector<double> nu;
  for (int k = 1; k <= count; ++k) nu.push_back(last_nu * k / count);
  Equilibria out{std::string(model),         problem, nu, solve(problem, 0.0).q,
                 solve(problem, nu.front()), {}};
  std::vector<SweepPoint> points(nu.size());
  Sweep(problem, out.first).run(nu, points);
  for (const SweepPoint& p : points)
    out.exact.push_back(exact_stretches(problem, p.nu, {0.0, p.xi, p.zeta, p.rho}));
  return out;
}

void add_warm(const Equilibria& of, const std::string& what, std::vector<Entry>& out) {
  enum class Claim { none, bound, proof };
  const auto add_sweep = [&](const char* method, Claim claim) {
    out.push_back(
        entry(of, what, method, std::nullopt,
              [&of, claim, points = std::vector<SweepPoint>(of.nu.size())](States& x) mutable {
                Sweep(of.problem, of.first, {claim != Claim::none}).run(of.nu, points);
                for (std::size_t k = 0; k < x.size(); ++k) {
                  const SweepPoint& p = points[k];
                  bool good = p.status == SolveStatus::solved;
                  Equilibrium at;
                  at.q = {0.0, p.xi, p.zeta, p.rho};
                  if (claim == Claim::proof && good) {
                    at.nu = angular_velocity(of.problem.branch(), p.nu);
                    good = certify(of.problem, at).proven;
                  }
                  x[k] = good ? at.q.vector() : failed;
                }
              }));
  };
  add_sweep("sweep", Claim::none);
  add_sweep("sweep-bounded", Claim::bound);
  add_sweep("sweep-certified", Claim::proof);
  Adder adder(of, what, true, out);
  add_solvers(of, adder);
  const Body& body = of.problem.body();
  for (const double tolerance : {1e-2, 1e-4, 1e-9, 1e-14}) {
    adder.add(
        "newton-4x4-last", tolerance,
        [&body, tolerance]<class M>(const M& model) {
          return Newton4x4<M>{body, model, tolerance};
        },
        Start::last_point);
  }
}

void add_cold(const Equilibria& of, const std::string& what, std::vector<Entry>& out) {
  const auto add_solve = [&](const char* method, Method by, bool proven) {
    SolveOptions options;
    options.method = by;
    out.push_back(entry(of, what, method, std::nullopt, [&of, options, proven](States& x) {
      for (std::size_t k = 0; k < x.size(); ++k) {
        const Equilibrium at = solve(of.problem, of.nu[k], options);
        const bool good =
            at.status == SolveStatus::solved && (!proven || certify(of.problem, at).proven);
        x[k] = good ? at.q.vector() : failed;
      }
    }));
  };
  add_solve("solve", Method::automatic, false);
  add_solve("solve-certified", Method::automatic, true);
  add_solve("solve-newton", Method::newton, false);
  add_solve("solve-nlopt", Method::nlopt, false);
  Adder adder(of, what, false, out);
  add_solvers(of, adder);
}

}  // namespace stationary::bench
