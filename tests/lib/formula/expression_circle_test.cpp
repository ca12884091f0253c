// Functions of the principal stretches through the circle lambda = mu: value and derivatives in
// (t, ln d) keep their digits down to lambda = mu itself, where differentiating lambda and mu would
// divide by their difference. Against 50 digits, and against the derivatives along lambda and mu in
// more digits than they lose.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "lib/material/models/model_coefficients.hpp"
#include "lib/number/interval.hpp"
#include "lib/number/taylor.hpp"
#include "tests/support/bodies/written_potential.hpp"
#include "tests/support/numbers/law.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using namespace support;
using Wide = Binary<140>;

const std::vector<double> gaps{8.0, 0.5, 1e-1, 1e-2, 1e-3, 1e-5, 1e-9, 1e-15, 0.0};

template <class S>
std::array<S, 6> planar_numbers(const PlanarDerivatives<S>& w) {
  return {w.w, w.w_t, w.w_l, w.w_tt, w.w_tl, w.w_ll};
}

/// In doubles, extended numbers and intervals, to the errors allowed relative to size.
template <class Model, class T>
void expect_digits(const std::string& place, const Model& model, double lambda, double mu,
                   const std::array<T, 6>& expected) {
  const auto plain = planar_numbers(model.template evaluate<2>(planar_invariants(lambda, mu)));
  const auto extended = planar_numbers(model.template evaluate<2>(extended_invariants(lambda, mu)));
  const auto intervals = with_coefficients(model, [](double c) { return Interval(c); });
  const auto enclosed = planar_numbers(
      intervals.template evaluate<2>(planar_invariants(Interval(lambda), Interval(mu))));
  for (std::size_t k = 0; k < 6; ++k) {
    const std::string here = place + ", number " + std::to_string(k) + ", " + at(lambda, mu);
    const T size = 1 + abs(expected[k]);
    EXPECT_TRUE(agrees(here, expected[k], T(plain[k]), T(size * T(2e-13))));
    EXPECT_TRUE(agrees(here, expected[k], exact<T>(extended[k]), T(size * T(1e-23))));
    EXPECT_TRUE(T(enclosed[k].lo) <= expected[k] && expected[k] <= T(enclosed[k].hi))
        << here << " not in " << enclosed[k].lo << ", " << enclosed[k].hi;
    EXPECT_LE(enclosed[k].width(), 1e-8 * nearest(size)) << here;
  }
}

TEST(ExpressionCircle, HenckyIsTheBuiltInOneIn50Digits) {
  const Hencky<> built_in{1.25, 0.75};
  const auto wide = with_coefficients(built_in, [](double c) { return Real50(c); });
  const auto model =
      written_plane("p*(log(lambda)^2 + log(mu_)^2) + q/2*log(d)^2", p_and_q, {1.25, 0.75});
  for (const double gap : gaps) {
    const double mu = 0.875;
    const double lambda = mu + gap;
    const auto expected =
        planar_numbers(wide.evaluate<2>(planar_invariants(Real50(lambda), Real50(mu))));
    expect_digits("hencky", model, lambda, mu, expected);
    expect_digits("hencky, exchanged", model, mu, lambda, expected);
  }
}

/// W = f(lambda) + f(mu):
///   W_t = (lambda f' - mu f'(mu))/(lambda - mu),  W_l = -lambda mu (f' - f'(mu))/(lambda - mu),
/// second derivatives as central differences of these, both with digits to spare.
struct Sum {
  Wide (*slope)(const Wide&);

  std::array<Wide, 2> first(const Wide& t, const Wide& d) const {
    const Wide root = sqrt(t * t - 4 * d);
    const Wide lambda = (t + root) / 2;
    const Wide mu = (t - root) / 2;
    return {(lambda * slope(lambda) - mu * slope(mu)) / root,
            -d * (slope(lambda) - slope(mu)) / root};
  }
  std::array<Wide, 6> operator()(const Wide& value, const Wide& lambda, const Wide& mu) const {
    const Wide t = lambda + mu;
    const Wide d = lambda * mu;
    const Wide h("1e-80");
    const auto at = first(t, d);
    const auto t_above = first(t + h, d);
    const auto t_below = first(t - h, d);
    const auto l_above = first(t, d * exp(h));
    const auto l_below = first(t, d * exp(Wide(-h)));
    return {value,
            at[0],
            at[1],
            (t_above[0] - t_below[0]) / (2 * h),
            (t_above[1] - t_below[1]) / (2 * h),
            (l_above[1] - l_below[1]) / (2 * h)};
  }
};

