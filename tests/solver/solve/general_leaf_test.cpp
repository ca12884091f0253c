// Leaves made from their Lambda, mixed by symplectic transformations, against 60 digits: every
// Lambda within its bound for the leaf given and for every entry shaken by its magnitude, energies
// and classes as the leaf was made; close Lambda, collisions and zeros among them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "lib/stability/general_spectrum.hpp"
#include "tests/support/bodies/motions.hpp"
#include "tests/support/numbers/shifted_qr.hpp"
#include "tests/support/numbers/wide_numbers.hpp"

namespace stationary {
namespace {

using Wide = support::Binary<60>;
constexpr double u = 0x1p-53;

template <std::size_t n>
using WideForm = Square<Wide, 2 * n>;

template <std::size_t n>
WideForm<n> diagonal(const std::vector<double>& frequency, const std::vector<int>& energy,
                     support::Random& random) {
  WideForm<n> out{};
  for (std::size_t k = 0; k < n; ++k) {
    out[k][k] = Wide(energy[k] * frequency[k]) * random.uniform(0.3, 3.0);
    out[n + k][n + k] = Wide(frequency[k]) * frequency[k] / out[k][k];
  }
  return out;
}

template <std::size_t n>
void transform(WideForm<n>& E, const WideForm<n>& T) {
  WideForm<n> ET{};
  WideForm<n> out{};
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t j = 0; j < 2 * n; ++j)
      for (std::size_t k = 0; k < 2 * n; ++k) ET[i][j] += E[i][k] * T[k][j];
  for (std::size_t i = 0; i < 2 * n; ++i)
    for (std::size_t j = 0; j < 2 * n; ++j)
      for (std::size_t k = 0; k < 2 * n; ++k) out[i][j] += T[k][i] * ET[k][j];
  E = out;
}

/// Changes of coordinates; shears of momenta and coordinates too where nothing is reversible.
template <std::size_t n>
void mix(WideForm<n>& E, bool reversible, support::Random& random) {
  const auto identity = [] {
    WideForm<n> out{};
    for (std::size_t k = 0; k < 2 * n; ++k) out[k][k] = 1;
    return out;
  };
  for (int k = 0; k < 12 && n > 1; ++k) {
    const auto a = static_cast<std::size_t>(random.integer(0, n - 1));
    const auto b = static_cast<std::size_t>(random.integer(0, n - 1));
    if (a == b) continue;
    WideForm<n> T = identity();
    T[a][b] = random.uniform(-1.0, 1.0);
    T[n + b][n + a] = -T[a][b];
    transform<n>(E, T);
  }
  if (reversible) return;
  for (const std::size_t first : {std::size_t{0}, n}) {
    WideForm<n> T = identity();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        T[first + i][n - first + j] = T[first + j][n - first + i] = random.uniform(-1.0, 1.0);
    transform<n>(E, T);
  }
}

template <std::size_t n>
Leaf leaf_of(const WideForm<n>& E) {
  Leaf out{};
  out.pairs = n;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    for (std::size_t j = 0; j < 2 * n; ++j) {
      const Wide x = i < j ? E[i][j] : E[j][i];
      const double hi = support::nearest(x);
      out.second_variation[i][j] = {hi, support::nearest(Wide(x - hi))};
      out.magnitude[i][j] = 3.0 * std::abs(hi);
    }
  }
  return out;
}

struct WideValue {
  Wide re;
  Wide im;
};

/// Lambda of the leaf, its entries moved by +-shake magnitude.
template <std::size_t n>
std::vector<WideValue> exact_lambdas(const Leaf& leaf, double shake, support::Random& random) {
  constexpr std::size_t N = 2 * n;
  WideForm<n> H;
  WideForm<n> E;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      E[i][j] = E[j][i] = support::exact<Wide>(leaf.second_variation[i][j]) +
                          Wide(shake * random.sign()) * leaf.magnitude[i][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      H[i][j] = E[n + i][j];
      H[n + i][j] = -E[i][j];
    }
  }
  const auto s = shifted_qr<Wide, N>(Hessenberg<Wide, N>(H).h);
  std::vector<WideValue> twice;
  std::vector<WideValue> out;
  if (!s) return out;
  for (const auto& each : *s)
    twice.push_back({each.re * each.re - each.im * each.im, 2 * each.re * each.im});
  while (!twice.empty()) {
    const WideValue z = twice.back();
    twice.pop_back();
    out.push_back(z);
    const auto far = [&](const WideValue& x) -> Wide {
      return abs(Wide(x.re - z.re)) + abs(Wide(x.im - z.im));
    };
    twice.erase(std::ranges::min_element(
        twice, [&](const WideValue& x, const WideValue& y) { return far(x) < far(y); }));
  }
  return out;
}

