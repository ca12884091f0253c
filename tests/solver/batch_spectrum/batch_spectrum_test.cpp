// The spectra of a batch's cells are those of stability(), cell by cell: the same class, negative
// directions and signatures wherever lanes claim them, numbers to the last places; whatever the
// instruction set and the other cells.
#include "solver/batch_spectrum/batch_spectrum.hpp"

#include <gtest/gtest.h>

#include <map>

#include "solver/solve/stability.hpp"
#include "tests/support/bodies/model_and_branch.hpp"
#include "tests/support/bodies/random_problem.hpp"
#include "tests/support/numbers/evenly.hpp"

namespace stationary {
namespace {

using namespace testing;

/// Of re and im against those of stability(): both are rounded once from about 100 bits, of a state
/// that is known to about 80, of 2^-53 that the Lambda's bound allows for.
constexpr double last_places = 0x1p-50;
constexpr double of_bound = 0x1p-24;

struct Spectra {
  std::vector<CellPlace> places;
  std::vector<CellSpectrum> spectra;
  std::size_t scalar = 0;
};

/// Of all solved cells.
Spectra spectra_of(const BatchInput& input, const BatchResult& solved,
                   const SpectrumOptions& options = {}) {
  Spectra out;
  for (std::size_t lane = 0; lane < input.lanes; ++lane)
    for (std::size_t k = 0; k < input.nu.size(); ++k)
      if (solved.cell(lane, k).status == SolveStatus::solved) out.places.push_back({lane, k});
  out.spectra.resize(out.places.size());
  out.scalar = cell_spectra(input, solved, out.places, options, out.spectra);
  return out;
}

Spectrum stability_of(const BatchInput& input, const BatchResult& solved, const CellPlace& place) {
  const BatchCell cell = solved.cell(place.lane, place.k);
  Equilibrium at;
  at.status = cell.status;
  at.q = {0.0, cell.xi, cell.zeta, cell.rho};
  at.nu = angular_velocity(input.branch, input.speed[place.lane] * input.nu[place.k]);
  at.error_bound = cell.error_bound;
  return stability(input.problem(place.lane), at);
}

void expect_same_spectrum(const CellSpectrum& actual, const Spectrum& expected,
                          const std::string& what) {
  ASSERT_EQ(name(actual.verdict), name(expected.verdict)) << what;
  ASSERT_EQ(actual.negative, expected.negative) << what;
  ASSERT_EQ(actual.modes, expected.modes) << what;
  double growth_tolerance = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(expected.modes); ++k) {
    const Mode& mode = expected.mode[k];
    const double size = std::hypot(mode.re, mode.im);
    const double tolerance =
        size > 0.0 ? last_places * size + of_bound * mode.lambda_error / size : 0.0;
    EXPECT_LE(std::abs(actual.mode[k].re - mode.re), tolerance) << what << ", mode " << k;
    EXPECT_LE(std::abs(actual.mode[k].im - mode.im), tolerance) << what << ", mode " << k;
    EXPECT_EQ(actual.mode[k].krein, mode.krein) << what << ", mode " << k;
    growth_tolerance = std::max(growth_tolerance, mode.re > 0.0 ? tolerance : 0.0);
  }
  EXPECT_LE(std::abs(actual.growth - expected.growth), growth_tolerance) << what;
}

using Classes = std::map<std::string_view, int>;

/// All cells against stability(), with modes and without; returns how many of each class.
Classes expect_as_alone(const BatchInput& input, const std::string& what,
                        double most_scalar = 1.0) {
  BatchResult solved;
  solve_batch(input, {}, solved);
  const Spectra with_modes = spectra_of(input, solved);
  const Spectra classes = spectra_of(input, solved, {.modes = false});
  EXPECT_LE(static_cast<double>(with_modes.scalar),
            most_scalar * static_cast<double>(with_modes.places.size()))
      << what;
  Classes out;
  for (std::size_t i = 0; i < with_modes.places.size(); ++i) {
    const CellPlace place = with_modes.places[i];
    const Spectrum expected = stability_of(input, solved, place);
    const std::string where =
        what + ", lane " + std::to_string(place.lane) + ", nu " + std::to_string(input.nu[place.k]);
    expect_same_spectrum(with_modes.spectra[i], expected, where);
    EXPECT_EQ(classes.spectra[i].verdict, expected.verdict) << where;
    EXPECT_EQ(classes.spectra[i].negative, expected.negative) << where;
    EXPECT_TRUE(std::isnan(classes.spectra[i].growth)) << where;
    ++out[name(expected.verdict)];
    if (::testing::Test::HasFailure()) return out;
  }
  return out;
}

class BatchSpectrumTest : public ::testing::TestWithParam<support::ModelAndBranch> {
 protected:
  static BatchInput bodies(std::vector<double> J1, std::vector<double> J2, std::vector<double> nu) {
    const auto [model, branch] = GetParam();
    const std::size_t lanes = J2.size();
    BatchInput out(Problem(Body(1.0, 1.7, 0.6), make_potential(model, {1.0, 2.0}), branch), lanes,
                   std::move(nu));
    out.inertia[0] = std::move(J1);
    out.inertia[1] = std::move(J2);
    return out;
  }
};

/// Few of the cells of a map are left to the scalar path.
TEST_P(BatchSpectrumTest, AsAloneOverAMap) {
  const BatchInput input =
      bodies(std::vector<double>(11, 1.0), evenly(0.6, 1.9, 11), evenly(0.07, 1.1, 23));
  const bool coupled = std::get<0>(GetParam()) == "neo-hookean-3d";
  expect_as_alone(input, "map", coupled ? 1.0 : 0.02);
}

/// J1 = J2: a forced zero in (i) and (ii), the circle in (iii).
TEST_P(BatchSpectrumTest, AsAloneWithMaterialSymmetry) {
  const std::vector<double> J = evenly(0.3, 2.0, 7);
  const bool coupled = std::get<0>(GetParam()) == "neo-hookean-3d";
  expect_as_alone(bodies(J, J, evenly(0.06, 1.3, 23)), "J1 = J2", coupled ? 1.0 : 0.02);
}

/// Slow down to rest, and J2 from J1 on by 1e-15 ...: where xi - zeta is lost.
TEST_P(BatchSpectrumTest, AsAloneNearTheCircle) {
  std::vector<double> J2;
  for (double gap = 1e-15; gap < 1e-2; gap *= 30.0) J2.push_back(1.0 + gap);
  std::vector<double> nu{0.0, -1e-9};
  for (double slow = 1e-8; slow < 0.9; slow *= 3.0) nu.push_back(slow);
  expect_as_alone(bodies(std::vector<double>(J2.size(), 1.0), J2, nu), "near the circle");
}

TEST_P(BatchSpectrumTest, SameInEveryInstructionSetAndCompany) {
  const BatchInput input =
      bodies(std::vector<double>(3, 1.0), {0.8, 1.0, 1.6}, evenly(0.0, 1.2, 15));
  BatchResult solved;
  solve_batch(input, {}, solved);
  const Spectra expected = spectra_of(input, solved, {.instructions = InstructionSet::baseline});
  for (const InstructionSet set :
       {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (!has_instruction_set(set)) continue;
    const Spectra all = spectra_of(input, solved, {.instructions = set});
    EXPECT_EQ(all.scalar, expected.scalar);
    for (std::size_t i = 0; i < all.places.size(); ++i) {
      CellSpectrum alone;
      (void)cell_spectra(input, solved, {&all.places[i], 1}, {.instructions = set}, {&alone, 1});
      for (const CellSpectrum* each : {&all.spectra[i], const_cast<const CellSpectrum*>(&alone)}) {
        ASSERT_EQ(each->verdict, expected.spectra[i].verdict);
        ASSERT_EQ(each->growth, expected.spectra[i].growth);
        for (std::size_t k = 0; k < static_cast<std::size_t>(each->modes); ++k) {
          ASSERT_EQ(each->mode[k].re, expected.spectra[i].mode[k].re);
          ASSERT_EQ(each->mode[k].im, expected.spectra[i].mode[k].im);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Models, BatchSpectrumTest,
    ::testing::Combine(::testing::Values("reciprocal-determinant", "saint-venant-kirchhoff", "biot",
                                         "biot-log", "neo-hookean", "hencky", "neo-hookean-3d"),
                       ::testing::Values(Branch::i, Branch::ii, Branch::iii)),
    support::model_and_branch);

/// Random bodies, coefficients over four orders of magnitude, one in ten with J1 = J2.
TEST(BatchSpectrum, AsAloneForRandomBodies) {
  support::Random random(20261);
  Classes seen;
  for (int trial = 0; trial < 4000; ++trial) {
    const Posed posed = random_problem(random, 4.0);
    const BatchInput input(posed.problem, 1, {posed.nu});
    for (const auto& [verdict, count] : expect_as_alone(input, posed.text)) seen[verdict] += count;
    if (HasFailure()) return;
  }
  for (const std::string_view verdict : {"stable", "elliptic", "unstable"})
    EXPECT_GT(seen[verdict], 10) << verdict;
}

/// Two shears in a quadruple, on the circle and where unequal inertias break it.
TEST(BatchSpectrum, AsAloneThroughCollisions) {
  const Problem problem(Body(1.0, 1.0, 0.6), make_potential("hencky", {1.0, 2.0}), Branch::iii);
  BatchInput input(problem, 6, evenly(1.0, 1.3, 400));
  input.inertia[1] = std::vector<double>{1.0, 1.0 + 1e-9, 1.0 + 1e-6, 1.0001, 0.999, 1.01};
  Classes seen = expect_as_alone(input, "hencky");
  EXPECT_GT(seen["oscillatory"], 40);
  EXPECT_GT(seen["stable"], 10);
}

/// Up to where classes change (tilts, folds of |pi|, collisions), found by bisection in the lanes'
/// own classes, to neighbouring doubles: nothing is claimed there that stability() does not.
TEST(BatchSpectrum, AsAloneUpToWhereClassesChange) {
  support::Random random(7);
  int changes = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Posed posed = random_problem(random, 3.0);
    const auto verdict_at = [&](double nu) {
      const BatchInput input(posed.problem, 1, {nu});
      BatchResult solved;
      solve_batch(input, {}, solved);
      const Spectra all = spectra_of(input, solved, {.modes = false});
      return all.spectra.empty() ? StabilityClass::marginal : all.spectra[0].verdict;
    };
    double low = 0.05 * posed.nu;
    double high = posed.nu;
    const StabilityClass below = verdict_at(low);
    if (verdict_at(high) == below) continue;
    ++changes;
    std::vector<double> nu;
    while (std::abs(high - low) > 0x1p-52 * std::abs(high)) {
      const double middle = 0.5 * (low + high);
      if (middle == low || middle == high) break;
      (verdict_at(middle) == below ? low : high) = middle;
      nu.push_back(low);
      nu.push_back(high);
    }
    expect_as_alone(BatchInput(posed.problem, 1, nu), posed.text);
    if (HasFailure()) return;
  }
  EXPECT_GT(changes, 50);
}

TEST(BatchSpectrum, RefusesWhatItCannotDo) {
  const Problem problem(Body(1.0, 1.7, 0.6), make_potential("reciprocal-determinant", {1.0, 2.0}),
                        Branch::i);
  const BatchInput input(problem, 1, {0.3, 5.0});
  BatchResult solved;
  solve_batch(input, {}, solved);
  const std::vector<CellPlace> places{{0, 0}, {0, 1}};
  std::vector<CellSpectrum> out(2);
  EXPECT_THROW((void)cell_spectra(input, solved, places, {}, out), std::invalid_argument);
  EXPECT_THROW((void)cell_spectra(input, solved, places, {}, {out.data(), 1}),
               std::invalid_argument);
  EXPECT_EQ(cell_spectra(input, solved, {places.data(), 1}, {}, {out.data(), 1}), 0U);
}

}  // namespace
}  // namespace stationary
