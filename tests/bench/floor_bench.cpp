// How far a warm solve is from the least it could cost. Printed, of branch (iii) and, for spectra,
// (i) too, on one core:
//
//   the machine   additions and multiplications per second: of independent vectors, of independent
//                 scalars, one after the other; divisions likewise
//   a solve       operations of the model's own formulas (one Jacobian in double, one residual in
//                 pairs of doubles, a correction being both), counted by a number that counts; the
//                 sweep's time for a point, and the same operations at the rate of independent
//                 scalars and one after the other
//   a spectrum    operations of the blocks' characteristic polynomials in pairs, and its time
//   bytes         written for a point
//
// The algebra of the 2x2 system and the predictor are not counted: the floor is lower than a solve
// without them.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "lib/balance/balance.hpp"
#include "lib/balanced/balanced_blocks.hpp"
#include "solver/batch/sweep.hpp"
#include "solver/solve/stability.hpp"

namespace stationary {
namespace {

/// A double that counts what is done to it.
struct Counted {
  double value = 0.0;

  constexpr Counted() = default;
  constexpr Counted(double x) : value(x) {}  // NOLINT(google-explicit-constructor)

  static inline long flops = 0;
  static inline long divisions = 0;
  static inline long functions = 0;  ///< logarithms, square roots

  friend Counted operator+(const Counted& x, const Counted& y) {
    return ++flops, x.value + y.value;
  }
  friend Counted operator-(const Counted& x, const Counted& y) {
    return ++flops, x.value - y.value;
  }
  friend Counted operator-(const Counted& x) { return -x.value; }
  friend Counted operator*(const Counted& x, const Counted& y) {
    return ++flops, x.value * y.value;
  }
  friend Counted operator/(const Counted& x, const Counted& y) {
    return ++divisions, x.value / y.value;
  }
  friend Counted log(const Counted& x) { return ++functions, std::log(x.value); }
  friend Counted sqrt(const Counted& x) { return ++functions, std::sqrt(x.value); }
};
double leading(const Counted& x) { return x.value; }
Counted by_power(const Counted& x, double power) { return Counted(power) * x; }
/// A product and a fused multiply-add; without the latter it takes 17.
Pair<Counted> two_product(const Counted& a, const Counted& b) {
  Counted::flops += 2;
  const DoubleDouble p = stationary::two_product(a.value, b.value);
  return {Counted(p.hi), Counted(p.lo)};
}
double leading(const Pair<Counted>& x) { return x.hi.value; }
Pair<Counted> log(const Pair<Counted>& x) {
  ++Counted::functions;
  return {Counted(std::log(x.hi.value)), Counted()};
}
Pair<Counted> sqrt(const Pair<Counted>& x) {
  ++Counted::functions;
  return {Counted(std::sqrt(x.hi.value)), Counted()};
}

}  // namespace
}  // namespace stationary

template <>
inline constexpr bool stationary::is_scalar<stationary::Counted> = true;

template <>
class std::numeric_limits<stationary::Counted> : public std::numeric_limits<double> {};
template <>
class std::numeric_limits<stationary::Pair<stationary::Counted>>
    : public std::numeric_limits<stationary::DoubleDouble> {};