/// The largest |found - exact|/bound of the pairing that makes it least.
double worst_ratio(const Spectrum& spectrum, const std::vector<WideValue>& exact) {
  std::vector<std::size_t> order(exact.size());
  std::iota(order.begin(), order.end(), 0);
  double best = HUGE_VAL;
  do {
    double worst = 0.0;
    int conjugate = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const Mode& mode = spectrum.mode[k];
      const double im =
          mode.lambda_im > 0.0 && conjugate++ % 2 == 1 ? -mode.lambda_im : mode.lambda_im;
      const double off = std::hypot(support::nearest(Wide(mode.lambda_re - exact[order[k]].re)),
                                    support::nearest(Wide(im - exact[order[k]].im)));
      worst = std::max(worst, off / mode.lambda_error);
      if (worst >= best) break;
    }
    best = std::min(best, worst);
  } while (std::ranges::next_permutation(order).found);
  return best;
}

template <std::size_t n>
Spectrum expect_held(const WideForm<n>& E, support::Random& random, const std::string& text) {
  const Leaf leaf = leaf_of<n>(E);
  const Spectrum spectrum = general_spectrum({MaterialSymmetry::none, u}, leaf);
  EXPECT_EQ(spectrum.modes, static_cast<int>(n)) << text;
  for (int trial = 0; trial < 3; ++trial) {
    const auto exact = exact_lambdas<n>(leaf, trial == 0 ? 0.0 : u, random);
    EXPECT_EQ(exact.size(), n) << text;
    if (exact.size() == n) {
      EXPECT_LE(worst_ratio(spectrum, exact), 1.0) << text << ", trial " << trial << "\n"
                                                   << spectrum;
    }
  }
  return spectrum;
}

template <std::size_t n>
void expect_leaves_told(bool reversible, std::uint64_t seed) {
  support::Random random(seed);
  for (int k = 0; k < 60; ++k) {
    std::vector<double> frequency;
    std::vector<int> energy;
    for (std::size_t j = 0; j < n; ++j) {
      frequency.push_back(0.4 + 0.6 * static_cast<double>(j) + random.uniform(0.0, 0.4));
      energy.push_back(k % 3 == 0 ? 1 : static_cast<int>(random.sign()));
    }
    WideForm<n> E = diagonal<n>(frequency, energy, random);
    const bool real = k % 5 == 4;
    if (real) E[0][0] = -E[0][0];
    mix<n>(E, reversible, random);
    const std::string text = "leaf " + std::to_string(k);
    const Spectrum spectrum = expect_held<n>(E, random, text);
    const long negative = std::ranges::count(energy, -1);
    if (real) {
      EXPECT_EQ(spectrum.verdict, StabilityClass::unstable) << text;
      continue;
    }
    EXPECT_EQ(spectrum.negative, 2 * negative) << text;
    EXPECT_EQ(name(spectrum.verdict),
              name(negative == 0 ? StabilityClass::stable : StabilityClass::elliptic))
        << text << "\n"
        << spectrum;
    for (std::size_t j = 0; j < n; ++j)
      EXPECT_EQ(spectrum.mode[j].krein, energy[j]) << text << "\n" << spectrum;
  }
}

TEST(GeneralLeaf, ThatIsReversible) {
  expect_leaves_told<5>(true, 821);
  expect_leaves_told<4>(true, 822);
  expect_leaves_told<3>(true, 823);
}

TEST(GeneralLeaf, ThatIsNot) {
  expect_leaves_told<5>(false, 824);
  expect_leaves_told<4>(false, 825);
  expect_leaves_told<3>(false, 826);
  expect_leaves_told<2>(false, 827);
  expect_leaves_told<1>(false, 828);
}

/// Three close ones of a definite leaf stay three imaginary ones, at any distance.
TEST(GeneralLeaf, WithThreeCloseFrequencies) {
  support::Random random(829);
  for (const bool reversible : {true, false}) {
    for (double apart = 1e-3; apart > 1e-19; apart *= 0.01) {
      std::vector<double> frequency{1.0, 1.0 + apart, 1.0 + 2.0 * apart, 2.0, 2.7};
      WideForm<5> E = diagonal<5>(frequency, {1, 1, 1, 1, 1}, random);
      mix<5>(E, reversible, random);
      const std::string text = "apart by " + std::to_string(std::log10(apart));
      const Spectrum spectrum = expect_held<5>(E, random, text);
      EXPECT_EQ(spectrum.verdict, StabilityClass::stable) << text << "\n" << spectrum;
    }
  }
}

