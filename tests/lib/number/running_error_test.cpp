// The bound of a RunningError holds: for inputs off by up to u, and against extended precision.
#include "lib/number/running_error.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "lib/stability/linearization.hpp"
#include "tests/support/bodies/random_states.hpp"

namespace stationary {
namespace {

using Bounded = RunningError<double>;

/// A state's numbers, in the order of StraightState.
using Inputs = std::array<double, 14>;

template <class S, class From>
StraightState<S> state_of(const Inputs& x, const From& from) {
  return {{from(x[0]), from(x[1]), from(x[2])},
          from(x[3]),
          from(x[4]),
          from(x[5]),
          from(x[6]),
          from(x[7]),
          from(x[8]),
          from(x[9]),
          from(x[10]),
          from(x[11]),
          from(x[12]),
          from(x[13])};
}

template <class S>
std::vector<S> results_of(const StraightState<S>& s) {
  const SymmetricPencil<S> even = even_pencil_i(s);
  const OddForms<S> odd = odd_forms_i(s);
  const Polynomial<S, 3> cubic = even_block_iii(s).characteristic();
  return {even.K[1][1], even.K[1][2], even.K[2][2], odd.Q1[0],  odd.det_Q1, odd.det_P,
          odd.P[2],     cubic.c[0],   cubic.c[1],   cubic.c[2], cubic.c[3], odd_lambda_iii(s)};
}

TEST(RunningError, BoundsTheBlocksOfASpectrum) {
  support::Random random(8801);
  double tightest = 1e300;
  for (int trial = 0; trial < 2000; ++trial) {
    const double u = random.log_uniform(0x1p-53, 1e-12);
    Inputs x;
    for (double& each : x) each = random.sign() * random.log_uniform(1e-3, 1e3);
    for (std::size_t k = 0; k < 6; ++k) x[k] = std::abs(x[k]);
    if (trial % 2 == 0) x[4] = x[3] * (1.0 + random.log_uniform(1e-12, 1e-3));  // cancels
    const auto bounded =
        results_of(state_of<Bounded>(x, [](double each) { return Bounded::input(each); }));
    const auto exact = results_of(state_of<DoubleDouble>(
        x, [&](double each) { return two_sum(each, each * u * random.uniform(-1.0, 1.0)); }));
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const double error = std::abs(double(exact[k] - DoubleDouble(bounded[k].value)));
      const double bound = u * bounded[k].units;
      EXPECT_LE(error, bound * (1.0 + 1e-6)) << "result " << k << ", trial " << trial;
      if (error > 0.0) tightest = std::min(tightest, bound / error);
    }
  }
  EXPECT_LT(tightest, 10.0) << "a bound of no use";
}

/// One operation at a time, of exact numbers and of inputs.
TEST(RunningError, BoundsASingleQuotientProductOrLogarithm) {
  support::Random random(8802);
  for (int trial = 0; trial < 2000; ++trial) {
    const double u = 0x1p-53;
    const double x = random.sign() * random.log_uniform(1e-3, 1e3);
    const double y = random.sign() * random.log_uniform(1e-3, 1e3);
    const double off = u * random.uniform(0.5, 1.0);
    for (const bool x_off : {false, true}) {
      for (const bool y_off : {false, true}) {
        const auto of = [](double each, bool input) {
          return input ? Bounded::input(each) : Bounded(each);
        };
        // The signs that move a product or a quotient farthest.
        const auto moved = [&](double each, bool input, double sign) {
          return input ? two_sum(each, each * off * sign) : DoubleDouble(each);
        };
        const auto holds = [&](const Bounded& bounded, const DoubleDouble& exact) {
          EXPECT_LE(std::abs(double(exact - DoubleDouble(bounded.value))),
                    u * bounded.units * (1.0 + 1e-6))
              << x << " " << y << " " << x_off << y_off;
        };
        const Bounded a = of(x, x_off);
        const Bounded b = of(y, y_off);
        for (const double sign : {-1.0, 1.0}) {
          holds(a * b, moved(x, x_off, sign) * moved(y, y_off, sign));
          holds(a / b, moved(x, x_off, sign) / moved(y, y_off, -sign));
          if (x > 0.0) holds(log(a), log(moved(x, x_off, sign)));
        }
      }
    }
  }
}

}  // namespace
}  // namespace stationary
