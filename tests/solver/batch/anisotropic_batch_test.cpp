// A batch of anisotropic bodies gives in every cell what solve() gives there, however many cells
// its lane has, up to folds and across gaps of broken bifurcations; and as batch.hpp has it
// whatever the threads, the other lanes and the order of nu.
#include "solver/batch/anisotropic_batch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "solver/batch_spectrum/batch_spectrum.hpp"
#include "solver/family/follow_sheet.hpp"
#include "solver/solve/stability.hpp"
#include "tests/support/bodies/anisotropic_motions.hpp"
#include "tests/support/bodies/plate.hpp"
#include "tests/support/numbers/evenly.hpp"

namespace stationary {
namespace {

using namespace testing;

BatchResult solved(const BatchInput& input, const BatchOptions& options = {}) {
  BatchResult out;
  solve_batch(input, options, out);
  return out;
}

Stretch stretch(const BatchCell& cell) { return {cell.alpha, cell.xi, cell.zeta, cell.rho}; }

/// Every cell against solve() there; how many are solved.
int expect_as_solved_alone(const BatchInput& input, const std::string& what) {
  const BatchResult out = solved(input);
  int count = 0;
  for (std::size_t lane = 0; lane < input.lanes; ++lane) {
    const Problem problem = input.problem(lane);
    for (std::size_t k = 0; k < input.nu.size(); ++k) {
      const double nu = input.speed[lane] * input.nu[k];
      const BatchCell cell = out.cell(lane, k);
      const Equilibrium alone = solve(problem, nu, without_search());
      EXPECT_EQ(cell.status, alone.status)
          << what << "; lane " << lane << ", nu " << nu << ": " << alone.message;
      if (cell.status != SolveStatus::solved || alone.status != SolveStatus::solved) continue;
      ++count;
      EXPECT_LE(stretch_difference(stretch(cell), alone.q), cell.error_bound + alone.error_bound)
          << what << "; lane " << lane << ", nu " << nu;
      EXPECT_LE(cell.error_bound, 1.5 * alone.error_bound);
      EXPECT_LE(
          check_balance(problem.body(), problem.potential(), stretch(cell), alone.nu).residual,
          acceptable_residual);
    }
  }
  return count;
}

/// Fibres at many angles, two of them axes of symmetry.
BatchInput fan(Branch branch, const AnisotropicPotential::Plane& plane, double k,
               const std::vector<double>& degrees, const std::vector<double>& nu) {
  BatchInput out(Problem(plate, fibred(plane, k, 30.0), branch), degrees.size(), nu);
  out.fibres[1] = degrees;
  return out;
}

TEST(AnisotropicBatch, AgreesWithSolveOverAngleAndSpin) {
  const BatchInput input =
      fan(Branch::iii, NeoHookean<>{1.0, 2.0}, 0.4,
          {-90.0, -60.0, -1e-3, 0.0, 1e-6, 1.0, 30.0, 45.0, 89.0, 90.0}, evenly(0.0, 1.0, 21));
  const int count = expect_as_solved_alone(input, "neo-hookean");
  EXPECT_GT(count, 150);
  EXPECT_LT(count, 210) << "some sheets escape before";
  const BatchResult out = solved(input);
  EXPECT_EQ(out.cell(3, 10).alpha, 0.0);
  EXPECT_LT(out.cell(6, 10).alpha, -1e-3);
}

/// Models, coefficients, inertia; (i) and (ii) where V is even.
TEST(AnisotropicBatch, AgreesWithSolveOverRandomBodies) {
  support::Random random(901);
  int count = 0;
  for (int k = 0; k < 12; ++k) {
    const OrientedBody at = random_oriented_body(random, k);
    std::vector<double> nu{0.0};
    for (int i = 0; i < 5; ++i) nu.push_back(random.uniform(0.0, 0.8));
    for (const Branch branch : {Branch::i, Branch::ii, Branch::iii}) {
      if (branch != Branch::iii && !at.V.even_in_alpha()) continue;
      BatchInput input(at.problem(branch), 2, nu);
      input.inertia[1] = std::vector<double>{at.body.J2, random.uniform(0.5, 2.0)};
      for (auto* values : {&input.plane, &input.thickness, &input.fibres}) {
        if (values->empty()) continue;
        const double value = values->front()[0];
        values->front() = std::vector<double>{value, 1.1 * value};
      }
      count += expect_as_solved_alone(input, at.text);
    }
  }
  EXPECT_GT(count, 100);
}

/// Keeps the first fold.
class FirstFold final : public CurveSink {
 public:
  void row(const Member& member, EventType event) override {
    if (event == EventType::fold_nu && !at) at = member;
  }
  std::optional<Member> at;
};

Member first_fold(const Problem& problem) {
  const AnyFamily family =
      anisotropic_family(problem.body(), problem.potential().anisotropic(), problem.branch(), false,
                         {.parameter = {}, .spectrum = false});
  FirstFold fold;
  FollowOptions how;
  how.continuation.to = 2.0;
  how.events = EventSet::none().add(EventType::fold_nu);
  follow(family, solve(problem, 0.0).q, 0.0, how, fold);
  return fold.at.value();
}

class AnisotropicBatchFold : public ::testing::TestWithParam<double> {
 protected:
  const Problem problem_{plate, fibred(Hencky<>{1.1, 0.8}, 0.05, GetParam()), Branch::iii};
  const Member fold_ = first_fold(problem_);
};

TEST_P(AnisotropicBatchFold, AgreesWithSolveUpToItAndEndsThere) {
  std::vector<double> nu;
  for (int digits = 1; digits <= 9; ++digits) {
    nu.push_back(fold_.nu * (1.0 - std::pow(10.0, -digits)));
    nu.push_back(fold_.nu * (1.0 + std::pow(10.0, -digits)));
  }
  EXPECT_EQ(expect_as_solved_alone(BatchInput(problem_, 1, nu), "fold"), 9);
}

/// 10^-k below it the side from rest is some 10^-(k/2) away, and the other as far beyond.
TEST_P(AnisotropicBatchFold, CellsAreOnTheSideFromRest) {
  std::vector<double> nu;
  for (double apart = 1e-2; apart > 1e-13; apart *= 0.7) nu.push_back(fold_.nu * (1.0 - apart));
  const BatchResult out = solved(BatchInput(problem_, 1, nu));
  double before = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < nu.size(); ++k) {
    ASSERT_EQ(out.cell(0, k).status, SolveStatus::solved) << 1.0 - nu[k] / fold_.nu;
    const double to_fold =
        std::log(fold_.q.xi * fold_.q.zeta / (out.cell(0, k).xi * out.cell(0, k).zeta));
    EXPECT_GT(to_fold, 0.0) << 1.0 - nu[k] / fold_.nu;
    EXPECT_LT(to_fold, 0.9 * before) << 1.0 - nu[k] / fold_.nu;
    before = to_fold;
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, AnisotropicBatchFold, ::testing::Values(0.0, 30.0, 90.0));

/// The circle's bifurcation to ellipses, broken a little by a fibre or by J1 != J2: beyond it the
/// sheet of rest goes to one side, close to one that goes straight on.
TEST(AnisotropicBatch, AgreesWithSolveAcrossTheGapOfABrokenBifurcation) {
  for (const double apart : {1e-2, 1e-4, 1e-6}) {
    const Potential V = fibred(BiotLog<>{1.0, 0.6}, apart, 30.0);
    const Problem problem(Body(1.0, 1.0 + apart, 0.6), V, Branch::iii);
    EXPECT_GT(expect_as_solved_alone(BatchInput(problem, 1, evenly(0.8, 1.4, 13)), "gap"), 5);
  }
}

TEST(AnisotropicBatch, AFaintFibreLeavesTheIsotropicBody) {
  const std::vector<double> nu = evenly(0.0, 0.6, 13);
  const BatchInput faint = fan(Branch::iii, NeoHookean<>{1.0, 2.0}, 1e-18, {0.0, 30.0}, nu);
  const double plane[] = {1.0, 2.0};
  const double thickness[] = {1.0, 3.0};
  const BatchInput none(Problem(plate,
                                Potential(Potential::planar("neo-hookean", plane),
                                          Potential::thickness("reciprocal-quadratic", thickness)),
                                Branch::iii),
                        2, nu);
  BatchResult out;
  solve_batch(faint, {}, out);
  const BatchResult isotropic = solved(none);
  for (std::size_t lane = 0; lane < 2; ++lane) {
    for (std::size_t k = 0; k < nu.size(); ++k) {
      const BatchCell cell = out.cell(lane, k);
      ASSERT_EQ(cell.status, SolveStatus::solved);
      EXPECT_LE(stretch_difference(stretch(cell), stretch(isotropic.cell(lane, k))), 2.3e-16);
    }
  }
  // Memory that was an anisotropic batch's.
  solve_batch(none, {}, out);
  EXPECT_EQ(out.cell(1, 3).alpha, 0.0);
  EXPECT_EQ(out.cell(1, 3).xi, isotropic.cell(1, 3).xi);
}

TEST(AnisotropicBatch, NeitherOrderNorSignNorOtherLanesNorThreadsMatter) {
  const std::vector<double> nu{0.3, -0.3, 0.0, 0.9, -0.1, 0.3};
  BatchInput input =
      fan(Branch::iii, BiotLog<>{1.0, 0.6}, 0.4, {10.0, 30.0, 90.0, -45.0, 70.0}, nu);
  input.speed = std::vector<double>{1.0, -1.0, 1.0, 0.5, 0.0};
  const BatchResult out = solved(input);
  EXPECT_EQ(out.fallbacks(), 5U);
  const BatchResult threads = solved(input, {.threads = 3});
  for (std::size_t lane = 0; lane < 5; ++lane) {
    BatchInput alone = fan(Branch::iii, BiotLog<>{1.0, 0.6}, 0.4, {input.fibres[1][lane]}, nu);
    alone.speed = input.speed[lane];
    const BatchResult one = solved(alone);
    for (std::size_t k = 0; k < nu.size(); ++k) {
      const BatchCell cell = out.cell(lane, k);
      for (const BatchCell& other : {threads.cell(lane, k), one.cell(0, k)}) {
        ASSERT_EQ(cell.status, other.status);
        if (cell.status != SolveStatus::solved) continue;
        EXPECT_EQ(stretch(cell).vector(), stretch(other).vector());
        EXPECT_EQ(cell.error_bound, other.error_bound);
      }
    }
    EXPECT_EQ(stretch(out.cell(lane, 0)).vector(), stretch(out.cell(lane, 1)).vector());
    EXPECT_EQ(stretch(out.cell(lane, 0)).vector(), stretch(out.cell(lane, 5)).vector());
  }
  // Other nu in the lane are other rows on the way, not another answer.
  const BatchInput fewer = fan(Branch::iii, BiotLog<>{1.0, 0.6}, 0.4, {10.0}, {0.3});
  EXPECT_LE(stretch_difference(stretch(solved(fewer).cell(0, 0)), stretch(out.cell(0, 0))),
            2.3e-16);
}

TEST(AnisotropicBatch, ProvenNoneAboutAnAxisThatIsNoneOfSymmetry) {
  const BatchInput input = fan(Branch::i, NeoHookean<>{1.0, 2.0}, 0.4, {0.0, 30.0}, {0.0, 0.3});
  EXPECT_EQ(expect_as_solved_alone(input, "axis 1"), 3);
  const BatchResult out = solved(input);
  EXPECT_EQ(out.cell(1, 0).status, SolveStatus::solved) << "at rest no axis is asked for";
  EXPECT_TRUE(std::isfinite(out.cell(1, 0).alpha));
  EXPECT_EQ(out.cell(1, 1).status, SolveStatus::none_exists);
  EXPECT_TRUE(std::isnan(out.cell(1, 1).xi));
}

/// a/rho + b rho^2/2: J3 nu^2 < b, whatever the plane; below the sheet may have ended.
TEST(AnisotropicBatch, ProvenNoneWhereTheThicknessHasNoBalance) {
  Problem problem(Body(0.1, 0.1, 3.0), fibred(NeoHookean<>{1.0, 2.0}, 0.4, 0.0), Branch::i);
  const BatchResult out = solved(BatchInput(problem, 1, {0.9, 1.0, 1.1}));
  EXPECT_EQ(out.cell(0, 0).status, SolveStatus::solved);
  EXPECT_EQ(out.cell(0, 1).status, SolveStatus::none_exists);
  EXPECT_EQ(out.cell(0, 2).status, SolveStatus::none_exists);
  const CellPlace none{0, 1};
  CellSpectrum spectrum;
  EXPECT_THROW((void)cell_spectra(BatchInput(problem, 1, {0.9, 1.0, 1.1}), out, {&none, 1}, {},
                                  {&spectrum, 1}),
               std::invalid_argument);
  EXPECT_EQ(solve(problem, 1.1).status, SolveStatus::none_exists);
}

TEST(AnisotropicBatch, SpectraOfItsCells) {
  const BatchInput input =
      fan(Branch::iii, NeoHookean<>{1.0, 2.0}, 0.4, {0.0, 30.0}, {0.0, 0.3, 0.6});
  const BatchResult out = solved(input);
  const std::vector<CellPlace> places{{0, 0}, {0, 2}, {1, 0}, {1, 1}, {1, 2}};
  std::vector<CellSpectrum> spectra(places.size());
  EXPECT_EQ(cell_spectra(input, out, places, {}, spectra), places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Problem problem = input.problem(places[i].lane);
    const Spectrum expected = stability(problem, solve(problem, input.nu[places[i].k]));
    EXPECT_EQ(spectra[i].verdict, expected.verdict);
    EXPECT_EQ(spectra[i].negative, expected.negative);
    ASSERT_EQ(spectra[i].modes, expected.modes);
    for (std::size_t k = 0; k < static_cast<std::size_t>(expected.modes); ++k)
      EXPECT_NEAR(spectra[i].mode[k].im, expected.mode[k].im, 1e-13);
  }
}

TEST(AnisotropicBatch, StoppedLeavesCellsNotRun) {
  const std::atomic<bool> stop = true;
  const BatchResult out = solved(
      fan(Branch::iii, NeoHookean<>{1.0, 2.0}, 0.4, {0.0, 30.0}, {0.0, 0.3}), {.stop = &stop});
  for (std::size_t lane = 0; lane < 2; ++lane) {
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(out.cell(lane, k).status, SolveStatus::not_run);
      EXPECT_TRUE(std::isnan(out.cell(lane, k).alpha));
    }
  }
}

TEST(AnisotropicBatch, MisuseThrows) {
  const BatchInput good = fan(Branch::iii, NeoHookean<>{1.0, 2.0}, 0.4, {0.0, 30.0}, {0.3});
  const auto message = [&](const auto& spoil) -> std::string {
    BatchInput input = good;
    spoil(input);
    try {
      solved(input);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message([](BatchInput&) {}), "");
  EXPECT_EQ(message([](BatchInput& input) { input.fibres[0] = -1.0; }), "k > 0");
  EXPECT_EQ(message([](BatchInput& input) {
              input.fibres[0] = std::vector<double>{1.0, 0.0};
            }),
            "k > 0");
  EXPECT_EQ(message([](BatchInput& input) { input.fibres[1] = INFINITY; }), "degrees finite");
  EXPECT_EQ(message([](BatchInput& input) { input.plane[0] = -1.0; }), "mu > 0");
  EXPECT_EQ(message([](BatchInput& input) {
              input.fibres[1] = std::vector<double>{1.0, 2.0, 3.0};
            }),
            "one value for all lanes, or one each");
  EXPECT_EQ(message([](BatchInput& input) { input.fibres.pop_back(); }),
            "as many coefficients as the models have");
}

}  // namespace
}  // namespace stationary