/// Two of opposite signature about to meet, or past it: never a wrong claim, none far inside the
/// bounds, and one far outside.
TEST(GeneralLeaf, BesideACollision) {
  support::Random random(830);
  for (const bool reversible : {true, false}) {
    for (double beyond = 1e-2; beyond > 1e-22; beyond *= 0.1) {
      for (const double side : {1.0, -1.0}) {
        WideForm<4> E = diagonal<4>({1.0, 1.0, 2.0, 2.7}, {1, 1, 1, -1}, random);
        // -B A of the first two: Lambda = -(w + y + d/2) +- sqrt(d (y + d/4)).
        const double w = random.uniform(0.5, 1.0);
        const double y = random.uniform(0.2, 0.6);
        E[0][0] = Wide(w) + 2 * Wide(y) + Wide(side * beyond);
        E[1][1] = -Wide(w);
        E[0][1] = E[1][0] = y;
        E[4][4] = 1;
        E[5][5] = -1;
        mix<4>(E, reversible, random);
        const std::string text = "beyond by " + std::to_string(side * std::log10(beyond));
        const Spectrum spectrum = expect_held<4>(E, random, text);
        if (spectrum.verdict == StabilityClass::marginal) {
          EXPECT_LE(beyond, 1e-8) << text << "\n" << spectrum;
          continue;
        }
        EXPECT_GE(beyond, 1e-17) << text << "\n" << spectrum;
        EXPECT_EQ(name(spectrum.verdict),
                  name(side > 0.0 ? StabilityClass::elliptic : StabilityClass::oscillatory))
            << text << "\n"
            << spectrum;
      }
    }
  }
}

TEST(GeneralLeaf, BesideZero) {
  support::Random random(831);
  for (const bool reversible : {true, false}) {
    for (double near = 1e-2; near > 1e-20; near *= 0.1) {
      for (const double side : {1.0, -1.0}) {
        WideForm<5> E = diagonal<5>({1.0, 1.3, 1.9, 2.6, 3.0}, {1, 1, -1, 1, -1}, random);
        E[0][0] = side * near;
        mix<5>(E, reversible, random);
        const std::string text = "zero but for " + std::to_string(side * std::log10(near));
        const Spectrum spectrum = expect_held<5>(E, random, text);
        if (spectrum.away_from_zero()) {
          EXPECT_EQ(spectrum.verdict == StabilityClass::unstable, side < 0.0) << text << spectrum;
          EXPECT_EQ(spectrum.negative, side > 0.0 ? 4 : 5) << text << spectrum;
        } else {
          EXPECT_LE(near, 1e-9) << text << spectrum;
        }
      }
    }
  }
}

/// A collapsed body under its own gravity: four Lambda of some 4 10^6 and one of 10^-14. The latter by a
/// linearization of its own in 50 digits.
TEST(GeneralLeaf, ASlowModeBesideStiffOnes) {
  const Body body(5.0945600179518769, 1.3792305714131288, 0.86379010973155024);
  BodyModel<> model;
  model.elastic.coupled = NeoHookean3d<>{1.1580177186729153, 5.1595940577654194};
  model.gravitates = true;
  model.g = 1.1445381088433928;
  model.J = {body.J1, body.J2, body.J3};
  const BasicStretch<DoubleDouble> q{0.0, 0.0018686227316598173537, 0.0035913403138245638147,
                                     0.0045380662428466368492};
  const Vector3<DoubleDouble> nu{DoubleDouble(0.93987479551303543), DoubleDouble(0.0),
                                 DoubleDouble(0.0)};
  const Spectrum found = general_spectrum(body, Potential(model), q, nu, 4e-14);
  const std::vector<Mode> modes = testing::by_lambda(found);
  ASSERT_EQ(modes.size(), 5U);
  EXPECT_LE(std::abs(modes[3].lambda_re + 7.51627554016008131e-15), modes[3].lambda_error);
  EXPECT_LT(modes[3].lambda_error, 1e-2 * 7.5e-15);
  EXPECT_LE(std::abs(modes[4].lambda_re - 4214781.40361277476), modes[4].lambda_error);
}

}  // namespace
}  // namespace stationary