namespace stationary {
namespace {

using Extended = Pair<Counted>;

struct Operations {
  long flops = 0;
  long divisions = 0;
  long functions = 0;
};

template <class F>
Operations count(const F& f) {
  Counted::flops = Counted::divisions = Counted::functions = 0;
  f();
  return {Counted::flops, Counted::divisions, Counted::functions};
}

/// Seconds of f, the least of some runs.
template <class F>
double least_seconds(const F& f) {
  double least = 1e300;
  for (int k = 0; k < 15; ++k) {
    const auto begin = std::chrono::steady_clock::now();
    f();
    const auto end = std::chrono::steady_clock::now();
    least = std::min(least, std::chrono::duration<double>(end - begin).count());
  }
  return least;
}

/// Keeps the compiler from knowing x.
template <class T>
void hide(T& x) {
  asm volatile("" : "+m"(x) : : "memory");
}

/// Operations per second of `lanes` numbers, each with `f` applied to it again and again.
template <std::size_t lanes, class F>
double rate(int operations, const F& f) {
  constexpr int rounds = 100'000;
  std::array<double, lanes> x;
  x.fill(1.0);
  hide(x);
  const double seconds = least_seconds([&] {
    for (int k = 0; k < rounds; ++k)
      for (double& each : x) each = f(each);
    hide(x);
  });
  return static_cast<double>(lanes) * rounds * operations / seconds;
}

struct Machine {
  double vectors;
  double scalars;
  double chain;
  double divisions;
};

/// Keeps x in a register of its own, from which no vector is made.
inline void keep_scalar(double& x) {
#ifdef __x86_64__
  asm volatile("" : "+x"(x));
#else
  asm volatile("" : "+w"(x));
#endif
}

/// Of independent scalars.
double scalar_rate() {
  constexpr int rounds = 100'000;
  double a = 1.0, b = 1.1, c = 1.2, d = 1.3, e = 1.4, f = 1.5, g = 1.6, h = 1.7;
  double factor = 0.999999;
  double term = 1e-7;
  hide(factor);
  hide(term);
  const double seconds = least_seconds([&] {
    for (int k = 0; k < rounds; ++k) {
      a = a * factor + term;
      b = b * factor + term;
      c = c * factor + term;
      d = d * factor + term;
      e = e * factor + term;
      f = f * factor + term;
      g = g * factor + term;
      h = h * factor + term;
      keep_scalar(a), keep_scalar(b), keep_scalar(c), keep_scalar(d);
      keep_scalar(e), keep_scalar(f), keep_scalar(g), keep_scalar(h);
    }
  });
  return 16.0 * rounds / seconds;
}

Machine measured() {
  double factor = 0.999999;
  double term = 1e-7;
  hide(factor);
  hide(term);
  const auto step = [=](double x) { return x * factor + term; };
  return {rate<64>(2, step), scalar_rate(), rate<1>(2, step),
          rate<8>(1, [=](double x) { return factor / x; })};
}

/// One Jacobian in double and one residual in pairs, of the plane.
template <class Plane>
Operations solve_operations(const Plane& plane, double xi, double zeta) {
  const CentrifugalRates<Counted> c{Counted(0.5), Counted(0.6), Counted(0.0)};
  const Operations jacobian = count([&] {
    const auto w = plane.template evaluate<2>(planar_invariants(Counted(xi), Counted(zeta)));
    planar_log_balance<2>(w, Counted(xi), Counted(zeta), c);
  });
  const CentrifugalRates<Extended> wide{Extended(0.5), Extended(0.6), Extended(0.0)};
  const Operations residual = count([&] {
    const Extended x = xi;
    const Extended z = zeta;
    const auto w = plane.template evaluate<1>(planar_invariants(x, z));
    planar_log_balance<1>(w, x, z, wide);
  });
  return {jacobian.flops + residual.flops, jacobian.divisions + residual.divisions,
          jacobian.functions + residual.functions};
}

template <class Model>
Operations spectrum_operations(const Model& model, Branch branch) {
  return count([&] {
    const SpinUnits units(1.0, 0.5);
    const SpinningBody<Extended, Counted> spin{.J1 = 1.0,
                                               .J2 = 1.7,
                                               .J3 = 0.6,
                                               .xi = Extended(0.9),
                                               .zeta = Extended(1.2),
                                               .rho = Extended(0.7),
                                               .omega = 0.5,
                                               .normal = branch == Branch::iii,
                                               .least_apart = 0.01};
    Curvatures<Extended> curvatures;
    add_plane(model.plane, spin, curvatures);
    add_thickness(model.thickness, spin, curvatures);
    const auto s = balanced_state(spin, curvatures, units);
    if (branch == Branch::i) {
      even_chain_i(s).characteristic();
      odd_quadratic_i(s);
    } else {
      normal_block(s).characteristic();
      odd_lambda_iii(s);
    }
  });
}

void print_machine(const Machine& machine) {
  std::printf(
      "additions and multiplications, billions a second: %.1f in vectors, %.1f scalar and "
      "independent, %.2f one after the other; divisions %.2f\n\n",
      1e-9 * machine.vectors, 1e-9 * machine.scalars, 1e-9 * machine.chain,
      1e-9 * machine.divisions);
}

double sweep_seconds(const Problem& problem, double to) {
  constexpr std::size_t points = 10'000;
  std::vector<double> nu(points);
  for (std::size_t k = 0; k < points; ++k) nu[k] = to * static_cast<double>(k + 1) / points;
  std::vector<SweepPoint> out(points);
  const Equilibrium start = solve(problem, 0.0);
  const double seconds = least_seconds([&] {
    Sweep sweep(problem, start, {.error_bound = false});
    sweep.run(nu, out);
  });
  return seconds / points;
}

double spectrum_seconds(const Problem& problem, double nu) {
  const Equilibrium at = solve(problem, nu);
  constexpr int rounds = 2000;
  return least_seconds([&] {
           for (int k = 0; k < rounds; ++k) {
             Spectrum spectrum = stability(problem, at);
             hide(spectrum);
           }
         }) /
         rounds;
}

void print_line(const char* what, std::string_view model, const char* branch,
                const Operations& operations, double seconds, const Machine& machine) {
  const auto flops = static_cast<double>(operations.flops);
  const auto divisions = static_cast<double>(operations.divisions);
  const double independent = flops / machine.scalars + divisions / machine.divisions;
  const double chained = flops / machine.chain + divisions / machine.divisions;
  std::printf("%-9s %-24s %-5s %6ld %10ld %10ld %10.1f %12.1f %12.1f %8.2f\n", what, model.data(),
              branch, operations.flops, operations.divisions, operations.functions, 1e9 * seconds,
              1e9 * independent, 1e9 * chained, independent / seconds);
}

void print_model(std::string_view name_of, const Machine& machine) {
  const double plane[2] = {1.0, 2.0};
  const double thickness[2] = {1.0, 3.0};
  const Potential potential(Potential::planar(name_of, plane),
                            Potential::thickness("reciprocal-quadratic", thickness));
  const Body body(1.0, 1.7, 0.6);
  const Problem third(body, potential, Branch::iii);
  const Operations solve_count = std::visit(
      [](const auto& model) { return solve_operations(model, 0.9, 1.2); }, potential.plane());
  print_line("solve", name_of, "(iii)", solve_count, sweep_seconds(third, 0.5), machine);
  for (const Branch branch : {Branch::i, Branch::iii}) {
    const Operations spectrum_count = std::visit(
        [&](const auto& plane_model, const auto& thickness_model) {
          return spectrum_operations(
              Separable<std::decay_t<decltype(plane_model)>,
                        std::decay_t<decltype(thickness_model)>>{plane_model, thickness_model},
              branch);
        },
        potential.plane(), potential.thickness());
    print_line("spectrum", name_of, branch == Branch::i ? "(i)" : "(iii)", spectrum_count,
               spectrum_seconds(Problem(body, potential, branch), 0.5), machine);
  }
}

}  // namespace
}  // namespace stationary

int main() {
  using namespace stationary;
  const Machine machine = measured();
  print_machine(machine);
  std::printf("%-9s %-24s %-5s %6s %10s %10s %10s %12s %12s %8s\n", "what", "model", "", "flops",
              "divisions", "functions", "ns", "independent", "in a chain", "share");
  for (const ModelDescription& model : model_descriptions())
    if (model.kind == ModelDescription::Kind::planar) print_model(model.name, machine);
  std::printf("\n%zu bytes written a point, %zu read\n", sizeof(SweepPoint), sizeof(double));
  return 0;
}