/// At the circle itself the reference is taken 1e-30 beside it, where the next digits would change.
template <class F>
void expect_sum(const std::string& f, const F& value, Wide (*slope)(const Wide&)) {
  const std::string of_lambda = f + "(lambda)";
  const auto model = written_plane(f, p_and_q, {1.25, 0.75});
  for (const double gap : gaps) {
    const double mu = 0.8125;
    const double lambda = mu + gap;
    const Wide beside = gap == 0.0 ? Wide("1e-30") : Wide(0);
    const Wide larger = Wide(lambda) + beside;
    const Wide smaller = Wide(mu) - beside;
    const auto expected = Sum{slope}(value(larger) + value(smaller), larger, smaller);
    expect_digits(f, model, lambda, mu, expected);
  }
}

TEST(ExpressionCircle, OgdenTermsOfAnyExponent) {
  expect_sum(
      "lambda^p + mu_^p", [](const Wide& x) { return Wide(pow(x, Wide(1.25))); },
      [](const Wide& x) { return Wide(Wide(1.25) * pow(x, Wide(0.25))); });
  expect_sum(
      "lambda^-1.5 + mu_^-1.5", [](const Wide& x) { return Wide(pow(x, Wide(-1.5))); },
      [](const Wide& x) { return Wide(Wide(-1.5) * pow(x, Wide(-2.5))); });
  expect_sum(
      "lambda^4 + mu_^4", [](const Wide& x) { return Wide(x * x * x * x); },
      [](const Wide& x) { return Wide(4 * x * x * x); });
  expect_sum(
      "sqrt(lambda) + sqrt(mu_)", [](const Wide& x) { return Wide(sqrt(x)); },
      [](const Wide& x) { return Wide(1 / (2 * sqrt(x))); });
}

TEST(ExpressionCircle, OtherFunctions) {
  expect_sum(
      "exp(-lambda) + exp(-mu_)", [](const Wide& x) { return Wide(exp(Wide(-x))); },
      [](const Wide& x) { return Wide(-exp(Wide(-x))); });
  expect_sum(
      "sin(lambda) + sin(mu_)", [](const Wide& x) { return Wide(sin(x)); },
      [](const Wide& x) { return Wide(cos(x)); });
  expect_sum(
      "cos(lambda) + cos(mu_)", [](const Wide& x) { return Wide(cos(x)); },
      [](const Wide& x) { return Wide(-sin(x)); });
  expect_sum(
      "tanh(lambda) + tanh(mu_)", [](const Wide& x) { return Wide(tanh(x)); },
      [](const Wide& x) { return Wide(1 - tanh(x) * tanh(x)); });
  expect_sum(
      "atan(lambda) + atan(mu_)", [](const Wide& x) { return Wide(atan(x)); },
      [](const Wide& x) { return Wide(1 / (1 + x * x)); });
  expect_sum(
      "tan(lambda/8) + tan(mu_/8)", [](const Wide& x) { return Wide(tan(Wide(x / 8))); },
      [](const Wide& x) { return Wide((1 + tan(Wide(x / 8)) * tan(Wide(x / 8))) / 8); });
}

/// Along a line of states that meets the circle, or passes it by: what intervals give of each order
/// holds what more digits give.
TEST(ExpressionCircle, EveryOrderAlongALineIsEnclosed) {
  constexpr int order = 3;
  const auto numbers = [&]<class T>(const auto& model, double lambda, double mu, const T&) {
    using Along = Taylor<T, order>;
    Along l{T(lambda)};
    Along m{T(mu)};
    l[1] = T(0.75);
    l[2] = T(0.25);
    m[1] = T(-0.5);
    m[3] = T(1.5);
    const auto of = with_coefficients(model, [](double c) { return Along(T(c)); });
    return planar_numbers(of.template evaluate<2>(planar_invariants(l, m)));
  };
  for (const char* formula :
       {"p*(log(lambda)^2 + log(mu_)^2) + q*log(lambda)*log(mu_)", "p*(exp(q*lambda) + exp(q*mu_))",
        "p*(lambda^2.5 + mu_^2.5) + q*(lambda^(-1.5) + mu_^(-1.5))", "p*(tanh(lambda) + tanh(mu_))",
        "q*(atan(lambda) + atan(mu_)) + p*cos(lambda)*cos(mu_)"}) {
    const auto model = written_plane(formula, p_and_q, {1.25, 0.75});
    for (const double gap : {0.0, 1e-12, 1e-5, 1e-2, 0.2, 0.9}) {
      const auto expected = numbers(model, 0.875 + gap, 0.875, Wide());
      const auto found = numbers(model, 0.875 + gap, 0.875, Interval());
      for (std::size_t k = 0; k < found.size(); ++k) {
        for (int j = 0; j <= order; ++j) {
          const Wide exact = expected[k][j];
          const Interval& at = found[k][j];
          EXPECT_TRUE(Wide(at.lo) <= exact && exact <= Wide(at.hi))
              << formula << ", number " << k << ", order " << j << ", gap " << gap;
          EXPECT_LE(at.width(), 1e-7 * (1.0 + nearest(abs(exact))))
              << formula << ", number " << k << ", order " << j << ", gap " << gap;
        }
      }
    }
  }
}

}  // namespace
}  // namespace stationary
